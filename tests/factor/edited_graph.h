// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file edited_graph.h
/// Patterns with the kinds of changes that scenes make.

#include "factor/pattern.h"
#include "support/random.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

namespace hawser::test {

/// A graph under edits: nodes with constant names, edges between names.
class EditedGraph {
  public:
    explicit EditedGraph(const factor::Pattern& p) {
        for (int v = 0; v < p.nodes(); ++v) {
            nodes_.push_back(
                {v, p.size[static_cast<std::size_t>(v)], p.sign[static_cast<std::size_t>(v)]});
            for (const std::int32_t u : p.neighbours(v))
                if (u < v) edges_.insert({u, v});
        }
        names_ = p.nodes();
        remember();
    }

    void add_edge(Random& random) {
        if (nodes_.size() < 2) return;
        const int a = pick(random), b = pick(random);
        if (a != b) edges_.insert({std::min(a, b), std::max(a, b)});
    }
    void remove_edge(Random& random) {
        if (edges_.empty()) return;
        auto it = edges_.begin();
        std::advance(it, random.integer(0, static_cast<int>(edges_.size()) - 1));
        edges_.erase(it);
    }
    /// Add a node, usually a contact: rows with one or two bodies, or a body with such rows.
    void add_node(Random& random) {
        const bool body = random.chance(0.3);
        const int name = names_++;
        nodes_.push_back({name, static_cast<std::int8_t>(body ? 6 : random.integer(1, 3)),
                          static_cast<std::int8_t>(body ? 1 : -1)});
        for (int k = random.integer(0, 3); k > 0; --k) {
            const int other = pick(random);
            if (other != name) edges_.insert({other, name});
        }
        if (body && random.chance(0.5)) {
            const int row = names_++;
            nodes_.push_back({row, 3, -1});
            edges_.insert({name, row});
            edges_.insert({std::min(pick(random), name), row});
        }
    }
    void remove_node(Random& random) {
        if (nodes_.empty()) return;
        const std::size_t i =
            static_cast<std::size_t>(random.integer(0, static_cast<int>(nodes_.size()) - 1));
        const int name = nodes_[i].name;
        nodes_.erase(nodes_.begin() + static_cast<std::ptrdiff_t>(i));
        std::erase_if(edges_, [&](const auto& e) { return e.first == name || e.second == name; });
    }
    void resize_node(Random& random) {
        if (nodes_.empty()) return;
        nodes_[static_cast<std::size_t>(random.integer(0, static_cast<int>(nodes_.size()) - 1))]
            .size = static_cast<std::int8_t>(random.integer(1, 6));
    }
    void shuffle(Random& random) { random.shuffle(nodes_); }

    /// Return the present pattern and the index of each node in the last pattern.
    factor::Pattern pattern(std::vector<std::int32_t>& old_of_new) {
        old_of_new.clear();
        for (const Node& n : nodes_)
            old_of_new.push_back(n.name < static_cast<int>(index_.size())
                                     ? index_[static_cast<std::size_t>(n.name)]
                                     : -1);
        remember();
        std::vector<std::int8_t> size, sign;
        for (const Node& n : nodes_) {
            size.push_back(n.size);
            sign.push_back(n.sign);
        }
        std::vector<std::int32_t> from, to;
        for (const auto& [a, b] : edges_) {
            from.push_back(index_[static_cast<std::size_t>(a)]);
            to.push_back(index_[static_cast<std::size_t>(b)]);
        }
        return factor::make_pattern(size, sign, from, to);
    }

  private:
    struct Node {
        int name;
        std::int8_t size, sign;
    };
    int pick(Random& random) const {
        return nodes_[static_cast<std::size_t>(
                          random.integer(0, static_cast<int>(nodes_.size()) - 1))]
            .name;
    }
    void remember() {
        index_.assign(static_cast<std::size_t>(names_), -1);
        for (std::size_t k = 0; k < nodes_.size(); ++k)
            index_[static_cast<std::size_t>(nodes_[k].name)] = static_cast<int>(k);
    }

    std::vector<Node> nodes_;
    std::set<std::pair<int, int>> edges_;
    std::vector<int> index_;
    int names_ = 0;
};

inline void edit(EditedGraph& graph, Random& random, bool numbers_stay) {
    for (int k = random.integer(0, 5); k > 0; --k) {
        const double dice = random.unit();
        if (dice < 0.4)
            graph.add_edge(random);
        else if (dice < 0.7)
            graph.remove_edge(random);
        else if (dice < 0.85)
            graph.add_node(random);
        else if (dice < 0.9)
            graph.resize_node(random);
        else if (!numbers_stay)
            graph.remove_node(random);
    }
    if (!numbers_stay && random.chance(0.3)) graph.shuffle(random);
}

}  // namespace hawser::test
