// SPDX-License-Identifier: Apache-2.0
/// Hashes of the shipped sites of version 2. A change needs a line in CHANGELOG.md.
#include <hawser/scene.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

namespace hawser {
namespace {

TEST(ShippedSites, HaveTheirPinnedHashes) {
    struct Row {
        const char* name;
        std::uint64_t hash;
    };
    for (const Row& row :
         {Row{"anchor_lines", 0x1676dbf9c0e94d54U}, Row{"anchor_contact", 0xfb8436b8f65ebf54U},
          Row{"anchor_sea", 0x94461327a7596c1bU}, Row{"anchor_adaptive", 0x20bb32330e23ac1cU},
          Row{"anchor_run", 0x6ed75bd0ed1fca80U}, Row{"anchor_seaway", 0xc41e15a9fdec02e9U}}) {
        const scene::Scene scene = scene::load_file(std::string("scenes/") + row.name + ".json");
        EXPECT_EQ(scene.hash, row.hash) << row.name;
    }
}

/// Cables of windlasses and anchor handlers feed elements; earlier, only their one element changed.
TEST(ShippedSites, FeedTheirWires) {
    const scene::Scene scene = scene::load_file("scenes/anchor_lines.json");
    int fed = 0;
    for (const scene::Cable& cable : scene.cables) fed += cable.drum_element > 0.0 ? 1 : 0;
    EXPECT_EQ(fed, 18) << "eight moorings, six lines of the vessels, four cranes";
}

}  // namespace
}  // namespace hawser
