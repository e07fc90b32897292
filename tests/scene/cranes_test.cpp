// SPDX-License-Identifier: Apache-2.0
// Cranes of a scene: their bodies and systems, templates and copies, rejections, and the bits of
// scenes with cranes.
#include "support.h"

#include "good_scenes.h"

#include <hawser/structure.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace hawser::scene::test {
namespace {

constexpr const char* kKnuckleFile = "scenes/crane_knuckle.json";

TEST(SceneCranes, AreMadeInTemplatesAndCopies) {
    Scene scene = load_text(kCranes, "cranes.json");
    World& w = scene.world;
    for (const char* name : {"knuckle", "big/crane", "1:knuckle", "1:big/crane"}) {
        const std::string crane(name);
        EXPECT_NE(w.find_system(crane), nullptr) << crane;
        EXPECT_TRUE(w.find_body(crane + "/hook").valid()) << crane;
        EXPECT_TRUE(w.find_interaction(crane + "/slew/motor").valid()) << crane;
    }
    for (int i = 0; i < 120; ++i) ASSERT_EQ(w.step(), Status::ok);
    // The crane is rotated by 90 degrees, and slewed by 10 more; it carries the box.
    EXPECT_NEAR(w.output(w.find_output("turn")), 0.17453, 1e-4);
    EXPECT_LT(w.pose(w.find_body("knuckle/hook")).position.x(), -2.0);
    EXPECT_EQ(w.system_signal("knuckle.held"), 1.0);
    EXPECT_NEAR(w.pose(w.find_body("1:knuckle/hook")).position.x() -
                    w.pose(w.find_body("knuckle/hook")).position.x(),
                200.0, 1e-9);
    // Three falls carry the empty hook.
    EXPECT_NEAR(w.output(w.find_output("big/fall")), 12000.0 * 9.81 / 3.0, 2000.0);
}

/// Return the message for an option: "path: message".
std::string refused_with(const std::string& set) {
    Options options;
    options.set = {set};
    try {
        (void)load_file(kKnuckleFile, options);
    } catch (const SceneError& error) {
        return error.path + ": " + error.message;
    }
    return "taken";
}

TEST(SceneCranes, AreRefusedAtTheirPlace) {
    struct Row {
        const char *set, *path, *words;
    };
    for (const Row& row : std::vector<Row>{
             {"cranes.crane.kind=knuckle", "/cranes/0/kind: ", "known: knuckle_boom, lattice"},
             {"cranes.crane.on=bargee", "/cranes/0/on: ", "did you mean \"barge\""},
             {"cranes.crane.on=crane/hook", "/cranes/0/on: ", "there is no body"},
             {"cranes.crane.hoist.efficiency=1.2", "/cranes/0/hoist/efficiency: ", "at most 1"},
             {"cranes.crane.hoist.efficiency=0", "/cranes/0/hoist/efficiency: ", "(0, 1]"},
             {"cranes.crane.hoist.falls=0", "/cranes/0/hoist/falls: ", "at least 1"},
             {"cranes.crane.hoist.fals=2", "/cranes/0/hoist/fals: ", "did you mean \"falls\""},
             {"cranes.crane.boom.mass=-1", "/cranes/0/boom/mass: ", "greater than 0"},
             {"cranes.crane.boom_cylinder.max_length=8",
              "/cranes/0/boom_cylinder/max_length: ", "m apart"},
             {"cranes.crane.jib_cylinder.max_length=12",
              "/cranes/0/jib_cylinder/max_length: ", "farther apart"},
             {"cranes.crane.jib_angle_deg=-150", "/cranes/0/jib_cylinder/min_length: ", "m apart"},
             {"cranes.crane.boom_foot=[0.5, 1, 4]", "/cranes/0/boom_foot: ", "plane"},
             {"cranes.crane.hook.least_hang=20", "/cranes/0/hook/least_hang: ", "6.8"},
             {"cranes.crane.rating.curve=[[14, 25000], [14, 20000]]",
              "/cranes/0/rating/curve/1: ", "have to grow"},
             {"cranes.crane.rating.curve=[[14, 25000], [18, 26000]]",
              "/cranes/0/rating/curve/1: ", "may not grow"},
             {"cranes.crane.rating.curve=[[14]]", "/cranes/0/rating/curve/0: ", "a radius"},
             {"cranes.crane.rating.warning=1.5", "/cranes/0/rating/warning: ", "above overload"},
             {"cranes.crane.loads.0.body=lod", "/cranes/0/loads/0/body: ", "did you mean \"load\""},
             {"cranes.crane.loads.0.body=world", "/cranes/0: ", "a rigid body or a lump"},
             {"cranes.crane.take=tug", "/cranes/0/take: ", "none of its loads"},
             {"cranes.crane.point=[0, 0]", "/cranes/0/point: ", "expected"}}) {
        const std::string reported = refused_with(row.set);
        EXPECT_TRUE(reported.starts_with(row.path)) << row.set << ": " << reported;
        EXPECT_NE(reported.find(row.words), std::string::npos) << row.set << ": " << reported;
    }
}

TEST(SceneCranes, TimelinesNameTheirLoads) {
    Scene scene = load_file("scenes/crane_lattice.json");
    ASSERT_FALSE(scene.timeline.empty());
    EXPECT_NE(to_string(scene.timeline.front()).find("crane.take = 1"), std::string::npos);
    Options options;
    options.set = {R"(timeline.0={"at": 1, "set": {"crane.take": "modul"}})"};
    try {
        (void)load_file("scenes/crane_lattice.json", options);
        FAIL() << "there is no such load";
    } catch (const SceneError& error) {
        EXPECT_EQ(error.path, "/timeline/0/set/crane.take");
        EXPECT_NE(error.message.find("did you mean \"module\""), std::string::npos)
            << error.message;
    }
}

TEST(SceneCranes, MistakesOfOneAreNoMistakesOfWhatNamesItsParts) {
    Options options;
    options.set = {"cranes.crane.boom_cylinder.max_length=8"};
    std::vector<SceneError> mistakes;
    EXPECT_FALSE(load_file(kKnuckleFile, options, mistakes));
    ASSERT_EQ(mistakes.size(), 1u) << mistakes[1].path << mistakes[1].message;
    EXPECT_EQ(mistakes[0].path, "/cranes/0/boom_cylinder/max_length");
}

/// A thousand steps of a scene in which its crane lifts and slews.
class Shift {
  public:
    Shift(const std::string& file, int threads)
        : scene_(load_file(file, [&] {
              Options options;
              options.threads = threads;
              return options;
          }())) {}
    World& world() { return scene_.world; }
    void work(int from, int to) {
        for (int i = from; i < to; ++i) {
            const auto order = [&](int step, const char* name, double value) {
                if (i == step) world().set_system_signal(std::string("crane.") + name, value);
            };
            order(60, "take", 1.0);
            order(120, "hoist", 0.1);
            order(600, "slew", 0.02);
            order(650, "luff", 0.02);
            order(900, "take", 0.0);
            ASSERT_EQ(world().step(), Status::ok) << i;
        }
    }

  private:
    Scene scene_;
};

TEST(SceneCranes, BitsDoNotDependOnThreadsOrRestoring) {
    constexpr int kSteps = 1000;
    for (const char* file : {kKnuckleFile, "scenes/crane_lattice.json"}) {
        std::vector<std::uint64_t> hashes;
        for (const int threads : {1, 2, 4, 8}) {
            Shift s(file, threads);
            s.work(0, kSteps);
            hashes.push_back(s.world().state().hash());
        }
        EXPECT_EQ(Shift(file, 1).world().system_signal("crane.held"), 0.0);
        for (const int at : {40, 300, 700, 950}) {
            Shift s(file, 1), other(file, 2);
            s.work(0, at);
            other.world().state().restore(s.world().state().structure(), s.world().state().save());
            other.work(at, kSteps);
            hashes.push_back(other.world().state().hash());
        }
        for (const std::uint64_t hash : hashes) EXPECT_EQ(hash, hashes.front()) << file;
    }
}

}  // namespace
}  // namespace hawser::scene::test
