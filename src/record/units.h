// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file units.h
/// Format numbers with readable units.

#include <string>

namespace hawser::record {

/// A unit with the power of thousand that makes `largest` readable, e.g. kN.
struct Unit {
    std::string name;
    double factor = 1.0;  ///< Factor from SI values to the unit.
};
[[nodiscard]] Unit readable_unit(double largest, const std::string& unit);

/// Format a number with three or four significant digits and its unit, e.g. "1.25 MN".
[[nodiscard]] std::string with_unit(double value, const std::string& unit);

}  // namespace hawser::record
