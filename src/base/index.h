// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file index.h
/// Ids are signed (−1: none), indices of standard containers are unsigned.

#include <cstddef>
#include <cstdint>

namespace hawser {

[[nodiscard]] constexpr std::size_t at(std::int64_t i) noexcept {
    return static_cast<std::size_t>(i);
}

}  // namespace hawser
