// SPDX-License-Identifier: Apache-2.0
// Nodes inserted and removed on lines in water: momentum of the line and of the water that it
// carries.
#include <hawser/hawser.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

namespace hawser::test::line_edits {
namespace {

constexpr double kRho = 1025.0, kDiameter = 0.14;
/// Rope with four times its mass of added water, and chain with an eighth.
constexpr std::array<double, 2> kMass{4.0, 120.0};  // kg/m
constexpr int kOfEach = 10;                         // elements

/// One wire of both types in still water without drag, free and far below the surface.
struct Line {
    World w{WorldDef{.step = 0.01}};
    WireId wire{};

    Line() {
        const BodyId first =
            w.add_body({.kind = BodyKind::lump, .position = {0, 0, -100}, .mass = 0.5 * kMass[0]});
        WireDef def{.name = "line", .from = first, .consistent_mass = true};
        for (const double mass : kMass)
            def.sections.push_back(
                {.elements = kOfEach, .length = kOfEach, .EA = 1e7, .mass_per_length = mass});
        for (int i = 1; i <= 2 * kOfEach; ++i)
            def.path.emplace_back(0.02 * std::sin(0.3 * i), 0.0, -100.0 - 1.002 * i);
        wire = w.wires().add(def);
        const LineWater water{.diameter = kDiameter, .cd_normal = 0.0, .cd_tangential = 0.0};
        SeaDef sea{.depth = 1000.0};
        sea.lines.push_back({.wire = wire,
                             .sections = {{kOfEach, water}, {kOfEach, water}},
                             .free_first = true,
                             .free_last = true});
        w.add(sea);
        EXPECT_EQ(w.step(), Status::ok);
        double s = 0.0;
        for (const BodyId id : w.wires().nodes(wire)) {
            w.set_velocity(
                id, {Vec3(0.3 * std::sin(0.2 * s), 0.2 * std::cos(0.15 * s), 0.0), Vec3::Zero()});
            s += 1.0;
        }
    }

    /// Compute Σ (m + A) v, each half element with ρ V across it, from docs/theory/drag.md.
    [[nodiscard]] Vec3 momentum(double* size = nullptr) const {
        const double per_length = kRho * 0.25 * std::numbers::pi * kDiameter * kDiameter;
        Vec3 sum = Vec3::Zero();
        const auto nodes = w.wires().nodes(wire);
        const auto elements = w.wires().elements(wire);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const Vec3 v = w.velocity(nodes[i]).linear;
            Vec3 own = w.body_def(nodes[i]).mass * v;
            for (const int side : {-1, 1}) {
                if ((side < 0 && i == 0) || (side > 0 && i + 1 == nodes.size())) continue;
                const std::size_t e = side < 0 ? i - 1 : i, other = side < 0 ? i - 1 : i + 1;
                const Vec3 t =
                    (w.pose(nodes[other]).position - w.pose(nodes[i]).position).normalized();
                const double half = 0.5 * w.interaction_def(elements[e]).get("length");
                own += per_length * half * (v - t * t.dot(v));
            }
            sum += own;
            if (size != nullptr) *size += own.norm();
        }
        return sum;
    }
};

/// Return the lost momentum over the momentum of all nodes.
double lost(const Line& line, const Vec3& before) {
    double size = 0.0;
    const Vec3 after = line.momentum(&size);
    return (after - before).norm() / size;
}

TEST(LineEdits, NodesThatComeKeepMomentumWithAddedMass) {
    for (const std::size_t element : {std::size_t{3}, std::size_t{9}, std::size_t{10}}) {
        Line line;
        const Vec3 before = line.momentum();
        ASSERT_TRUE(
            line.w.wires().insert_node(line.w.wires().elements(line.wire)[element], 0.3).valid());
        const double off = lost(line, before);
        std::printf("a node comes on element %zu: %.2g of the momentum\n", element, off);
        EXPECT_LT(off, 1e-6);
    }
}

/// Remove a node. @param node  The node. @return fraction of momentum lost with it.
double lost_with(std::size_t node) {
    Line line;
    const Vec3 before = line.momentum();
    EXPECT_TRUE(line.w.wires().remove_node(line.w.wires().nodes(line.wire)[node], 3.15)) << node;
    const double off = lost(line, before);
    std::printf("node %zu goes: %.2g of the momentum\n", node, off);
    return off;
}

/// Four elements on each side share the mass of a removed node. The water moves with the mass,
/// except for the rotation of the elements' directions at a bend of 2e-3 rad: water is carried
/// across them.
TEST(LineEdits, NodesThatGoFarFromOtherLineTypesKeepMomentumWithAddedMass) {
    EXPECT_LT(lost_with(4), 3e-6);
    EXPECT_LT(lost_with(16), 3e-6);
}

/// Nearer to the other line type, momentum of the masses is kept and that of the water is not
/// (docs/theory/sea_loads.md). This measures the loss, with water of four times and an eighth of
/// the mass.
TEST(LineEdits, NodesThatGoNearOtherLineTypesLoseAThousandth) {
    for (const std::size_t node : {std::size_t{7}, std::size_t{9}, std::size_t{11}})
        EXPECT_LT(lost_with(node), 2e-3);
}

}  // namespace
}  // namespace hawser::test::line_edits
