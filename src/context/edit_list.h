// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file edit_list.h
/// What edits leave for the next analysis (edits.h).

#include <cstdint>
#include <vector>

namespace hawser::stepper {

/// What the system has to follow to before the next step.
enum class Changed : std::uint8_t {
    nothing,
    shapes,  ///< Shapes came or went: bodies and interactions are those that were analysed.
    all,
};

/// What has come since the last analysis that a step was taken with.
struct Edits {
    bool any = false;                        ///< The world had started by then.
    std::vector<std::int32_t> interactions;  ///< Added.
    void clear() noexcept {
        any = false;
        interactions.clear();
    }
};

}  // namespace hawser::stepper
