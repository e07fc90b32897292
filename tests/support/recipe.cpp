// SPDX-License-Identifier: Apache-2.0
#include "support/recipe.h"

namespace hawser::test {
namespace {

constexpr InteractionKind kJoints[] = {InteractionKind::Ball,      InteractionKind::Hinge,
                                       InteractionKind::Prismatic, InteractionKind::Cylindrical,
                                       InteractionKind::Universal, InteractionKind::Lock,
                                       InteractionKind::Distance};

/// Set z of frame 1 of a universal joint perpendicular to z of frame 0.
void square_axes(InteractionDef& d) {
    if (d.kind == InteractionKind::Universal)
        d.frame[1] = d.frame[1] * Quat(Eigen::AngleAxisd(EIGEN_PI / 2, Vec3::UnitX()));
}

BodyId random_rigid(Recipe& r, Random& random, const Vec3& x) {
    const double m = random.uniform(1.0, 50.0);
    const double a = random.uniform(0.3, 1.0), b = random.uniform(0.3, 1.0),
                 c = random.uniform(0.3, 1.0);
    const BodyId id = r.rigid(x, random.rotation(), m,
                              m / 12.0 * Vec3(b * b + c * c, a * a + c * c, a * a + b * b));
    BodyDef& def = r.bodies[static_cast<std::size_t>(id.index)];
    def.velocity = random.vector(0.5);
    def.angular_velocity = random.vector(1.0);
    def.force = random.vector(20.0);
    def.torque = random.vector(2.0);
    if (random.chance(0.5)) def.linear_damping = {1.0, 2.0, 3.0};
    if (random.chance(0.5)) def.angular_damping = {0.1, 0.2, 0.3};
    return id;
}

/// Add joints between a random earlier body and each new one, drives on some of them.
std::vector<BodyId> add_links(Recipe& r, Random& random, int links, BodyId root) {
    std::vector<BodyId> tree{root};
    for (int i = 0; i < links; ++i) {
        const BodyId parent =
            tree[static_cast<std::size_t>(random.integer(0, static_cast<int>(tree.size()) - 1))];
        const Vec3 from = r.bodies[static_cast<std::size_t>(parent.index)].position;
        const BodyId child = random_rigid(r, random, from + random.vector(2.0));
        const InteractionKind kind = kJoints[random.integer(0, 6)];
        const Quat frame = random.rotation();
        const Vec3 to = r.bodies[static_cast<std::size_t>(child.index)].position;
        InteractionDef d = r.at(kind, {parent, child}, 0.5 * (from + to), frame);
        if (kind == InteractionKind::Distance) d.point[0] = d.point[1] = Vec3(0.1, 0.2, 0.0);
        square_axes(d);
        r.add(d);
        if (kind == InteractionKind::Hinge) {
            InteractionDef motor = r.at(InteractionKind::HingeMotor, {parent, child}, to, frame);
            motor.compliance[0] = 1e-3;
            r.add(motor.set("speed", 0.3));
            InteractionDef range = r.at(InteractionKind::HingeRange, {parent, child}, to, frame);
            r.add(range.set("min", -2.0).set("max", -0.01));
        }
        if (kind == InteractionKind::Prismatic) {
            InteractionDef motor = r.at(InteractionKind::SlideMotor, {parent, child}, to, frame);
            motor.compliance[0] = 1e-3;
            r.add(motor.set("speed", 0.2));
            InteractionDef range = r.at(InteractionKind::SlideRange, {parent, child}, to, frame);
            r.add(range.set("min", 0.01).set("max", 1.0));
        }
        tree.push_back(child);
    }
    return tree;
}

/// Add a wire from `end`, paid out by a scalar drum, with bending stiffness.
void add_wire(Recipe& r, Random& random, BodyId end) {
    const Vec3 from = r.bodies[static_cast<std::size_t>(end.index)].position;
    std::vector<BodyId> node{end};
    for (int i = 1; i <= 4; ++i)
        node.push_back(r.lump(from + Vec3(1.0 * i, 0.1 * i * i, -0.2 * i) + random.vector(0.05),
                              random.uniform(0.5, 5.0)));
    const BodyId drum = r.scalar(0.3, 2.0);
    for (std::size_t i = 0; i + 1 < node.size(); ++i) {
        const bool winch = i == 0;
        InteractionDef d =
            winch ? between(InteractionKind::WinchStretch, {node[i], node[i + 1], drum})
                  : between(InteractionKind::Stretch, {node[i], node[i + 1]});
        if (winch) d.set("radius", 0.2);
        r.add(d.set("EA", 1e5).set("length", 1.0).set("breaking_load", 1e9));
    }
    for (std::size_t i = 0; i + 2 < node.size(); ++i) {
        InteractionDef d = between(InteractionKind::Bend, {node[i], node[i + 1], node[i + 2]});
        r.add(d.set("EI", 50.0).set("length", 1.0));
    }
    InteractionDef drive = between(InteractionKind::ScalarMotor, {drum});
    drive.compliance[0] = 1e-2;
    r.add(drive.set("speed", 0.5));
    const BodyId spool = r.scalar(1.0, 1.0);
    InteractionDef other = between(InteractionKind::WinchStretch, {node.back(), r.ground(), spool});
    r.add(other.set("radius", 0.1).set("EA", 1e4));
    r.add(between(InteractionKind::Hold, {spool}));
}

}  // namespace

Recipe mixed(std::uint64_t seed, int links) {
    Random random(seed);
    Recipe r;
    const BodyId carriage = r.add({.name = "carriage",
                                   .kind = BodyKind::kinematic,
                                   .position = {0, 0, 5},
                                   .velocity = {0.1, 0, 0.05},
                                   .angular_velocity = {0, 0, 0.2}});
    const std::vector<BodyId> tree = add_links(r, random, links, carriage);
    const BodyId hull = tree.back();
    InteractionDef water = between(InteractionKind::Hydrostatic, {hull});
    r.add(water.set("heave_stiffness", 2e3)
              .set("roll_stiffness", 5e2)
              .set("pitch_stiffness", 5e2)
              .set("heave_damping", 1e2));
    InteractionDef twist =
        r.at(InteractionKind::Twist, {tree[tree.size() - 2], hull}, {0, 0, 0}, random.rotation());
    r.add(twist.set("GJ", 30.0).set("length", 1.0));
    add_wire(r, random, hull);
    return r;
}

Recipe chains(std::uint64_t seed, int count, int links) {
    Random random(seed);
    Recipe r;
    const BodyId ground = r.ground();
    std::vector<BodyId> end;
    std::vector<Vec3> tip;
    for (int c = 0; c < count; ++c) {
        BodyId last = ground;
        Vec3 joint(8.0 * c, 0, 0);
        for (int i = 0; i < links; ++i) {
            const Vec3 next = joint + Vec3(0.6, 0.2, 0.5) + random.vector(0.4);
            const BodyId link = random_rigid(r, random, 0.5 * (joint + next) + random.vector(0.1));
            if (c % 2 == 0)
                r.add(r.at(InteractionKind::Ball, {last, link}, joint));
            else
                r.add(r.at(InteractionKind::Ball, {link, last}, joint));
            last = link;
            joint = next;
        }
        end.push_back(last);
        tip.push_back(joint);
    }
    const BodyId hull = random_rigid(r, random, tip.front() + Vec3(1, 1, 1));
    for (std::size_t c = 0; c < end.size(); ++c)
        r.add(r.at(InteractionKind::Ball, {end[c], hull}, tip[c]));
    return r;
}

}  // namespace hawser::test
