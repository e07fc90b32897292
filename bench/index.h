// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file index.h
/// Convert signed numbers to indices of standard containers.

#include <cstddef>
#include <cstdint>

namespace hawser::bench {

constexpr std::size_t at(std::int64_t i) noexcept { return static_cast<std::size_t>(i); }

}  // namespace hawser::bench
