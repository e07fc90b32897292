// SPDX-License-Identifier: Apache-2.0
// Scenes that request more than the limits, and files of useless numbers: rejected by their counts,
// before anything is built.
#include <hawser/scene.h>

#include <gtest/gtest.h>

#include <chrono>
#include <string>

namespace hawser::test {
namespace {

/// Load a text. @return the message of the rejection, which comes before anything is built. @param
/// most  Time limit [s].
std::string error_message(const std::string& text, double most = 1.0) {
    const auto start = std::chrono::steady_clock::now();
    std::string said = "taken";
    try {
        (void)scene::load_text(text, "big.json");
    } catch (const scene::SceneError& error) {
        said = error.what();
    }
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    EXPECT_LT(took.count(), most) << said;
    return said;
}

std::string scene_of(const std::string& cables, const std::string& more = "") {
    return R"({"version": 1, "name": "big", "line_types": {"l": {"mass_per_length": 4, "EA": 1e7,
        "diameter": 0.03}, "stiff": {"mass_per_length": 4, "EA": 1e7, "diameter": 0.03, "EI": 10}},
        "bodies": [{"name": "a", "kind": "fixed", "position": [0, 0, 0]}])" +
           (cables.empty() ? "" : ", \"cables\": [" + cables + "]") + more + "}";
}

std::string cable_of(const std::string& name, int elements, const std::string& line = "l") {
    return R"({"name": ")" + name + R"(", "line_type": ")" + line +
           R"(", "from": {"body": "a", "point": [0, 0, 0]}, "to": {"at": [1e5, 0, 0]},
           "length": 120000, "elements": )" +
           std::to_string(elements) + "}";
}

void expect_part(const std::string& said, const char* part) {
    EXPECT_NE(said.find(part), std::string::npos) << said;
}

TEST(HostileSize, ElementsAreCountedBeforeTheyAreMade) {
    // max_bodies of scenes is 2,000,000. Bodies here: the body, the nodes between the ends, and the
    // fixed end.
    expect_part(error_message(scene_of(cable_of("c", 2'000'000))), "2000001 bodies");
    expect_part(error_message(scene_of(cable_of("c", 1'200'000) + "," + cable_of("d", 1'200'000))),
                "2400001 bodies");
    expect_part(error_message(scene_of(cable_of("c", 300'000),
                                       R"(, "repeat": {"copies": 7, "offset": [0, 9, 0]})")),
                "2100007 bodies");
    // A stretch per element and a bend per node; the default limit of each is 4,000,000.
    expect_part(error_message(scene_of(cable_of("c", 600'000, "stiff"),
                                       R"(, "settings": {"max_interactions": 1000000})")),
                "1199999 interactions");
    const std::string instances =
        R"(, "templates": {"t": {"cables": [)" + cable_of("c", 500'000) + R"(]},
            "two": {"instances": [{"template": "t", "name": "x"}, {"template": "t", "name": "y"}]}},
            "instances": [{"template": "two", "name": "p"}, {"template": "two", "name": "q"},
                          {"template": "t", "name": "r"}])";
    expect_part(error_message(scene_of("", instances)), "2500001 bodies");
}

TEST(HostileSize, NumbersUnderAnUnknownKeyAreNotRead) {
    std::string numbers = "1";
    for (int i = 0; i < 2'000'000; ++i) numbers += ",1";
    expect_part(error_message(scene_of("", ", \"foo\": [" + numbers + "]")),
                "there is no key \"foo\", and it holds more than 10000 values");
    expect_part(error_message(scene_of("", ", \"plot\": {\"foo\": [" + numbers + "]}")),
                "an array of more than 2000000 entries");
    std::string twice = scene_of("", ", \"foo\": [[1, 2, 3]]");
    expect_part(error_message(twice), "foo");  // little is read, and rejected like any unknown key
}

TEST(HostileSize, ValuesOfAFileAreCounted_full) {
    std::string row = "[1";
    for (int i = 1; i < 1000; ++i) row += ",1";
    row += "]";
    std::string rows = row;
    for (int i = 0; i < 10'100; ++i) rows += "," + row;
    // 10,000,000 values at about 100 ns each, on a busy machine.
    expect_part(error_message(scene_of("", ", \"plot\": {\"foo\": [" + rows + "]}"), 10.0),
                "more than 10000000 values");
}

}  // namespace
}  // namespace hawser::test
