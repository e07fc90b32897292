// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file sanitizer.h
/// True in a build with a sanitizer. Code then runs 5 to 50 times slower. A test that repeats the
/// same code may repeat it less: a sanitizer needs to check each access once.

namespace hawser::test {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

}  // namespace hawser::test
