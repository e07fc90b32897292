// SPDX-License-Identifier: Apache-2.0
#include "paper_matrix/matrix_market.h"

#include "index.h"

#include <algorithm>
#include <map>
#include <stdexcept>

namespace hawser::bench {

using market::positive;

BlockSystem group_blocks(const Sparse& lower, const std::vector<std::vector<int>>& groups) {
    SystemBuilder builder;
    const auto n = at(lower.rows());
    std::vector<int> node(n), place(n);
    std::vector<const std::vector<int>*> members;
    for (const bool sign : {true, false})
        for (const std::vector<int>& g : groups) {
            if (positive(lower, g.front()) != sign) continue;
            for (const int i : g)
                if (positive(lower, i) != sign)
                    throw std::runtime_error("a block has diagonal entries of both signs");
            std::vector<double> block(g.size() * g.size());
            for (std::size_t i = 0; i < g.size(); ++i)
                for (std::size_t j = 0; j < g.size(); ++j)
                    block[i * g.size() + j] =
                        lower.coeff(std::max(g[i], g[j]), std::min(g[i], g[j]));
            const int a = builder.add_node(static_cast<int>(g.size()), sign ? 1 : -1, block);
            for (std::size_t i = 0; i < g.size(); ++i) {
                node[at(g[i])] = a;
                place[at(g[i])] = static_cast<int>(i);
            }
            members.push_back(&g);
        }
    std::map<std::pair<int, int>, std::vector<double>> blocks;  // (high, low), by rows
    for (int j = 0; j < lower.outerSize(); ++j)
        for (Sparse::InnerIterator it(lower, j); it; ++it) {
            auto row = at(it.row()), column = at(j);
            if (node[row] == node[column]) continue;
            if (node[row] < node[column]) std::swap(row, column);
            const std::size_t width = members[at(node[column])]->size();
            auto& block = blocks[{node[row], node[column]}];
            block.resize(members[at(node[row])]->size() * width, 0.0);
            block[at(place[row]) * width + at(place[column])] = it.value();
        }
    for (const auto& [pair, block] : blocks) builder.add_block(pair.first, pair.second, block);
    return builder.finish("file", 31);
}

BlockSystem read_matrix_market(const std::string& file, const std::string& blocks) {
    const Sparse lower = market::read_lower(file);
    return group_blocks(
        lower, blocks.empty() ? indistinguishable_columns(lower)
                              : market::read_block_sizes(blocks, static_cast<int>(lower.rows())));
}

}  // namespace hawser::bench
