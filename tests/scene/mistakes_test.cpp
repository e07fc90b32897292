// SPDX-License-Identifier: Apache-2.0
// All mistakes of a scene in one pass, without those that only follow from others.
#include "malformed_table.h"

#include "support.h"
#include "support/sanitizer.h"
#include "support/tier.h"

#include <algorithm>
#include <iterator>
#include <random>

namespace hawser::scene::test {
namespace {

std::vector<SceneError> mistakes_in(std::string_view text, const Options& options = {}) {
    std::vector<SceneError> found;
    const auto scene = load_text(text, "test.json", options, found);
    EXPECT_EQ(scene.has_value(), found.empty());
    return found;
}

std::vector<std::string> paths(const std::vector<SceneError>& mistakes) {
    std::vector<std::string> out;
    for (const SceneError& m : mistakes) {
        out.push_back(m.path);
    }
    std::sort(out.begin(), out.end());
    return out;
}

std::string all_of(const std::vector<SceneError>& mistakes) {
    std::string text;
    for (const SceneError& m : mistakes) {
        text += std::string(m.what()) + "\n";
    }
    return text;
}

TEST(Mistakes, a_good_scene_has_none) {
    for (const std::string_view scene : kGoodScenes) {
        EXPECT_TRUE(mistakes_in(scene).empty());
    }
}

TEST(Mistakes, the_first_is_the_one_that_loading_throws) {
    for (const Mistake& mistake : kMistakes) {
        SCOPED_TRACE(mistake.patch);
        const auto found = mistakes_in(patched(mistake.scene, mistake.patch));
        ASSERT_FALSE(found.empty());
        EXPECT_EQ(found[0].path, mistake.path) << all_of(found);
        EXPECT_NE(found[0].message.find(mistake.words), std::string::npos) << all_of(found);
    }
}

/// One edit with one mistake gives one line: references to the part left out give none.
TEST(Mistakes, what_follows_from_a_mistake_is_none) {
    const char* patches[] = {
        R"([{"op":"replace","path":"/bodies/0/mass","value":-1}])",
        R"([{"op":"replace","path":"/line_types/chain76/EA","value":-5.83e8}])",
        R"([{"op":"replace","path":"/cables/0/elements","value":0}])",
        R"([{"op":"remove","path":"/line_types/chain76"}])",
    };
    for (const char* patch : patches) {
        const auto found = mistakes_in(patched(kSite, patch));
        if (std::string_view(patch).find("remove") == std::string_view::npos) {
            EXPECT_EQ(found.size(), 1U) << patch << "\n" << all_of(found);
        }
        for (const SceneError& m : found) {
            EXPECT_EQ(m.message.find("there is no body"), std::string::npos) << m.what();
            EXPECT_EQ(m.message.find("there is no cable"), std::string::npos) << m.what();
        }
    }
}

TEST(Mistakes, every_one_of_many_is_listed) {
    const auto found = mistakes_in(R"({"version": 1, "name": "bad",
      "settings": {"step": 5, "durtion": 2},
      "line_types": {"w": {"mass_per_length": -1, "EA": 1e8}},
      "bodies": [{"name": "a", "mass": -4, "box": [1, 1, 1]},
                 {"name": "b", "mass": 5, "box": [0.2, 1, 0.5], "colour": "red"},
                 {"name": "c", "mass": 1, "box": [1, 1, 1]},
                 {"name": "c", "mass": 1, "box": [1, 1, 1]},
                 {"name": "d", "mass": 1}],
      "cables": [{"name": "k", "line_type": "w", "elements": 3, "length": 3,
                  "from": {"body": "a"}, "to": {"body": "c"}}],
      "interactions": [
        {"kind": "ball", "bodies": ["a", "b"], "at": [0, 0, 0]},
        {"kind": "hinge", "bodies": ["c", "e"], "at": [0, 0, 0], "axis": [0, 0, 1]},
        {"kind": "ball", "bodies": ["c", "k/1"], "at": [0, 0, 0]},
        {"kind": "hinj", "bodies": ["a", "b"]}],
      "inputs": [{"name": "i", "body": "c", "component": "force_x", "min": 2, "max": 1},
                 {"name": "j", "body": "d", "component": "force_x"}],
      "plot": {"motions": ["a", "q"]}})");
    const std::vector<std::string> expected = {"/bodies/0/mass",
                                               "/bodies/1/colour",
                                               "/bodies/3",
                                               "/bodies/4",
                                               "/inputs/0/min",
                                               "/interactions/1/bodies/1",
                                               "/interactions/3/kind",
                                               "/line_types/w/mass_per_length",
                                               "/plot/motions/1",
                                               "/settings/durtion",
                                               "/settings/step"};
    EXPECT_EQ(paths(found), expected) << all_of(found);
}

/// Two mistakes at unrelated positions: both are found.
TEST(Mistakes, pairs_of_mistakes_are_both_found) {
    std::vector<const Mistake*> simple;
    for (const Mistake& m : kMistakes) {
        const std::string_view patch = m.patch;
        const bool one = patch.find("},{") == std::string_view::npos;
        // A position of its own below a list or the settings, so that it does not contain the other
        // one.
        if (m.scene == kSite && one && m.path.find('/', 1) != std::string_view::npos &&
            patch.find("\"path\":\"\"") == std::string_view::npos) {
            simple.push_back(&m);
        }
    }
    ASSERT_GE(simple.size(), 60U);
    const auto owner = [](std::string_view path) {
        const auto second = path.find('/', 1);
        return path.substr(0, path.find('/', second + 1));
    };
    int pairs = 0;
    for (std::size_t i = 0; i < simple.size(); ++i) {
        const Mistake& a = *simple[i];
        const Mistake& b = *simple[(7 * i + 3) % simple.size()];
        // Mistakes of the document's structure: those of names may follow from another one.
        const auto shape = [](const Mistake& m) {
            return find_problem(Json::parse(patched(m.scene, m.patch)), *format().scene)
                .has_value();
        };
        if (owner(a.path) == owner(b.path) || !shape(a) || !shape(b)) {
            continue;
        }
        const auto found = paths(mistakes_in(patched(patched(kSite, a.patch), b.patch)));
        for (const std::string_view path : {a.path, b.path}) {
            EXPECT_TRUE(std::find(found.begin(), found.end(), path) != found.end())
                << a.patch << "\n"
                << b.patch;
        }
        ++pairs;
    }
    EXPECT_GE(pairs, 20);
}

TEST(Mistakes, of_templates_are_listed_once_and_name_the_instance) {
    const auto found = mistakes_in(R"({"version": 1, "name": "t",
      "templates": {"crane": {"parameters": {"m": 5}, "bodies": [
         {"name": "boom", "mass": "${m}", "box": [1, 1, 1]},
         {"name": "hook", "mass": 1}]}},
      "instances": [{"template": "crane", "name": "p"},
                    {"template": "crane", "name": "q", "parameters": {"m": -5}},
                    {"template": "crain", "name": "r"}],
      "interactions": [{"kind": "ball", "bodies": ["p/hook", "r/boom"], "at": [0, 0, 0]}]})");
    // The hook of the template, although two instances have it; the mass of one; the wrong
    // template.
    EXPECT_EQ(found.size(), 3U) << all_of(found);
    const std::string text = all_of(found);
    EXPECT_NE(text.find("(in the instance \"p\")"), std::string::npos) << text;
    EXPECT_NE(text.find("(in the instance \"q\")"), std::string::npos) << text;
    EXPECT_NE(text.find("did you mean \"crane\""), std::string::npos) << text;
}

