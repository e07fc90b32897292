// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file index.h
/// Convert array indices.

#include <cstddef>
#include <cstdint>

namespace hawser::draw {

[[nodiscard]] constexpr std::size_t at(std::int64_t i) noexcept {
    return static_cast<std::size_t>(i);
}

}  // namespace hawser::draw
