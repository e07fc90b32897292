// SPDX-License-Identifier: Apache-2.0
#include "collide/broad.h"

#include "base/index.h"
#include "base/small.h"
#include "collide/grow.h"

#include <hawser/def.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <new>

namespace hawser::collide {
namespace {

using generic::load3;
using generic::V3;
constexpr int kSweepChunk = 128;  ///< Entries of the sweep per task.
constexpr int kLargeChunk = 256;  ///< Shapes per task that are tested against all large ones.
constexpr double kLargeRatio =
    8.0;  ///< Shapes larger than this multiple of the median size are large.
constexpr double kStripWidthRatio = 4.0;  ///< Width of a strip over the median size.
constexpr int kMaxStrips = 1024;
constexpr std::size_t kInitialPairs = 512;  ///< Capacity for the pairs of a task before it grows.
constexpr int kSomeAnyway = 4;              ///< If there are fewer shapes than this, all are large.

bool boxes_overlap(const Bounds& a, const Bounds& b) noexcept {
    return a.low[0] <= b.high[0] && b.low[0] <= a.high[0] && a.low[1] <= b.high[1] &&
           b.low[1] <= a.high[1] && a.low[2] <= b.high[2] && b.low[2] <= a.high[2];
}

/// True if the distance of a shape to a plane can become smaller than the margin within the step.
/// The swept box of the shape includes its motion and half of the margin. The motion of the plane
/// and the other half are added here.
bool meets_plane(const Placed& plane, const Placed& s, double h, double margin) noexcept {
    const double* r = plane.at.r;
    double least = 0.0;
    for (int i = 0; i < 3; ++i) {
        const double n = r[3 * i + 2];
        least += n * ((n > 0.0 ? s.swept.low[i] : s.swept.high[i]) - plane.at.x[i]);
    }
    const V3 w = load3(plane.motion.w);
    const V3 v = load3(plane.motion.v) + generic::cross(w, load3(s.centre) - load3(plane.origin));
    const double own = generic::norm(v) + generic::norm(w) * s.radius;
    return !(least > 0.5 * margin + h * own);
}

/// True if a shape was removed or its line has broken. Such slots have no size and are excluded
/// from the median. Otherwise, after a wire has lost most of its nodes, all other shapes would
/// count as large.
bool is_vacant_or_broken(const Placed& p) noexcept { return p.swept.low[0] > p.swept.high[0]; }

double extent(const Placed& p) noexcept {
    double e = 0.0;
    for (int i = 0; i < 3; ++i) e = std::max(e, p.box.high[i] - p.box.low[i]);
    return e;
}

/// List the small shapes. Shapes that were small in the last step keep the order of its sweep, so
/// that little sorting remains.
void list_small(std::vector<std::uint8_t>& is_large, std::vector<std::int32_t>& small) {
    constexpr std::uint8_t kListedShape = 2;
    std::size_t kept = 0;
    for (const std::int32_t s : small)
        if (at(s) < is_large.size() && is_large[at(s)] == 0) {
            is_large[at(s)] = kListedShape;
            small[kept++] = s;
        }
    small.resize(kept);
    for (std::size_t i = 0; i < is_large.size(); ++i) {
        if (is_large[i] == 0) small.push_back(static_cast<std::int32_t>(i));
        if (is_large[i] == kListedShape) is_large[i] = 0;
    }
}

/// Run a task that may throw std::bad_alloc. Workers must not throw.
template <class F>
void run(base::Executor& pool, int count, F&& f) {
    std::atomic<bool> failed{false};
    auto task = [&](int i, int) noexcept {
        try {
            f(i);
        } catch (const std::bad_alloc&) {
            failed = true;
        }
    };
    pool.for_each(count, task);
    if (failed) throw std::bad_alloc();
}

}  // namespace

void Broad::prepare(const base::Array<Placed>& placed) {
    std::vector<double>&extents = extents_, &by_size = by_size_;
    extents.clear();
    by_size.clear();
    for (const Placed& p : placed) {
        extents.push_back(extent(p));
        if (!is_vacant_or_broken(p)) by_size.push_back(extents.back());
    }
    const auto middle = by_size.begin() + static_cast<std::ptrdiff_t>(by_size.size() / 2);
    if (!by_size.empty()) std::nth_element(by_size.begin(), middle, by_size.end());
    const double limit = by_size.size() < kSomeAnyway ? -1.0 : kLargeRatio * *middle;
    is_large_.assign(placed.size(), 0);
    large_.clear();
    V3 sum{0.0, 0.0, 0.0}, square{0.0, 0.0, 0.0};
    double n = 0.0;
    for (std::size_t i = 0; i < placed.size(); ++i) {
        is_large_[i] = placed[i].unbounded || extents[i] > limit ? 1 : 0;
        if (is_large_[i]) {
            large_.push_back(static_cast<std::int32_t>(i));
            continue;
        }
        if (is_vacant_or_broken(placed[i])) continue;
        n += 1.0;
        const V3 c = load3(placed[i].centre);
        sum = sum + c;
        square = square + V3{c.x * c.x, c.y * c.y, c.z * c.z};
    }
    list_small(is_large_, small_);
    // Find the axis with the largest variance of the small shapes.
    n = std::max(n, 1.0);
    const double spread[3] = {square.x - sum.x * sum.x / n, square.y - sum.y * sum.y / n,
                              square.z - sum.z * sum.z / n};
    std::sort(axis_, axis_ + 3, [&](int a, int b) {
        return spread[a] > spread[b] || (spread[a] == spread[b] && a < b);
    });
    width_ = by_size.empty() ? 1.0 : std::max(kStripWidthRatio * *middle, 1e-9);
    first_.resize(placed.size() + 2);
    sorted_.resize(small_.size());
    strip_begin_.reserve(kMaxStrips + 2);
}

void Broad::sort(const base::Array<Placed>& placed) {
    auto less = [](const Sorted& a, const Sorted& b) {
        return a.low[0] < b.low[0] || (a.low[0] == b.low[0] && a.shape < b.shape);
    };
    // The cost of insertion grows with the motion since the last step. If it becomes too large,
    // sort from the start.
    std::size_t moved = 0;
    const std::size_t most = 16 * small_.size();
    for (std::size_t i = 0; i < small_.size(); ++i) {
        Sorted s{};
        s.shape = small_[i];
        const Bounds& box = placed[at(s.shape)].swept;
        for (int k = 0; k < 3; ++k) {
            s.low[k] = box.low[axis_[k]];
            s.high[k] = box.high[axis_[k]];
        }
        std::size_t to = i;
        for (; to > 0 && moved <= most && less(s, sorted_[to - 1]); --to, ++moved)
            sorted_[to] = sorted_[to - 1];
        sorted_[to] = s;
    }
    if (moved > most) std::sort(sorted_.begin(), sorted_.end(), less);
    for (std::size_t i = 0; i < small_.size(); ++i) small_[i] = sorted_[i].shape;
}

void Broad::cut_into_strips() {
    double low = 1e300, high = -1e300;
    for (const Sorted& s : sorted_) {
        if (s.low[0] > s.high[0]) continue;  // empty box
        low = std::min(low, s.low[1]);
        high = std::max(high, s.high[1]);
    }
    const double span = std::max(high - low, 0.0);
    const int count = static_cast<int>(std::clamp(span / width_, 1.0, double{kMaxStrips}));
    const double per_length = span > 0.0 ? count / span : 0.0;
    auto strip = [&](double x) {
        return static_cast<std::int32_t>(std::clamp((x - low) * per_length, 0.0, count - 1.0));
    };
    strip_begin_.assign(static_cast<std::size_t>(count) + 2, 0);
    for (Sorted& s : sorted_) {
        if (s.low[0] > s.high[0]) continue;
        s.first = strip(s.low[1]);
        for (std::int32_t k = s.first; k <= strip(s.high[1]); ++k) ++strip_begin_[at(k) + 2];
    }
    for (std::size_t k = 2; k < strip_begin_.size(); ++k) strip_begin_[k] += strip_begin_[k - 1];
    resize_with_reserve(entries_, at(strip_begin_.back()));
    for (Sorted& s : sorted_) {
        if (s.low[0] > s.high[0]) continue;
        for (s.strip = s.first; s.strip <= strip(s.high[1]); ++s.strip)
            entries_[at(strip_begin_[at(s.strip) + 1]++)] = s;
    }
}

/// Number of pairs found by all tasks. Each task adds its pairs in batches of kBatchSize.
struct Broad::Count {
    static constexpr std::size_t kBatchSize = 4096;
    std::atomic<std::int64_t> reported{0};
    const std::int64_t most;
    base::Executor& pool;
    /// Count the pairs that a task has found towards the limit of all tasks. @param found  Pairs
    /// found by the task. @param own  Number of these that are already counted. @return true if the
    /// search may continue.
    bool add_and_continue(std::size_t found, std::size_t& own) noexcept {
        if (found - own < kBatchSize) return !pool.stopping();
        const auto more = static_cast<std::int64_t>(found - own);
        own = found;
        return reported.fetch_add(more, std::memory_order_relaxed) + more <= most &&
               !pool.stopping();
    }
};

void Broad::find_pairs_in_strip(int chunk, const Filter& filter, Count& count) {
    base::Array<Pair>& found = found_[at(chunk)];
    found.clear();
    const std::size_t end = std::min(entries_.size(), at((chunk + 1) * kSweepChunk));
    std::size_t reported = 0;
    for (std::size_t i = at(chunk * kSweepChunk); i < end; ++i) {
        const Sorted& s = entries_[i];
        const std::size_t stop = at(strip_begin_[at(s.strip) + 1]);
        for (std::size_t j = i + 1; j < stop && entries_[j].low[0] <= s.high[0]; ++j) {
            const Sorted& o = entries_[j];
            if (s.low[1] > o.high[1] || o.low[1] > s.high[1] || s.low[2] > o.high[2] ||
                o.low[2] > s.high[2])
                continue;
            if (std::max(s.first, o.first) != s.strip || !filter.may_touch(s.shape, o.shape))
                continue;
            found.push_back({std::min(s.shape, o.shape), std::max(s.shape, o.shape)});
        }
        if (!count.add_and_continue(found.size(), reported)) return;
    }
}

void Broad::test_against_large(int chunk, const base::Array<Placed>& placed, const Filter& filter,
                               double h, double margin, Count& pairs) {
    base::Array<Pair>& found = found_[at(base::chunks(entries_.size(), kSweepChunk) + chunk)];
    found.clear();
    const auto count = static_cast<std::int32_t>(placed.size());
    const std::int32_t begin = chunk * kLargeChunk, end = std::min(count, begin + kLargeChunk);
    std::size_t reported = 0;
    for (const std::int32_t big : large_) {
        const Placed& p = placed[at(big)];
        const bool plane = p.geometry.kind == ShapeKind::plane;
        for (std::int32_t s = begin; s < end; ++s) {
            if (s == big || (is_large_[at(s)] && s < big)) continue;
            const Placed& o = placed[at(s)];
            if (!boxes_overlap(p.swept, o.swept)) continue;
            if (plane && !o.unbounded && !meets_plane(p, o, h, margin)) continue;
            if (filter.may_touch(big, s)) found.push_back({std::min(big, s), std::max(big, s)});
        }
        if (!pairs.add_and_continue(found.size(), reported)) return;
    }
}

void Broad::gather(int lists, base::Array<Pair>& out) {
    std::fill(first_.begin(), first_.end(), 0);
    for (int l = 0; l < lists; ++l)
        for (const Pair& p : found_[at(l)]) ++first_[at(p.a) + 2];
    for (std::size_t i = 2; i < first_.size(); ++i) first_[i] += first_[i - 1];
    resize_with_reserve(out, at(first_.back()));
    for (int l = 0; l < lists; ++l)
        for (const Pair& p : found_[at(l)]) out[at(first_[at(p.a) + 1]++)] = p;
    for (std::size_t i = 0; i + 2 < first_.size(); ++i) {
        Pair* const a = out.data() + first_[i];
        Pair* const b = out.data() + first_[i + 1];
        if (!std::is_sorted(a, b)) std::sort(a, b);
    }
}

void Broad::find(const base::Array<Placed>& placed, const Filter& filter, double h, double margin,
                 std::int64_t most, base::Executor& pool, base::Array<Pair>& out) {
    sort(placed);
    cut_into_strips();
    const int sweeps = base::chunks(entries_.size(), kSweepChunk);
    const int others = large_.empty() ? 0 : base::chunks(placed.size(), kLargeChunk);
    const auto tasks = static_cast<std::size_t>(sweeps) + static_cast<std::size_t>(others);
    while (found_.size() < tasks) found_.emplace_back().reserve(kInitialPairs);
    Count count{.reported = 0, .most = most, .pool = pool};
    run(pool, sweeps + others, [&](int i) {
        if (i < sweeps)
            find_pairs_in_strip(i, filter, count);
        else
            test_against_large(i - sweeps, placed, filter, h, margin, count);
    });
    std::size_t pairs = 0;
    for (std::size_t l = 0; l < tasks; ++l) pairs += found_[l].size();
    if (pairs > static_cast<std::size_t>(most))
        throw LimitError({Bound::pairs, static_cast<double>(pairs), static_cast<double>(most)});
    gather(sweeps + others, out);
}

std::size_t Broad::bytes() const noexcept {
    std::size_t n = base::bytes(is_large_) + base::bytes(large_) + base::bytes(small_) +
                    base::bytes(sorted_) + base::bytes(entries_) + base::bytes(strip_begin_) +
                    base::bytes(first_);
    for (const auto& f : found_) n += base::bytes(f);
    return n;
}

}  // namespace hawser::collide
