// SPDX-License-Identifier: Apache-2.0
// Methods that `hawser-bench wires` compares.
#include "measure.h"

#include <fmt/format.h>

namespace hawser::bench::wires {
namespace {

constexpr bool kHaveMujoco = HAWSER_HAVE_MUJOCO, kHaveBullet = HAWSER_HAVE_BULLET,
               kHaveSimbody = HAWSER_HAVE_SIMBODY;

double euler_exponent(double turns) { return kRub * 2.0 * kPi * turns; }
double no_friction(double /*turns*/) { return 0.0; }

void add_ours(std::vector<WireMethod>& all) {
    for (const int places : {1, 8, 64})
        all.push_back({.name = fmt::format("hawser-route-{}", places),
                       .description = fmt::format("route without mass, {} place(s)", places),
                       .ours = true,
                       .make = [places](double turns, int) { return make_route(turns, places); },
                       .exponent = euler_exponent,
                       .quick = true});
    all.push_back({.name = "hawser-guide",
                   .description = "wire of lumps over a guide",
                   .ours = true,
                   .make = [](double turns, int) { return make_guide(turns); },
                   .exponent = euler_exponent,
                   .quick = true});
    for (const int n : {8, 16, 32, 64})
        all.push_back({.name = fmt::format("hawser-segments-{}", n),
                       .description = fmt::format("lumps, {} capsules on a cylinder", n),
                       .ours = true,
                       .make = [n](double turns, int) { return make_segments(turns, n); },
                       .exponent = [n](double turns) { return lump_exponent(turns, n); },
                       .quick = n == 16});
}

void add_peers(std::vector<WireMethod>& all) {
    all.push_back({.name = "mujoco-tendon",
                   .description = "MuJoCo, spatial tendon over a cylinder, no friction",
                   .make = make_mujoco_tendon,
                   .exponent = no_friction,
                   .in_build = kHaveMujoco});
    for (const bool noslip : {false, true})
        for (const int n : {16, 32})
            all.push_back({.name = fmt::format("mujoco-{}-{}", noslip ? "noslip" : "chain", n),
                           .description = fmt::format("MuJoCo, ball joints, {} capsules{}", n,
                                                      noslip ? ", noslip solver" : ""),
                           .make =
                               [n, noslip](double turns, int substeps) {
                                   return make_mujoco_chain(turns, n, substeps, noslip);
                               },
                           .exponent = [n](double turns) { return link_exponent(turns, n); },
                           .in_build = kHaveMujoco});
    for (const int n : {16, 32})
        all.push_back({.name = fmt::format("bullet-chain-{}", n),
                       .description = fmt::format("Bullet, point-to-point, {} capsules", n),
                       .make = [n](double turns,
                                   int substeps) { return make_bullet_chain(turns, n, substeps); },
                       .exponent = [n](double turns) { return link_exponent(turns, n); },
                       .in_build = kHaveBullet});
    all.push_back({.name = "simbody-cable",
                   .description = "Simbody, CableSpring over a cylinder, no friction",
                   .make = make_simbody_cable,
                   .exponent = no_friction,
                   .in_build = kHaveSimbody});
}

}  // namespace

std::vector<WireMethod> methods() {
    std::vector<WireMethod> all;
    add_ours(all);
    add_peers(all);
    return all;
}

#if !HAWSER_HAVE_MUJOCO
std::unique_ptr<Rig> make_mujoco_tendon(double /*turns*/, int /*substeps*/) { return nullptr; }
std::unique_ptr<Rig> make_mujoco_chain(double /*turns*/, int /*elements*/, int /*substeps*/,
                                       bool /*noslip*/) {
    return nullptr;
}
#endif
#if !HAWSER_HAVE_BULLET
std::unique_ptr<Rig> make_bullet_chain(double /*turns*/, int /*elements*/, int /*substeps*/) {
    return nullptr;
}
#endif
#if !HAWSER_HAVE_SIMBODY
std::unique_ptr<Rig> make_simbody_cable(double /*turns*/, int /*substeps*/) { return nullptr; }
#endif

}  // namespace hawser::bench::wires
