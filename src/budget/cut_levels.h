// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file cut_levels.h
/// Choice of the interfaces between groups that a step couples compliantly
/// (docs/theory/deadlines.md). Interfaces become compliant if a step with one iteration of
/// friction still misses the deadline.
///
/// Level l couples the first l interfaces compliantly. They are ordered by the cost of a cut, with
/// the weights of the partitioner (docs/partition.md). Interfaces with the least net force and
/// relative velocity come first.
///
/// The saving of a level is predicted. Its matrix is analysed once, in the first step with known
/// forces, for its flops and nnz(L). Its time follows from them (deadline.h). A level is used only
/// if it is predicted to be cheaper than the present one. The exact factorisation of wires has
/// nearly no fill-in. A split of wires saves nothing and is not made.
///
/// Limits: a change of level needs an analysis of the system in that step. A level is therefore
/// used for at least kMinStepsAtLevel steps. A lower level follows only if it fits with a margin of
/// 10 %.

#include "budget/deadline.h"

#include <cstdint>
#include <vector>

namespace hawser::budget {

class CutLevels {
  public:
    static constexpr int kMinStepsAtLevel = 20;  ///< Steps.
    /// Maximum time of a new level relative to the present one.
    static constexpr double kMaxTimeRatio = 0.95;
    static constexpr double kLowerLevelFraction =
        0.9;  ///< Maximum fraction of the limit for a lower level.

    struct Level {
        std::uint64_t interfaces = 0;
        /// matrix_work() from a separate analysis; after the level has been active, from the
        /// analysis of the world.
        double matrix = 0.0;
    };

    /// Set the levels: sets of interfaces that may be cut, level 0 first.
    /// @param levels  Empty: no levels are known.
    void set(std::vector<Level> levels);
    [[nodiscard]] bool known() const noexcept { return !levels_.empty(); }
    [[nodiscard]] const std::vector<Level>& levels() const noexcept { return levels_; }
    /// Choose the interfaces to cut in the next step, as a bit mask. @param load  Load of a step at
    /// the present level. @param asked  Interfaces cut in the step before.
    [[nodiscard]] std::uint64_t choose(const Deadline& deadline, const Load& load, double seconds,
                                       std::uint64_t asked) noexcept;

  private:
    [[nodiscard]] std::size_t required_level(const std::vector<double>& time,
                                             double seconds) noexcept;

    std::vector<Level> levels_;
    std::vector<double> time_;  ///< Scratch.
    std::size_t level_ = 0;
    bool level_untried_ = true;  ///< True if no step has used the present level yet.
    int steps_with_margin_ =
        0;  ///< Consecutive steps at this level in which a lower one would have sufficed.
};

}  // namespace hawser::budget
