// SPDX-License-Identifier: Apache-2.0
// Shipped scenes load, and their resolved text is complete.
#include "good_scenes.h"
#include "support.h"

#include <algorithm>

namespace hawser::scene::test {
namespace {

std::vector<std::string> library() {
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator("scenes")) {
        if (entry.path().extension() == ".json" &&
            entry.path().string().find(".settled") == std::string::npos) {
            files.push_back(entry.path().string());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

/// Expect that all data of the interface are equal in two worlds, to the bit.
void expect_same(const Scene& a, const Scene& b) {
    ASSERT_EQ(a.world.body_count(), b.world.body_count());
    ASSERT_EQ(a.world.interaction_count(), b.world.interaction_count());
    ASSERT_EQ(a.world.input_count(), b.world.input_count());
    ASSERT_EQ(a.cables.size(), b.cables.size());
    for (int i = 0; i < a.world.body_count(); ++i) {
        const BodyDef& x = a.world.body_def(BodyId{i});
        const BodyDef& y = b.world.body_def(BodyId{i});
        EXPECT_EQ(x.name, y.name);
        EXPECT_EQ(x.position, y.position) << x.name;
        EXPECT_EQ(x.orientation.coeffs(), y.orientation.coeffs()) << x.name;
        EXPECT_EQ(x.velocity, y.velocity) << x.name;
        EXPECT_EQ(x.mass, y.mass) << x.name;
        EXPECT_EQ(x.inertia, y.inertia) << x.name;
    }
    EXPECT_EQ(a.world.state().hash(), b.world.state().hash());
}

TEST(Library, every_scene_loads_and_its_text_gives_the_same_world) {
    const auto files = library();
    ASSERT_GE(files.size(), 20U);
    for (const std::string& file : files) {
        SCOPED_TRACE(file);
        try {
            const Scene scene = load_file(file);
            EXPECT_EQ(std::filesystem::path(file).stem().string(), scene.name);
            const Scene again = load_text(scene.text, "resolved.json");
            EXPECT_EQ(scene.text, again.text);
            EXPECT_EQ(scene.hash, again.hash);
            expect_same(scene, again);
        } catch (const SceneError& error) {
            ADD_FAILURE() << error.what();
        }
    }
}

TEST(Library, good_scenes_give_the_same_world_from_their_text) {
    for (const std::string_view text : kGoodScenes) {
        Options options;
        options.step = 0.01;
        options.form = Form::saddle;
        const Scene scene = load_text(text, "a.json", options);
        EXPECT_EQ(scene.world.settings().step, 0.01);
        EXPECT_EQ(scene.world.settings().form, Form::saddle);
        const Scene again = load_text(scene.text, "b.json");
        EXPECT_EQ(again.world.settings().step, 0.01);
        EXPECT_EQ(again.world.settings().form, Form::saddle);
        EXPECT_EQ(scene.text, again.text);
        expect_same(scene, again);
    }
}

TEST(Library, hash_follows_the_content_and_nothing_else) {
    const std::uint64_t hash = load_text(kPendulum, "a.json").hash;
    // Spaces, the order of keys and the line for editors have no effect.
    const Json parsed = Json::parse(kPendulum);
    EXPECT_EQ(load_text(parsed.dump(4), "b.json").hash, hash);
    EXPECT_EQ(
        load_text(patched(kPendulum, R"([{"op":"add","path":"/$schema","value":"x"}])"), "c.json")
            .hash,
        hash);
    Options options;
    options.threads = 2;
    EXPECT_EQ(load_text(kPendulum, "a.json", options).hash, hash);
    options.step = 0.01;
    EXPECT_NE(load_text(kPendulum, "a.json", options).hash, hash);
}

}  // namespace
}  // namespace hawser::scene::test
