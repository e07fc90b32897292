// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file nearest.h
/// The known name nearest to a wrong one.

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hawser::world {

/// Return the number of insertions, deletions and replacements between two words (V. Levenshtein,
/// 1966).
[[nodiscard]] inline std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j < row.size(); ++j) row[j] = j;
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t corner = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = corner + (a[i] == b[j] ? 0 : 1);
            corner = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

/// Return "; did you mean 'x'?", or "; give one of a, b, c" if no name is near.
[[nodiscard]] inline std::string remedy_of(std::string_view wrong,
                                           std::span<const char* const> known) {
    const char* best = nullptr;
    std::size_t least = std::max<std::size_t>(2, wrong.size() / 3) + 1;
    std::string all;
    for (const char* name : known) {
        all += (all.empty() ? "" : ", ") + std::string(name);
        if (const std::size_t d = edit_distance(wrong, name); d < least) {
            least = d;
            best = name;
        }
    }
    return best != nullptr && !wrong.empty() ? "; did you mean '" + std::string(best) + "'?"
                                             : "; give one of " + all;
}

}  // namespace hawser::world
