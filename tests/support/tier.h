// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file tier.h
/// Size of random suites in the tier of tests that runs: quick, full or long.
///
/// A tier includes the smaller ones. The environment variable HAWSER_TIER names it; `make test`,
/// `make test-full` and `make test-long` set it. A test that only a larger tier runs has a name
/// that ends in `_full` or `_long`. All others are quick.
///
/// A random suite runs in every tier:
/// - quick: a few cases of a fixed seed, so that a failure is due to the change;
/// - full, long: more cases of a fresh seed, which the test prints.
///
/// HAWSER_SEED=N repeats a seed in any tier.

#include <cstdint>
#include <vector>

namespace hawser::test {

enum class Tier { quick, full, long_runs };

/// Return the tier that the environment names; quick by default.
Tier tier();

/// Return the value for the running tier.
int by_tier(int quick, int full, int long_runs);

/// Read the seed in HAWSER_SEED. @return false if there is none.
bool seed_from_environment(std::uint32_t& seed);

/// Return the first seed of a random suite: HAWSER_SEED, or `fixed` in the quick tier. Otherwise a
/// fresh one, which is printed with the name of the running test. Fresh seeds are in [0, 2^31).
std::uint32_t first_seed(std::uint32_t fixed);

/// Return the number of seeds from first_seed() on: 1 if HAWSER_SEED is given, otherwise by_tier().
int seed_count(int quick, int full, int long_runs);

/// Return the seeds of a suite that draws each case from its own seed: seed_count() from
/// first_seed() on.
std::vector<std::uint32_t> seeds(std::uint32_t fixed, int quick, int full, int long_runs);

}  // namespace hawser::test
