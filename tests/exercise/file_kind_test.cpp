// SPDX-License-Identifier: Apache-2.0
#include "base/file_kind.h"

#include <hawser/exercise.h>
#include <hawser/scene.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace hawser::test {

namespace {

struct OtherFile {
    const char* what;
    std::string text;
    std::vector<const char*> said;  ///< Parts that the message contains.
};

std::vector<OtherFile> other_files() {
    return {
        {"recording", std::string("HAWSERRC\x01\0\0\0", 12), {"a recording", "hawser replay x"}},
        {"snapshot", std::string("HAWSERST\x01\0\0\0", 12), {"a saved state", "--restore x"}},
        {"exercise",
         R"({"version": 1, "exercise": "lift", "scene": "a.json"})",
         {"an exercise", "hawser exercise x"}},
        {"settled state", R"({"bodies": {"a": {"p": [0, 0, 0]}}})", {"a settled state", "state"}},
        {"operations", R"([{"at": 1, "cut": "tow"}])", {"a list of operations", "--control x"}},
        {"summary", R"({"scene_hash": "1", "state_hash": "2"})", {"the summary of a run"}},
        {"control", "time,a\n0,1\n", {"a control file", "--control x"}},
        {"moordyn",
         "--------- MoorDyn Input File ------\nx\n---- LINE TYPES ----\n",
         {"MoorDyn", "\"cables\""}},
        {"moordyn without its first line",
         "Mooring of a spar\n\n---------------------- LINE DICTIONARY -----\nTypeName\n",
         {"MoorDyn"}},
        {"urdf", "<?xml version=\"1.0\"?>\n<robot name=\"r\"/>", {"URDF", "\"bodies\""}},
        {"xacro", "<robot xmlns:xacro=\"http://www.ros.org/wiki/xacro\"/>", {"xacro"}},
        {"mjcf", "<!-- <robot> -->\n<mujoco model=\"m\"></mujoco>", {"MuJoCo (MJCF)"}},
        {"sdf", "<sdf version=\"1.6\"><world name=\"w\"/></sdf>", {"Gazebo (SDF)"}},
        {"xml", "<svg></svg>", {"XML"}},
        {"yaml", "# a scene\nversion: 1\nbodies:\n  - name: a\n", {"YAML", "convert it to JSON"}},
        {"yaml of OrcaFlex", "%YAML 1.1\n# Type: Model\n# Program: OrcaFlex 11\n", {"OrcaFlex"}},
        {"toml", "[settings]\nstep = 0.01\n", {"TOML"}},
        {"comments",
         "{\"version\": 1,\n  // the name\n \"name\": \"http://x\"}",
         {"JSON with comments (line 2, column 3)", "remove them"}},
        {"comments in C",
         "{\"version\": 1, /* one */ \"name\": \"x\"}",
         {"JSON with comments (line 1, column 16)"}},
        {"comma", "{\"name\": \"a, ]\", \"version\": 1,\n}", {"a comma", "(line 1, column 30)"}},
        {"utf-16", std::string("\xff\xfe{\0", 4), {"UTF-16", "UTF-8"}},
        {"gzip", "\x1f\x8b\x08", {"compressed"}},
        {"picture", "\x89PNG\r\n", {"a picture"}},
        {"bytes",
         std::string("\x7f"
                     "ELF\0\0",
                     6),
         {"a binary file", "offset 4"}},
        {"nothing", " \n\t", {"an empty file"}},
    };
}

}  // namespace

TEST(FileKind, ScenesAndExercisesNameFilesOfAnotherKind) {
    for (const OtherFile& file : other_files()) {
        SCOPED_TRACE(file.what);
        try {
            (void)scene::load_text(file.text, "x");
            ADD_FAILURE() << "read as a scene";
        } catch (const scene::SceneError& error) {
            for (const char* words : file.said)
                EXPECT_NE(error.message.find(words), std::string::npos) << error.message;
            EXPECT_NE(error.message.find("not a scene"), std::string::npos) << error.message;
        }
    }
    try {
        (void)exercise::load_text(R"({"version": 1, "name": "a", "bodies": []})", "x");
        ADD_FAILURE();
    } catch (const scene::SceneError& error) {
        EXPECT_EQ(error.message, "this is a scene, not an exercise; `hawser run x` runs it");
    }
}

TEST(FileKind, ScenesWithMistakesStayScenes) {
    const auto message = [](const std::string& text) {
        try {
            (void)scene::load_text(text, "x");
        } catch (const scene::SceneError& error) {
            return error.message;
        }
        return std::string("none");
    };
    // "http://x" in a string is not a comment. A missing or additional colon or comma is not YAML.
    for (const char* text :
         {R"({"version": 1, "name": "http://x", "bodis": []})",
          R"({"version": 1, "name": "x", "bodies": {"a": 1}})",
          R"({"version": 1, "name": "x" "bodies": []})", R"({"version" 1})", "[1, 2]"})
        EXPECT_EQ(message(text).find("this is"), std::string::npos) << message(text);
}

}  // namespace hawser::test
