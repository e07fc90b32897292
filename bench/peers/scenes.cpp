// SPDX-License-Identifier: Apache-2.0
#include "scenes.h"

#include "scene_parts.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace hawser::bench {
Scene heavy_hook() {
    Scene s;
    s.name = "heavy_hook";
    s.code = "S1";
    s.duration = 10.0;
    const int n = 100;
    const double angle = 20.0 * std::numbers::pi / 180.0;
    const Vec3 dir(std::sin(angle), 0.0, -std::cos(angle));
    std::vector<Vec3> nodes;
    for (int i = 0; i <= n; ++i) nodes.push_back(i * dir);
    // The block is body 100, after the links; joined half its size below the last node.
    Body block = box(50e3, Vec3::Ones(), (n + 1.0) * dir);
    block.start.q = along_x(dir);
    int previous = kWorld;
    for (int i = 0; i < n; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const int now = add(s, link(10.0, 0.05, nodes[k], nodes[k + 1]));
        join(s, previous, now, nodes[k]);
        previous = now;
    }
    s.block = add(s, block);
    join(s, previous, s.block, nodes.back());
    s.layouts = {{"tree", {}}};
    s.energy_scale = 0.0;  // potential energy from the start to hanging straight down
    for (const Body& b : s.bodies)
        s.energy_scale += b.mass * s.gravity * b.start.x.norm() * (1.0 - std::cos(angle));
    return s;
}

Scene tow_zigzag() {
    Scene s;
    s.name = "tow_zigzag";
    s.code = "S2p";
    s.gravity = 0.0;
    s.duration = 20.0;
    const int n = 200;
    const double l = 2.0, mass = 50.0, thrust = 500e3;
    s.sine = 0.05;
    std::vector<Vec3> nodes{Vec3::Zero()};
    double y0 = 0.0;
    for (int i = 1; i <= n; ++i) {
        const double zigzag = i == n ? 0.0 : (i % 2 == 1 ? -1e-3 : 1e-3);
        const double y = i == n ? 0.0 : s.sine * std::sin(std::numbers::pi * i / n) + zigzag;
        const double dx = std::sqrt(l * l - (y - y0) * (y - y0));
        nodes.push_back(nodes.back() + Vec3(dx, y - y0, 0.0));
        y0 = y;
    }
    const Vec3 half(40.0, 9.0, 4.0);
    const int ship2 = add(s, box(kShipMass, half, nodes.front() - 40.0 * Vec3::UnitX()));
    const int ship1 = add(s, box(kShipMass, half, nodes.back() + 40.0 * Vec3::UnitX()));
    s.cable_first = static_cast<int>(s.bodies.size());
    s.cable_links = n;
    chain(s, ship2, ship1, nodes, mass, 0.04);
    s.thrusts.push_back({ship1, thrust * Vec3::UnitX()});
    float_hull(s, ship1, kShipHeave);
    float_hull(s, ship2, kShipHeave);
    s.towed = {ship2};
    const double all = 2.0 * kShipMass + n * mass;
    s.tension = thrust * kShipMass / all;
    s.sine_omega = std::numbers::pi / (n * l) * std::sqrt(0.5 * thrust / (mass / l));
    s.layouts = {{"tree", {}}, {"ship 1 closed", {static_cast<int>(s.joints.size()) - 1}}};
    // Work of the thrust over the run: F x with x = F t^2 / (2 m).
    s.energy_scale = thrust * thrust * s.duration * s.duration / (2.0 * all);
    return s;
}

std::vector<Scene> all_scenes() {
    return {heavy_hook(), tow_zigzag(), mooring(), mooring_seabed(), box_stack(), box_stack_1e6()};
}

Scene scene_by_name(const std::string& name) {
    std::string known;
    for (Scene& s : all_scenes()) {
        if (s.name == name || s.code == name) return s;
        known += (known.empty() ? "" : ", ") + s.name;
    }
    throw std::invalid_argument("unknown scene '" + name + "': expected one of " + known);
}

void external_loads(const Scene& scene, const std::vector<BodyState>& states,
                    std::vector<Load>& loads) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        loads[i].force = -scene.bodies[i].drag * states[i].v;
        loads[i].torque.setZero();
    }
    for (const Thrust& t : scene.thrusts) loads[static_cast<std::size_t>(t.body)].force += t.force;
    for (const Floating& f : scene.floating) {
        const auto i = static_cast<std::size_t>(f.body);
        const BodyState& st = states[i];
        loads[i].force.z() -= f.heave_k * (st.x.z() - scene.bodies[i].start.x.z());
        loads[i].force.z() -= f.heave_c * st.v.z();
        const Vec3 up = st.q * Vec3::UnitZ();
        loads[i].torque += f.tilt_k * up.cross(Vec3::UnitZ());
        loads[i].torque -= f.tilt_c * Vec3(st.w.x(), st.w.y(), 0.0);
    }
}

}  // namespace hawser::bench
