// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file units.h
/// Numbers with their units, as people read them.

#include <string>

namespace hawser::record {

/// A unit with the power of thousand in which `largest` reads well, e.g. kN.
struct Unit {
    std::string name;
    double factor = 1.0;  ///< Multiply SI values by it.
};
[[nodiscard]] Unit readable_unit(double largest, const std::string& unit);

/// A number with three or four significant digits and its unit, e.g. "1.25 MN".
[[nodiscard]] std::string with_unit(double value, const std::string& unit);

}  // namespace hawser::record
