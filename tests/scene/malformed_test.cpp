// SPDX-License-Identifier: Apache-2.0
// Every malformed scene is rejected with file, position and reason; none crashes.
#include "malformed_table.h"

#include "support.h"
#include "support/tier.h"

#include <sys/wait.h>

#include <cstdio>
#include <cstdlib>
#include <iterator>

namespace hawser::scene::test {
namespace {

static_assert(std::size(kMistakes) >= 200);

TEST(Malformed, good_scenes_load) {
    for (const std::string_view scene : kGoodScenes) {
        EXPECT_EQ(refusal(scene), "");
    }
}

TEST(Malformed, every_mistake_is_refused_at_its_place) {
    for (const Mistake& mistake : kMistakes) {
        SCOPED_TRACE(mistake.patch);
        const std::string text = patched(mistake.scene, mistake.patch);
        try {
            (void)load_text(text, "test.json");
            ADD_FAILURE() << "accepted";
        } catch (const SceneError& error) {
            EXPECT_EQ(error.file, "test.json");
            EXPECT_EQ(error.path, mistake.path) << error.what();
            EXPECT_NE(error.message.find(mistake.words), std::string::npos) << error.what();
        }
    }
}

struct Damaged {
    std::string text;
    std::string words;
};

TEST(Malformed, texts_that_are_not_json) {
    const std::string open(70, '[');
    const std::string objects = [] {
        std::string text;
        for (int i = 0; i < 70; ++i) {
            text += R"({"a":)";
        }
        return text;
    }();
    const Damaged texts[] = {
        {"", "an empty file"},
        {" ", "an empty file"},
        {"{", "line 1"},
        {"}", "line 1"},
        {"[1, 2", "line 1"},
        {"{\"version\": 1,}", "a comma behind a last entry (line 1, column 14)"},
        {"{\"version\": 1 \"name\": \"x\"}", "line 1"},
        {"{\n  \"version\": 1,\n  \"name\": x\n}", "line 3, column 11"},
        {"{'version': 1}", "line 1"},
        {"{version: 1}", "line 1"},
        {"{\"version\": 01}", "line 1"},
        {"{\"version\": +1}", "line 1"},
        {"{\"version\": .5}", "line 1"},
        {"{\"version\": 1.}", "line 1"},
        {"{\"version\": 0x1}", "line 1"},
        {"{\"version\": NaN}", "line 1"},
        {"{\"version\": nan}", "line 1"},
        {"{\"version\": Infinity}", "line 1"},
        {"{\"version\": -Infinity}", "line 1"},
        {"{\"version\": 1e999}", "number overflow"},
        {"{\"version\": -1e999}", "number overflow"},
        {"{\"version\": tru}", "line 1"},
        {"// comment\n{}", "comments (line 1, column 1)"},
        {"{} {}", "line 1"},
        {"{\"a\": \"\x01\"}", "line 1"},
        {"{\"a\": \"\\q\"}", "line 1"},
        {"{\"a\": \"\\ud800\"}", "line 1"},
        {"{\"a\": \"\xff\"}", "line 1"},
        {"{\"a\": \"\xc3\"}", "line 1"},
        {std::string("{\"a\": 1}\0", 9), "a NUL byte at offset 8"},
        {"\xff\xfe{}", "UTF-16"},
        {"{\"version\": 1, \"version\": 1}", "given twice"},
        {"{\"settings\": {\"step\": 1, \"step\": 1}}", "given twice"},
        {open, "more than 64 levels"},
        {objects, "more than 64 levels"},
    };
    for (const Damaged& damaged : texts) {
        const std::string message = refusal(damaged.text);
        EXPECT_NE(message.find(damaged.words), std::string::npos)
            << damaged.text << " -> " << message;
    }
}

/// Exit code and messages of `hawser check FILE`.
struct Outcome {
    int code = -1;
    std::string output;
};

Outcome check_with_program(const std::string& program, const std::filesystem::path& file) {
    const std::string command = "'" + program + "' check '" + file.string() + "' 2>&1";
    Outcome run;
    FILE* pipe = popen(command.c_str(), "r");
    char buffer[512];
    while (fgets(buffer, sizeof buffer, pipe) != nullptr) {
        run.output += buffer;
    }
    const int status = pclose(pipe);
    run.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return run;
}

TEST(Malformed, the_program_refuses_every_one_with_its_code) {
    const char* folder_of_programs = std::getenv("HAWSER_BIN_DIR");
    const std::string program =
        std::string(folder_of_programs != nullptr ? folder_of_programs : "") + "/hawser";
    if (!std::filesystem::exists(program)) {
        GTEST_SKIP() << "needs the program; HAWSER_BIN_DIR names its folder";
    }
    const TempFolder folder;
    const auto good = check_with_program(program, folder.write("good.json", kSite));
    EXPECT_EQ(good.code, 0) << good.output;
    // Each start of the program takes tens of milliseconds; the test above covers every mistake.
    const int stride = ::hawser::test::by_tier(9, 1, 1);
    int number = 0;
    for (const Mistake& mistake : kMistakes) {
        if (number++ % stride != 0) continue;
        SCOPED_TRACE(mistake.patch);
        const auto file = folder.write("scene.json", patched(mistake.scene, mistake.patch));
        const Outcome outcome = check_with_program(program, file);
        // 1 is the documented exit code for a rejected scene; a crash has another.
        EXPECT_EQ(outcome.code, 1) << outcome.output;
        EXPECT_NE(outcome.output.find("scene.json: " + std::string(mistake.path)),
                  std::string::npos)
            << outcome.output;
    }
}

TEST(Malformed, a_file_too_large_is_not_read) {
    std::string text(kMaxFileBytes + 1, ' ');
    EXPECT_NE(refusal(text).find("64 MiB"), std::string::npos);
    const TempFolder folder;
    const auto file = folder.write("large.json", text);
    try {
        (void)load_file(file);
        FAIL();
    } catch (const SceneError& error) {
        EXPECT_EQ(error.file, file.string());
        EXPECT_NE(error.message.find("64 MiB"), std::string::npos);
    }
}

TEST(Malformed, files_that_are_not_there) {
    for (const char* name : {"", "no_such_scene.json", "/", "."}) {
        EXPECT_THROW((void)load_file(name), SceneError) << name;
    }
}

TEST(Malformed, options) {
    const auto with = [](auto change) {
        Options options;
        change(options);
        return refusal(kSite, options);
    };
    EXPECT_NE(with([](Options& o) { o.scale = 0; }).find("scale"), std::string::npos);
    EXPECT_NE(with([](Options& o) { o.scale = 1001; }).find("scale"), std::string::npos);
    EXPECT_NE(with([](Options& o) { o.threads = 0; }).find("threads"), std::string::npos);
    EXPECT_NE(with([](Options& o) { o.step = -1; }).find("/settings/step"), std::string::npos);
    EXPECT_NE(with([](Options& o) { o.step = std::nan(""); }).find("/settings/step"),
              std::string::npos);
    Options scaled;
    scaled.scale = 2;
    EXPECT_NE(refusal(kPendulum, scaled).find("repeat"), std::string::npos);

    const std::pair<const char*, const char*> sets[] = {
        {"", "path=value"},
        {"settings.step", "path=value"},
        {"=1", "path=value"},
        {"settings.stp=0.1", "did you mean \"step\""},
        {"setings.step=0.1", "did you mean \"settings\""},
        {"settings.step=fast", "a time"},
        {"settings.step=NaN", "a time"},
        {"settings.step.x=1", "there is no \"x\""},
        {"bodies.rog.mass=1", "did you mean \"rig\""},
        {"bodies.99.mass=1", "there is no \"99\""},
        {"bodies.rig.mass=-1", "greater than 0"},
        {"bodies.rig.maas=1", "did you mean \"mass\""},
        {"interactions.fal.EA=1", "did you mean \"fall\""},
        {"cables.moor.elements=0", "at least 1"},
        {"line_types.chain67.EA=1", "did you mean \"chain76\""},
        {"a..b=1", "has no key"},
        {"bodies.rig.mass=\xff", "ASCII"},
    };
    for (const auto& [option, words] : sets) {
        const std::string message = with([&, o = option](Options& all) { all.set = {o}; });
        EXPECT_NE(message.find(words), std::string::npos) << option << " -> " << message;
    }
}

}  // namespace
}  // namespace hawser::scene::test
