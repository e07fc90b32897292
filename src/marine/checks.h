// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file checks.h
/// Check the definition of a sea. Errors name the field.

#include <hawser/sea.h>

#include "base/number.h"

#include <cmath>
#include <string>

namespace hawser::marine {

/// Return the name of an entry of a list, such as "lines/3".
[[nodiscard]] inline std::string entry(const char* list, std::size_t i) {
    return std::string(list) + "/" + std::to_string(i);
}

/// Check the range of a number.
/// @throws SeaError if the value is NaN, below `least` (or equal to it, if `above` is set) or above
/// `most`.
inline void check_range(const std::string& field, double value, double least, double most,
                        bool above, const char* unit) {
    if ((value > least || (!above && value == least)) && value <= most) return;
    throw SeaError(field, number(value) + " " + unit + "; give " +
                              (above ? "more than " : "from ") + number(least) + " to " +
                              number(most));
}

/// Check depth, level, waves, current and wind.
/// @throws SeaError
void check_sea(const SeaDef& def, double gravity);

/// Check the coefficients of lines and rods, including their volume.
/// @throws SeaError
void check_line_water(const std::string& at, const LineWater& water);

/// Check coefficients, memory, strips and linear statics of a hull.
/// @throws SeaError
void check_coefficients(const World& world, const WaterHull& hull, const std::string& at);

}  // namespace hawser::marine
