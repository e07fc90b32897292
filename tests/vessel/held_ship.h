// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file held_ship.h
/// A ship at rest in still water, for thrusts and powers without inflow.

#include <hawser/hawser.h>
#include <hawser/vessel.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>

namespace hawser::test {

/// A ship held by damping.
struct HeldShip {
    World world{WorldDef{.step = 1.0 / 60.0}};
    VesselDef def;

    HeldShip() {
        BodyDef body{.name = "hull", .mass = 8e6, .inertia = 1e9 * Mat3::Identity()};
        body.gravity = false;
        def.name = "ship";
        def.body = world.add_body(body);
        for (int i = 0; i < 6; ++i) def.damping(i, i) = 1e13;
    }
    /// Append an azimuth without a propeller, of 100 kN.
    PropulsorDef& azimuth(const char* name) {
        PropulsorDef p;
        p.name = name;
        p.kind = PropulsorKind::azimuth;
        p.thrust = 1e5;
        def.propulsors.push_back(p);
        return def.propulsors.back();
    }
    void set(const std::string& name, double value) {
        world.set_system_signal("ship." + name, value);
    }
    [[nodiscard]] double get(const std::string& name) const {
        return world.system_signal("ship." + name);
    }
    void run(double seconds) {
        for (long i = std::lround(seconds * 60.0); i > 0; --i) ASSERT_EQ(world.step(), Status::ok);
    }
    [[nodiscard]] std::int64_t count(EventKind kind) const {
        return world.events().extremes(kind).count;
    }
};

}  // namespace hawser::test
