// SPDX-License-Identifier: Apache-2.0
// Examples of docs/scenes.md are valid.
#include "scene/format.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <sstream>

namespace hawser::scene {
namespace {

std::vector<std::string> examples() {
    std::ifstream stream("docs/scenes.md");
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
    const auto all = examples();
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

}  // namespace
}  // namespace hawser::scene
