// SPDX-License-Identifier: Apache-2.0
#include "collide/broad.h"

#include "base/small.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <new>

namespace hawser::collide {
namespace {

using generic::load3;
using generic::V3;
std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

constexpr int kSweepChunk = 128;  ///< Places in the sweep of one task.
constexpr int kLargeChunk = 256;  ///< Shapes that one task holds against all large ones.
constexpr double kLarge = 8.0;    ///< Times the median size.
constexpr int kSomeAnyway = 4;    ///< Fewer shapes than this are all large.

int chunks(std::size_t count, int size) { return (static_cast<int>(count) + size - 1) / size; }

bool meet(const Bounds& a, const Bounds& b) noexcept {
    return a.low[0] <= b.high[0] && b.low[0] <= a.high[0] && a.low[1] <= b.high[1] &&
           b.low[1] <= a.high[1] && a.low[2] <= b.high[2] && b.low[2] <= a.high[2];
}

/// Can a shape come closer to a plane than the margin? What it reaches is in its swept box, with
/// half of the margin; the other half and the plane's own motion come on top.
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

double extent(const Placed& p) noexcept {
    double e = 0.0;
    for (int i = 0; i < 3; ++i) e = std::max(e, p.box.high[i] - p.box.low[i]);
    return e;
}

/// Run a task that may throw std::bad_alloc; workers may not.
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
    std::vector<double> extents;
    for (const Placed& p : placed) extents.push_back(extent(p));
    std::vector<double> by_size = extents;
    const auto middle = by_size.begin() + static_cast<std::ptrdiff_t>(by_size.size() / 2);
    if (!by_size.empty()) std::nth_element(by_size.begin(), middle, by_size.end());
    const double limit = by_size.size() < kSomeAnyway ? -1.0 : kLarge * *middle;
    is_large_.assign(placed.size(), 0);
    large_.clear();
    small_.clear();
    V3 sum{0.0, 0.0, 0.0}, square{0.0, 0.0, 0.0};
    for (std::size_t i = 0; i < placed.size(); ++i) {
        is_large_[i] = placed[i].unbounded || extents[i] > limit ? 1 : 0;
        (is_large_[i] ? large_ : small_).push_back(static_cast<std::int32_t>(i));
        if (is_large_[i]) continue;
        const V3 c = load3(placed[i].centre);
        sum = sum + c;
        square = square + V3{c.x * c.x, c.y * c.y, c.z * c.z};
    }
    // The axis along which the small shapes are spread most.
    const double n = std::max<double>(1.0, static_cast<double>(small_.size()));
    const double spread[3] = {square.x - sum.x * sum.x / n, square.y - sum.y * sum.y / n,
                              square.z - sum.z * sum.z / n};
    axis_ = static_cast<int>(std::max_element(spread, spread + 3) - spread);
    found_.resize(static_cast<std::size_t>(chunks(small_.size(), kSweepChunk) +
                                           chunks(placed.size(), kLargeChunk)));
    first_.resize(placed.size() + 2);
    sorted_.resize(small_.size());
}

void Broad::sort(const base::Array<Placed>& placed) {
    const int axes[3] = {axis_, (axis_ + 1) % 3, (axis_ + 2) % 3};
    auto less = [](const Sorted& a, const Sorted& b) {
        return a.low[0] < b.low[0] || (a.low[0] == b.low[0] && a.shape < b.shape);
    };
    // Insertion costs what moved since the last step; where that is much, sorting anew is cheaper.
    std::size_t moved = 0;
    const std::size_t most = 16 * small_.size();
    for (std::size_t i = 0; i < small_.size(); ++i) {
        Sorted s{};
        s.shape = small_[i];
        const Bounds& box = placed[at(s.shape)].swept;
        for (int k = 0; k < 3; ++k) {
            s.low[k] = box.low[axes[k]];
            s.high[k] = box.high[axes[k]];
        }
        std::size_t to = i;
        for (; to > 0 && moved <= most && less(s, sorted_[to - 1]); --to, ++moved)
            sorted_[to] = sorted_[to - 1];
        sorted_[to] = s;
    }
    if (moved > most) std::sort(sorted_.begin(), sorted_.end(), less);
    for (std::size_t i = 0; i < small_.size(); ++i) small_[i] = sorted_[i].shape;
}

void Broad::sweep(int chunk, const Filter& filter) {
    base::Array<Pair>& found = found_[at(chunk)];
    found.clear();
    const std::size_t count = sorted_.size();
    const std::size_t end = std::min(count, at((chunk + 1) * kSweepChunk));
    for (std::size_t i = at(chunk * kSweepChunk); i < end; ++i) {
        const Sorted& s = sorted_[i];
        for (std::size_t j = i + 1; j < count && sorted_[j].low[0] <= s.high[0]; ++j) {
            const Sorted& o = sorted_[j];
            if (s.low[1] > o.high[1] || o.low[1] > s.high[1] || s.low[2] > o.high[2] ||
                o.low[2] > s.high[2])
                continue;
            if (!filter.allows(s.shape, o.shape)) continue;
            found.push_back({std::min(s.shape, o.shape), std::max(s.shape, o.shape)});
        }
    }
}

void Broad::hold_against_large(int chunk, const base::Array<Placed>& placed, const Filter& filter,
                               double h, double margin) {
    base::Array<Pair>& found = found_[at(chunks(small_.size(), kSweepChunk) + chunk)];
    found.clear();
    const auto count = static_cast<std::int32_t>(placed.size());
    const std::int32_t begin = chunk * kLargeChunk, end = std::min(count, begin + kLargeChunk);
    for (const std::int32_t big : large_) {
        const Placed& p = placed[at(big)];
        const bool plane = p.geometry.kind == ShapeKind::plane;
        for (std::int32_t s = begin; s < end; ++s) {
            if (s == big || (is_large_[at(s)] && s < big)) continue;
            const Placed& o = placed[at(s)];
            if (!meet(p.swept, o.swept)) continue;
            if (plane && !o.unbounded && !meets_plane(p, o, h, margin)) continue;
            if (filter.allows(big, s)) found.push_back({std::min(big, s), std::max(big, s)});
        }
    }
}

void Broad::gather(int lists, base::Array<Pair>& out) {
    std::fill(first_.begin(), first_.end(), 0);
    for (int l = 0; l < lists; ++l)
        for (const Pair& p : found_[at(l)]) ++first_[at(p.a) + 2];
    for (std::size_t i = 2; i < first_.size(); ++i) first_[i] += first_[i - 1];
    out.resize(at(first_.back()));
    for (int l = 0; l < lists; ++l)
        for (const Pair& p : found_[at(l)]) out[at(first_[at(p.a) + 1]++)] = p;
    for (std::size_t i = 0; i + 2 < first_.size(); ++i) {
        Pair* const a = out.data() + first_[i];
        Pair* const b = out.data() + first_[i + 1];
        if (!std::is_sorted(a, b)) std::sort(a, b);
    }
}

void Broad::find(const base::Array<Placed>& placed, const Filter& filter, double h, double margin,
                 base::Executor& pool, base::Array<Pair>& out) {
    sort(placed);
    const int sweeps = chunks(small_.size(), kSweepChunk);
    const int others = large_.empty() ? 0 : chunks(placed.size(), kLargeChunk);
    run(pool, sweeps + others, [&](int i) {
        if (i < sweeps)
            sweep(i, filter);
        else
            hold_against_large(i - sweeps, placed, filter, h, margin);
    });
    gather(sweeps + others, out);
}

std::size_t Broad::bytes() const noexcept {
    std::size_t n = base::bytes(is_large_) + base::bytes(large_) + base::bytes(small_) +
                    base::bytes(sorted_) + base::bytes(first_);
    for (const auto& f : found_) n += base::bytes(f);
    return n;
}

}  // namespace hawser::collide
