// SPDX-License-Identifier: Apache-2.0
/// Bollards and guides within two elements of each other: wires come to lie on all of them, slide
/// over them at Euler's ratio, and lift off; none is passed through.
#include <hawser/catenary.h>
#include <hawser/hawser.h>

#include "support/bits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace hawser {
namespace {

constexpr double kLinear = 23.0, kRowEA = 2.33e8, kThick = 0.038;  // kg/m, N, m
constexpr double kPostRadius = 0.3, kRowFriction = 0.2;            // m

/// A wire of elements of 3 m that hangs between two carriers, above bollards across it.
struct PostRow {
    World w;
    BodyId ground{}, left{}, right{};
    WireId wire{};
    std::vector<std::string> names;
    std::vector<Vec3> places;

    explicit PostRow(const std::vector<double>& posts, int threads = 1)
        : w(WorldDef{.step = 1.0 / 60.0, .threads = threads}) {
        constexpr double kLength = 42.0, kHeight = 7.0;
        constexpr int kElements = 14;
        CatenaryDef shape;
        shape.from = {-20, 0, kHeight};
        shape.to = {20, 0, kHeight};
        shape.sections = {{kLength, kLinear * 9.81, kRowEA, kElements}};
        const Catenary start = catenary(shape);
        ground = w.add_body({.name = "ground", .kind = BodyKind::fixed});
        left = w.add_body({.name = "left", .kind = BodyKind::kinematic, .position = shape.from});
        right = w.add_body({.name = "right", .kind = BodyKind::kinematic, .position = shape.to});
        WireDef def{.name = "wire", .from = left, .to = right};
        def.elements = kElements;
        def.length = kLength;
        def.EA = kRowEA;
        def.mass_per_length = kLinear;
        def.drag = 60.0;
        def.consistent_mass = true;
        def.radius = kThick;
        def.path.assign(start.nodes.begin() + 1, start.nodes.end() - 1);
        wire = w.wires().add(def);
        for (const double x : posts) {
            names.push_back("post" + std::to_string(names.size()));
            places.push_back({x, 0, 0});
            const ShapeId pin =
                w.add_shape({.kind = ShapeKind::cylinder,
                             .body = ground,
                             .position = {x, 0, 0},
                             .orientation = Quat(std::sqrt(0.5), std::sqrt(0.5), 0, 0),
                             .radius = kPostRadius,
                             .half_length = 2.0,
                             .margin = 1.0});
            w.add(PostDef{.name = names.back(), .shape = pin, .friction = kRowFriction});
        }
    }
    [[nodiscard]] double get(std::size_t post, const char* signal) const {
        return w.system_signal(names[post] + "." + signal);
    }
    [[nodiscard]] double all(const char* signal) const {
        double sum = 0.0;
        for (std::size_t k = 0; k < names.size(); ++k) sum += get(k, signal);
        return sum;
    }
    /// Return the largest depth of the wire's middle under the surface of a bollard [m].
    [[nodiscard]] double sunk() const {
        double out = 0.0;
        for (const InteractionId id : w.wires().elements(wire)) {
            const std::array<Vec3, 2> ends = w.wires().ends(id);
            const Vec3 d = ends[1] - ends[0];
            for (const Vec3& at : places) {
                const double t = std::clamp((at - ends[0]).dot(d) / d.squaredNorm(), 0.0, 1.0);
                out = std::max(out, kPostRadius + kThick - (ends[0] + t * d - at).norm());
            }
        }
        return out;
    }
    /// Move both ends by a distance within a time. @return the largest sunk().
    double move(const Vec3& by, double seconds) {
        double worst = 0.0;
        const auto steps = static_cast<int>(std::lround(60.0 * seconds));
        for (const BodyId id : {left, right}) w.set_velocity(id, {by / seconds, Vec3::Zero()});
        for (int i = 0; i < steps; ++i) {
            EXPECT_EQ(w.step(), Status::ok) << w.time();
            EXPECT_LT(w.stats().momentum_residual, 1e-8) << w.time();
            worst = std::max(worst, sunk());
        }
        for (const BodyId id : {left, right}) w.set_velocity(id, {});
        return worst;
    }
    /// Return the mass of nodes and of loads of their elements [kg].
    [[nodiscard]] double mass() {
        double sum = 0.0;
        for (const BodyId id : w.wires().nodes(wire))
            if (w.body_def(id).kind == BodyKind::lump) sum += w.body_def(id).mass;
        const auto elements = w.wires().elements(wire);
        for (const InteractionId end : {elements.front(), elements.back()})
            sum += 0.5 * w.interaction_def(end).get("mass");
        for (const InteractionId id : elements)
            for (int k = 0; k < w.system_count(); ++k) sum += w.system(k).carried_mass(id);
        return sum;
    }
};

TEST(NearPosts, TakeOneWireEachAndLetItGo) {
    for (const std::vector<double>& posts :
         {std::vector<double>{-0.75, 0.75}, {0.0, 3.0}, {-0.4, 0.6}, {-1.5, 0.0, 1.5}}) {
        PostRow d(posts);
        const double mass = d.mass(), distance = posts[1] - posts[0];
        const std::size_t had = d.w.wires().elements(d.wire).size();
        double sunk = d.move({0, 0, -4}, 8.0);
        sunk = std::max(sunk, d.move({0, 0, 0}, 12.0));
        EXPECT_EQ(d.all("held"), static_cast<double>(posts.size())) << distance;
        EXPECT_LE(d.all("taken"), static_cast<double>(posts.size()) + 1.0) << distance;
        EXPECT_NEAR(d.mass(), mass, 1e-9 * mass) << distance;
        // Pulled along, it slides over all of them, and nodes pass.
        sunk = std::max(sunk, d.move({6, 0, 0}, 24.0));
        double angle = 0.0;
        for (std::size_t k = 0; k < posts.size(); ++k) {
            angle += d.get(k, "angle");
            EXPECT_GT(d.get(k, "slide"), 2.0) << distance;
            // As at guides: the weight of half an element is not at the point of its tension.
            EXPECT_NEAR(d.get(k, "behind") / d.get(k, "before") /
                            std::exp(kRowFriction * d.get(k, "angle")),
                        1.0, 5e-3)
                << distance;
        }
        EXPECT_NEAR(
            d.get(posts.size() - 1, "behind") / d.get(0, "before") / std::exp(kRowFriction * angle),
            1.0, 2e-2)
            << "and of what hangs between them";
        EXPECT_NEAR(d.mass(), mass, 1e-9 * mass) << distance;
        // If one element touches several bollards, a node inserted between them hangs under it by m
        // g l/4T: 0.05 m of 40 kg over 3 m at 6 kN. Contacts lift it again.
        EXPECT_LT(sunk, posts.size() > 2 ? 0.06 : 5e-3) << distance;
        d.move({-6, 0, 4}, 12.0);
        d.move({0, 0, 0}, 10.0);
        EXPECT_EQ(d.all("held"), 0.0) << distance;
        EXPECT_NEAR(d.mass(), mass, 1e-9 * mass) << distance;
        // Nodes inserted between bollards remain.
        EXPECT_LE(d.w.wires().elements(d.wire).size(), had + 2 * posts.size()) << distance;
        for (const InteractionId id : d.w.wires().elements(d.wire))
            EXPECT_EQ(d.w.interaction_def(id).kind, InteractionKind::Stretch);
        EXPECT_NE(d.w.verdict().grade, Grade::wrong) << distance;
        std::printf("%zu posts, %.1f m apart: sunk by %.1e m, %zu elements of %zu\n", posts.size(),
                    distance, sunk, d.w.wires().elements(d.wire).size(), had);
    }
}

TEST(NearPosts, GiveTheSameBitsOnAnyThreadsAndAfterRestoring) {
    const auto drive = [](PostRow& d, int i) {
        const Vec3 velocity = i < 480    ? Vec3(0, 0, -0.5)
                              : i < 1080 ? Vec3(0.3, 0, 0)
                                         : Vec3(0, 0, 0.5);
        for (const BodyId id : {d.left, d.right}) d.w.set_velocity(id, {velocity, Vec3::Zero()});
    };
    test::expect_same_bits(
        {.steps = 1560, .restored = {200, 300, 700, 1200}},
        [](int threads) { return PostRow({-0.75, 0.75}, threads); }, drive,
        [](const PostRow& d) { EXPECT_NE(d.w.verdict().grade, Grade::wrong); });
}

/// Guides have a node between them: without one, the wire would be pulled over from another
/// element.
TEST(NearGuides, ShareNoElement) {
    PostRow d({});
    // The middle of an element, and beside it.
    const InteractionId element = d.w.wires().elements(d.wire)[5];
    const std::array<Vec3, 2> ends = d.w.wires().ends(element);
    const auto at = [&](double share) { return Vec3(ends[0] + share * (ends[1] - ends[0])); };
    const auto add = [&](const char* name, double share) -> std::string {
        try {
            d.w.add(GuideDef{.name = name, .wire = d.wire, .body = d.ground, .point = at(share)});
        } catch (const DefError& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(add("one", 0.4), "");
    EXPECT_NE(add("two", 0.6).find("an element of another guide"), std::string::npos)
        << add("two", 0.6);
    // In the next element, there is a node between them.
    EXPECT_EQ(add("two", 1.4), "");
}

/// Two eyes slightly more than an element apart, with the wire pulled through both.
TEST(NearGuides, NodesRunThroughBoth) {
    PostRow d({});
    std::array<InteractionId, 2> at{};
    std::copy_n(d.w.wires().elements(d.wire).begin() + 6, 2, at.begin());
    for (const std::size_t k : {0U, 1U}) {
        const std::array<Vec3, 2> ends = d.w.wires().ends(at[k]);
        d.w.add(GuideDef{.name = k == 0 ? "one" : "two",
                         .wire = d.wire,
                         .element = at[k],
                         .body = d.ground,
                         .point = ends[0] + 0.4 * (ends[1] - ends[0]),
                         .friction = kRowFriction});
    }
    const double mass = d.mass();
    d.move({0, 0, -0.5}, 4.0);
    d.move({8, 0, 0}, 32.0);
    for (const char* name : {"one", "two"}) {
        const std::string eye = name;
        EXPECT_GT(d.w.system_signal(eye + ".slide"), 6.0) << eye;
        EXPECT_NEAR(d.w.system_signal(eye + ".behind") / d.w.system_signal(eye + ".before") /
                        std::exp(kRowFriction * d.w.system_signal(eye + ".angle")),
                    1.0, 5e-3)
            << eye;
    }
    EXPECT_NEAR(d.mass(), mass, 1e-9 * mass);
    EXPECT_NE(d.w.verdict().grade, Grade::wrong);
}

}  // namespace
}  // namespace hawser
