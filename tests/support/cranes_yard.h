// SPDX-License-Identifier: Apache-2.0
#pragma once
/// A crane on a quay with a weight on its hook.
#include "support/cranes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace hawser::test {

inline constexpr double kYardStep = 1.0 / 60.0;
inline constexpr double kSling = 1.0;

/// @tparam Def  Definition of the crane, which carries the weight from the start.
template <class Def>
struct CraneYard {
    World w;
    BodyId quay{}, box{};
    CraneIds ids;

    CraneYard(Def (*make)(BodyId), double mass, const auto& change, int threads = 1)
        : w(WorldDef{.step = kYardStep, .threads = threads}) {
        quay = w.add_body({.name = "quay", .kind = BodyKind::fixed});
        Def def = make(quay);
        box = w.add_body({.name = "box",
                          .kind = BodyKind::lump,
                          .position = point_of(make) - Vec3(0, 0, kSling),
                          .mass = mass});
        def.loads = {{.body = box,
                      .eyes = {{0, 0, 0}},
                      .sling_length = kSling,
                      .sling_EA = 5e10,
                      .reach = 0.01}};
        def.take = 1;
        change(def);
        ids = w.add(def);
    }
    CraneYard(Def (*make)(BodyId), double mass) : CraneYard(make, mass, [](Def&) {}) {}

    /// Return the position of the hook of a crane of this type at the start.
    static Vec3 point_of(Def (*make)(BodyId)) {
        World w;
        const Def def = make(w.add_body({.kind = BodyKind::fixed}));
        return w.world_point(w.add(def).hook, {0, 0, -0.5 * def.hook.height});
    }
    void run(double seconds) {
        for (long i = std::lround(seconds / kYardStep); i > 0; --i) ASSERT_EQ(w.step(), Status::ok);
    }
    [[nodiscard]] double signal(const char* name) const {
        return w.system_signal(std::string("crane.") + name);
    }
    void order(const char* name, double value) {
        w.set_system_signal(std::string("crane.") + name, value);
    }
    [[nodiscard]] InteractionId part(const char* name) const {
        return w.find_interaction(std::string("crane/") + name);
    }
    [[nodiscard]] double tension(const char* name) const { return -w.force(part(name))[0]; }
    [[nodiscard]] std::int64_t count(EventKind kind) const {
        return w.events().extremes(kind).count;
    }
    /// Return the mean of `read` over a time.
    double mean(double seconds, const auto& read) {
        const long steps = std::lround(seconds / kYardStep);
        double sum = 0.0;
        for (long i = 0; i < steps; ++i) {
            EXPECT_EQ(w.step(), Status::ok);
            sum += read();
        }
        return sum / static_cast<double>(steps);
    }
};

using KnuckleYard = CraneYard<KnuckleCraneDef>;
using LatticeYard = CraneYard<LatticeCraneDef>;

}  // namespace hawser::test
