// SPDX-License-Identifier: Apache-2.0
// The committed schema and reference page are those that the source generates. To write them anew:
//   HAWSER_WRITE_GENERATED=1 build/release/bin/hawser_test_scene --gtest_filter='Generated.*'
#include "scene/schema.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace hawser::scene {
namespace {

void compare(const std::string& file, const std::string& text) {
    if (std::getenv("HAWSER_WRITE_GENERATED") != nullptr) {
        std::filesystem::create_directories(std::filesystem::path(file).parent_path());
        std::ofstream(file) << text;
    }
    std::ifstream stream(file);
    std::stringstream stored;
    stored << stream.rdbuf();
    EXPECT_TRUE(stored.str() == text)
        << file << " is not what the source generates; run scripts/write_scene_documents.sh";
}

TEST(Generated, schema) { compare("schema/scene-1.json", schema_text()); }
TEST(Generated, reference) { compare("docs/scenes_reference.md", reference_text()); }

}  // namespace
}  // namespace hawser::scene
