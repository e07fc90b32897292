// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file stable_text.h
/// Removes from outputs the parts that differ between runs or machines, and compares the rest.

#include <string>
#include <string_view>

namespace hawser::golden {

/// Return the text with its volatile parts replaced: times, memory, machine, version, state hash,
/// and `folder`, which becomes "$OUT". Lines of progress are deleted. The patterns are in
/// stable_text.cpp.
[[nodiscard]] std::string stable_text(std::string text, const std::string& folder);

/// Return a JSON document without its volatile members, one value per line.
[[nodiscard]] std::string stable_json(const std::string& text, const std::string& folder);

/// Largest difference between two numbers that are treated as equal: relative to the larger, or
/// absolute.
struct NumberTolerance {
    double relative = 1e-6;
    double absolute = 1e-9;
};

/// Compare line by line: numbers within the tolerance, everything else exactly. Return up to eight
/// lines that differ, with both texts.
[[nodiscard]] std::string compare_texts(std::string_view reference, std::string_view text,
                                        const NumberTolerance& tolerance);

}  // namespace hawser::golden
