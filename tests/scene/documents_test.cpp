// SPDX-License-Identifier: Apache-2.0
// JSON blocks of docs/scenes.md, README.md and the tutorials have the format of scenes.
#include "scene/format.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <sstream>

namespace hawser::scene {
namespace {

std::vector<std::string> examples(const std::string& page) {
    std::ifstream stream(page);
    std::vector<std::string> all;
    std::string line;
    bool inside = false;
    while (std::getline(stream, line)) {
        if (line == "```json") {
            all.emplace_back();
            inside = true;
        } else if (line == "```") {
            inside = false;
        } else if (inside) {
            all.back() += line + "\n";
        }
    }
    return all;
}

TEST(Documents, examples_fit_the_format) {
    const auto all = examples("docs/scenes.md");
    ASSERT_EQ(all.size(), 19U);
    for (const std::string& text : all) {
        SCOPED_TRACE(text);
        const Json value = parse_json(text, "docs/scenes.md", outermost_keys());
        Json scene{{"version", 1}, {"name", "example"}};
        if (value.contains("kind")) {
            scene["interactions"] = Json::array({value});
        } else if (value.contains("line_type")) {
            scene["cables"] = Json::array({value});
        } else {
            scene.update(value);
        }
        check_shape(scene, *format().scene, {"docs/scenes.md", ""});
    }
}

/// Return a scene with a block of a page: a scene, some of its keys, or keys of an object in it.
Json scene_with_block(const std::string& page, std::string text) {
    if (text.find_first_not_of(' ') != text.find('{')) text = "{" + text + "}";
    const Json block = parse_json(text, page, outermost_keys());
    Json scene{{"version", 1}, {"name", "example"}};
    if (block.contains("line_type"))
        scene["cables"] = Json::array({block});
    else if (block.contains("waves"))
        (scene["sea"] = {{"depth", 50}}).update(block);
    else if (block.contains("propulsors") || block.contains("control") || block.contains("power"))
        (scene["vessels"] = Json::array({{{"name", "ship"}, {"body", "hull"}}}))[0].update(block);
    else
        scene.update(block);
    return scene;
}

TEST(Documents, blocks_of_tutorials_fit_the_format) {
    int blocks = 0;
    for (const char* page : {"README.md", "docs/moored_barge.md", "docs/winches.md",
                             "docs/cranes.md", "docs/sea.md", "docs/vessels.md", "docs/anchors.md"})
        for (const std::string& text : examples(page)) {
            SCOPED_TRACE(text);
            check_shape(scene_with_block(page, text), *format().scene, {page, ""});
            ++blocks;
        }
    EXPECT_EQ(blocks, 24);
}

}  // namespace
}  // namespace hawser::scene
