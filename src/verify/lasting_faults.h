// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file lasting_faults.h
/// Detect violated ranges and overlapping bodies from definitions and poses alone.
///
/// A body that is forced beyond the end of a range, and a falling body that penetrates, return
/// within some steps. A failure is a violation for more than six steps. In small worlds
/// these are six samples of the program's own monitor.

#include <hawser/hawser.h>

#include <span>
#include <string>

namespace hawser::verify {

class LastingFaults {
  public:
    /// Check the state after a step. @param pose  Poses of all bodies, by index, after the step.
    /// @return "" or a description of the failure.
    [[nodiscard]] std::string after_step(const World& world, std::span<const Pose> pose);

  private:
    std::string check_ranges(const World& world, std::span<const Pose> pose);
    std::string check_depths(const World& world);
    int steps_beyond_ = 0;  ///< Consecutive steps with a violated range.
    int deep_ = 0;          ///< Consecutive steps with a deep overlap.
};

}  // namespace hawser::verify
