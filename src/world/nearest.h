// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file nearest.h
/// The known name nearest to a wrong one.

#include "base/edit_distance.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace hawser::world {

/// Return "; did you mean 'x'?", or "; give one of a, b, c" if no name is near.
[[nodiscard]] inline std::string name_suggestion(std::string_view wrong,
                                                 std::span<const char* const> known) {
    const char* best = nullptr;
    std::size_t least = std::max<std::size_t>(2, wrong.size() / 3) + 1;
    std::string all;
    for (const char* name : known) {
        all += (all.empty() ? "" : ", ") + std::string(name);
        if (const std::size_t d = base::edit_distance(wrong, name); d < least) {
            least = d;
            best = name;
        }
    }
    return best != nullptr && !wrong.empty() ? "; did you mean '" + std::string(best) + "'?"
                                             : "; give one of " + all;
}

}  // namespace hawser::world
