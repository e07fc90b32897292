// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file random_control.h
/// Generate random input values over time as a control file (record/control.h).
///
/// Each input has its own random sequence, from the seed and its name. An additional input
/// therefore does not change the values of the others. The generator is std::mt19937_64, whose
/// numbers the C++ standard fixes, and the text depends on no other source.

#include <cstdint>
#include <span>
#include <string>

namespace hawser::record {

struct RandomInput {
    std::string name;
    double min = 0.0, max = 0.0;  ///< Range of its values, finite.
    double start = 0.0;           ///< Value at time 0; clamped to the range.
    double rest = 0.0;            ///< Value that it returns to in between; clamped to the range.
    bool whole = false;           ///< Whole numbers and steps only, such as the mode of a winch.
};

struct RandomControlDef {
    std::uint64_t seed = 1;
    double duration = 0.0;  ///< Changes happen before this time [s].
    double period = 5.0;    ///< Mean time between changes of an input [s].
    double interval = 0.1;  ///< Time between the lines of a ramp, and unit of all times [s].
};

/// Return the text of a control file. It has steps (60 %) and ramps (40 %). Their targets are a
/// limit of the range (30 %), `rest` (20 %) or any value between. The first line of values has the
/// start values of all inputs.
[[nodiscard]] std::string random_control(std::span<const RandomInput> inputs,
                                         const RandomControlDef& def);

}  // namespace hawser::record
