// SPDX-License-Identifier: Apache-2.0
/// Runs that reach an impossible state end as failed, with cause, object and time.
#include "cli/program.h"

#include <nlohmann/json.hpp>

namespace hawser::test {

/// Two joints between the same bodies that no pose can close together.
constexpr const char* kContradiction = R"({"version": 1, "name": "contradiction",
    "settings": {"duration": 1}, "bodies": [
        {"name": "a", "mass": 4, "box": [1, 1, 0.3]},
        {"name": "b", "mass": 5, "box": [0.2, 1, 0.5], "position": [0, 2, -0.5]}],
    "interactions": [
        {"name": "slide", "kind": "cylindrical", "bodies": ["a", "b"], "at": [0.5, -0.5, 1],
         "axis": [0, 0, 1]},
        {"name": "weld", "kind": "lock", "bodies": ["a", "b"],
         "points": [[-1, 0.5, 0], [0.5, -0.7, 0.7]]}]})";

class Diverged : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = test_folder();
        scene_ = (folder_ / "contradiction.json").string();
        write_text(scene_, kContradiction);
    }
    std::filesystem::path folder_;
    std::string scene_;
};

TEST_F(Diverged, ARunEndsWithCode2AndTheReasonInWords) {
    const std::string summary = (folder_ / "s.json").string();
    const std::string record = (folder_ / "r.hwr").string();
    const Outcome o =
        run_program({"run", scene_, "--unchecked", "--summary", summary, "--record", record});
    EXPECT_EQ(o.code, 2) << o.err;
    for (const char* word : {"failed at", "diverged", "joint '", " m ", "check"})
        EXPECT_NE(o.err.find(word), std::string::npos) << word << ": " << o.err;
    EXPECT_NE(o.out.find("(failed)"), std::string::npos) << o.out;
    EXPECT_NE(o.out.find("margins"), std::string::npos);
    const auto s = nlohmann::json::parse(read_text(summary));
    EXPECT_EQ(s.at("outcome"), "failed");
    EXPECT_EQ(s.at("verdict").at("grade"), "wrong");
    EXPECT_GT(s.at("verdict").at("margins").at("violation").at("of_wrong").get<double>(), 1.0);
    EXPECT_TRUE(std::filesystem::exists(record));
}

TEST_F(Diverged, WarnGoesOnToTheEnd) {
    const Outcome o =
        run_program({"run", scene_, "--unchecked", "--set", "settings.on_diverged=warn"});
    EXPECT_EQ(o.code, 0) << o.err;
    EXPECT_NE(o.out.find("wrong"), std::string::npos) << o.out;
    EXPECT_NE(o.out.find("joints were open"), std::string::npos) << o.out;
}

TEST_F(Diverged, AGoodRunPrintsItsMargins) {
    const Outcome o = run_program({"run", "scenes/pendulum.json", "--duration", "1", "--verify"});
    EXPECT_EQ(o.code, 0) << o.err;
    EXPECT_NE(o.out.find("margins"), std::string::npos);
    EXPECT_NE(o.out.find("(finished), ok"), std::string::npos) << o.out;
}

}  // namespace hawser::test
