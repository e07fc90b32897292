// SPDX-License-Identifier: Apache-2.0
// Random damage: a damaged scene either is rejected with a SceneError or happens to be valid. It
// never crashes and never throws another exception.
#include "good_scenes.h"
#include "support.h"
#include "support/tier.h"

#include <rapidcheck/gtest.h>

#include <random>

namespace hawser::scene::test {
namespace {

/// Result of reading a text.
enum class Fate { refused, accepted };

Fate fate_of(const std::string& text) {
    try {
        const Scene scene = load_text(text, "test.json");
        EXPECT_GT(scene.world.body_count(), 0);
        return Fate::accepted;
    } catch (const SceneError& error) {
        EXPECT_EQ(error.file, "test.json");
        EXPECT_FALSE(error.message.empty());
        return Fate::refused;
    }
}

std::string damage(std::string text, std::mt19937& random) {
    const auto pick = [&](std::size_t n) {
        return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
    };
    const std::size_t edits = 1 + pick(3);
    for (std::size_t i = 0; i < edits && !text.empty(); ++i) {
        const std::size_t at = pick(text.size());
        switch (pick(5)) {
            case 0:
                text[at] = static_cast<char>(pick(256));
                break;
            case 1:
                text.erase(at, 1 + pick(8));
                break;
            case 2:
                text.insert(at, 1, static_cast<char>(pick(256)));
                break;
            case 3:
                std::swap(text[at], text[pick(text.size())]);
                break;
            default:
                text.resize(at);
                break;
        }
    }
    return text;
}

TEST(Damage, bytes_of_good_scenes) {
    std::mt19937 random(::hawser::test::first_seed(20240229));
    int refused = 0;
    const int rounds = ::hawser::test::by_tier(300, 3000, 100'000);
    for (int round = 0; round < rounds; ++round) {
        const std::string good(kGoodScenes[static_cast<std::size_t>(round) % kGoodScenes.size()]);
        refused += fate_of(damage(good, random)) == Fate::refused ? 1 : 0;
    }
    // Some damage is harmless (a digit, a letter of a description), most is not.
    EXPECT_GT(refused, rounds / 2);
}

RC_GTEST_PROP(Damage, any_bytes_are_refused, ()) {
    const auto bytes = *rc::gen::container<std::string>(rc::gen::arbitrary<char>());
    RC_ASSERT(fate_of(bytes) == Fate::refused);
}

RC_GTEST_PROP(Damage, swapped_values_never_crash, ()) {
    const std::string_view source =
        *rc::gen::elementOf(std::vector<std::string_view>(kGoodScenes.begin(), kGoodScenes.end()));
    const Json good = Json::parse(source);
    const Json flat = good.flatten();
    std::vector<std::string> pointers;
    for (const auto& [pointer, value] : flat.items()) {
        pointers.push_back(pointer);
    }
    Json damaged = good;
    const auto from = *rc::gen::elementOf(pointers);
    const auto to = *rc::gen::elementOf(pointers);
    // Sizes are not changed: a large value is a large scene, not a mistake.
    RC_PRE(!to.ends_with("/copies") && !to.ends_with("/elements"));
    damaged[Json::json_pointer(to)] = flat[from];
    (void)fate_of(damaged.dump());
}

}  // namespace
}  // namespace hawser::scene::test
