// SPDX-License-Identifier: Apache-2.0
#include "budget/cut_levels.h"

#include "assembly/parts.h"
#include "base/index.h"
#include "budget/deadline.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace hawser::budget {

void CutLevels::set(std::vector<Level> levels) {
    levels_ = std::move(levels);
    time_.resize(levels_.size());
    now_ = 0;
    since_ = 0;
    fresh_ = true;
}

std::size_t CutLevels::wanted(const std::vector<double>& time, double seconds) noexcept {
    if (time[now_] > seconds) {
        since_ = 0;
        std::size_t best = now_;
        for (std::size_t l = now_ + 1; l < time.size(); ++l) {
            if (time[l] < time[best]) best = l;
            if (time[l] <= seconds) break;
        }
        return time[best] <= kSaving * time[now_] ? best : now_;
    }
    std::size_t lower = 0;
    while (lower < now_ && time[lower] > kRoom * seconds) ++lower;
    since_ = lower < now_ ? since_ + 1 : 0;
    if (since_ < kStay) return now_;
    since_ = 0;
    return lower;
}

std::uint64_t CutLevels::choose(const Deadline& deadline, const Load& load, double seconds,
                                std::uint64_t asked) noexcept {
    if (levels_.size() < 2) return 0;
    // After a restore, or a step with prescribed cuts, another level may be active.
    for (std::size_t l = 0; l < levels_.size(); ++l) {
        if (levels_[l].interfaces != asked || l == now_) continue;
        now_ = l;
        fresh_ = true;
    }
    if (!deadline.settled()) return asked;
    const double sweeps = kRowWork * load.rows;
    const double matrix = load.matrix - sweeps, change = matrix - levels_[now_].matrix;
    // Contacts change the matrix at all levels by the same amount.
    for (Level& l : levels_)
        if (!fresh_) l.matrix = std::max(0.0, l.matrix + change);
    levels_[now_].matrix = matrix;
    for (std::size_t l = 0; l < levels_.size(); ++l)
        time_[l] = deadline.predict({load.rows, levels_[l].matrix + sweeps}, 1);
    const std::size_t before = std::exchange(now_, wanted(time_, seconds));
    fresh_ = now_ != before;
    return levels_[now_].interfaces;
}

}  // namespace hawser::budget
