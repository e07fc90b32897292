// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file checks.h
/// Refusals of a sea's definition, by its field.

#include <hawser/sea.h>

#include "base/number.h"

#include <cmath>
#include <string>

namespace hawser::marine {

/// "lines/3" and the like.
[[nodiscard]] inline std::string entry(const char* list, std::size_t i) {
    return std::string(list) + "/" + std::to_string(i);
}

/// @throws SeaError for a number below the least one, at it where it has to be above, above the
/// most, or none.
inline void check_range(const std::string& field, double value, double least, double most,
                        bool above, const char* unit) {
    if ((value > least || (!above && value == least)) && value <= most) return;
    throw SeaError(field, number(value) + " " + unit + "; give " +
                              (above ? "more than " : "from ") + number(least) + " to " +
                              number(most));
}

/// Depth, level, waves, current, wind. @throws SeaError
void check_sea(const SeaDef& def, double gravity);

/// Coefficients of lines and rods, with their volume. @throws SeaError
void check_line_water(const std::string& at, const LineWater& water);

/// Coefficients, memory, strips and linear statics of a hull. @throws SeaError
void check_coefficients(const World& world, const WaterHull& hull, const std::string& at);

}  // namespace hawser::marine
