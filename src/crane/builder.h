// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file builder.h
/// Add the parts of a crane to its site: links, hinges with their drives, drums, lines.

#include <hawser/crane.h>
#include <hawser/route.h>

#include "crane/common.h"
#include "crane/linkage.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace hawser::crane {

/// Body whose frame in a definition begins at a pin instead of its centre of mass.
struct Link {
    BodyId id{};
    Vec3 pin{0.0, 0.0, 0.0};  ///< Origin of its frame in the world [m].
    Quat turn = Quat::Identity();
    Vec3 centre{0.0, 0.0, 0.0};  ///< Centre of mass in its frame [m].

    [[nodiscard]] Vec3 world(const Vec3& p) const { return pin + turn * p; }
    [[nodiscard]] Vec3 local(const Vec3& p) const { return p - centre; }
    [[nodiscard]] Vec3 of_world(const Vec3& w) const {
        return turn.conjugate() * (w - pin) - centre;
    }
};

/// Limit, drive and brake of a hinge between two links.
struct HingeParts {
    std::optional<std::pair<double, double>> range{};  ///< Range of the angle [rad].
    std::optional<double> torque{};                    ///< Largest torque of a motor [N m].
    std::optional<double> brake{};                     ///< Torque of a brake [N m].
};

class Builder {
  public:
    Builder(CraneSite& site, const Common& common);

    [[nodiscard]] const Link& base() const { return base_; }
    /// Return the unit vector opposite to gravity; without gravity the crane's z axis.
    [[nodiscard]] const Vec3& vertical() const { return up_; }
    [[nodiscard]] const Vec3& gravity() const { return gravity_; }
    [[nodiscard]] std::string part_name(const char* what) const { return part(common_.name, what); }

    /// Add the slewing column on its bearing, with motor and brake.
    Link add_column();
    /// Add a boom or jib on a pin. @param turn  Orientation of the boom or jib in the world.
    Link add_link(const char* what, const CraneLink& def, const Vec3& pin, const Quat& turn);
    Link add_box(const char* what, double mass, const Vec3& half_size, const Vec3& pin,
                 const Quat& turn, const Vec3& centre, const Vec3& damping = Vec3::Zero());
    BodyId add_lump(const char* what, double mass, const Vec3& at);
    BodyId add_scalar(const char* what, double mass);
    /// Add a hinge. @param turn  Rotation from the frame of the joint, which turns about z, to that
    /// of the links.
    void add_hinge(const char* what, const Link& a, const Link& b, const Vec3& at, const Quat& turn,
                   const HingeParts& parts);
    /// Add a cylinder with its stroke and motor. @param tension  Force of the cylinder at the start
    /// [N].
    void add_cylinder(const char* what, const CraneCylinder& def, const Link& a, const Link& b,
                      double tension);
    /// Add a drum with motor and brake. @return the drum.
    BodyId add_drum(const char* what, const CraneTackle& def);
    void add_route(const RouteDef& def);
    InteractionId add(const InteractionDef& def) { return site_.add(def); }
    [[nodiscard]] CraneBody find(BodyId id) const { return site_.find(id); }

    /// Return the moment of a force at a point about a hinge through `pin`, positive if it raises
    /// [N m].
    [[nodiscard]] double raising_moment(const Vec3& pin, const Vec3& at, const Vec3& force) const {
        return raise_axis_.dot((at - pin).cross(force));
    }
    /// Return the unit vector of the world about which the boom turns when it is raised, at the
    /// start.
    [[nodiscard]] const Vec3& raise_axis() const { return raise_axis_; }
    /// Return the horizontal unit vector of the world in the direction of the boom.
    [[nodiscard]] const Vec3& ahead() const { return ahead_; }

  private:
    BodyId add_body(BodyDef def);
    [[nodiscard]] RouteBody route_body(BodyId id) const;

    CraneSite& site_;
    const Common& common_;
    CraneBody mount_body_;
    Link base_;
    Vec3 gravity_, up_, ahead_, raise_axis_;
    std::map<std::int32_t, RouteBody> route_bodies_;
};

/// Return the rotation that maps z of a joint's frame to −y, so that the joint angle increases when
/// a link is raised.
[[nodiscard]] Quat hinge_turn();

/// Add the hook with its block, which hangs from the head of a link by the falls of the hoist.
/// @param over  Link whose head has a sheave at the knuckle that the line passes over; null: none.
Link add_hoist(Builder& b, const Common& c, const Link& drum_on, const Link* over, const Link& head,
               double head_at);

/// Add the slings of the load that hangs from the start, if there is one.
void add_slings(Builder& b, const Common& c, const Link& hook);

/// Return the number of sheaves at the head or at the hook.
[[nodiscard]] constexpr int head_sheaves(int falls) noexcept { return (falls + 1) / 2; }
[[nodiscard]] constexpr int hook_sheaves(int falls) noexcept { return falls / 2; }

}  // namespace hawser::crane
