// SPDX-License-Identifier: Apache-2.0
/// Tutorial of docs/winches.md, run as written: its figures are those of its runs.
#include <hawser/hawser.h>
#include <hawser/session.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

namespace hawser::test {
namespace {

using Json = nlohmann::json;

/// The page has figures in hundredths of a metre.
constexpr double kRounded = 0.0051;

struct Tutorial {
    std::string text;
    Json scene;
    std::string table;

    Tutorial() {
        std::ifstream in("docs/winches.md");
        text.assign(std::istreambuf_iterator<char>(in), {});
        text = text.substr(0, text.find("## Drum and layers"));
        const std::vector<std::string> blocks = fenced();
        scene = Json::parse(blocks.at(0));
        scene.update(Json::parse(blocks.at(1)));
        table = blocks.at(2);
    }

    /// Return the contents of its code blocks.
    [[nodiscard]] std::vector<std::string> fenced() const {
        std::vector<std::string> out;
        std::size_t at = 0;
        while ((at = text.find("\n```", at)) != std::string::npos) {
            const std::size_t begin = text.find('\n', at + 1) + 1, end = text.find("\n```", begin);
            out.push_back(text.substr(begin, end - begin + 1));
            at = end + 4;
        }
        return out;
    }

    /// Return the number at the position of "#".
    [[nodiscard]] double figure(std::string words) const {
        words.replace(words.find('#'), 1, "([0-9.]+)");
        std::smatch found;
        if (!std::regex_search(text, found, std::regex(words))) {
            ADD_FAILURE() << "docs/winches.md does not say: " << words;
            return 0.0;
        }
        return std::stod(found[1]);
    }
};

double height(const Session& session) {
    return session.world().pose(session.world().find_body("load")).position.z();
}

void run_to(Session& session, double time) {
    while (session.time() < time - 1e-6) ASSERT_EQ(session.step(), Status::ok) << session.time();
}

TEST(WinchTutorial, ConstantTensionLiftsTheLoadByWhatThePageSays) {
    Tutorial page;
    page.scene["winches"][0].update({{"mode", "tension"}, {"tension", 8e4}});
    SessionDef def;
    def.scene_text = page.scene.dump();
    Session session(def);
    const double start = height(session);
    run_to(session, 10.0);
    EXPECT_NEAR(height(session) - start, page.figure("rises by # m in 10 s"), kRounded);
}

TEST(WinchTutorial, TheControlFileLiftsItByWhatThePageSays) {
    const Tutorial page;
    const auto folder = std::filesystem::path(testing::TempDir()) / "hawser_winch_tutorial";
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "tension.csv") << page.table;
    SessionDef def;
    def.scene_text = page.scene.dump();
    def.control = folder / "tension.csv";
    Session session(def);
    run_to(session, 5.0);
    const double held = height(session);
    EXPECT_NEAR(held, 8.0, 0.01) << "the brake holds it, on its elastic wire";
    run_to(session, 20.0);
    const double lifted = height(session);
    EXPECT_NEAR(lifted - held, page.figure("lifts the load by # m in 15 s"), kRounded);
    // The brake stops it; only the stretch of the wire is left, some centimetres.
    run_to(session, 25.0);
    EXPECT_NEAR(height(session), lifted, 0.1);
}

}  // namespace
}  // namespace hawser::test
