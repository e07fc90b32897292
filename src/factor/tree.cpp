// SPDX-License-Identifier: Apache-2.0
#include "factor/tree.h"

#include "base/index.h"
#include "base/memory.h"

#include <algorithm>

namespace hawser::factor {
namespace {

/// Estimate the time of one front [ns]: a fixed part, a latency for each pivot, and the flops.
/// Measured on AVX-512 and AVX2 machines; only ratios matter.
double front_time(double p, double q) {
    const double n = p + q;
    return 250.0 + 7.0 * p + 0.06 * (p * p * p / 3.0 + p * p * q + p * q * q) + 0.15 * n * p;
}

}  // namespace

void TreeBuilder::postorder(const Columns& columns, std::vector<std::int32_t>& order,
                            std::vector<std::int32_t>& position) {
    const std::size_t n = order.size();
    // Subtrees fill ranges, children from left to right. The end of each follows from the sizes,
    // from the last to the first. Roots hang on an extra node n.
    up_.resize(n);
    size_.assign(n + 1, 1);
    for (std::size_t k = 0; k < n; ++k) {
        const std::int32_t p = columns.parent(order[k]);
        up_[k] = p < 0 ? static_cast<std::int32_t>(n) : position[at(p)];
        size_[at(up_[k])] += size_[k];
    }
    end_.resize(n + 1);
    end_[n] = static_cast<std::int32_t>(n);
    post_.resize(n);
    for (std::size_t k = n; k-- > 0;) {
        std::int32_t& end = end_[at(up_[k])];
        end_[k] = end - 1;
        end -= size_[k];
        post_[at(end_[k])] = order[k];
        position[at(order[k])] = end_[k];  // parents before children: no longer read
    }
    order.swap(post_);
}

void TreeBuilder::grow_fronts(const Pattern& pattern, const Columns& columns,
                              std::span<const std::int32_t> order,
                              std::span<const std::int32_t> position,
                              std::span<const std::int32_t> chain_of, bool follows,
                              Supernodes& out) {
    const std::size_t n = order.size();
    // From left to right: a node joins the front just before it if that front's last node is its
    // child and merging is exact or saves time.
    growing_.resize(n);
    front_size_.resize(n);
    other_.assign(n, follows ? 0 : 1);
    Growing* last = growing_.data();  // the current front
    auto time_of = [](Growing& g) {
        if (g.time < 0.0) g.time = front_time(g.p, g.q);
        return g.time;
    };
    for (std::size_t k = 0; k < n; ++k) {
        const auto id = static_cast<std::int32_t>(k);
        const std::int32_t node = order[k], parent = columns.parent(node);
        const std::int32_t up = parent < 0 ? -1 : position[at(parent)];
        const std::int32_t chain = chain_of.empty() ? -1 : chain_of[at(node)];
        Grown& grown = front_size_[at(node)];
        if (other_[k] == 0 && !columns.column_changed(node)) {
            last -= grown.merged;
            *last++ = {id + 1 - grown.nodes, id + 1, grown.p, columns.below(node), up, chain, -1.0};
            continue;
        }
        if (up >= 0) other_[at(up)] = 1;
        *last = {id, id + 1, pattern.size[at(node)], columns.below(node), up, chain, -1.0};
        const Growing* const alone = last;
        // A parent lies behind its child: in the last front if before its end.
        for (; last != growing_.data(); --last) {
            Growing& c = last[-1];
            if (c.parent < 0 || c.parent >= last->end || c.chain != last->chain) break;
            double together = -1.0;
            if (c.chain < 0 && !(c.q == last->p + last->q && c.p + last->p <= 48)) {
                together = front_time(c.p + last->p, last->q);
                if (together > time_of(c) + time_of(*last)) break;
            }
            c = {c.begin, last->end, c.p + last->p, last->q, last->parent, c.chain, together};
        }
        grown = {static_cast<std::int32_t>(alone - last), last->end - last->begin, last->p};
        ++last;
    }
    growing_.resize(static_cast<std::size_t>(last - growing_.data()));

    const std::size_t fronts = growing_.size();
    out.begin.resize(fronts + 1);
    out.parent.resize(fronts);
    out.p.resize(fronts);
    front_at_.resize(n);
    for (std::size_t f = 0; f < fronts; ++f) {
        out.begin[f] = growing_[f].begin;
        out.p[f] = growing_[f].p;
        std::fill(front_at_.begin() + growing_[f].begin, front_at_.begin() + growing_[f].end,
                  static_cast<std::int32_t>(f));
    }
    out.begin[fronts] = static_cast<std::int32_t>(n);
    for (std::size_t f = 0; f < fronts; ++f)
        out.parent[f] = growing_[f].parent < 0 ? -1 : front_at_[at(growing_[f].parent)];
}

std::size_t TreeBuilder::bytes() const noexcept {
    return base::bytes(growing_) + base::bytes(up_) + base::bytes(size_) + base::bytes(end_) +
           base::bytes(post_) + base::bytes(front_at_) + base::bytes(front_size_) +
           base::bytes(other_);
}

}  // namespace hawser::factor
