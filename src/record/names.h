// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file names.h
/// Find the existing name that is most similar to a misspelled one.

#include <span>
#include <string>
#include <string_view>

namespace hawser::record {

/// Return the candidate with the fewest insertions, deletions and replacements of characters; empty
/// if there is no candidate.
[[nodiscard]] std::string nearest_name(std::string_view name,
                                       std::span<const std::string> candidates);

}  // namespace hawser::record
