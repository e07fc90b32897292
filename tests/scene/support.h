// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/description.h"
#include "scene/format.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace hawser::scene::test {

inline Document document_of(std::string_view text, const Options& options = {}) {
    return make_document(parse_json(text, "test.json", outermost_keys()), "test.json", options);
}

/// Return the flat lists of a scene, without a world.
inline Description flat(std::string_view text, const Options& options = {}) {
    const Document document = document_of(text, options);
    Description out;
    expand(out, document);
    return out;
}

/// Apply a JSON Patch (RFC 6902) to a valid scene.
inline std::string patched(std::string_view scene, std::string_view patch) {
    return Json::parse(scene).patch(Json::parse(patch)).dump();
}

inline const BodyDef& body(const Description& d, const std::string& name) {
    const BodyId id = d.find_body(name);
    EXPECT_TRUE(id.valid()) << "no body " << name;
    return d.body(id);
}

inline const InteractionDef& interaction(const Description& d, const std::string& name) {
    const InteractionId id = d.find_interaction(name);
    EXPECT_TRUE(id.valid()) << "no interaction " << name;
    return d.interactions[static_cast<std::size_t>(id.index)];
}

/// Return the message of the SceneError of a text; "" if it is accepted.
inline std::string refusal(std::string_view text, const Options& options = {}) {
    try {
        (void)load_text(text, "test.json", options);
    } catch (const SceneError& error) {
        EXPECT_EQ(error.file, "test.json");
        EXPECT_TRUE(std::string(error.what()).starts_with("test.json: " + error.path));
        EXPECT_FALSE(error.message.empty());
        return error.what();
    }
    return "";
}

/// A folder of files, deleted by the destructor.
class TempFolder {
  public:
    TempFolder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "hawser-XXXXXX").string();
        path = mkdtemp(pattern.data());
    }
    ~TempFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
    TempFolder(const TempFolder&) = delete;
    TempFolder& operator=(const TempFolder&) = delete;

    std::filesystem::path write(const std::string& name, std::string_view text) const {
        const auto file = path / name;
        std::filesystem::create_directories(file.parent_path());
        std::ofstream(file, std::ios::binary) << text;
        return file;
    }

    std::filesystem::path path;
};

}  // namespace hawser::scene::test
