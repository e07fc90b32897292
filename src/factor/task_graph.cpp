// SPDX-License-Identifier: Apache-2.0
#include "factor/task_graph.h"

#include "base/index.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <numeric>
#include <thread>

namespace hawser::factor {
namespace {

using Edges = std::vector<std::pair<std::int32_t, std::int32_t>>;

/// List the successors of each node, ascending, each once.
void list_successors(TaskGraph::Way& way, const Edges& edges, std::size_t n) {
    way.start.assign(n + 1, 0);
    way.waits.assign(n, 0);
    way.next.resize(edges.size());
    for (const auto& [from, to] : edges) ++way.start[at(from)];
    std::exclusive_scan(way.start.begin(), way.start.end(), way.start.begin(), 0);
    for (const auto& [from, to] : edges) way.next[at(way.start[at(from)]++)] = to;
    // Each start is now the end.
    auto begin = way.next.begin(), kept = begin;
    for (std::size_t v = 0; v < n; ++v) {
        const auto end = way.next.begin() + way.start[v];
        way.start[v] = static_cast<std::int32_t>(kept - way.next.begin());
        std::sort(begin, end);
        kept = std::copy(begin, std::unique(begin, end), kept);
        begin = end;
    }
    way.next.erase(kept, way.next.end());
    way.start[n] = static_cast<std::int32_t>(way.next.size());
    for (const std::int32_t to : way.next) ++way.waits[at(to)];
}

/// Reverse the edges.
void reverse_edges(TaskGraph::Way& way, const TaskGraph::Way& upward) {
    const std::size_t n = upward.waits.size();
    way.start.resize(n + 1);
    way.waits.resize(n);
    way.next.resize(upward.next.size());
    way.start[0] = 0;
    std::inclusive_scan(upward.waits.begin(), upward.waits.end(), way.start.begin() + 1);
    for (std::size_t v = 0; v < n; ++v) {
        way.waits[v] = upward.start[v + 1] - upward.start[v];
        for (std::int32_t k = upward.start[v]; k < upward.start[v + 1]; ++k)
            way.next[at(way.start[at(upward.next[at(k)])]++)] = static_cast<std::int32_t>(v);
    }
    for (std::size_t v = 0; v < n; ++v) way.start[v] -= upward.waits[v];
}

/// Rank nodes by the remaining work when they begin: their own work and the longest path behind it.
std::int64_t rank(TaskGraph::Way& way, const std::vector<std::int64_t>& work, bool upward,
                  std::vector<std::int64_t>& left) {
    const std::size_t n = work.size();
    left.assign(n, 0);
    std::int64_t path = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t v = upward ? n - 1 - i : i;
        for (std::int32_t k = way.start[v]; k < way.start[v + 1]; ++k)
            left[v] = std::max(left[v], left[at(way.next[at(k)])]);
        left[v] += work[v];
        path = std::max(path, left[v]);
    }
    way.by_rank.resize(n);
    std::iota(way.by_rank.begin(), way.by_rank.end(), 0);
    std::sort(way.by_rank.begin(), way.by_rank.end(), [&](std::int32_t a, std::int32_t b) {
        return left[at(a)] != left[at(b)] ? left[at(a)] > left[at(b)] : a < b;
    });
    way.rank.resize(n);
    for (std::size_t k = 0; k < n; ++k) way.rank[at(way.by_rank[k])] = static_cast<std::int32_t>(k);
    return path;
}

inline void spin_pause() noexcept {
#if defined(__x86_64__)
    __builtin_ia32_pause();
#endif
}

}  // namespace

void TaskGraph::build(const Edges& edges, std::vector<std::int64_t>& left) {
    list_successors(upward, edges, work.size());
    path = rank(upward, work, true, left);
    reverse_edges(downward, upward);
    static_cast<void>(rank(downward, work, false, left));
}

