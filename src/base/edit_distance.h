// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file edit_distance.h
/// Distance between two names, to propose the nearest known one in a message.

#include <cstddef>
#include <string_view>

namespace hawser::base {

/// Return the smallest number of insertions, deletions, replacements and swaps of neighbours that
/// turns one text into the other (optimal string alignment). The time is proportional to the
/// product of the lengths, the memory to their sum.
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

}  // namespace hawser::base
