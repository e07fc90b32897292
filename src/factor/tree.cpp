// SPDX-License-Identifier: Apache-2.0
#include "factor/tree.h"

#include "factor/symbolic.h"

#include <algorithm>

namespace hawser::factor {
namespace {

std::vector<std::int32_t> inverse(const std::vector<std::int32_t>& order) {
    std::vector<std::int32_t> position(order.size());
    for (std::size_t k = 0; k < order.size(); ++k)
        position[static_cast<std::size_t>(order[k])] = static_cast<std::int32_t>(k);
    return position;
}

/// Postorder of a forest given by parents; children in ascending order. post[k] = old position.
std::vector<std::int32_t> postorder(const std::vector<std::int32_t>& parent) {
    const std::size_t n = parent.size();
    std::vector<std::int32_t> head(n + 1, -1), next(n, -1), post, stack;
    post.reserve(n);
    for (std::size_t i = n; i-- > 0;) {
        const std::size_t p = parent[i] < 0 ? n : static_cast<std::size_t>(parent[i]);
        next[i] = head[p];
        head[p] = static_cast<std::int32_t>(i);
    }
    for (std::int32_t root = head[n]; root >= 0; root = next[static_cast<std::size_t>(root)]) {
        stack.push_back(root);
        while (!stack.empty()) {
            const auto top = static_cast<std::size_t>(stack.back());
            if (head[top] >= 0) {
                const std::int32_t child = head[top];
                head[top] = next[static_cast<std::size_t>(child)];
                stack.push_back(child);
            } else {
                post.push_back(stack.back());
                stack.pop_back();
            }
        }
    }
    return post;
}

/// Rough time of one front [ns]: a fixed part, a latency for each pivot, and the flops.
/// Measured on AVX-512 and AVX2 machines; only ratios matter.
double front_time(double p, double q) {
    const double n = p + q;
    return 80.0 + 7.0 * p + 0.06 * (p * p * p / 3.0 + p * p * q + p * q * q) + 0.15 * n * p;
}

struct Building {
    std::vector<std::int32_t> begin, end;  ///< Pivot positions.
    std::vector<std::int32_t> p;           ///< Pivot scalars.
    std::vector<std::int32_t> q;           ///< Update scalars.
};

}  // namespace

std::vector<std::int32_t> elimination_tree(const Pattern& pattern,
                                           const std::vector<std::int32_t>& order) {
    const std::size_t n = order.size();
    const std::vector<std::int32_t> position = inverse(order);
    std::vector<std::int32_t> parent(n, -1), ancestor(n, -1);
    for (std::size_t k = 0; k < n; ++k)
        for (std::int32_t u : pattern.neighbours(order[k])) {
            auto i = static_cast<std::size_t>(position[static_cast<std::size_t>(u)]);
            if (i >= k) continue;
            while (ancestor[i] >= 0 && ancestor[i] != static_cast<std::int32_t>(k)) {
                const auto up = static_cast<std::size_t>(ancestor[i]);
                ancestor[i] = static_cast<std::int32_t>(k);
                i = up;
            }
            if (ancestor[i] < 0) {
                ancestor[i] = static_cast<std::int32_t>(k);
                parent[i] = static_cast<std::int32_t>(k);
            }
        }
    return parent;
}

Supernodes build_tree(const Pattern& pattern, std::vector<std::int32_t>& order,
                      const std::vector<std::int32_t>& chain_of) {
    const std::size_t n = order.size();
    // Postorder the tree, so that subtrees are contiguous.
    std::vector<std::int32_t> parent = elimination_tree(pattern, order);
    {
        const std::vector<std::int32_t> post = postorder(parent), where = inverse(post);
        std::vector<std::int32_t> new_order(n), new_parent(n);
        for (std::size_t k = 0; k < n; ++k) {
            const auto old = static_cast<std::size_t>(post[k]);
            new_order[k] = order[old];
            new_parent[k] = parent[old] < 0 ? -1 : where[static_cast<std::size_t>(parent[old])];
        }
        order.swap(new_order);
        parent.swap(new_parent);
    }
    const std::vector<std::int32_t> position = inverse(order);
    auto size_at = [&](std::int32_t k) {
        return static_cast<std::int32_t>(
            pattern.size[static_cast<std::size_t>(order[static_cast<std::size_t>(k)])]);
    };

    auto chain_at = [&](std::int32_t k) {
        return chain_of.empty()
                   ? -1
                   : chain_of[static_cast<std::size_t>(order[static_cast<std::size_t>(k)])];
    };

    // Structure of every column (positions after it), children merged by marks.
    std::vector<std::int32_t> struct_begin(n + 1, 0), structure, mark(n, -1);
    std::vector<std::int32_t> head(n, -1), next(n, -1);
    for (std::size_t k = 0; k < n; ++k) {
        const auto id = static_cast<std::int32_t>(k);
        mark[k] = id;
        const auto first = static_cast<std::ptrdiff_t>(structure.size());
        auto take = [&](std::int32_t i) {
            if (i > id && mark[static_cast<std::size_t>(i)] != id) {
                mark[static_cast<std::size_t>(i)] = id;
                structure.push_back(i);
            }
        };
        for (std::int32_t u : pattern.neighbours(order[k]))
            take(position[static_cast<std::size_t>(u)]);
        for (std::int32_t c = head[k]; c >= 0; c = next[static_cast<std::size_t>(c)])
            for (std::int32_t i = struct_begin[static_cast<std::size_t>(c)];
                 i < struct_begin[static_cast<std::size_t>(c) + 1]; ++i)
                take(structure[static_cast<std::size_t>(i)]);
        std::sort(structure.begin() + first, structure.end());
        struct_begin[k + 1] = static_cast<std::int32_t>(structure.size());
        if (parent[k] >= 0) {
            next[k] = head[static_cast<std::size_t>(parent[k])];
            head[static_cast<std::size_t>(parent[k])] = id;
        }
    }

    // Grow fronts left to right: a node joins the front just before it when that front's last
    // node is its child and merging is exact or pays.
    Building b;
    std::vector<std::int32_t> stack_of_fronts;
    for (std::size_t k = 0; k < n; ++k) {
        const auto id = static_cast<std::int32_t>(k);
        std::int32_t q = 0;
        for (std::int32_t i = struct_begin[k]; i < struct_begin[k + 1]; ++i)
            q += size_at(structure[static_cast<std::size_t>(i)]);
        b.begin.push_back(id);
        b.end.push_back(id + 1);
        b.p.push_back(size_at(id));
        b.q.push_back(q);
        while (b.begin.size() > 1) {
            const std::size_t c = b.begin.size() - 2, f = c + 1;
            if (parent[static_cast<std::size_t>(b.end[c] - 1)] < b.begin[f] ||
                parent[static_cast<std::size_t>(b.end[c] - 1)] >= b.end[f])
                break;
            if (chain_at(b.begin[c]) != chain_at(b.begin[f])) break;
            if (chain_at(b.begin[c]) < 0) {
                const bool exact = b.q[c] == b.p[f] + b.q[f];
                const double apart = front_time(b.p[c], b.q[c]) + front_time(b.p[f], b.q[f]);
                const double together = front_time(b.p[c] + b.p[f], b.q[f]);
                if (!(exact && b.p[c] + b.p[f] <= 48) && together > apart) break;
            }
            b.end[c] = b.end[f];
            b.p[c] += b.p[f];
            b.q[c] = b.q[f];
            b.begin.pop_back();
            b.end.pop_back();
            b.p.pop_back();
            b.q.pop_back();
        }
    }

    Supernodes sn;
    const std::size_t fronts = b.begin.size();
    std::vector<std::int32_t> front_at(n);
    for (std::size_t f = 0; f < fronts; ++f)
        for (std::int32_t k = b.begin[f]; k < b.end[f]; ++k)
            front_at[static_cast<std::size_t>(k)] = static_cast<std::int32_t>(f);
    sn.begin.push_back(0);
    sn.row_begin.push_back(0);
    for (std::size_t f = 0; f < fronts; ++f) {
        const auto last = static_cast<std::size_t>(b.end[f] - 1);
        sn.begin.push_back(b.end[f]);
        sn.parent.push_back(parent[last] < 0 ? -1
                                             : front_at[static_cast<std::size_t>(parent[last])]);
        // The structure of the last pivot covers every pivot's rows behind the front.
        sn.rows.insert(sn.rows.end(), structure.begin() + struct_begin[last],
                       structure.begin() + struct_begin[last + 1]);
        sn.row_begin.push_back(static_cast<std::int32_t>(sn.rows.size()));
    }
    return sn;
}

}  // namespace hawser::factor
