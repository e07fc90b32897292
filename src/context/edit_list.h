// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file edit_list.h
/// Notes of edits for the next analysis (edits.h).

#include <cstdint>
#include <vector>

namespace hawser::context {

/// Changes that the system has to follow before the next step.
enum class Changed : std::uint8_t {
    nothing,
    shapes,  ///< Shapes were added or removed; bodies and interactions are those of the analysis.
    all,
};

/// Additions since the last analysis that a step used.
struct Edits {
    bool any = false;                        ///< True if the world had already started.
    std::vector<std::int32_t> interactions;  ///< Added interactions.
    void clear() noexcept {
        any = false;
        interactions.clear();
    }
};

}  // namespace hawser::context
