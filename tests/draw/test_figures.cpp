// SPDX-License-Identifier: Apache-2.0
#include "draw/figures/block_graph.h"
#include "draw/figures/interaction_graph.h"
#include "draw/figures/matrix.h"
#include "draw/figures/panel.h"
#include "draw/svg.h"
#include "draw/xml_check.h"
#include "record/small_scene.h"

#include <numeric>

namespace hawser::test {

using draw::BlockGraph;

// Make the graph of bodies a, b, c, d in a row, joined by rows r (a b), s (b c), t (c d).
BlockGraph row_of_four() {
    BlockGraph g;
    g.size = {6, 3, 3, 6, 1, 2, 3};
    g.sign = {1, 1, 1, 1, -1, -1, -1};
    const std::vector<std::vector<std::int32_t>> near{{4},    {4, 5}, {5, 6}, {6},
                                                      {0, 1}, {1, 2}, {2, 3}};
    g.start.push_back(0);
    for (const auto& list : near) {
        g.adjacent.insert(g.adjacent.end(), list.begin(), list.end());
        g.start.push_back(static_cast<std::int32_t>(g.adjacent.size()));
    }
    g.origin = {0, 1, 2, 3, 4, 5, 6};
    g.part = {0, 0, 1, 1, -1, -1, -1};
    return g;
}

std::vector<std::int32_t> natural(const BlockGraph& g) {
    std::vector<std::int32_t> order(static_cast<std::size_t>(g.nodes()));
    std::iota(order.begin(), order.end(), 0);
    return order;
}

TEST(BlockGraphs, RowsThatAreCutStandInBothParts) {
    const BlockGraph split = draw::split_graph(row_of_four(), 2);
    EXPECT_EQ(split.origin, (std::vector<std::int32_t>{0, 1, 4, 5, 2, 3, 5, 6}));
    EXPECT_EQ(split.part, (std::vector<std::int32_t>{0, 0, 0, 0, 1, 1, 1, 1}));
    for (std::int32_t v = 0; v < split.nodes(); ++v)
        for (const std::int32_t u : split.neighbours(v))
            EXPECT_EQ(split.part[static_cast<std::size_t>(u)],
                      split.part[static_cast<std::size_t>(v)]);
    // The duplicate of s in the first part has b as its only neighbour.
    const auto near = split.neighbours(3);
    EXPECT_EQ(std::vector<std::int32_t>(near.begin(), near.end()), (std::vector<std::int32_t>{1}));
    const BlockGraph second = draw::part_graph(split, 1);
    EXPECT_EQ(second.origin, (std::vector<std::int32_t>{4, 5, 6, 7}));
    EXPECT_EQ(second.adjacent, (std::vector<std::int32_t>{2, 3, 3, 0, 0, 1}));
}

TEST(BlockGraphs, CountsAreThoseOfTheSolver) {
    const BlockGraph g = row_of_four();
    const auto order = natural(g);
    const auto factor = draw::factor_blocks(g.start, g.adjacent, order);
    const draw::MatrixCounts c = count(g, order, factor);
    BlockFactor f;
    f.analyse(draw::pattern_of(g), order);
    EXPECT_EQ(c.scalars, f.info().scalars);
    EXPECT_EQ(c.nodes, f.info().nodes);
    EXPECT_EQ(c.nnz, f.info().matrix_nnz);
    // Merged fronts contain additional zeros.
    EXPECT_LE(c.factor_nnz, f.info().factor_nnz);
    EXPECT_LE(c.flops, f.info().flops);
    // r fills in between a and b, then with s, and s with t: 1·2 + 2·3 scalars.
    EXPECT_EQ(c.factor_nnz - c.nnz, 8);
}

TEST(BlockGraphs, FollowASystem) {
    SmallScene scene;
    ASSERT_EQ(scene.world.step(), Status::ok);
    const SystemView view = scene.world.solver().matrix();
    const BlockGraph g = draw::block_graph_of_world(view);
    const draw::MatrixCounts c =
        count(g, view.order, draw::factor_blocks(g.start, g.adjacent, view.order));
    EXPECT_EQ(c.nnz, view.matrix_nnz);
    EXPECT_LE(c.factor_nnz, view.factor_nnz);
}

TEST(InteractionGraphs, HaveBodiesThatMoveAndWhatActsOnThem) {
    SmallScene scene;
    const draw::InteractionGraph g = draw::interaction_graph(scene.world);
    ASSERT_EQ(g.nodes.size(), 2u);
    ASSERT_EQ(g.edges.size(), 2u);
    EXPECT_EQ(g.nodes[0].degree, 2);
    EXPECT_EQ(g.nodes[1].degree, 1);
    EXPECT_EQ(g.edges[0].fixed.size(), 1u);
    EXPECT_EQ(g.edges[1].nodes, (std::vector<std::int32_t>{0, 1}));
}

TEST(FigurePages, HoldTheirPanelsAndAreXml) {
    SmallScene scene;
    BlockGraph g = row_of_four();
    const auto order = natural(g);
    const auto factor = draw::factor_blocks(g.start, g.adjacent, order);
    draw::InteractionGraph bodies = draw::interaction_graph(scene.world);
    bodies.edges[1].cut = bodies.nodes[1].separator = true;
    bodies.nodes[0].part = 1;
    const auto matrix =
        draw::draw_matrix(g, order, factor, {.title = "a < b", .notes = {"n = 24"}});
    const auto graph = draw::draw_graph(bodies, {.title = "cut graph", .notes = {}, .parts = true});
    const auto page = draw::make_page("Fig. 0", "of a test", {{&matrix, &graph}, {&matrix}});
    const XmlDocument d = XmlReader(draw::to_svg(page)).read();
    for (const char* text : {"a < b", "n = 24", "cut graph", "cut interaction", "part 2", "Fig. 0"})
        EXPECT_NE(std::find(d.texts.begin(), d.texts.end(), text), d.texts.end()) << text;
    for (const draw::Shape& shape : page.shapes)
        if (const auto* cells = std::get_if<draw::Cells>(&shape))
            for (const draw::Box& b : cells->boxes) {
                EXPECT_GE(b.x, 0.0);
                EXPECT_LE(b.right(), page.width);
                EXPECT_LE(b.bottom(), page.height);
            }
}

}  // namespace hawser::test
