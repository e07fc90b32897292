// SPDX-License-Identifier: Apache-2.0
#include "live/drag.h"

#include <algorithm>
#include <cmath>

namespace hawser::live {
namespace {

/// Return a lower bound of the effective mass at a point of a body [kg].
double mass_at(const BodyDef& def, const Vec3& point) {
    double inverse = 1.0 / def.mass;
    if (def.kind == BodyKind::rigid) inverse += point.squaredNorm() * def.inertia.inverse().trace();
    return 1.0 / inverse;
}

/// Return a stiffness with a visible response: a body oscillates with a period of about six
/// seconds, a node of a wire follows at once.
double usual_stiffness(BodyKind kind, double mass, double most) {
    return kind == BodyKind::lump ? most : std::min(most, mass);  // ω = 1 rad/s
}

}  // namespace

BodyId node_near(const World& world, WireId wire, double share) {
    const auto nodes = world.wires().nodes(wire);
    const auto last = static_cast<double>(nodes.empty() ? 0 : nodes.size() - 1);
    BodyId best{};
    double least = 2.0 * last + 1.0;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        const double separation = std::abs(static_cast<double>(n) - share * last);
        if (separation >= least || !world.alive(nodes[n]) ||
            world.body_def(nodes[n]).kind != BodyKind::lump)
            continue;
        least = separation;
        best = nodes[n];
    }
    if (!best.valid())
        throw DefError("the wire \"" + world.wires().name(wire) + "\" has no node to pull at");
    return best;
}

void Drags::begin(World& world, std::uint32_t client, BodyId body, const Vec3& point,
                  const Vec3& target, double stiffness) {
    const BodyDef& def = world.body_def(body);
    if (def.kind != BodyKind::rigid && def.kind != BodyKind::lump)
        throw DefError("\"" + def.name +
                       "\" cannot be pulled: it is neither rigid nor a point mass");
    const auto mine = std::find_if(drags_.begin(), drags_.end(),
                                   [&](const Drag& d) { return d.client == client; });
    if (mine != drags_.end() && mine->body != body) end(world, client);
    const bool known =
        std::any_of(bases_.begin(), bases_.end(), [&](const Base& b) { return b.body == body; });
    if (!known) bases_.push_back({body, def.force, def.torque});
    const Drag drag{client, body, def.kind == BodyKind::lump ? Vec3::Zero().eval() : point, target,
                    stiffness};
    const auto again = std::find_if(drags_.begin(), drags_.end(),
                                    [&](const Drag& d) { return d.client == client; });
    if (again != drags_.end())
        *again = drag;
    else
        drags_.push_back(drag);
}

void Drags::restore_force(World& world, BodyId body) {
    const auto base =
        std::find_if(bases_.begin(), bases_.end(), [&](const Base& b) { return b.body == body; });
    if (base == bases_.end()) return;
    if (world.alive(body)) world.set_force(body, base->force, base->torque);
}

void Drags::end(World& world, std::uint32_t client) {
    const auto mine = std::find_if(drags_.begin(), drags_.end(),
                                   [&](const Drag& d) { return d.client == client; });
    if (mine == drags_.end()) return;
    const BodyId body = mine->body;
    drags_.erase(mine);
    restore_force(world, body);
    if (std::none_of(drags_.begin(), drags_.end(), [&](const Drag& d) { return d.body == body; }))
        std::erase_if(bases_, [&](const Base& b) { return b.body == body; });
}

void Drags::remove_forces(World& world) {
    for (const Base& base : bases_) restore_force(world, base.body);
}

void Drags::end_all(World& world) {
    remove_forces(world);
    drags_.clear();
    bases_.clear();
}

void Drags::remove_gone_bodies(const World& world) {
    std::erase_if(drags_, [&](const Drag& d) { return !world.alive(d.body); });
    std::erase_if(bases_, [&](const Base& b) { return !world.alive(b.body); });
}

void Drags::before_step(World& world) {
    if (drags_.empty()) return;
    remove_gone_bodies(world);
    const double h = world.settings().step;
    for (const Base& base : bases_) {
        Vec3 force = base.force, torque = base.torque;
        for (const Drag& drag : drags_) {
            if (drag.body != base.body) continue;
            const BodyDef& def = world.body_def(drag.body);
            const Pose pose = world.pose(drag.body);
            const Twist twist = world.velocity(drag.body);
            const Vec3 arm = pose.orientation * drag.point;
            const double mass = mass_at(def, drag.point), most = 0.25 * mass / (h * h);
            const double k = drag.stiffness > 0.0 ? std::min(drag.stiffness, most)
                                                  : usual_stiffness(def.kind, mass, most);
            const double c = std::min(1.4 * std::sqrt(k * mass), 0.5 * mass / h);
            const Vec3 pull = k * (drag.target - pose.position - arm) -
                              c * (twist.linear + twist.angular.cross(arm));
            force += pull;
            torque += arm.cross(pull);
        }
        world.set_force(base.body, force, torque);
    }
}

}  // namespace hawser::live
