// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file parted.h
/// List broken cables, for pictures.

#include <hawser/recording.h>
#include "draw/drawing.h"

#include <cstddef>
#include <string>
#include <vector>

namespace hawser::draw {

inline constexpr Color kBrokenColor{190, 30, 30, 255};

struct BrokenElement {
    std::size_t cable = 0;     ///< Index in Recording::cables.
    std::int32_t element = 0;  ///< Element index in the cable.
    double time = 0.0;         ///< Time of the break [s].
    std::string text;          ///< Text with element, position and time.
};

/// Return the elements of cables that had broken by a time. Elements that were added with a node
/// after the start are not included.
[[nodiscard]] std::vector<BrokenElement> broken_elements(const record::Recording& recording,
                                                         double until);

/// True if an element of a cable is in the list.
[[nodiscard]] bool is_broken(const std::vector<BrokenElement>& parted, std::size_t cable,
                             std::int32_t element);

}  // namespace hawser::draw
