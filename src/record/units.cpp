// SPDX-License-Identifier: Apache-2.0
#include "record/units.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

namespace hawser::record {

Unit readable_unit(double largest, const std::string& unit) {
    static constexpr std::array<std::pair<double, const char*>, 6> kPrefixes{
        {{1e9, "G"}, {1e6, "M"}, {1e3, "k"}, {1.0, ""}, {1e-3, "m"}, {1e-6, "µ"}}};
    if (!std::isfinite(largest) || largest == 0.0) return {unit, 1.0};
    // Masses: prefixes below a kilogram belong to the gram, those from 1000 kg on to the tonne.
    if (unit == "kg" && std::abs(largest) < 1.0) {
        const Unit grams = readable_unit(largest * 1e3, "g");
        return {grams.name, grams.factor * 1e3};
    }
    if (unit == "kg" && std::abs(largest) >= 1e3) {
        const Unit tonnes = readable_unit(largest * 1e-3, "t");
        return {tonnes.name, tonnes.factor * 1e-3};
    }
    if (unit == "kg") return {unit, 1.0};
    // Lengths stay in metres up to scenes of kilometres: motions of ships are not read in km.
    for (const auto& [size, prefix] : kPrefixes) {
        if (unit == "m" && size > 1.0) continue;
        if (std::abs(largest) >= size || size == 1e-6) return {prefix + unit, 1.0 / size};
    }
    return {unit, 1.0};
}

std::string with_unit(double value, const std::string& unit) {
    const Unit u = readable_unit(value, unit);
    const double shown = value * u.factor + 0.0;  // a slack line's −0 is shown as 0
    if (value != 0.0 && std::abs(shown) < 0.1) return fmt::format("{:.2e} {}", value, unit);
    return fmt::format("{:.4g} {}", shown, u.name);
}

}  // namespace hawser::record
