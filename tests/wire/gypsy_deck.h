// SPDX-License-Identifier: Apache-2.0
#pragma once
/// A windlass with chain of 76 mm at the fairlead of a deck, and an end whose motion is prescribed.
#include <hawser/hawser.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace hawser::test {

inline constexpr double kBar = 0.076;

inline WinchDef windlass() {
    const ChainProperties chain = chain_properties(kBar, true);
    WinchDef def{.name = "windlass"};
    def.gypsy = {.pockets = 5, .jump_load = 1.2e6, .jump_friction = 4e5};
    def.wire_diameter = kBar;
    def.mass_per_length = chain.mass_per_length;
    def.stored = 300.0;
    def.inertia = 2e4;
    def.brake_static = 5e6;
    return def;
}

struct ChainDeck {
    World w;
    BodyId end{};
    WireId wire{};
    WinchIds ids{};
    WinchDef def;

    explicit ChainDeck(WinchDef winch, double gravity = 0.0, double step = 1.0 / 240.0,
                       double length = 40.0)
        : w(WorldDef{.step = step, .gravity = Vec3(0, 0, -gravity)}), def(std::move(winch)) {
        const BodyId deck = w.add_body({.name = "deck", .kind = BodyKind::fixed});
        end = w.add_body({.name = "end", .kind = BodyKind::kinematic, .position = {0, 0, -length}});
        const ChainProperties chain = chain_properties(kBar, true);
        wire = w.wires().add({.name = "chain",
                              .from = deck,
                              .to = end,
                              .elements = 4,
                              .EA = chain.EA,
                              .mass_per_length = chain.mass_per_length,
                              .axial_damping = 2.0});
        def.wire = wire;
        ids = w.add(def);
    }
    /// Step once; the end moves away from the deck at a speed [m/s].
    void step(double speed) {
        Twist t;
        t.linear.z() = -speed;
        w.set_velocity(end, t);
        ASSERT_EQ(w.step(), Status::ok) << to_string(w.bad_load(), w);
    }
    void run(double seconds, double speed) {
        for (long i = std::lround(seconds / w.settings().step); i > 0; --i) step(speed);
    }
    void set(const char* name, double value) {
        w.set_system_signal(std::string("windlass.") + name, value);
    }
    void set(WinchMode mode) { set("mode", static_cast<double>(mode)); }
    double get(const char* name) { return w.system_signal(std::string("windlass.") + name); }
    WinchState state() { return static_cast<WinchState>(std::lround(get("state"))); }
    double tension() { return std::max(0.0, -w.force(ids.line)[0]); }
    double drum() { return w.pose(ids.drum).position.x(); }
    double chain() { return w.pose(ids.chain).position.x(); }
    /// Return the length of chain that slipped over its wheel [m].
    double jumped() { return gypsy_radius(def) * (chain() - drum()); }
    std::int64_t count(EventKind kind) { return w.events().extremes(kind).count; }
};

}  // namespace hawser::test
