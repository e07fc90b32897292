// SPDX-License-Identifier: Apache-2.0
#include "factor/approximate_degree.h"

#include "base/index.h"
#include "base/memory.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

namespace hawser::factor {

void ApproximateDegree::insert(std::int32_t node) noexcept {
    const std::size_t list = at(degree_[at(node)]);
    const std::int32_t first = head_[list];
    next_[at(node)] = first;
    prev_[at(node)] = -1;
    if (first >= 0) prev_[at(first)] = node;
    head_[list] = node;
}

void ApproximateDegree::remove(std::int32_t node) noexcept {
    const std::int32_t before = prev_[at(node)], after = next_[at(node)];
    if (after >= 0) prev_[at(after)] = before;
    (before >= 0 ? next_[at(before)] : head_[at(degree_[at(node)])]) = after;
}

/// Append a variable and the variables merged with it to the order.
void ApproximateDegree::finish(std::int32_t variable) noexcept {
    for (std::int32_t v = variable; v >= 0; v = twin_[at(v)]) *order_++ = v;
}

void ApproximateDegree::begin(const Pattern& pattern) {
    const std::size_t n = pattern.size.size(), entries = pattern.adjacent.size();
    // An element is written behind all lists. The total length of the lists never grows.
    if (2 * entries + n > at(std::numeric_limits<std::int32_t>::max())) throw std::bad_alloc();
    lists_.resize(2 * entries + n);
    for (auto* v : {&start_, &length_, &next_, &prev_, &last_twin_, &bucket_next_}) v->resize(n);
    elements_.assign(n, 0);
    weight_.assign(n, 0);
    degree_.assign(n, 0);
    mark_.assign(n, 0);
    twin_.assign(n, -1);
    twin_mark_.assign(n, -1);
    bucket_.assign(n, -1);
    dense_nodes_.clear();
    constexpr double kDenseFactor = 100.0;
    const double most = kDenseFactor * std::sqrt(static_cast<double>(n));
    remaining_weight_ = 0;
    for (std::size_t v = 0; v < n; ++v) {
        const auto node = static_cast<std::int32_t>(v);
        last_twin_[v] = node;
        if (static_cast<double>(pattern.neighbours(node).size()) > most) {
            dense_nodes_.push_back(node);
            continue;
        }
        weight_[v] = pattern.size[v];
        remaining_weight_ += weight_[v];
    }
    free_ = 0;
    head_.assign(at(remaining_weight_) + 1, -1);
    for (std::size_t v = 0; v < n; ++v) {
        start_[v] = free_;
        if (weight_[v] > 0)
            for (const std::int32_t u : pattern.neighbours(static_cast<std::int32_t>(v))) {
                if (weight_[at(u)] == 0) continue;
                lists_[at(free_++)] = u;
                degree_[v] += weight_[at(u)];
            }
        length_[v] = free_ - start_[v];
    }
    for (std::size_t v = n; v-- > 0;)
        if (weight_[v] > 0) insert(static_cast<std::int32_t>(v));
    least_degree_ = 0;
    mark_stamp_ = 2;
}

void ApproximateDegree::run(const Pattern& pattern, std::vector<std::int32_t>& order) {
    order.resize(pattern.size.size());
    begin(pattern);
    order_ = order.data();
    while (remaining_weight_ > 0) {
        while (head_[at(least_degree_)] < 0) ++least_degree_;
        const std::int32_t pivot = head_[at(least_degree_)];
        remove(pivot);
        finish(pivot);
        remaining_weight_ -= weight_[at(pivot)];
        compact_if_needed(pivot);
        form_element(pivot);
        measure_elements(pivot);
        shorten_lists(pivot);
        join_twins(pivot);
        close_element(pivot);
    }
    for (const std::int32_t v : dense_nodes_) *order_++ = v;
}

/// Compact the lists if the free space behind them is too small for the element of the pivot.
void ApproximateDegree::compact_if_needed(std::int32_t pivot) noexcept {
    std::int64_t most = length_[at(pivot)] - elements_[at(pivot)];
    for (std::int32_t k = 0; k < elements_[at(pivot)]; ++k)
        most += length_[at(lists_[at(start_[at(pivot)] + k)])];
    if (free_ + most <= static_cast<std::int64_t>(lists_.size())) return;
    // Replace the first entry of each list by the index of its node.
    for (std::size_t v = 0; v < length_.size(); ++v) {
        if (length_[v] == 0) continue;
        std::int32_t& first = lists_[at(start_[v])];
        start_[v] = first;
        first = -1 - static_cast<std::int32_t>(v);
    }
    std::int32_t to = 0;
    for (std::int32_t k = 0; k < free_;) {
        const std::int32_t tag = lists_[at(k++)];
        if (tag >= 0) continue;
        const std::size_t v = at(-1 - tag);
        const std::int32_t begin = to;
        lists_[at(to++)] = start_[v];
        for (std::int32_t i = 1; i < length_[v]; ++i) lists_[at(to++)] = lists_[at(k++)];
        start_[v] = begin;
    }
    free_ = to;
}

/// Append the variables of entries [begin, end) of a list to the element, except those that it
/// already contains.
void ApproximateDegree::gather(std::int32_t pivot, std::int32_t list, std::int32_t begin,
                               std::int32_t end) noexcept {
    for (std::int32_t k = start_[at(list)] + begin; k < start_[at(list)] + end; ++k) {
        const std::int32_t v = lists_[at(k)];
        const std::int32_t weight = weight_[at(v)];
        if (weight <= 0) continue;
        weight_[at(v)] = -weight;
        degree_[at(pivot)] += weight;
        remove(v);
        lists_[at(free_++)] = v;
    }
}

/// Replace the pivot by its element: the clique of the pivot's variables and those of all elements
/// adjacent to it. These elements are absorbed.
void ApproximateDegree::form_element(std::int32_t pivot) noexcept {
    const std::size_t p = at(pivot);
    weight_[p] = 0;
    degree_[p] = 0;
    const std::int32_t begin = free_;
    for (std::int32_t k = 0; k < elements_[p]; ++k) {
        const std::int32_t e = lists_[at(start_[p] + k)];
        gather(pivot, e, 0, length_[at(e)]);
        mark_[at(e)] = 0;
        length_[at(e)] = 0;
    }
    gather(pivot, pivot, elements_[p], length_[p]);
    start_[p] = begin;
    length_[p] = free_ - begin;
    elements_[p] = 0;
    mark_[p] = 1;
}

/// Set mark − stamp = |L_e \ L_p| for all elements e adjacent to variables of the pivot's element.
void ApproximateDegree::measure_elements(std::int32_t pivot) noexcept {
    const std::size_t p = at(pivot);
    for (std::int32_t k = start_[p]; k < start_[p] + length_[p]; ++k) {
        const std::size_t v = at(lists_[at(k)]);
        const std::int32_t weight = -weight_[v];
        for (std::int32_t i = start_[v]; i < start_[v] + elements_[v]; ++i) {
            const std::size_t e = at(lists_[at(i)]);
            if (mark_[e] == 0) continue;
            if (mark_[e] < mark_stamp_) mark_[e] = degree_[e] + mark_stamp_;
            mark_[e] -= weight;
        }
    }
}

/// Remove from a variable's list all entries that the pivot's element covers, and put that element
/// first.
/// @return false if no other entry remains.
bool ApproximateDegree::remove_covered_entries(std::int32_t pivot, std::int32_t variable) noexcept {
    const std::size_t v = at(variable);
    const std::int32_t begin = start_[v];
    std::int32_t to = begin;
    std::int64_t degree = 0;
    std::uint32_t hash = 0;
    for (std::int32_t k = begin; k < begin + elements_[v]; ++k) {
        const std::int32_t e = lists_[at(k)];
        if (mark_[at(e)] == 0) continue;
        const std::int64_t outside = mark_[at(e)] - mark_stamp_;
        if (outside == 0) {  // absorbed
            mark_[at(e)] = 0;
            length_[at(e)] = 0;
            continue;
        }
        degree += outside;
        hash += static_cast<std::uint32_t>(e);
        lists_[at(to++)] = e;
    }
    const std::int32_t variables = to;
    for (std::int32_t k = begin + elements_[v]; k < begin + length_[v]; ++k) {
        const std::int32_t u = lists_[at(k)];
        if (weight_[at(u)] <= 0) continue;
        degree += weight_[at(u)];
        hash += static_cast<std::uint32_t>(u);
        lists_[at(to++)] = u;
    }
    if (to == begin) return false;
    // The list contained the pivot or an element that ended, so one slot is free.
    lists_[at(to)] = lists_[at(variables)];
    lists_[at(variables)] = lists_[at(begin)];
    lists_[at(begin)] = pivot;
    elements_[v] = variables - begin + 1;
    length_[v] = to - begin + 1;
    degree_[v] = static_cast<std::int32_t>(std::min<std::int64_t>(degree_[v], degree));
    const std::size_t bucket = hash % bucket_.size();
    bucket_next_[v] = bucket_[bucket];
    bucket_[bucket] = variable;
    next_[v] = static_cast<std::int32_t>(bucket);  // not in a degree list any more
    return true;
}

/// Shorten the lists of all variables of the pivot's element. Variables without other entries are
/// eliminated together with the pivot.
void ApproximateDegree::shorten_lists(std::int32_t pivot) noexcept {
    const std::size_t p = at(pivot);
    for (std::int32_t k = start_[p]; k < start_[p] + length_[p]; ++k) {
        const std::int32_t variable = lists_[at(k)];
        const std::size_t v = at(variable);
        if (remove_covered_entries(pivot, variable)) continue;
        finish(variable);
        degree_[p] += weight_[v];
        remaining_weight_ += weight_[v];
        weight_[v] = 0;
        length_[v] = 0;
    }
    // Raise the stamp above all marks of this pivot.
    mark_stamp_ += static_cast<std::int64_t>(head_.size());
}

/// Merge variables of one hash bucket whose lists are equal as sets.
void ApproximateDegree::join_bucket(std::int32_t first) noexcept {
    for (std::int32_t a = first; a >= 0 && bucket_next_[at(a)] >= 0; a = bucket_next_[at(a)]) {
        const std::size_t i = at(a);
        auto entries = [&](std::size_t v, auto&& each) {  // behind the pivot's element
            for (std::int32_t k = start_[v] + 1; k < start_[v] + length_[v]; ++k)
                if (!each(at(lists_[at(k)]))) return false;
            return true;
        };
        bool marked = false;
        std::int32_t before = a;
        for (std::int32_t b = bucket_next_[i]; b >= 0; b = bucket_next_[at(b)]) {
            const std::size_t j = at(b);
            bool same = length_[i] == length_[j] && elements_[i] == elements_[j];
            if (same && !marked) {
                marked = true;
                (void)entries(i, [&](std::size_t u) { return twin_mark_[u] = a, true; });
            }
            same = same && entries(j, [&](std::size_t u) { return twin_mark_[u] == a; });
            if (!same) {
                before = b;
                continue;
            }
            twin_[at(last_twin_[i])] = b;
            last_twin_[i] = last_twin_[j];
            weight_[i] += weight_[j];
            weight_[j] = 0;
            length_[j] = 0;
            bucket_next_[at(before)] = bucket_next_[j];
        }
        // Reset the marks of this variable, which may also be in the bucket of a later pivot.
        if (marked) (void)entries(i, [&](std::size_t u) { return twin_mark_[u] = -1, true; });
    }
}

void ApproximateDegree::join_twins(std::int32_t pivot) noexcept {
    const std::size_t p = at(pivot);
    for (std::int32_t k = start_[p]; k < start_[p] + length_[p]; ++k) {
        const std::size_t v = at(lists_[at(k)]);
        if (weight_[v] == 0) continue;
        const std::size_t bucket = at(next_[v]);
        if (bucket_[bucket] < 0) continue;
        join_bucket(bucket_[bucket]);
        bucket_[bucket] = -1;
    }
}

/// Set the degrees of the variables that remain in the element, and remove the eliminated ones.
void ApproximateDegree::close_element(std::int32_t pivot) noexcept {
    const std::size_t p = at(pivot);
    std::int32_t to = start_[p];
    for (std::int32_t k = start_[p]; k < start_[p] + length_[p]; ++k) {
        const std::int32_t variable = lists_[at(k)];
        const std::size_t v = at(variable);
        if (weight_[v] == 0) continue;
        const std::int32_t weight = weight_[v] = -weight_[v];
        degree_[v] = std::min(degree_[v] + degree_[p] - weight, remaining_weight_ - weight);
        insert(variable);
        least_degree_ = std::min(least_degree_, degree_[v]);
        lists_[at(to++)] = variable;
    }
    length_[p] = to - start_[p];
    if (length_[p] == 0) mark_[p] = 0;
    free_ = to;
}

std::size_t ApproximateDegree::bytes() const noexcept {
    std::size_t sum = base::bytes(mark_);
    for (const auto* v :
         {&lists_, &start_, &length_, &elements_, &weight_, &degree_, &head_, &next_, &prev_,
          &twin_, &last_twin_, &twin_mark_, &bucket_, &bucket_next_, &dense_nodes_})
        sum += base::bytes(*v);
    return sum;
}

}  // namespace hawser::factor
