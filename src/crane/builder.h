// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file builder.h
/// Adds the parts of a crane to its site: links, hinges with what drives them, drums, lines.

#include <hawser/crane.h>
#include <hawser/route.h>

#include "crane/common.h"
#include "crane/linkage.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace hawser::crane {

/// A body whose frame in a definition begins at a pin and not in its centre of mass.
struct Link {
    BodyId id{};
    Vec3 pin{0.0, 0.0, 0.0};  ///< Origin of its frame in the world.
    Quat turn = Quat::Identity();
    Vec3 centre{0.0, 0.0, 0.0};  ///< Of mass, in its frame.

    [[nodiscard]] Vec3 world(const Vec3& p) const { return pin + turn * p; }
    [[nodiscard]] Vec3 local(const Vec3& p) const { return p - centre; }
    [[nodiscard]] Vec3 of_world(const Vec3& w) const {
        return turn.conjugate() * (w - pin) - centre;
    }
};

/// How a hinge between two links is limited, driven and rubbed.
struct HingeParts {
    std::optional<std::pair<double, double>> range{};  ///< [rad]
    std::optional<double> torque{};                    ///< Of a motor [N m].
    std::optional<double> brake{};                     ///< [N m]
};

class Builder {
  public:
    Builder(CraneSite& site, const Common& common);

    [[nodiscard]] const Link& base() const { return base_; }
    /// Up, square to gravity's pull; without gravity the crane's z.
    [[nodiscard]] const Vec3& up() const { return up_; }
    [[nodiscard]] const Vec3& gravity() const { return gravity_; }
    [[nodiscard]] std::string named(const char* what) const { return part(common_.name, what); }

    /// The slewing column on its bearing, with motor and brake.
    Link add_column();
    /// A boom or jib on a pin, turned against what it stands on.
    Link add_link(const char* what, const CraneLink& def, const Vec3& pin, const Quat& turn);
    Link add_box(const char* what, double mass, const Vec3& half_size, const Vec3& pin,
                 const Quat& turn, const Vec3& centre, const Vec3& damping = Vec3::Zero());
    BodyId add_lump(const char* what, double mass, const Vec3& at);
    BodyId add_scalar(const char* what, double mass);
    /// @param turn  From the frame of the joint, which turns about z, to that of the links.
    void add_hinge(const char* what, const Link& a, const Link& b, const Vec3& at, const Quat& turn,
                   const HingeParts& parts);
    /// A cylinder of the force `tension` at the start, with its stroke and motor.
    void add_cylinder(const char* what, const CraneCylinder& def, const Link& a, const Link& b,
                      double tension);
    /// Drum with motor and brake. @return it.
    BodyId add_drum(const char* what, const CraneTackle& def);
    void add_route(const RouteDef& def);
    InteractionId add(const InteractionDef& def) { return site_.add(def); }
    [[nodiscard]] CraneBody find(BodyId id) const { return site_.find(id); }

    /// Moment about a hinge through `pin` that raises, of a force at a point [N m].
    [[nodiscard]] double raising(const Vec3& pin, const Vec3& at, const Vec3& force) const {
        return raise_axis_.dot((at - pin).cross(force));
    }
    /// Unit vector of the world about which the boom turns when it is raised, at the start.
    [[nodiscard]] const Vec3& raise_axis() const { return raise_axis_; }
    /// Level unit vector of the world, to where the boom points.
    [[nodiscard]] const Vec3& ahead() const { return ahead_; }

  private:
    BodyId add_body(BodyDef def);
    [[nodiscard]] RouteBody route_body(BodyId id) const;

    CraneSite& site_;
    const Common& common_;
    CraneBody on_;
    Link base_;
    Vec3 gravity_, up_, ahead_, raise_axis_;
    std::map<std::int32_t, RouteBody> made_;
};

/// Turns z of a joint's frame to −y, so that what is raised has a growing angle.
[[nodiscard]] Quat hinge_turn();

/// Hook with its block, hung from the head of a link by the falls of the hoist.
/// @param over  Where the line comes over the knuckle: that link, whose head has a sheave.
Link add_hoist(Builder& b, const Common& c, const Link& drum_on, const Link* over, const Link& head,
               double head_at);

/// Slings of the load that hangs from the start, if one does.
void add_slings(Builder& b, const Common& c, const Link& hook);

/// Sheaves at the head and at the hook.
[[nodiscard]] constexpr int head_sheaves(int falls) noexcept { return (falls + 1) / 2; }
[[nodiscard]] constexpr int hook_sheaves(int falls) noexcept { return falls / 2; }

}  // namespace hawser::crane
