// SPDX-License-Identifier: Apache-2.0
#include "factor/minimum_degree.h"

#include "base/index.h"
#include "factor/kernels.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace hawser::factor {
namespace {

constexpr std::int32_t kWordsAtOnce = 8;                          // of a row
constexpr std::uint64_t kHashMultiplier = 0x9e37'79b9'7f4a'7c15;  // spreads bits to the upper end

[[nodiscard]] constexpr std::uint64_t bit(std::int32_t node) {
    return std::uint64_t{1} << (node & 63);
}

}  // namespace

void MinimumDegree::insert(std::int32_t node) noexcept {
    const std::int32_t list = list_of(degree_[at(node)]), first = next_[at(list)];
    next_[at(node)] = first;
    prev_[at(node)] = list;
    prev_[at(first)] = node;
    next_[at(list)] = node;
}

void MinimumDegree::remove(std::int32_t node) noexcept {
    const std::int32_t before = prev_[at(node)], after = next_[at(node)];
    prev_[at(after)] = before;
    next_[at(before)] = after;
}

/// Set the weights of nodes, and create one list for each possible degree.
void MinimumDegree::set_node_weights(const Pattern& pattern) {
    const std::int32_t n = pattern.nodes();
    bool has[kMaxBlock + 1] = {};
    std::int32_t divisor = 0;
    for (const std::int8_t size : pattern.size) has[size] = true;
    for (std::int32_t size = 1; size <= kMaxBlock; ++size)
        if (has[size]) divisor = std::gcd(divisor, size);
    weights_ = NodeWeights{};
    std::int32_t row_of[kMaxBlock + 1] = {}, least = 0;
    for (std::int32_t size = 1; size <= kMaxBlock; ++size) {
        if (!has[size]) continue;
        if (least == 0) {
            least = size;
            weights_.least = size / divisor;
            continue;
        }
        row_of[size] = weights_.count;
        weights_.more[weights_.count++] = (size - least) / divisor;
    }
    heavy_.assign(at(weights_.count) * at(words_), 0);
    weights_.rows = heavy_.data();
    weight_.resize(at(n));
    std::int32_t sum = 0;
    for (std::int32_t v = 0; v < n; ++v) {
        const std::int32_t size = pattern.size[at(v)];
        if (size != least) heavy_[at(row_of[size]) * at(words_) + at(v / 64)] |= bit(v);
        weight_[at(v)] = size / divisor;
        sum += weight_[at(v)];
    }
    next_.resize(at(n) + at(sum) + 1);
    prev_.resize(at(n) + at(sum) + 1);
    for (std::int32_t list = n; list <= n + sum; ++list) next_[at(list)] = prev_[at(list)] = list;
}

void MinimumDegree::begin(const Pattern& pattern) {
    const std::int32_t n = pattern.nodes();
    words_ = (n + 64 * kWordsAtOnce - 1) / (64 * kWordsAtOnce) * kWordsAtOnce;
    set_node_weights(pattern);
    rows_.assign(at(n) * at(words_), 0);
    remaining_nodes_.assign(at(words_), 0);
    degree_.resize(at(n));
    nonzero_words_.resize(at(n));
    folds_.resize(at(n));
    twin_.assign(at(n), -1);
    last_twin_.resize(at(n));
    touched_.resize(at(n));
    sizes_.resize(at(n));
    for (std::int32_t v = n; v-- > 0;) {
        std::uint64_t* const own = row(v);
        std::uint32_t words = 0;
        auto add = [&](std::int32_t u) {
            own[u / 64] |= bit(u);
            words |= std::uint32_t{1} << (u / 64);
        };
        add(v);
        degree_[at(v)] = 0;
        for (const std::int32_t u : pattern.neighbours(v)) {
            add(u);
            degree_[at(v)] += weight_[at(u)];
        }
        nonzero_words_[at(v)] = words;
        remaining_nodes_[at(v / 64)] |= bit(v);
        last_twin_[at(v)] = v;
        insert(v);
    }
    heads_ = remaining_nodes_;
    clique_.resize(at(words_));
    least_degree_ = 0;
}

void MinimumDegree::run(const Pattern& pattern, std::vector<std::int32_t>& order) {
    const auto n = pattern.size.size();
    order.resize(n);
    begin(pattern);
    order_ = order.data();
    const Kernels& kernels = factor_kernels();
    while (order_ != order.data() + n) {
        while (next_[at(list_of(least_degree_))] == list_of(least_degree_)) ++least_degree_;
        eliminate(next_[at(list_of(least_degree_))], kernels);
    }
}

