// SPDX-License-Identifier: Apache-2.0
/// Move cuts along their wires.
#include "graph/split.h"

#include <cstdlib>

namespace hawser::graph {
namespace {

/// Largest distance that a cut moves, as a fraction of an even part.
constexpr double kMaxCutShift = 0.10;
/// A cut moves between two steps only if its weight falls below this fraction of the old weight.
constexpr double kMaxWeightRatio = 0.8;
/// Least gain for which a cut moves, in thousandths. Smaller gains are noise that would move cuts
/// in every step.
constexpr std::int64_t kMinGain = 100;

}  // namespace

/// Return the position with the least cost for the cut behind node `left`, as an index of
/// units_.nodes.
std::int32_t Splitter::cheaper_cut_near(std::int32_t wire, std::int32_t left) const noexcept {
    const auto part = [&](std::int32_t k) { return part_[at(units_.nodes[at(k)])]; };
    const auto room = static_cast<std::int64_t>(kMaxCutShift * static_cast<double>(mean_load_));
    std::int32_t best = left;
    for (const std::int32_t step : {-1, 1}) {
        std::int64_t moved = 0;
        std::int32_t k = left;
        for (;;) {
            const std::int32_t crossed = step < 0 ? k : k + 1;  // node that changes its part
            const std::int32_t next = k + step;
            if (next < units_.begin[at(wire)] + kStubNodes - 1 ||
                next + 1 > units_.begin[at(wire) + 1] - kStubNodes)
                break;
            const std::int32_t side = step < 0 ? part(left) : part(left + 1);
            if (part(crossed) != side || part(step < 0 ? next : next + 1) != side) break;
            if (group_part_[at(units_.nodes[at(crossed)])] >= 0) break;
            moved += node_cost_[at(units_.nodes[at(crossed)])];
            if (moved > room) break;
            k = next;
            const std::int64_t here = weight_[at(k)], there = weight_[at(best)];
            if (here < there || (here == there && std::abs(k - left) < std::abs(best - left)))
                best = k;
        }
    }
    return best;
}

void Splitter::move_cut(std::int32_t old_left, std::int32_t left) noexcept {
    const std::int32_t a = part_[at(units_.nodes[at(old_left)])];
    const std::int32_t b = part_[at(units_.nodes[at(old_left) + 1])];
    for (std::int32_t k = old_left + 1; k <= left; ++k) assign_part(units_.nodes[at(k)], a);
    for (std::int32_t k = left + 1; k <= old_left; ++k) assign_part(units_.nodes[at(k)], b);
}

void Splitter::move_cuts() {
    for (std::int32_t w = 0; w < units_.wires; ++w)
        for (std::int32_t k = units_.begin[at(w)]; k + 1 < units_.begin[at(w) + 1]; ++k) {
            if (part_[at(units_.nodes[at(k)])] == part_[at(units_.nodes[at(k + 1)])]) continue;
            const std::int32_t to = cheaper_cut_near(w, k);
            move_cut(k, to);
            k = std::max(k, to);
        }
}

/// Move the cut whose cost decreases most, if the decrease is large enough.
void Splitter::move_best_cut() {
    std::int32_t from = -1, to = -1;
    std::int64_t gain = kMinGain - 1;
    for (std::int32_t w = 0; w < units_.wires; ++w)
        for (std::int32_t k = units_.begin[at(w)]; k + 1 < units_.begin[at(w) + 1]; ++k) {
            if (part_[at(units_.nodes[at(k)])] == part_[at(units_.nodes[at(k + 1)])]) continue;
            const std::int32_t best = cheaper_cut_near(w, k);
            const std::int64_t old = weight_[at(k)], now = weight_[at(best)];
            const std::int64_t gained = old - now - repair_[at(k)];
            if (static_cast<double>(now) > kMaxWeightRatio * static_cast<double>(old) ||
                gained <= gain)
                continue;
            gain = gained;
            from = k;
            to = best;
        }
    if (from >= 0) move_cut(from, to);
}

}  // namespace hawser::graph
