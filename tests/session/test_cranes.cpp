// SPDX-License-Identifier: Apache-2.0
/// A crane that takes and releases its load in a session: recorded, replayed, saved.
#include <hawser/hawser.h>
#include <hawser/repeater.h>
#include <hawser/session.h>

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace hawser::test {
namespace {

struct CraneFolder {
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("hawser_cranes_" + std::to_string(::getpid()));
    CraneFolder() { std::filesystem::create_directories(path); }
    ~CraneFolder() { std::filesystem::remove_all(path); }
    [[nodiscard]] std::string file(const char* name) const { return (path / name).string(); }
};

/// Take the load, lift it, and release it in the air. @param save  File for the state before step
/// `at`; 0: none.
std::vector<std::uint64_t> lift(Session& session, int steps, const std::string& save = "",
                                int at = 0) {
    std::vector<std::uint64_t> hashes;
    while (session.world().step_count() < steps) {
        const auto now = session.world().step_count();
        if (at > 0 && now == at) session.save(save);
        if (now == 30) session.set_input("crane.take", 1.0);
        if (now == 60) session.set_input("crane.hoist", 0.3);
        if (now == 460) session.set_input("crane.take", 0.0);
        EXPECT_EQ(session.step(), Status::ok) << now;
        hashes.push_back(session.world().state().motion_hash());
    }
    return hashes;
}

TEST(SessionCranes, AreRecordedRepeatedAndSaved) {
    const CraneFolder folder;
    const std::string scene = "scenes/crane_knuckle.json";
    Session session({.scene = scene, .record = folder.file("lift.hwr")});
    const std::vector<std::uint64_t> all = lift(session, 520);
    session.finish();
    EXPECT_GT(session.world().events().extremes(EventKind::join).count, 0);
    EXPECT_GT(session.world().events().extremes(EventKind::detach).count, 0);
    for (const int at : {20, 100, 400, 500}) {
        Session first({.scene = scene});
        (void)lift(first, at + 1, folder.file("at.hws"), at);
        Session second({.scene = scene, .restore = folder.file("at.hws")});
        const std::vector<std::uint64_t> rest = lift(second, 520);
        ASSERT_EQ(rest.size(), all.size() - static_cast<std::size_t>(at));
        EXPECT_TRUE(std::equal(rest.begin(), rest.end(), all.begin() + at)) << at;
    }
    // A replay needs no code of the crane: its actions are in the recording.
    const record::Recording r = record::Recording::open(folder.file("lift.hwr"));
    EXPECT_EQ(r.damage, "");
    scene::Scene again = scene::load_text(r.scene_text, "lift.hwr");
    while (again.world.system_count() > 0) (void)again.world.remove_system(again.world.system(0));
    again.world.prepare();
    again.world.state().restore(r.snapshot);
    record::Repeater repeater(r);
    for (std::size_t i = 0; i < r.frame_count(); ++i) {
        const record::Frame head = r.frame_head(i);
        while (again.world.step_count() < head.step) {
            repeater.before_step(again.world);
            ASSERT_EQ(again.world.step(), Status::ok);
        }
        EXPECT_EQ(again.world.state().motion_hash(), head.hash) << i;
    }
}

}  // namespace
}  // namespace hawser::test