/// Append a node and the nodes merged with it to the order.
void MinimumDegree::finish(std::int32_t head) noexcept {
    heads_[at(head / 64)] &= ~bit(head);
    for (std::int32_t v = head; v >= 0; v = twin_[at(v)]) {
        remaining_nodes_[at(v / 64)] &= ~bit(v);
        *order_++ = v;
    }
}

/// Write the remaining nodes of a row to clique_, and list its heads (representatives of merged
/// nodes) in touched_.
/// @param in_words  Mask of the words of the row that are not zero.
/// @return number of heads.
std::int32_t MinimumDegree::list_heads(const std::uint64_t* own, std::uint32_t in_words) noexcept {
    for (std::int32_t w = 0; w < words_; ++w) clique_[at(w)] = own[w] & remaining_nodes_[at(w)];
    std::int32_t count = 0;
    for (std::uint32_t words = in_words; words != 0; words &= words - 1) {
        const std::int32_t w = std::countr_zero(words);
        for (std::uint64_t b = own[w] & heads_[at(w)]; b != 0; b &= b - 1)
            touched_[at(count++)] = 64 * w + std::countr_zero(b);
    }
    return count;
}

/// Eliminate the pivot and the nodes merged with it, then each neighbour without other neighbours.
void MinimumDegree::eliminate(std::int32_t pivot, const Kernels& kernels) noexcept {
    remove(pivot);
    finish(pivot);
    const std::int32_t clique = degree_[at(pivot)];  // weight of its remaining neighbours
    const std::int32_t count = list_heads(row(pivot), nonzero_words_[at(pivot)]);
    kernels.unite_rows(rows_.data(), words_, touched_.data(), count, clique_.data(),
                       remaining_nodes_.data(), weights_, sizes_.data(), folds_.data());
    std::int32_t kept = 0, gone = 0;
    for (std::int32_t k = 0; k < count; ++k) {
        const std::int32_t u = touched_[at(k)], size = sizes_[at(k)];
        remove(u);
        nonzero_words_[at(u)] |= nonzero_words_[at(pivot)];
        touched_[at(kept)] = u;
        sizes_[at(kept)] = size;
        folds_[at(kept)] = folds_[at(k)];
        ++kept;
        if (size != clique) continue;
        --kept;
        gone += weight_[at(u)];
        finish(u);
    }
    join_twins(kept);
    for (std::int32_t k = kept; k-- > 0;) {
        const std::int32_t u = touched_[at(k)];
        if (u < 0) continue;
        degree_[at(u)] = sizes_[at(k)] - gone - weight_[at(u)];
        least_degree_ = std::min(least_degree_, degree_[at(u)]);
        insert(u);
    }
}

/// Merge touched nodes with equal rows: the first becomes the head, the others are marked −1. A
/// hash table of one word shows in most cases that no two rows are equal.
void MinimumDegree::join_twins(std::int32_t count) noexcept {
    std::uint64_t seen = 0, again = 0;
    for (std::int32_t k = 0; k < count; ++k) {
        const std::uint64_t place = std::uint64_t{1} << ((folds_[at(k)] * kHashMultiplier) >> 58);
        again |= seen & place;
        seen |= place;
    }
    if (again == 0) return;
    for (std::int32_t i = 0; i < count; ++i)
        for (std::int32_t j = i + 1; j < count; ++j) {
            if (folds_[at(i)] != folds_[at(j)]) continue;
            const std::int32_t u = touched_[at(i)], v = touched_[at(j)];
            if (u < 0 || v < 0 || !std::equal(row(u), row(u) + words_, row(v))) continue;
            twin_[at(last_twin_[at(u)])] = v;
            last_twin_[at(u)] = last_twin_[at(v)];
            weight_[at(u)] += weight_[at(v)];
            heads_[at(v / 64)] &= ~bit(v);
            touched_[at(j)] = -1;
        }
}

std::size_t MinimumDegree::bytes() const noexcept {
    std::size_t sum = base::bytes(rows_) + base::bytes(remaining_nodes_) + base::bytes(heads_) +
                      base::bytes(clique_) + base::bytes(heavy_) + base::bytes(folds_) +
                      base::bytes(nonzero_words_);
    for (const auto* v :
         {&next_, &prev_, &degree_, &weight_, &twin_, &last_twin_, &touched_, &sizes_})
        sum += base::bytes(*v);
    return sum;
}

}  // namespace hawser::factor
