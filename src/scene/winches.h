// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file winches.h
/// The numbers of a winch in a scene: format and reader go by one table.

#include <hawser/winch.h>

#include <span>

namespace hawser::scene {

struct WinchNumber {
    const char* key;
    double WinchDef::* value;
    const char* unit;
    const char* fallback;  ///< In words; "" where it must be given.
    const char* doc;
    double least, most;  ///< 0 itself only where there is a default.
};

[[nodiscard]] std::span<const WinchNumber> winch_numbers() noexcept;

/// Of a gypsy, beside its "pockets".
struct GypsyNumber {
    const char* key;
    double GypsyDef::* value;
    const char* unit;
    const char* fallback;
    const char* doc;
    double least, most;
};
[[nodiscard]] std::span<const GypsyNumber> gypsy_numbers() noexcept;
inline constexpr int kLeastPockets = 3, kMostPockets = 100;

}  // namespace hawser::scene
