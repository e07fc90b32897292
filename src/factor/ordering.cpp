// SPDX-License-Identifier: Apache-2.0
#include "factor/ordering.h"

extern "C" {
#include <amd.h>
}

#include <algorithm>
#include <new>
#include <numeric>

namespace hawser::factor {

std::vector<std::int32_t> order_nodes(const Pattern& pattern) {
    const int n = pattern.nodes();
    std::vector<std::int32_t> order(static_cast<std::size_t>(n));
    std::iota(order.begin(), order.end(), 0);
    if (n == 0) return order;
    double control[AMD_CONTROL], info[AMD_INFO];
    amd_defaults(control);
    // A hull with hundreds of neighbours is not "dense": only nodes above 10·√n·10 are.
    control[AMD_DENSE] = 100.0;
    const int status =
        amd_order(n, pattern.start.data(), pattern.adjacent.data(), order.data(), control, info);
    if (status == AMD_OUT_OF_MEMORY) throw std::bad_alloc();
    place_rows_after_bodies(pattern, order);
    return order;
}

Elimination plan_elimination(const Pattern& pattern) {
    Elimination plan{{}, find_chains(pattern)};
    const Chains& chains = plan.chains;
    if (chains.count() == 0) {
        plan.order = order_nodes(pattern);
        return plan;
    }
    const auto n = static_cast<std::size_t>(pattern.nodes());
    std::vector<std::int32_t> rest_of(n, 0), rest, mark(n, -1);
    for (std::int32_t v : chains.nodes) rest_of[static_cast<std::size_t>(v)] = -1;
    Pattern left;
    for (std::size_t v = 0; v < n; ++v) {
        if (rest_of[v] < 0) continue;
        rest_of[v] = static_cast<std::int32_t>(rest.size());
        rest.push_back(static_cast<std::int32_t>(v));
        left.size.push_back(pattern.size[v]);
        left.sign.push_back(pattern.sign[v]);
    }
    std::vector<std::int32_t> from, to, boundary;
    for (std::size_t k = 0; k < rest.size(); ++k)
        for (std::int32_t u : pattern.neighbours(rest[k]))
            if (rest_of[static_cast<std::size_t>(u)] > static_cast<std::int32_t>(k)) {
                from.push_back(static_cast<std::int32_t>(k));
                to.push_back(rest_of[static_cast<std::size_t>(u)]);
            }
    for (int c = 0; c < chains.count(); ++c) {
        boundary.clear();
        const auto unit = static_cast<std::size_t>(c);
        for (std::int32_t i = chains.unit_begin[static_cast<std::size_t>(chains.begin[unit])];
             i < chains.unit_begin[static_cast<std::size_t>(chains.begin[unit + 1])]; ++i)
            for (std::int32_t u : pattern.neighbours(chains.nodes[static_cast<std::size_t>(i)])) {
                const auto w = static_cast<std::size_t>(u);
                if (rest_of[w] < 0 || mark[w] == c) continue;
                mark[w] = c;
                boundary.push_back(rest_of[w]);
            }
        for (std::size_t i = 0; i < boundary.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                from.push_back(boundary[i]);
                to.push_back(boundary[j]);
            }
    }
    left = make_pattern(std::move(left.size), std::move(left.sign), from, to);
    plan.order = chains.nodes;
    for (std::int32_t k : order_nodes(left))
        plan.order.push_back(rest[static_cast<std::size_t>(k)]);
    return plan;
}

void place_rows_after_bodies(const Pattern& pattern, std::vector<std::int32_t>& order) {
    const auto n = order.size();
    std::vector<std::int32_t> position(n);
    for (std::size_t k = 0; k < n; ++k)
        position[static_cast<std::size_t>(order[k])] = static_cast<std::int32_t>(k);
    // Sort key: twice the position; a moved node gets the odd number behind its body.
    std::vector<std::int64_t> key(n);
    bool moved = false;
    for (std::size_t k = 0; k < n; ++k) {
        const std::int32_t v = order[k];
        key[k] = 2 * static_cast<std::int64_t>(k);
        if (pattern.sign[static_cast<std::size_t>(v)] > 0) continue;
        std::int32_t first = -1;
        for (std::int32_t u : pattern.neighbours(v))
            if (pattern.sign[static_cast<std::size_t>(u)] > 0 &&
                (first < 0 || position[static_cast<std::size_t>(u)] < first))
                first = position[static_cast<std::size_t>(u)];
        if (first > static_cast<std::int32_t>(k)) {
            key[k] = 2 * static_cast<std::int64_t>(first) + 1;
            moved = true;
        }
    }
    if (!moved) return;
    std::vector<std::int32_t> slots(n);
    std::iota(slots.begin(), slots.end(), 0);
    std::sort(slots.begin(), slots.end(), [&](std::int32_t a, std::int32_t b) {
        const auto key_a = key[static_cast<std::size_t>(a)];
        const auto key_b = key[static_cast<std::size_t>(b)];
        return key_a != key_b ? key_a < key_b : a < b;
    });
    std::vector<std::int32_t> result(n);
    for (std::size_t k = 0; k < n; ++k) result[k] = order[static_cast<std::size_t>(slots[k])];
    order.swap(result);
}

}  // namespace hawser::factor
