// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file define.h
/// From typed definitions to those of the table: names of parameters are looked up there, and what
/// is not given stays kDefault.

#include <hawser/joints.h>

#include <string>
#include <string_view>
#include <vector>

namespace hawser::world {

/// What one typed definition is made of, the joint first.
struct Parts {
    std::vector<InteractionDef> defs;
    /// Where the id of each goes, or null.
    std::vector<InteractionId*> ids;
    void add(InteractionDef def, InteractionId& id) {
        defs.push_back(std::move(def));
        ids.push_back(&id);
    }
    /// Add all interactions, or none where one is refused.
    void add_to(World& world) const;
};

/// "boom/motor"; "" of what has no name.
[[nodiscard]] std::string part_name(const std::string& name, const char* part);

/// A parameter that is given.
void set_given(InteractionDef& def, std::string_view param, double value);
/// The same compliance and damping time in every row.
void set_rows(InteractionDef& def, double compliance, double damping_time);

/// The three things that act on a coordinate, each of its own kind, at the place of `frame`.
struct AxisKinds {
    InteractionKind limit, motor, friction;
};
/// @param own  Whether a joint, the first part, presses on the friction.
void add_axis(Parts& parts, const InteractionDef& frame, const std::string& name,
              const AxisKinds& kinds, const std::optional<AxisLimit>& limit,
              const std::optional<AxisMotor>& motor, const std::optional<AxisFriction>& friction,
              AxisIds& ids);
/// Frames of the first `count` bodies with their z along an axis, which agree as these stand now.
void set_frames(InteractionDef& def, const World& world, std::size_t count, const Vec3& axis,
                JointFrame in);
void set_motor(InteractionDef& def, const AxisMotor& motor);
void set_friction(InteractionDef& def, const AxisFriction& friction);

}  // namespace hawser::world
