// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file define.h
/// Conversion of typed definitions to table definitions. Parameter names are looked up here, and
/// missing values stay kDefault.

#include <hawser/joints.h>

#include <string>
#include <string_view>
#include <vector>

namespace hawser::world {

/// Interactions of one typed definition, the joint first.
struct Parts {
    std::vector<InteractionDef> defs;
    /// Destination of each id, or null.
    std::vector<InteractionId*> ids;
    void add(InteractionDef def, InteractionId& id) {
        defs.push_back(std::move(def));
        ids.push_back(&id);
    }
    /// Add all interactions of the joint to the world, or none if one is rejected.
    void add_to(World& world) const;
};

/// Return "boom/motor", or "" without a name.
[[nodiscard]] std::string part_name(const std::string& name, const char* part);

/// Set a parameter if a value is given.
void set_if_given(InteractionDef& def, std::string_view param, double value);
/// Set the same compliance and damping time in every row.
void set_rows(InteractionDef& def, double compliance, double damping_time);

/// Kinds of the three interactions on a coordinate, placed at `frame`.
struct AxisKinds {
    InteractionKind limit, motor, friction;
};
/// Add the limit, motor and friction of a coordinate. @param own  True if the force of the first
/// part, a joint, is a load of the friction.
void add_axis(Parts& parts, const InteractionDef& frame, const std::string& name,
              const AxisKinds& kinds, const std::optional<AxisLimit>& limit,
              const std::optional<AxisMotor>& motor, const std::optional<AxisFriction>& friction,
              AxisIds& ids);
/// Set frames of the first `count` bodies with z along an axis, which agree in the current poses.
void set_frames(InteractionDef& def, const World& world, std::size_t count, const Vec3& axis,
                JointFrame in);
void set_motor(InteractionDef& def, const AxisMotor& motor);
void set_friction(InteractionDef& def, const AxisFriction& friction);

}  // namespace hawser::world
