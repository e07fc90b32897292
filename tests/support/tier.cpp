// SPDX-License-Identifier: Apache-2.0
#include "support/tier.h"

#include "support/sanitizer.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <random>
#include <string_view>

namespace hawser::test {

Tier tier() {
    const char* name = std::getenv("HAWSER_TIER");
    if (name == nullptr || std::string_view(name) == "quick") return Tier::quick;
    if (std::string_view(name) == "full") return Tier::full;
    if (std::string_view(name) == "long") return Tier::long_runs;
    std::fprintf(stderr, "HAWSER_TIER=%s: expected quick, full or long\n", name);
    std::exit(2);
}

bool sampled() { return kSanitized && std::getenv("HAWSER_SANITIZER_SAMPLE") != nullptr; }

int by_tier(int quick, int full, int long_runs) {
    const Tier now = tier();
    return now == Tier::quick ? quick : now == Tier::full ? full : long_runs;
}

bool seed_from_environment(std::uint32_t& seed) {
    const char* given = std::getenv("HAWSER_SEED");
    if (given == nullptr) return false;
    seed = static_cast<std::uint32_t>(std::strtoul(given, nullptr, 0));
    return true;
}

std::uint32_t first_seed(std::uint32_t fixed) {
    std::uint32_t seed = fixed;
    if (seed_from_environment(seed) || tier() == Tier::quick) return seed;
    seed = std::random_device{}() & 0x7fffffffU;
    const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
    std::printf("%s.%s: seed %u\n", test != nullptr ? test->test_suite_name() : "?",
                test != nullptr ? test->name() : "?", seed);
    std::fflush(stdout);  // in case of a crash
    return seed;
}

int seed_count(int quick, int full, int long_runs) {
    std::uint32_t seed = 0;
    return seed_from_environment(seed) ? 1 : by_tier(quick, full, long_runs);
}

std::vector<std::uint32_t> seeds(std::uint32_t fixed, int quick, int full, int long_runs) {
    std::vector<std::uint32_t> all(static_cast<std::size_t>(seed_count(quick, full, long_runs)));
    std::iota(all.begin(), all.end(), first_seed(fixed));
    return all;
}

}  // namespace hawser::test
