// SPDX-License-Identifier: Apache-2.0
/// Exercise files: mistakes with their position, agreement with the schema, and arbitrary bytes.
#include "exercise/small_exercise.h"

#include "debrief/debrief.h"
#include "support/sanitizer.h"
#include "support/tier.h"

#include <nlohmann/json.hpp>

#include <random>
#include <regex>

namespace hawser::test {
namespace {

using nlohmann::json;

/// Return position and reason of a rejection of a document.
std::string refusal(const Yard& yard, const std::string& text) {
    try {
        (void)yard.load(text);
    } catch (const scene::SceneError& error) {
        EXPECT_EQ(std::filesystem::path(error.file).filename(), "small.json") << error.what();
        return error.path + ": " + error.message;
    }
    return "taken";
}

TEST(ExerciseFiles, MistakesHavePlaceAndRemedy) {
    const Yard yard;
    const std::pair<const char*, const char*> cases[][2] = {
        {{"/stations/1/inputs/0", "\"puhs\""}, {"/stations/1/inputs/0", "did you mean \"push\"?"}},
        {{"/stations/1/name", "\"watcher\""}, {"/stations/1/name", "a role of every exercise"}},
        {{"/stations/1/name", "\"winch\""}, {"/stations/1/name", "is there already"}},
        {{"/displays/0", "\"load_y\""}, {"/displays/0", "did you mean \"load_z\"?"}},
        {{"/faults/0/wire", "\"two\""}, {"/faults/0/wire", "did you mean \"tow\"?"}},
        {{"/faults/0/s", "63"}, {"/faults/0/s", "the wire is shorter"}},
        {{"/faults/1/motor", "\"hiost\""}, {"/faults/1/motor", "did you mean \"hoist\"?"}},
        {{"/faults/1/motor", "\"hoist/motor\""}, {"/faults/1/motor", "belongs to \"hoist\""}},
        {{"/faults/1/share", "0.5"}, {"/faults/1/motor", "always fails completely"}},
        {{"/faults/2/motor", "\"band\""}, {"/faults/2/motor", "nothing that drives"}},
        {{"/faults/6/delay", "0"}, {"/faults/6/delay", "greater than 0"}},
        {{"/faults/0/kind", "\"line_prats\""}, {"/faults/0/kind", "did you mean \"line_parts\"?"}},
        {{"/faults/0/hold", "1"}, {"/faults/0/hold", "has no key \"hold\""}},
        {{"/goals/0/when/0/output", "\"laod_z\""},
         {"/goals/0/when/0/output", "did you mean \"load_z\"?"}},
        {{"/goals/0/when/0/below", "2"}, {"/goals/0/when/0", "never met"}},
        {{"/goals/0/after", "\"up\""}, {"/goals/0/after", "there is no goal \"up\" above it"}},
        {{"/phases", R"([{"name": "lift", "goal": "pu"}])"},
         {"/phases/0/goal", "did you mean \"up\"?"}},
        {{"/goals/0/event", "\"slack\""}, {"/goals/0", "not both"}},
        {{"/penalties/0/event", "\"line_braek\""},
         {"/penalties/0/event", "did you mean \"line_break\"?"}},
        {{"/outputs/0/body", "\"laod\""}, {"/outputs/0/body", "did you mean \"load\"?"}},
        {{"/outputs/0/name", "\"tow_pull\""}, {"/outputs/1", "tow_pull"}},
        {{"/scene", "\"../../etc/passwd\""}, {"/scene", "outside"}},
        {{"/scene", "\"none.json\""}, {"/scene", "there is no file"}},
        {{"/duration", "0"}, {"/duration", "at least"}},
        {{"/version", "2"}, {"/version", "at most 1"}},
        {{"/goal", "[]"}, {"/goal", "did you mean \"goals\"?"}}};
    for (const auto& [change, expected] : cases) {
        json root = json::parse(kSmallExercise);
        root[json::json_pointer(change.first)] = json::parse(change.second);
        std::string got;
        try {
            (void)yard.load(root.dump());
            got = "taken";
        } catch (const scene::SceneError& error) {
            got = error.path + ": " + error.message;
        }
        EXPECT_TRUE(got.starts_with(expected.first) &&
                    got.find(expected.second) != std::string::npos)
            << change.first << " = " << change.second << "\n  " << got;
    }
    json lacking = json::parse(kSmallExercise);
    lacking["goals"][0].erase("when");
    EXPECT_NE(refusal(yard, lacking.dump()).find("/goals/0: needs \"when\" or \"event\""),
              std::string::npos);
    EXPECT_EQ(refusal(yard, kSmallExercise), "taken");
}

TEST(ExerciseFiles, SurvivesAnyBytes) {
    const Yard yard;
    std::mt19937 random(first_seed(3));
    const int rounds = by_tier(150, 1000, 10'000);
    const std::string good = kSmallExercise;
    int taken = 0;
    for (int round = 0; round < rounds; ++round) {
        std::string text = good;
        for (int k = 0; k < 1 + round % 4; ++k) {
            const std::size_t at = random() % text.size();
            switch (random() % 4) {
                case 0:  // Mostly harmless: another number.
                    if (std::isdigit(static_cast<unsigned char>(text[at])) != 0)
                        text[at] = static_cast<char>('0' + random() % 10);
                    else if (random() % 4 == 0)
                        text[at] = static_cast<char>(random() % 256);
                    break;
                case 1:
                    text.erase(at, random() % 30);
                    break;
                case 2:
                    text.insert(at, text.substr(random() % text.size(), random() % 60));
                    break;
                default:
                    text.insert(at, "9999999999e9");
                    break;
            }
        }
        try {
            (void)yard.load(text);
            ++taken;
        } catch (const scene::SceneError&) {
        }
    }
    EXPECT_GT(taken, rounds / 80)
        << "some of it does no harm, so that the test reaches what is behind";
    EXPECT_LT(taken, 3 * rounds / 4);
}

TEST(ExerciseFiles, ForgedNotesAreRefusedOrMeanSomething) {
    const Yard yard;
    {
        Running e(yard.load(), {.record = yard.file("r.hwr")});
        e.run->set_input("winch", "hoist.speed", -0.3);
        e.steps(10);
        e.run->trigger("instructor", "worn");
        (void)e.run->mark();
        e.steps(10);
        e.run->end("enough", false);
        (void)e.session->finish();
    }
    record::Recording recording = record::Recording::open(yard.file("r.hwr"));
    const std::vector<record::RecordedNote> notes = recording.notes;
    std::mt19937 random(first_seed(11));
    const int rounds = by_tier(20, 100, 1000);
    int refused = 0;
    for (int round = 0; round < rounds; ++round) {
        std::vector<std::byte> forged;
        recording.notes = notes;
        const std::size_t k = random() % notes.size();
        forged.assign(notes[k].bytes.begin(), notes[k].bytes.end());
        // After the document, which has its own test.
        const std::size_t from = k == 0 ? forged.size() - 9 : 0;
        forged[from + random() % (forged.size() - from)] = static_cast<std::byte>(random() % 256);
        if (round % 5 == 0) forged.resize(random() % (forged.size() + 1));
        recording.notes[k].bytes = forged;
        try {
            (void)exercise::rescore(recording);
        } catch (const record::RecordingError&) {
            ++refused;
        } catch (const scene::SceneError&) {
            ++refused;
        }
    }
    EXPECT_GT(refused, rounds / 8);
    recording.notes.clear();
    EXPECT_THROW((void)exercise::rescore(recording), record::RecordingError);
}

TEST(Debriefing, IsOneFileWithoutScriptsThatEscapesAllText) {
    const Yard yard;
    json root = json::parse(kSmallExercise);
    const std::string evil = "<script>alert(1)</script><img src=x onerror=y>&\"'";
    root["description"] = evil;
    for (const char* list : {"goals", "penalties", "alarms", "faults", "ends"})
        root[list][0]["text"] = evil;
    Running e(yard.load(root.dump()), {.record = yard.file("r.hwr")});
    e.run->set_input("winch", "hoist.speed", -0.5);
    for (int i = 0; i < 400 && !e.run->ended(); ++i) ASSERT_EQ(e.run->step(), Status::ok);
    (void)e.session->finish();
    const record::Recording recording = record::Recording::open(yard.file("r.hwr"));
    const std::string html =
        debrief::to_html(e.loaded.exercise, e.run->result(), e.run->curves(), &recording);
    EXPECT_EQ(html.find("<script"), std::string::npos);
    EXPECT_EQ(html.find("<img"), std::string::npos);
    EXPECT_NE(html.find("&lt;script&gt;"), std::string::npos);
    EXPECT_NE(html.find("default-src 'none'"), std::string::npos);
    // Nothing is fetched: the only addresses are names of XML.
    const std::regex address(R"((src|href|url)\s*[=(]\s*["']?(http|//))");
    EXPECT_FALSE(std::regex_search(html.substr(0, 20000), address));
    EXPECT_GE(std::count(html.begin(), html.end(), '<'), 200);
    std::size_t plots = 0;
    for (std::size_t at = html.find("<figure"); at != std::string::npos;
         at = html.find("<figure", at + 1))
        ++plots;
    EXPECT_EQ(plots, 5U) << "displays, two in space, side and top, tensions";
}

}  // namespace
}  // namespace hawser::test
