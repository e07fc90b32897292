// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file parted.h
/// Cables that have parted, for pictures.

#include <hawser/recording.h>
#include "draw/drawing.h"

#include <cstddef>
#include <string>
#include <vector>

namespace hawser::draw {

inline constexpr Color kPartedColor{190, 30, 30, 255};

struct PartedElement {
    std::size_t cable = 0;     ///< Index in Recording::cables.
    std::int32_t element = 0;  ///< Of the cable.
    double time = 0.0;         ///< [s]
    std::string text;          ///< Which one, where, when.
};

/// Elements of cables that had parted by a time. Those that came later than the cable, with a node
/// that was put in, are not among them.
[[nodiscard]] std::vector<PartedElement> parted_elements(const record::Recording& recording,
                                                         double until);

/// Whether an element of a cable is among them.
[[nodiscard]] bool is_parted(const std::vector<PartedElement>& parted, std::size_t cable,
                             std::int32_t element);

}  // namespace hawser::draw
