// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file cut_levels.h
/// Which interfaces between groups a step couples compliantly, when friction with one iteration
/// does not fit its deadline (docs/methods.md, 11).
///
/// Level l couples the first l interfaces so, in the order of what cutting them costs by the
/// weights of the partitioner (docs/partition.md): those with the least net force and relative
/// velocity first. What a level saves is not guessed: its matrix is analysed once, for its flops
/// and nnz(L), in the first step in which forces are known, and its time predicted from them
/// (deadline.h). A level that is not predicted to be cheaper than the one in force is never taken:
/// in wires, whose exact factorisation has next to no fill, no split saves anything, and none is
/// made.
///
/// Limits: coming to another level analyses the system in that step. So a level stays for at least
/// kStay steps, and gives way to a lower one only where that fits with a tenth to spare.

#include "context/deadline.h"

#include <cstdint>
#include <vector>

namespace hawser::stepper {

class CutLevels {
  public:
    static constexpr int kStay = 20;         ///< Steps.
    static constexpr double kSaving = 0.95;  ///< Of the time of the level in force, at most.
    static constexpr double kRoom = 0.9;     ///< Of the limit, for a lower level.

    struct Level {
        std::uint64_t interfaces = 0;
        /// matrix_work(): of an analysis beside the world, and once it has been in force of the
        /// world's own.
        double matrix = 0.0;
    };

    /// Level 0 first. @param levels  Empty: none are known.
    void set(std::vector<Level> levels);
    [[nodiscard]] bool known() const noexcept { return !levels_.empty(); }
    [[nodiscard]] const std::vector<Level>& levels() const noexcept { return levels_; }
    /// Interfaces for the step that begins. @param load  Of a step at the level in force.
    /// @param asked  Interfaces of the step before.
    [[nodiscard]] std::uint64_t choose(const Deadline& deadline, const Load& load, double seconds,
                                       std::uint64_t asked) noexcept;

  private:
    [[nodiscard]] std::size_t wanted(const std::vector<double>& time, double seconds) noexcept;

    std::vector<Level> levels_;
    std::vector<double> time_;  ///< Scratch.
    std::size_t now_ = 0;
    bool fresh_ = true;  ///< The level in force has not been seen in a step yet.
    int since_ = 0;      ///< Steps at this level in which a lower one would have done, in a row.
};

}  // namespace hawser::stepper
