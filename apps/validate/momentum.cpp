// SPDX-License-Identifier: Apache-2.0
// Momentum of scenes without external forces.
#include "validate/cases.h"
#include "validate/tools.h"

namespace hawser::validate {
namespace {

constexpr long kSteps = 10'000;

/// Σ m v and Σ x × m v. The second is the angular momentum of a scene of nodes.
struct Momentum {
    Vec3 linear = Vec3::Zero();
    Vec3 angular = Vec3::Zero();
};

Momentum momentum(const World& world) {
    Momentum sum;
    for (int i = 0; i < world.body_count(); ++i) {
        const BodyDef& def = world.body_def(BodyId{i});
        if (def.kind != BodyKind::rigid && def.kind != BodyKind::lump) continue;
        const Vec3 p = def.mass * world.velocity(BodyId{i}).linear;
        sum.linear += p;
        sum.angular += world.pose(BodyId{i}).position.cross(p);
    }
    return sum;
}

void check_angular(Report& report, const std::string& stiffness, double tolerance,
                   const std::string& reason) {
    scene::Scene s =
        open_scene("cable_spin", 1.0 / 60.0, {"settings.geometric_stiffness=" + stiffness});
    advance(s.world, 1);  // the first step applies the staggered start
    const Momentum before = momentum(s.world);
    advance(s.world, kSteps);
    report.compare("angular momentum, K_g = " + stiffness + " [kg m2/s]", list(before.angular),
                   list(momentum(s.world).angular), tolerance, reason);
}

}  // namespace

void case_momentum(Report& report) {
    scene::Scene s = open_scene("cable_momentum", 1.0 / 60.0);
    advance(s.world, 1);
    const Momentum before = momentum(s.world);
    advance(s.world, kSteps);
    report.compare("momentum after 1e4 steps [kg m/s]", list(before.linear),
                   list(momentum(s.world).linear), 1e-12, "round-off");
    check_angular(report, "0", 1e-12, "round-off");
    check_angular(report, "1", 1e-3,
                  "geometric stiffness keeps momentum, and angular momentum to second order");
}

}  // namespace hawser::validate
