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

/// Edges sorted by their first node, each once.
void fill(TaskGraph::Way& way, const Edges& edges, std::size_t n) {
    way.start.assign(n + 1, 0);
    way.waits.assign(n, 0);
    way.next.clear();
    for (const auto& [from, to] : edges) {
        ++way.start[at(from) + 1];
        ++way.waits[at(to)];
        way.next.push_back(to);
    }
    std::partial_sum(way.start.begin(), way.start.end(), way.start.begin());
}

/// Nodes by what is left to do once they begin: their own work and the longest path behind it.
std::int64_t rank(TaskGraph::Way& way, const std::vector<std::int64_t>& work, bool up) {
    const std::size_t n = work.size();
    std::vector<std::int64_t> left(n);
    std::int64_t path = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t v = up ? n - 1 - i : i;
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

inline void relax() noexcept {
#if defined(__x86_64__)
    __builtin_ia32_pause();
#endif
}

}  // namespace

void TaskGraph::build(Edges& edges) {
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    fill(up, edges, work.size());
    path = rank(up, work, true);
    for (auto& [from, to] : edges) std::swap(from, to);
    std::sort(edges.begin(), edges.end());
    fill(down, edges, work.size());
    static_cast<void>(rank(down, work, false));
}

std::size_t TaskGraph::bytes() const noexcept {
    std::size_t sum = base::bytes(work);
    for (const Way* way : {&up, &down})
        sum += base::bytes(way->start) + base::bytes(way->next) + base::bytes(way->waits) +
               base::bytes(way->rank) + base::bytes(way->by_rank);
    return sum;
}

void TaskQueue::reserve(const TaskGraph& graph, int threads) {
    const std::size_t n = graph.work.size(), words = (n + 63) / 64;
    if (waits_.size() < n) waits_.resize(n);
    if (ready_.size() < words) ready_.resize(words);
    // At first in turns, as a list would be dealt out.
    for (std::size_t v = owner_.size(); v < n; ++v)
        owner_.push_back(static_cast<std::int16_t>(v % at(threads)));
    if (mine_.size() < words * at(threads)) mine_.resize(words * at(threads));
}

void TaskQueue::begin(const TaskGraph::Way& way, int threads) noexcept {
    const std::size_t n = way.waits.size();
    words_ = (n + 63) / 64;
    // An executor may tell of more threads than there is room for, if it uses the first ones only.
    if (words_ > 0) threads = std::min(threads, static_cast<int>(mine_.size() / words_));
    std::copy(way.waits.begin(), way.waits.end(), waits_.begin());
    std::fill_n(ready_.begin(), words_, std::uint64_t{0});
    std::fill_n(mine_.begin(), words_ * at(threads), std::uint64_t{0});
    for (std::size_t v = 0; v < n; ++v) {
        const std::size_t r = at(way.rank[v]);
        const std::uint64_t bit = std::uint64_t{1} << (r % 64);
        if (way.waits[v] == 0) ready_[r / 64] |= bit;
        if (owner_[v] < threads) mine_[at(owner_[v]) * words_ + r / 64] |= bit;
    }
}

/// The lowest ready bit of a word among those, −1: none.
int TaskQueue::take_bit(std::size_t w, std::uint64_t among) noexcept {
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

/// As many calls as nodes: where nothing is ready, another thread is at work on what will be.
std::int32_t TaskQueue::take(const TaskGraph::Way& way, int thread) noexcept {
    const std::uint64_t* mine = mine_.data() + at(thread) * words_;
    for (int spins = 0;; ++spins) {
        for (const bool own : {true, false})
            for (std::size_t w = 0; w < words_; ++w) {
                const int bit = take_bit(w, own ? mine[w] : ~std::uint64_t{0});
                if (bit < 0) continue;
                const std::int32_t node = way.by_rank[64 * w + static_cast<std::size_t>(bit)];
                owner_[at(node)] = static_cast<std::int16_t>(thread);
                return node;
            }
        if (spins < 2'000)
            relax();
        else
            std::this_thread::yield();  // fewer cores than threads
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
