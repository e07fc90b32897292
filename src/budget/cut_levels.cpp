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
    level_ = 0;
    steps_with_margin_ = 0;
    level_untried_ = true;
}

std::size_t CutLevels::required_level(const std::vector<double>& time, double seconds) noexcept {
    if (time[level_] > seconds) {
        steps_with_margin_ = 0;
        std::size_t best = level_;
        for (std::size_t l = level_ + 1; l < time.size(); ++l) {
            if (time[l] < time[best]) best = l;
            if (time[l] <= seconds) break;
        }
        return time[best] <= kMaxTimeRatio * time[level_] ? best : level_;
    }
    std::size_t lower = 0;
    while (lower < level_ && time[lower] > kLowerLevelFraction * seconds) ++lower;
    steps_with_margin_ = lower < level_ ? steps_with_margin_ + 1 : 0;
    if (steps_with_margin_ < kMinStepsAtLevel) return level_;
    steps_with_margin_ = 0;
    return lower;
}

std::uint64_t CutLevels::choose(const Deadline& deadline, const Load& load, double seconds,
                                std::uint64_t asked) noexcept {
    if (levels_.size() < 2) return 0;
    // After a restore, or a step with prescribed cuts, another level may be active.
    for (std::size_t l = 0; l < levels_.size(); ++l) {
        if (levels_[l].interfaces != asked || l == level_) continue;
        level_ = l;
        level_untried_ = true;
    }
    if (!deadline.has_enough_samples()) return asked;
    const double sweeps = kRowWork * load.rows;
    const double matrix = load.matrix - sweeps, change = matrix - levels_[level_].matrix;
    // Contacts change the matrix at all levels by the same amount.
    for (Level& l : levels_)
        if (!level_untried_) l.matrix = std::max(0.0, l.matrix + change);
    levels_[level_].matrix = matrix;
    for (std::size_t l = 0; l < levels_.size(); ++l)
        time_[l] = deadline.predict({load.rows, levels_[l].matrix + sweeps}, 1);
    const std::size_t before = std::exchange(level_, required_level(time_, seconds));
    level_untried_ = level_ != before;
    return levels_[level_].interfaces;
}

}  // namespace hawser::budget
