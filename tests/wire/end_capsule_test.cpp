// SPDX-License-Identifier: Apache-2.0
/// Capsules of wires that extend to the attachments. No wire passes through an element next to a
/// fairlead; momentum and energy; bollards; pairs without contact; rejected definitions.
#include <hawser/hawser.h>

#include "support/random.h"
#include "support/tier.h"
#include "wire/capsule_wire.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace hawser::test {
namespace {

constexpr double kTick = 1.0 / 60.0;

/// Ends of a straight piece before and after a step [m].
using Swept = std::array<std::array<Vec3, 2>, 2>;

/// True if two pieces passed through each other: by bisection, the moment at which they are
/// coplanar and cross.
bool went_through(const Swept& a, const Swept& b) {
    const auto at = [](const Swept& s, double t) {
        return std::array<Vec3, 2>{s[0][0] + t * (s[1][0] - s[0][0]),
                                   s[0][1] + t * (s[1][1] - s[0][1])};
    };
    const auto volume = [&](double t) {
        const auto p = at(a, t), q = at(b, t);
        return (p[1] - p[0]).cross(q[1] - q[0]).dot(q[0] - p[0]);
    };
    constexpr int kParts = 32;
    for (int k = 0; k < kParts; ++k) {
        double low = static_cast<double>(k) / kParts, high = static_cast<double>(k + 1) / kParts;
        if ((volume(low) > 0.0) == (volume(high) > 0.0)) continue;
        for (int i = 0; i < 40; ++i) {
            const double middle = 0.5 * (low + high);
            ((volume(middle) > 0.0) == (volume(low) > 0.0) ? low : high) = middle;
        }
        const auto p = at(a, low), q = at(b, low);
        const Vec3 u = p[1] - p[0], v = q[1] - q[0], n = u.cross(v), from = q[0] - p[0];
        const double s = from.cross(v).dot(n), t = from.cross(u).dot(n), all = n.squaredNorm();
        if (s > 0.0 && s < all && t > 0.0 && t < all) return true;
    }
    return false;
}

/// A wire of two elements from a fairlead off the middle of a free hull to a buoy. Another one
/// between two weights is thrown at the element next to the fairlead. No gravity.
struct Thrown {
    World w{WorldDef{.step = kTick, .gravity = Vec3::Zero(), .contact_margin = 0.1}};
    BodyId hull{}, buoy{};
    WireId still{}, thrown{};

