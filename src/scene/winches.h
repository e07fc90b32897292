// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file winches.h
/// Numbers of a winch in a scene. Format and reader use one table.

#include <hawser/winch.h>

#include <span>

namespace hawser::scene {

struct WinchNumber {
    const char* key;
    double WinchDef::* value;
    const char* unit;
    const char* fallback;  ///< Default in words; "" if the key is required.
    const char* doc;
    double least, most;  ///< Range. 0 is included only if there is a default.
};

[[nodiscard]] std::span<const WinchNumber> winch_numbers() noexcept;

/// A number of a gypsy, in addition to its "pockets".
struct GypsyNumber {
    const char* key;
    double GypsyDef::* value;
    const char* unit;
    const char* fallback;
    const char* doc;
    double least, most;
};
[[nodiscard]] std::span<const GypsyNumber> gypsy_numbers() noexcept;
inline constexpr int kMinPockets = 3, kMaxPockets = 100;

}  // namespace hawser::scene