TEST(Mistakes, of_what_the_world_refuses_are_all_listed) {
    // Both rods join two bodies at rest, which only the world detects.
    const auto found = mistakes_in(R"({"version": 1, "name": "w", "bodies": [
        {"name": "a", "kind": "fixed"}, {"name": "b", "kind": "fixed", "position": [1, 0, 0]},
        {"name": "c", "kind": "lump", "mass": 1, "position": [2, 0, 0]}], "interactions": [
        {"kind": "distance", "bodies": ["a", "b"]}, {"kind": "distance", "bodies": ["b", "c"]},
        {"kind": "distance", "bodies": ["b", "a"]}]})");
    EXPECT_EQ(paths(found), (std::vector<std::string>{"/interactions/0", "/interactions/2"}))
        << all_of(found);
}

/// A feed needs a fairlead that is not a point mass: the message names the key of the cable, and
/// all are listed.
TEST(Mistakes, of_drum_feeds_name_their_cable) {
    const auto found = mistakes_in(R"({"version": 2, "name": "f", "bodies": [
        {"name": "spool", "kind": "scalar", "mass": 500, "gravity": false},
        {"name": "a", "kind": "lump", "mass": 500}, {"name": "b", "kind": "lump", "mass": 500},
        {"name": "load", "kind": "lump", "mass": 1000, "position": [0, 0, -40]}],
        "line_types": {"w": {"mass_per_length": 4, "EA": 1e7}}, "cables": [
        {"name": "c", "line_type": "w", "elements": 4, "from": {"body": "a"},
         "to": {"body": "load"}, "winch": {"drum": "spool", "radius": 0.8}},
        {"name": "d", "line_type": "w", "elements": 4, "from": {"body": "b"},
         "to": {"body": "load"}, "winch": {"drum": "spool", "radius": 0.8}}]})");
    EXPECT_EQ(paths(found), (std::vector<std::string>{"/cables/0/winch", "/cables/1/winch"}))
        << all_of(found);
}

