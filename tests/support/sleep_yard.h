// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file sleep_yard.h
/// A world of islands that come to rest.

#include <gtest/gtest.h>

#include <hawser/hawser.h>

#include <string>
#include <vector>

namespace hawser::test {

/// Four islands: a stack of three boxes, a ball with rolling resistance, a hanging wire, a slide
/// with a brake on a slope.
struct SleepYard {
    World w;
    BodyId ground{}, box[3], ball{}, node[4], slide{}, anchor{};
    InputId brake{}, push{};

    explicit SleepYard(const WorldDef& def) : w(def) {
        BodyDef fixed;
        fixed.kind = BodyKind::fixed;
        fixed.name = "ground";
        ground = w.add_body(fixed);
        const bool rolling = def.nonsmooth == Nonsmooth::newton;
        MaterialDef m;
        m.name = "felt";
        m.friction = 0.6;
        m.stiffness = 1e7;
        m.rolling = rolling ? 0.05 : 0.0;
        const MaterialId felt = w.add_material(m);
        ShapeDef plane;
        plane.kind = ShapeKind::plane;
        plane.body = ground;
        plane.material = felt;
        w.add_shape(plane);
        for (int i = 0; i < 3; ++i) box[i] = add_box({0.0, 0.0, 0.5 + 1.0 * i});
        BodyDef round;
        round.name = "ball";
        round.mass = 10.0;
        round.inertia = 0.4 * 10.0 * 0.25 * Mat3::Identity();
        round.position = {5.0, 0.0, 0.5};
        round.velocity = {0.3, 0.0, 0.0};
        if (!rolling) round.velocity.setZero();
        ball = w.add_body(round);
        ShapeDef sphere;
        sphere.radius = 0.5;
        sphere.body = ball;
        sphere.material = felt;
        w.add_shape(sphere);
        add_wire();
        add_slide();
    }

    BodyId add_box(const Vec3& at) {
        BodyDef d;
        d.mass = 100.0;
        d.inertia = 100.0 / 6.0 * Mat3::Identity();
        d.position = at;
        const BodyId id = w.add_body(d);
        ShapeDef s;
        s.kind = ShapeKind::box;
        s.half_size = {0.5, 0.5, 0.5};
        s.body = id;
        w.add_shape(s);
        return id;
    }

    void add_wire() {
        BodyId last = ground;
        for (int i = 0; i < 4; ++i) {
            BodyDef d;
            d.kind = BodyKind::lump;
            d.mass = 2.0;
            d.position = {10.0, 0.0, 9.0 - i};
            d.linear_damping = {40.0, 40.0, 40.0};
            node[i] = w.add_body(d);
            InteractionDef s;
            s.kind = InteractionKind::Stretch;
            s.body = {last, node[i]};
            if (i == 0) s.point[0] = {10.0, 0.0, 10.0};
            s.set("EA", 1e6);
            w.add_interaction(s);
            last = node[i];
        }
    }

    void add_slide() {
        BodyDef d;
        d.mass = 20.0;
        d.inertia = Mat3::Identity();
        d.position = {20.0, 0.0, 5.0};
        slide = w.add_body(d);
        InteractionDef p;
        p.kind = InteractionKind::Prismatic;
        p.body = {ground, slide};
        p.point[0] = d.position;
        // z of the frames is tilted by 45 degrees.
        p.frame[0] = p.frame[1] = Quat(Eigen::AngleAxisd(0.785398163, Vec3::UnitY()));
        w.add_interaction(p);
        InteractionDef f = p;
        f.kind = InteractionKind::SlideFriction;
        f.compliance.fill(kDefault);
        f.damping_time.fill(kDefault);
        f.params.fill(kDefault);
        f.name = "brake";
        f.set("force", 300.0);
        const InteractionId held = w.add_interaction(f);
        InputDef in;
        in.name = "brake";
        in.interaction = held;
        in.param = "force";
        brake = w.add_input(in);
        InputDef thrust;
        thrust.name = "push";
        thrust.body = node[3];
        push = w.add_input(thrust);
    }

    void run(int steps) {
        for (int i = 0; i < steps; ++i) ASSERT_EQ(w.step(), Status::ok) << i;
    }
    [[nodiscard]] std::vector<BodyId> moving() const {
        return {box[0], box[1], box[2], ball, node[0], node[1], node[2], node[3], slide};
    }
    [[nodiscard]] std::vector<double> state() const {
        std::vector<double> out;
        const auto add = [&](const auto& a) {
            out.insert(out.end(), a.data(), a.data() + a.size());
        };
        for (const BodyId id : moving()) {
            add(w.pose(id).position);
            add(w.pose(id).orientation.coeffs());
            add(w.velocity(id).linear);
            add(w.velocity(id).angular);
        }
        return out;
    }
    [[nodiscard]] std::string asleep() const {
        std::string out;
        for (const BodyId id : moving()) out += w.asleep(id) ? 'z' : '.';
        return out;
    }
};

}  // namespace hawser::test
