// SPDX-License-Identifier: Apache-2.0
#include "draw/figures/block_graph.h"

#include "draw/figures/index.h"

#include <algorithm>

namespace hawser::draw {
namespace {

/// Return the subgraph of the nodes in `chosen`, in their new order.
BlockGraph induced_subgraph(const BlockGraph& from, std::span<const std::int32_t> chosen,
                            std::vector<std::int32_t>& number) {
    BlockGraph out;
    number.assign(from.size.size(), -1);
    for (std::size_t k = 0; k < chosen.size(); ++k)
        number[at(chosen[k])] = static_cast<std::int32_t>(k);
    out.start.push_back(0);
    for (const std::int32_t node : chosen) {
        out.size.push_back(from.size[at(node)]);
        out.sign.push_back(from.sign[at(node)]);
        out.origin.push_back(node);
        for (const std::int32_t other : from.neighbours(node))
            if (number[at(other)] >= 0) out.adjacent.push_back(number[at(other)]);
        std::sort(out.adjacent.begin() + out.start.back(), out.adjacent.end());
        out.start.push_back(static_cast<std::int32_t>(out.adjacent.size()));
    }
    return out;
}

}  // namespace

BlockGraph block_graph_of_world(const SystemView& view,
                                std::span<const std::int32_t> part_of_body) {
    BlockGraph g;
    g.start = view.edge_start;
    g.adjacent = view.edges;
    for (std::size_t i = 0; i < view.nodes.size(); ++i) {
        const SystemNode& node = view.nodes[i];
        g.size.push_back(static_cast<std::int8_t>(node.size));
        g.sign.push_back(node.body.valid() ? 1 : -1);
        g.origin.push_back(static_cast<std::int32_t>(i));
        const bool known = node.body.valid() && !part_of_body.empty();
        g.part.push_back(known ? std::max(-1, part_of_body[at(node.body.index)]) : -1);
    }
    return g;
}

BlockGraph split_graph(const BlockGraph& whole, std::int32_t parts) {
    BlockGraph out;
    out.start.push_back(0);
    std::vector<std::int32_t> number, chosen;
    for (std::int32_t p = 0; p < parts; ++p) {
        chosen.clear();
        for (std::int32_t v = 0; v < whole.nodes(); ++v)
            if (whole.sign[at(v)] > 0 && whole.part[at(v)] == p) chosen.push_back(v);
        for (std::int32_t v = 0; v < whole.nodes(); ++v) {
            const auto near = whole.neighbours(v);
            if (whole.sign[at(v)] < 0 && std::any_of(
                                             near.begin(), near.end(),
                                             [&](std::int32_t b) {
                                                 return whole.sign[at(b)] > 0 &&
                                                        whole.part[at(b)] == p;
                                             }))
                chosen.push_back(v);
        }
        const BlockGraph piece = induced_subgraph(whole, chosen, number);
        const std::int32_t first = out.nodes();
        const auto base = static_cast<std::int32_t>(out.adjacent.size());
        out.size.insert(out.size.end(), piece.size.begin(), piece.size.end());
        out.sign.insert(out.sign.end(), piece.sign.begin(), piece.sign.end());
        out.origin.insert(out.origin.end(), piece.origin.begin(), piece.origin.end());
        out.part.insert(out.part.end(), piece.size.size(), p);
        for (const std::int32_t v : piece.adjacent) out.adjacent.push_back(first + v);
        for (std::size_t k = 1; k < piece.start.size(); ++k)
            out.start.push_back(base + piece.start[k]);
    }
    return out;
}

BlockGraph part_graph(const BlockGraph& split, std::int32_t part) {
    std::vector<std::int32_t> chosen, number;
    for (std::int32_t v = 0; v < split.nodes(); ++v)
        if (split.part[at(v)] == part) chosen.push_back(v);
    BlockGraph out = induced_subgraph(split, chosen, number);
    out.part.assign(out.size.size(), part);
    return out;
}

BlockPattern pattern_of(const BlockGraph& graph) {
    BlockPattern p{.size = graph.size, .sign = graph.sign, .edges = {}};
    for (std::int32_t v = 0; v < graph.nodes(); ++v)
        for (const std::int32_t u : graph.neighbours(v))
            if (u < v) p.edges.push_back({v, u});
    return p;
}

MatrixCounts count(const BlockGraph& graph, std::span<const std::int32_t> order,
                   const FactorBlocks& factor) {
    MatrixCounts c;
    c.nodes = graph.nodes();
    for (std::int32_t v = 0; v < graph.nodes(); ++v) {
        const std::int64_t s = graph.size[at(v)];
        c.scalars += s;
        c.nnz += s * (s + 1) / 2;
        for (const std::int32_t u : graph.neighbours(v))
            if (u < v) c.nnz += s * graph.size[at(u)];
    }
    for (std::size_t k = 0; k + 1 < factor.start.size(); ++k) {
        const std::int64_t s = graph.size[at(order[k])];
        std::int64_t below = 0;
        for (std::int64_t e = factor.start[k]; e < factor.start[k + 1]; ++e)
            below += graph.size[at(order[at(factor.row[at(e)])])];
        c.factor_nnz += s * (s + 1) / 2 + s * below;
        for (std::int64_t i = 0; i < s; ++i) {
            const std::int64_t m = s - 1 - i + below;
            c.flops += m * (m + 2);
        }
    }
    return c;
}

}  // namespace hawser::draw
