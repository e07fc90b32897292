// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file lanes.h
/// Checks of base/lanes.h and base/transpose.h, compiled once for each instruction set.

namespace hawser::sse2 {
/// Check all functions. @return name of the first function with a wrong result; null if there is
/// none.
[[nodiscard]] const char* wrong_lanes();
}  // namespace hawser::sse2
namespace hawser::avx2 {
[[nodiscard]] const char* wrong_lanes();
}
namespace hawser::avx512 {
[[nodiscard]] const char* wrong_lanes();
}
