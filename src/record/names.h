// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file names.h
/// The name that was probably meant.

#include <span>
#include <string>
#include <string_view>

namespace hawser::record {

/// The candidate with the fewest insertions, deletions and replacements of characters; empty
/// when there is no candidate.
[[nodiscard]] std::string nearest_name(std::string_view name,
                                       std::span<const std::string> candidates);

}  // namespace hawser::record