TEST(Mistakes, keys_given_twice_and_options_are_listed) {
    EXPECT_EQ(mistakes_in(R"({"version": 1, "name": "x", "name": "y", "bodies": [
        {"name": "b", "kind": "lump", "mass": 1, "mass": 2}]})")
                  .size(),
              2U);
    Options options;
    options.set = {"bodies.rog.mass=1", "settings.stp=0.1"};
    const auto found = mistakes_in(kSite, options);
    EXPECT_EQ(found.size(), 2U) << all_of(found);
}

/// Replace each value of a valid scene in turn by an invalid one: reading continues after all of
/// them, and finds mistakes exactly where loading throws one.
TEST(Mistakes, reading_goes_on_past_anything) {
    const Json replacements[] = {nullptr,        -1,       1e300, "text", Json::array(),
                                 Json::object(), {1, 2, 3}};
    std::mt19937 random(::hawser::test::first_seed(7));
    const int rounds = ::hawser::test::by_tier(::hawser::test::kSanitized ? 20 : 50,
                                               ::hawser::test::kSanitized ? 60 : 200, 2500);
    int refused = 0, documents = 0;
    for (const std::string_view text : kGoodScenes) {
        const Json scene = Json::parse(text);
        const Json flat = scene.flatten();
        std::vector<Json::json_pointer> places;
        for (const auto& [pointer, value] : flat.items()) {
            for (Json::json_pointer at(pointer); !at.empty(); at = at.parent_pointer()) {
                places.push_back(at);
            }
        }
        // Several at once: each leaves out a part to which others may refer.
        for (int round = 0; round < rounds; ++round) {
            Json changed = scene;
            for (unsigned k = 0; k < 1 + random() % 4; ++k) {
                const Json::json_pointer& at = places[random() % places.size()];
                if (changed.contains(at)) {
                    changed[at] = replacements[random() % std::size(replacements)];
                }
            }
            const std::string document = changed.dump();
            std::vector<SceneError> found;
            ASSERT_NO_THROW((void)load_text(document, "test.json", Options(), found)) << document;
            const std::string first = refusal(document);
            ASSERT_EQ(found.empty(), first.empty()) << document << "\n" << first;
            refused += found.empty() ? 0 : 1;
            ++documents;
        }
    }
    EXPECT_GT(refused, documents / 4);
}

}  // namespace
}  // namespace hawser::scene::test
