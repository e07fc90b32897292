// SPDX-License-Identifier: Apache-2.0
#include "factor/tree.h"

#include "base/index.h"
#include "base/memory.h"

#include <algorithm>

namespace hawser::factor {
namespace {

/// Rough time of one front [ns]: a fixed part, a latency for each pivot, and the flops.
/// Measured on AVX-512 and AVX2 machines; only ratios matter.
double front_time(double p, double q) {
    const double n = p + q;
    return 80.0 + 7.0 * p + 0.06 * (p * p * p / 3.0 + p * p * q + p * q * q) + 0.15 * n * p;
}

}  // namespace

void TreeBuilder::postorder(const Columns& columns, std::vector<std::int32_t>& order,
                            std::vector<std::int32_t>& position) {
    const std::size_t n = order.size();
    // Children by node, ascending in the order; roots hang on an extra node n.
    head_.assign(n + 1, -1);
    next_.resize(n);
    for (std::size_t k = n; k-- > 0;) {
        const std::int32_t v = order[k], up = columns.parent(v);
        const std::size_t p = up < 0 ? n : at(up);
        next_[at(v)] = head_[p];
        head_[p] = v;
    }
    post_.clear();
    for (std::int32_t root = head_[n]; root >= 0; root = next_[at(root)]) {
        stack_.push_back(root);
        while (!stack_.empty()) {
            const std::size_t top = at(stack_.back());
            if (const std::int32_t child = head_[top]; child >= 0) {
                head_[top] = next_[at(child)];
                stack_.push_back(child);
            } else {
                post_.push_back(stack_.back());
                stack_.pop_back();
            }
        }
    }
    order.assign(post_.begin(), post_.end());
    position.resize(n);
    for (std::size_t k = 0; k < n; ++k) position[at(order[k])] = static_cast<std::int32_t>(k);
}

void TreeBuilder::grow_fronts(const Pattern& pattern, const Columns& columns,
                              std::span<const std::int32_t> order,
                              std::span<const std::int32_t> position,
                              std::span<const std::int32_t> chain_of, Supernodes& out) {
    const std::size_t n = order.size();
    // Left to right: a node joins the front just before it when that front's last node is its
    // child and merging is exact or pays.
    growing_.clear();
    auto time_of = [](Growing& g) {
        if (g.time < 0.0) g.time = front_time(g.p, g.q);
        return g.time;
    };
    for (std::size_t k = 0; k < n; ++k) {
        const auto id = static_cast<std::int32_t>(k);
        const std::int32_t node = order[k], up = columns.parent(node);
        growing_.push_back({id, id + 1, pattern.size[at(node)], columns.below(node),
                            up < 0 ? -1 : position[at(up)],
                            chain_of.empty() ? -1 : chain_of[at(node)], -1.0});
        while (growing_.size() > 1) {
            Growing& c = growing_[growing_.size() - 2];
            Growing& f = growing_.back();
            if (c.parent < f.begin || c.parent >= f.end || c.chain != f.chain) break;
            double together = -1.0;
            if (c.chain < 0 && !(c.q == f.p + f.q && c.p + f.p <= 48)) {
                together = front_time(c.p + f.p, f.q);
                if (together > time_of(c) + time_of(f)) break;
            }
            c = {c.begin, f.end, c.p + f.p, f.q, f.parent, c.chain, together};
            growing_.pop_back();
        }
    }

    const std::size_t fronts = growing_.size();
    out.begin.resize(fronts + 1);
    out.parent.resize(fronts);
    front_at_.resize(n);
    for (std::size_t f = 0; f < fronts; ++f) {
        out.begin[f] = growing_[f].begin;
        std::fill(front_at_.begin() + growing_[f].begin, front_at_.begin() + growing_[f].end,
                  static_cast<std::int32_t>(f));
    }
    out.begin[fronts] = static_cast<std::int32_t>(n);
    for (std::size_t f = 0; f < fronts; ++f)
        out.parent[f] = growing_[f].parent < 0 ? -1 : front_at_[at(growing_[f].parent)];
}

std::size_t TreeBuilder::bytes() const noexcept {
    return base::bytes(growing_) + base::bytes(head_) + base::bytes(next_) + base::bytes(stack_) +
           base::bytes(post_) + base::bytes(front_at_);
}

}  // namespace hawser::factor
