// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file sanitizer.h
/// True in a build with a sanitizer. Code then runs 5 to 50 times slower. A test that repeats the
/// same code may repeat it less: a sanitizer needs to check each access once.
///
/// The gate sets HAWSER_SANITIZER_SAMPLE=1. Builds with a sanitizer then skip the tests that call
/// HAWSER_SKIP_IF_SAMPLED(). `make check-full` runs all of them.

#include <gtest/gtest.h>

namespace hawser::test {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

/// True if this build has a sanitizer and the environment requests a sample of the tests.
[[nodiscard]] bool sampled();

}  // namespace hawser::test

/// Skip a long test if sampled(). Shorter tests run the same code.
#define HAWSER_SKIP_IF_SAMPLED() \
    if (hawser::test::sampled()) GTEST_SKIP() << "not in the sample; make check-full runs it"