    explicit Thrown(Random& random) {
        const auto body = [&](const char* name, const Vec3& at, double mass, const Vec3& speed) {
            return w.add_body({.name = name,
                               .position = at,
                               .velocity = speed,
                               .mass = mass,
                               .inertia = Mat3::Identity() * mass});
        };
        const double pull = std::exp(random.uniform(8.0, 12.5));  // 3 to 270 kN
        const Vec3 fairlead(2.0, 1.0, 0.5);
        hull = body("hull", -fairlead, 2e5, Vec3::Zero());
        buoy = body("buoy", {20, 0, 0}, 2e4, Vec3::Zero());
        WireDef def = capsule_wire("still");
        def.from = hull;
        def.from_point = fairlead;
        def.to = buoy;
        def.elements = 4;
        def.length = 20.0 / (1.0 + pull / kCapsuleEA);
        still = w.wires().add(def);
        // Its middle hits the first element anywhere except at the hull, from any side.
        const Vec3 aim(random.uniform(0.3, 4.7), 0, 0);
        const double round = random.uniform(0.0, 6.283), lean = random.uniform(-0.5, 0.5);
        const Vec3 way = Vec3(0, std::cos(round), std::sin(round));
        const Vec3 along = Vec3(std::sin(lean), -std::cos(lean) * std::sin(round),
                                std::cos(lean) * std::cos(round));
        const Vec3 speed = -random.uniform(2.5, 20.0) * way;
        const Vec3 middle = aim + random.uniform(0.3, 1.0) * way;
        const double share = random.uniform(0.4, 0.6), length = 12.0;
        const Vec3 ends[2] = {middle - share * length * along,
                              middle + (1.0 - share) * length * along};
        WireDef other = def;
        other.name = "thrown";
        other.from = body("a", ends[0], 300.0, speed);
        other.from_point = Vec3::Zero();
        other.to = body("b", ends[1], 300.0, speed);
        other.elements = random.integer(3, 6);
        other.length = length;
        other.velocity = speed;
        thrown = w.wires().add(other);
    }
    [[nodiscard]] std::vector<std::array<Vec3, 2>> pieces(WireId wire) const {
        std::vector<std::array<Vec3, 2>> out;
        for (const InteractionId id : w.wires().elements(wire)) out.push_back(w.wires().ends(id));
        return out;
    }
    /// Return the kinetic and elastic energy, by forces [J].
    [[nodiscard]] double energy() const {
        double sum = w.energy().kinetic;
        for (const WireId wire : {still, thrown})
            for (const InteractionId id : w.wires().elements(wire)) {
                const double pull = w.force(id)[0];
                sum += 0.5 * pull * pull * w.interaction_def(id).get("length") / kCapsuleEA;
            }
        return sum;
    }
};

TEST(EndCapsules, LetNothingThroughBesideAFairlead) {
    Random random(first_seed(21));
    const int throws = by_tier(5, 100, 1000);
    int through = 0, touched = 0;
    double made = 0.0;
    for (int k = 0; k < throws; ++k) {
        Thrown d(random);
        bool hit = false;
        // Half a second, before the weights at the ends have come around.
        double first = 0.0;
        for (int i = 0; i < 30; ++i) {
            const auto before = std::pair(d.pieces(d.still), d.pieces(d.thrown));
            ASSERT_EQ(d.w.step(), Status::ok) << k << " " << i;
            const auto after = std::pair(d.pieces(d.still), d.pieces(d.thrown));
            for (std::size_t a = 0; a < after.first.size(); ++a)
                for (std::size_t b = 0; b < after.second.size(); ++b)
                    through += went_through({before.first[a], after.first[a]},
                                            {before.second[b], after.second[b]})
                                   ? 1
                                   : 0;
            for (const ContactView& c : d.w.contacts()) hit = hit || c.force.norm() > 0.0;
            // The first step finds the forces of the initial tension.
            if (i == 0) first = d.energy();
            made = std::max(made, d.energy() / first - 1.0);
        }
        touched += hit ? 1 : 0;
        EXPECT_NE(d.w.verdict().grade, Grade::wrong) << k;
    }
    std::printf("end capsules: %d of %d touched, %d went through, energy made %.2e\n", touched,
                throws, through, made);
    EXPECT_EQ(touched, throws);
    EXPECT_EQ(through, 0);
    // Limit of the monitors for single steps (docs/limits.md).
    EXPECT_LT(made, 0.01);
}

/// The momentum that a ball transfers to an element at a hull goes to node and hull: all of it, at
/// its lever arm.
TEST(EndCapsules, ShareMomentumBetweenLumpAndBody) {
    for (const double along : {0.1, 1.5, 4.9}) {
        World w({.step = kTick, .gravity = Vec3::Zero()});
        Mat3 inertia = Vec3(3e3, 5e3, 4e3).asDiagonal();
        const BodyId hull = w.add_body({.name = "hull",
                                        .position = {-1, 2, 0.5},
                                        .orientation = Quat(0.9, 0.1, -0.3, 0.2).normalized(),
                                        .mass = 2e3,
                                        .inertia = inertia});
        const Vec3 fairlead = w.local_point(hull, Vec3::Zero());
        const BodyId far = w.add_body(
            {.name = "far", .kind = BodyKind::lump, .position = {10, 0, 0}, .mass = 200.0});
        WireDef def = capsule_wire("wire");
        def.from = hull;
        def.from_point = fairlead;
        def.to = far;
        def.elements = 2;
        def.length = 12.0;  // slack: only the contact acts
        def.path = {{5, 0, 0}};
        def.consistent_mass = false;  // the whole mass is in the nodes
        def.radius = 0.05;
        (void)w.wires().add(def);
        const BodyId ball = w.add_body({.name = "ball",
                                        .position = {along, 0.02, 0.31},
                                        .velocity = {1.5, -0.5, -6.0},
                                        .angular_velocity = {2, 1, 0},
                                        .mass = 100.0,
                                        .inertia = Mat3::Identity() * 4.0});
        w.add_shape({.kind = ShapeKind::sphere, .body = ball, .radius = 0.25});
        const auto sums = [&](const std::vector<Vec3>& at) {
            std::pair<Vec3, Vec3> out(Vec3::Zero(), Vec3::Zero());
            for (std::size_t i = 0; i < w.bodies().size(); ++i) {
                const BodyId id = w.bodies()[i];
                const BodyDef& d = w.body_def(id);
                const Twist v = w.velocity(id);
                out.first += d.mass * v.linear;
                out.second += at[i].cross(d.mass * v.linear);
            }
            return out;
        };
        std::vector<Vec3> at;
        for (const BodyId id : w.bodies()) at.push_back(w.pose(id).position);
        const Vec3 spun = w.velocity(ball).angular;
        const auto before = sums(at);
        ASSERT_EQ(w.step(), Status::ok);
        double force = 0.0;
        for (const ContactView& c : w.contacts()) force += c.force.norm();
        EXPECT_GT(force, 1.0) << along;
        const auto after = sums(at);
        // Angular momentum: from the change of the angular velocities of hull and ball about their
        // centres, at the attitudes at the start of the step. The hull was at rest.
        const Mat3 turn = Quat(0.9, 0.1, -0.3, 0.2).normalized().toRotationMatrix();
        const Vec3 spin = turn * inertia * turn.transpose() * w.velocity(hull).angular +
                          4.0 * (w.velocity(ball).angular - spun);
        const Vec3 lost = after.second + spin - before.second;
        EXPECT_LT((after.first - before.first).norm(), 1e-9 * 600.0) << along;
        // Rotation of the hull within the step changes its angular momentum by a thousandth.
        EXPECT_LT(lost.norm(), 2e-3 * spin.norm()) << along;
        EXPECT_GT(w.velocity(hull).angular.norm(), 1e-6) << along;
    }
}

/// A bollard on which the wire's last element comes to lie: the element before the anchor.
TEST(EndCapsules, LayTheElementBeforeAnAnchorOverAPost) {
    World w({.step = kTick});
    const BodyId ground = w.add_body({.name = "ground", .kind = BodyKind::fixed});
    const BodyId tug =
        w.add_body({.name = "tug", .kind = BodyKind::kinematic, .position = {-14, 0, 1.5}});
    const BodyId anchor = w.add_body({.name = "anchor",
                                      .position = {4, 0, 1.5},
                                      .mass = 3e3,
                                      .inertia = Mat3::Identity() * 3e3,
                                      .angular_damping = Vec3::Constant(1e4)});
    WireDef def = capsule_wire("wire");
    def.from = tug;
    def.to = anchor;
    def.to_point = {-0.5, 0, 0};
    const double way = 17.5 / 3.0;
    def.path = {{-14 + way, 0, 1.5}, {-14 + 2 * way, 0, 1.5}};
    def.elements = 3;
    def.length = 17.5;
    def.drag = 60.0;
    const WireId wire = w.wires().add(def);
    const ShapeId pin = w.add_shape({.kind = ShapeKind::cylinder,
                                     .body = ground,
                                     .orientation = Quat(std::sqrt(0.5), std::sqrt(0.5), 0, 0),
                                     .radius = 0.5,
                                     .half_length = 2.0,
                                     .margin = 1.0});
    w.add(PostDef{.name = "post", .shape = pin, .friction = 0.2});
    double deepest = 0.0;
    const auto run = [&](int steps, double speed) {
        w.set_velocity(tug, {.linear = {speed, 0, 0}, .angular = Vec3::Zero()});
        for (int i = 0; i < steps; ++i) {
            ASSERT_EQ(w.step(), Status::ok) << w.time();
            for (const InteractionId id : w.wires().elements(wire)) {
                const std::array<Vec3, 2> ends = w.wires().ends(id);
                const Vec3 along = ends[1] - ends[0];
                const double t = std::clamp(-ends[0].dot(along) / along.squaredNorm(), 0.0, 1.0);
                const Vec3 near = ends[0] + t * along;
                deepest = std::max(deepest, 0.5 + kCapsuleRadius - std::hypot(near.x(), near.z()));
            }
        }
    };
    run(600, 0.0);
    EXPECT_EQ(w.system_signal("post.held"), 1.0);
    run(300, -0.5);
    std::printf("anchor over a post: %.4f m into it at most\n", deepest);
    // Compression of a contact of 1e8 N/m by the falling wire, and the sagitta that the straight
    // parts at a contact node cut off.
    EXPECT_LT(deepest, 0.02);
    EXPECT_LT(w.pose(anchor).position.z(), 0.0) << "it hangs";
    EXPECT_GT(w.pose(anchor).position.x(), 0.0) << "on its side of the post";
}

/// Two wires that end at one point of a hull have no contact with each other or with the hull.
TEST(EndCapsules, LeaveAloneWhatHoldsThem) {
    World w({.step = kTick, .gravity = Vec3::Zero()});
    const BodyId hull = w.add_body(
        {.name = "hull", .mass = 1e5, .inertia = Mat3::Identity() * 1e5, .half_size = {4, 2, 1}});
    w.add_shape({.kind = ShapeKind::box, .body = hull, .half_size = {4, 2, 1}});
    for (const double side : {-1.0, 1.0}) {
        const BodyId far = w.add_body({.name = side < 0 ? "left" : "right",
                                       .kind = BodyKind::fixed,
                                       .position = {14, side, 0}});
        WireDef def = capsule_wire(side < 0 ? "l" : "r");
        def.from = hull;
        def.from_point = {3.5, 0, 0};
        def.to = far;
        def.to_point = {0, 0.1, 0};
        def.elements = 2;
        def.consistent_mass = false;
        (void)w.wires().add(def);
    }
    for (int i = 0; i < 60; ++i) {
        ASSERT_EQ(w.step(), Status::ok);
        for (const ContactView& c : w.contacts()) EXPECT_EQ(c.force.norm(), 0.0) << i;
    }
    EXPECT_LT(w.velocity(hull).linear.norm(), 1e-9);
}

TEST(EndCapsules, NeedARadius) {
    World w;
    const BodyId ground = w.add_body({.name = "ground", .kind = BodyKind::fixed});
    WireDef def = capsule_wire("wire");
    def.from = ground;
    def.elements = 3;
    def.length = 3.0;
    def.radius = 0.0;
    try {
        (void)w.wires().add(def);
        FAIL();
    } catch (const DefError& error) {
        EXPECT_NE(std::string(error.what()).find("radius"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace hawser::test
