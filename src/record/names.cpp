// SPDX-License-Identifier: Apache-2.0
#include "record/names.h"

#include "base/edit_distance.h"

#include <cstddef>
#include <limits>

namespace hawser::record {

std::string nearest_name(std::string_view name, std::span<const std::string> candidates) {
    // Longer names are no typing errors and would only cost time.
    const std::string_view short_name = name.substr(0, 200);
    std::string best;
    std::size_t least = std::numeric_limits<std::size_t>::max();
    for (const std::string& candidate : candidates) {
        const std::size_t d = base::edit_distance(short_name, candidate);
        if (d < least) {
            least = d;
            best = candidate;
        }
    }
    return best;
}

}  // namespace hawser::record
