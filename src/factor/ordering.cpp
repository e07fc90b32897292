// SPDX-License-Identifier: Apache-2.0
#include "factor/ordering.h"

#include "base/index.h"
#include "base/memory.h"

extern "C" {
#include <amd.h>
}

#include <algorithm>
#include <functional>
#include <limits>
#include <new>

namespace hawser::factor {

void Orderer::order(const Pattern& pattern, std::vector<std::int32_t>& order) {
    const auto& size = pattern.size;
    if (pattern.nodes() <= MinimumDegree::kMaximum)
        minimum_degree_.run(pattern, order);
    else if (std::adjacent_find(size.begin(), size.end(), std::not_equal_to<>()) != size.end())
        amd_.run(pattern, order);
    else
        return order_by_amd(pattern, order);
    place_rows(pattern, order);
}

/// Order the nodes with AMD. The inner function of the library is called, with the arguments that
/// amd_order() would pass. This is possible because the lists of a pattern are those of A + Aᵀ,
/// valid and sorted.
void Orderer::order_by_amd(const Pattern& pattern, std::vector<std::int32_t>& order) {
    const std::size_t n = pattern.size.size(), entries = pattern.adjacent.size();
    order.resize(n);
    if (n == 0) return;
    double control[AMD_CONTROL];
    amd_defaults(control);
    // A hull with hundreds of neighbours is not "dense": only nodes above 10·√n·10 are.
    control[AMD_DENSE] = 100.0;
    // With this capacity the lists are seldom compacted. The capacity does not change the order.
    const std::size_t room = 2 * entries + n;
    if (room > at(std::numeric_limits<std::int32_t>::max())) throw std::bad_alloc();
    constexpr std::size_t kWorkArrays = 8;
    work_.resize(kWorkArrays * n + room);
    std::int32_t* array[kWorkArrays];
    for (std::size_t i = 0; i < kWorkArrays; ++i) array[i] = work_.data() + i * n;
    const auto& [start, length, count, next, head, elements, degree, flags] = array;
    std::int32_t* const lists = work_.data() + kWorkArrays * n;
    for (std::size_t v = 0; v < n; ++v) {
        start[v] = pattern.start[v];
        length[v] = pattern.start[v + 1] - pattern.start[v];
    }
    std::copy(pattern.adjacent.begin(), pattern.adjacent.end(), lists);
    amd_2(static_cast<int>(n), start, lists, length, static_cast<int>(room),
          static_cast<int>(entries), count, next, order.data(), head, elements, degree, flags,
          control, nullptr);
    place_rows(pattern, order);
}

/// Find the boundary of each chain. Each node is listed once.
void Orderer::find_boundaries(const Pattern& pattern, const Chains& chains) {
    mark_.assign(index_outside_chains_.size(), -1);
    boundary_.clear();
    boundary_begin_.assign(1, 0);
    for (int c = 0; c < chains.count(); ++c) {
        const std::int32_t begin = chains.unit_begin[at(chains.begin[at(c)])],
                           end = chains.unit_begin[at(chains.begin[at(c) + 1])];
        for (std::int32_t i = begin; i < end; ++i)
            for (const std::int32_t u : pattern.neighbours(chains.nodes[at(i)])) {
                if (index_outside_chains_[at(u)] < 0 || mark_[at(u)] == c) continue;
                mark_[at(u)] = c;
                boundary_.push_back(index_outside_chains_[at(u)]);
            }
        boundary_begin_.push_back(static_cast<std::int32_t>(boundary_.size()));
    }
}

/// Build the pattern without the chains, in which their boundaries are cliques.
void Orderer::build_pattern_without_chains(const Pattern& pattern, const Chains& chains) {
    const std::size_t n = pattern.size.size();
    index_outside_chains_.assign(n, 0);
    for (const std::int32_t v : chains.nodes) index_outside_chains_[at(v)] = -1;
    nodes_outside_.clear();
    remaining_pattern_.size.clear();
    remaining_pattern_.sign.clear();
    for (std::size_t v = 0; v < n; ++v) {
        if (index_outside_chains_[v] < 0) continue;
        index_outside_chains_[v] = static_cast<std::int32_t>(nodes_outside_.size());
        nodes_outside_.push_back(static_cast<std::int32_t>(v));
        remaining_pattern_.size.push_back(pattern.size[v]);
        remaining_pattern_.sign.push_back(pattern.sign[v]);
    }
    find_boundaries(pattern, chains);
    // Lists of the chains that a node touches, as indices into boundary_.
    touch_.assign(nodes_outside_.size(), -1);
    touch_next_.resize(boundary_.size());
    mark_.resize(boundary_.size());  // from here on: the chain of each entry
    for (int c = 0; c < chains.count(); ++c)
        for (std::int32_t i = boundary_begin_[at(c)]; i < boundary_begin_[at(c) + 1]; ++i) {
            touch_next_[at(i)] = touch_[at(boundary_[at(i)])];
            touch_[at(boundary_[at(i)])] = i;
            mark_[at(i)] = c;
        }
    remaining_pattern_.start.assign(1, 0);
    remaining_pattern_.adjacent.clear();
    for (std::size_t k = 0; k < nodes_outside_.size(); ++k) {
        const std::size_t begin = remaining_pattern_.adjacent.size();
        for (const std::int32_t u : pattern.neighbours(nodes_outside_[k]))
            if (index_outside_chains_[at(u)] >= 0)
                remaining_pattern_.adjacent.push_back(index_outside_chains_[at(u)]);
        for (std::int32_t t = touch_[k]; t >= 0; t = touch_next_[at(t)]) {
            const std::size_t c = at(mark_[at(t)]);
            for (std::int32_t i = boundary_begin_[c]; i < boundary_begin_[c + 1]; ++i)
                if (at(boundary_[at(i)]) != k)
                    remaining_pattern_.adjacent.push_back(boundary_[at(i)]);
        }
        if (touch_[k] >= 0) {
            const auto first =
                remaining_pattern_.adjacent.begin() + static_cast<std::ptrdiff_t>(begin);
            std::sort(first, remaining_pattern_.adjacent.end());
            remaining_pattern_.adjacent.erase(std::unique(first, remaining_pattern_.adjacent.end()),
                                              remaining_pattern_.adjacent.end());
        }
        remaining_pattern_.start.push_back(
            static_cast<std::int32_t>(remaining_pattern_.adjacent.size()));
    }
}

void Orderer::plan(const Pattern& pattern, std::vector<std::int32_t>& order_, Chains& chains) {
    chains_.find(pattern, chains);
    if (chains.count() == 0) {
        order(pattern, order_);
        return;
    }
    build_pattern_without_chains(pattern, chains);
    order(remaining_pattern_, outside_order_);
    order_.assign(chains.nodes.begin(), chains.nodes.end());
    for (const std::int32_t k : outside_order_) order_.push_back(nodes_outside_[at(k)]);
}

void Orderer::place_rows(const Pattern& pattern, std::vector<std::int32_t>& order) {
    if (std::find(pattern.sign.begin(), pattern.sign.end(), -1) == pattern.sign.end()) return;
    const std::size_t n = order.size();
    position_.resize(n);
    for (std::size_t k = 0; k < n; ++k) position_[at(order[k])] = static_cast<std::int32_t>(k);
    // Positions from last to first, so that the lists behind a body ascend.
    head_.assign(n, -1);
    next_.resize(n);
    bool moved = false;
    for (std::size_t k = n; k-- > 0;) {
        const std::int32_t v = order[k];
        if (pattern.sign[at(v)] > 0) continue;
        auto first = static_cast<std::int32_t>(n);
        for (const std::int32_t u : pattern.neighbours(v))
            if (pattern.sign[at(u)] > 0) first = std::min(first, position_[at(u)]);
        if (first == static_cast<std::int32_t>(n) || first < static_cast<std::int32_t>(k)) continue;
        next_[k] = head_[at(first)];
        head_[at(first)] = static_cast<std::int32_t>(k);
        position_[at(v)] = -1;
        moved = true;
    }
    if (!moved) return;
    // Read from a copy by position, because order is overwritten.
    work_.assign(order.begin(), order.end());
    std::size_t to = 0;
    for (std::size_t k = 0; k < n; ++k) {
        if (position_[at(work_[k])] >= 0) order[to++] = work_[k];
        for (std::int32_t m = head_[k]; m >= 0; m = next_[at(m)]) order[to++] = work_[at(m)];
    }
}

std::size_t Orderer::bytes() const noexcept {
    std::size_t sum = chains_.bytes() + minimum_degree_.bytes() + amd_.bytes() +
                      base::bytes(remaining_pattern_.size) + base::bytes(remaining_pattern_.sign);
    for (const auto* v :
         {&work_, &position_, &head_, &next_, &remaining_pattern_.start,
          &remaining_pattern_.adjacent, &index_outside_chains_, &nodes_outside_, &outside_order_,
          &boundary_, &boundary_begin_, &touch_, &touch_next_, &mark_})
        sum += base::bytes(*v);
    return sum;
}

std::vector<std::int32_t> order_nodes(const Pattern& pattern) {
    std::vector<std::int32_t> order;
    Orderer().order_by_amd(pattern, order);
    return order;
}

Elimination plan_elimination(const Pattern& pattern) {
    Elimination plan;
    Orderer().plan(pattern, plan.order, plan.chains);
    return plan;
}

void place_rows_after_bodies(const Pattern& pattern, std::vector<std::int32_t>& order) {
    Orderer().place_rows(pattern, order);
}

}  // namespace hawser::factor
