// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file lasting_faults.h
/// Ranges that do not hold and bodies that lie in each other, by definitions and poses alone.
///
/// What strikes the end of a range passes it within a step by the way that it goes in one, and what
/// falls comes in: both come back. Wrong is what stays for more than six steps, which in small
/// worlds are six looks of the program's own judge.

#include <hawser/hawser.h>

#include <span>
#include <string>

namespace hawser::verify {

class LastingFaults {
  public:
    /// @param pose  Of all bodies, by index, after the step. @return "" or what is wrong.
    [[nodiscard]] std::string after_step(const World& world, std::span<const Pose> pose);

  private:
    std::string check_ranges(const World& world, std::span<const Pose> pose);
    std::string check_depths(const World& world);
    int beyond_ = 0;  ///< Steps in a row after which some range was violated.
    int deep_ = 0;    ///< Steps in a row after which some body lay deep in another.
};

}  // namespace hawser::verify
