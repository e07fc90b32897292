// SPDX-License-Identifier: Apache-2.0
#pragma once
/// A winch at the fairlead of a deck, with prescribed motion of the end of its wire.
#include <hawser/hawser.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace hawser::test {

/// Return a winch with 31 turns per layer and 9 layers for 1,500 m.
inline WinchDef big_winch() {
    return {.name = "winch",
            .core_radius = 0.6,
            .width = 2.4,
            .flange_radius = 1.4,
            .wire_diameter = 0.076,
            .mass_per_length = 25.0,
            .stored = 1500.0,
            .inertia = 4e4,
            .torque_haul = 3e6,
            .torque_pay = 3e6};
}

struct Deck {
    World w;
    BodyId end{};
    WireId wire{};
    WinchIds ids{};

    explicit Deck(WinchDef def, double step = 1.0 / 240.0, double length = 40.0)
        : w(WorldDef{.step = step, .gravity = Vec3::Zero()}) {
        const BodyId deck = w.add_body({.name = "deck", .kind = BodyKind::fixed});
        end = w.add_body({.name = "end", .kind = BodyKind::kinematic, .position = {length, 0, 0}});
        wire = w.wires().add({.name = "wire",
                              .from = deck,
                              .to = end,
                              .elements = 2,  // one node can move
                              .EA = 3e8,
                              .mass_per_length = 25.0,
                              .axial_damping = 5.0});
        def.wire = wire;
        ids = w.add(def);
    }
    void step(double speed) {
        Twist t;
        t.linear.x() = speed;
        w.set_velocity(end, t);
        ASSERT_EQ(w.step(), Status::ok) << to_string(w.bad_load(), w);
    }
    void run(double seconds, double speed) {
        for (long i = std::lround(seconds / w.settings().step); i > 0; --i) step(speed);
    }
    void set(const char* name, double value) {
        w.set_system_signal(std::string("winch.") + name, value);
    }
    void set(WinchMode mode) { set("mode", static_cast<double>(mode)); }
    double get(const char* name) { return w.system_signal(std::string("winch.") + name); }
    WinchState state() { return static_cast<WinchState>(std::lround(get("state"))); }
    double tension() { return std::max(0.0, -w.force(ids.line)[0]); }
    std::int64_t count(EventKind kind) { return w.events().extremes(kind).count; }
};

}  // namespace hawser::test