std::size_t TaskGraph::bytes() const noexcept {
    std::size_t sum = base::bytes(work);
    for (const Way* way : {&upward, &downward})
        sum += base::bytes(way->start) + base::bytes(way->next) + base::bytes(way->waits) +
               base::bytes(way->rank) + base::bytes(way->by_rank);
    return sum;
}

void TaskQueue::reserve(const TaskGraph& graph, int threads) {
    const std::size_t n = graph.work.size(), words = (n + 63) / 64;
    if (waits_.size() < n) waits_.resize(n);
    if (ready_.size() < words) ready_.resize(words);
    // Distribute new nodes among the threads in turn.
    for (std::size_t v = owner_.size(); v < n; ++v)
        owner_.push_back(static_cast<std::int16_t>(v % at(threads)));
    if (owned_.size() < words * at(threads)) owned_.resize(words * at(threads));
}

void TaskQueue::begin(const TaskGraph::Way& way, int threads) noexcept {
    const std::size_t n = way.waits.size();
    words_ = (n + 63) / 64;
    // An executor may report more threads than the buffers have capacity for, if it uses only the
    // first ones.
    if (words_ > 0) threads = std::min(threads, static_cast<int>(owned_.size() / words_));
    std::copy(way.waits.begin(), way.waits.end(), waits_.begin());
    std::fill_n(ready_.begin(), words_, std::uint64_t{0});
    std::fill_n(owned_.begin(), words_ * at(threads), std::uint64_t{0});
    for (std::size_t v = 0; v < n; ++v) {
        const std::size_t r = at(way.rank[v]);
        const std::uint64_t bit = std::uint64_t{1} << (r % 64);
        if (way.waits[v] == 0) ready_[r / 64] |= bit;
        if (owner_[v] < threads) owned_[at(owner_[v]) * words_ + r / 64] |= bit;
    }
}

/// Clear and return the lowest ready bit of a word among the given bits, −1: none.
int TaskQueue::claim_ready_bit(std::size_t w, std::uint64_t among) noexcept {
    std::atomic_ref word(ready_[w]);
    std::uint64_t bits = word.load(std::memory_order_relaxed) & among;
    while (bits != 0) {
        const std::uint64_t lowest = bits & (~bits + 1);
        const std::uint64_t before = word.fetch_and(~lowest, std::memory_order_acquire);
        if ((before & lowest) != 0) return std::countr_zero(lowest);
        bits = before & among;
    }
    return -1;
}

/// Return the next ready node. Called once per node: if none is ready, another thread is running a
/// predecessor.
std::int32_t TaskQueue::next_ready_node(const TaskGraph::Way& way, int thread, bool owns) noexcept {
    const std::uint64_t* mine = owned_.data() + at(thread) * words_;
    for (int spins = 0;; ++spins) {
        for (const bool own : {true, false})
            for (std::size_t w = 0; w < words_; ++w) {
                const int bit = claim_ready_bit(w, own ? mine[w] : ~std::uint64_t{0});
                if (bit < 0) continue;
                const std::int32_t node = way.by_rank[64 * w + static_cast<std::size_t>(bit)];
                if (owns) owner_[at(node)] = static_cast<std::int16_t>(thread);
                return node;
            }
        if (spins < 2'000)
            spin_pause();
        else
            std::this_thread::yield();  // for fewer cores than threads
    }
}

void TaskQueue::finish(const TaskGraph::Way& way, std::int32_t node) noexcept {
    for (std::int32_t k = way.start[at(node)]; k < way.start[at(node) + 1]; ++k) {
        const std::size_t v = at(way.next[at(k)]);
        if (std::atomic_ref(waits_[v]).fetch_sub(1, std::memory_order_acq_rel) != 1) continue;
        const std::size_t r = at(way.rank[v]);
        std::atomic_ref(ready_[r / 64])
            .fetch_or(std::uint64_t{1} << (r % 64), std::memory_order_release);
    }
}

}  // namespace hawser::factor
