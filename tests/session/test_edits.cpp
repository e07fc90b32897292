// SPDX-License-Identifier: Apache-2.0
/// A run with additions and removals, and all observers.
#include <hawser/hawser.h>
#include <hawser/session.h>

#include "support/repeat.h"
#include "verify/certificate.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

namespace hawser::test {
namespace {

namespace fs = std::filesystem;

struct TempFolder {
    fs::path path = fs::temp_directory_path() / ("hawser_edits_" + std::to_string(::getpid()));
    TempFolder() { fs::create_directories(path); }
    ~TempFolder() { fs::remove_all(path); }
};

/// Boxes that fall on a floor, and a bob on a rod, all of which come to rest.
const std::string kYard = R"({
  "version": 1, "name": "yard", "settings": {"step": 0.01},
  "bodies": [
    {"name": "floor", "kind": "fixed", "shapes": [{"kind": "plane"}]},
    {"name": "crate", "mass": 20, "box": [0.4, 0.4, 0.4], "position": [0, 0, 0.25],
     "linear_damping": [20, 20, 20], "shapes": [{"kind": "box", "half_size": [0.2, 0.2, 0.2]}]},
    {"name": "other", "mass": 20, "box": [0.4, 0.4, 0.4], "position": [2, 0, 0.25],
     "shapes": [{"kind": "box", "half_size": [0.2, 0.2, 0.2]}]},
    {"name": "bob", "mass": 3, "box": [0.1, 0.1, 0.1], "position": [5.2, 0, 1.1],
     "linear_damping": [6, 6, 6],
     "angular_damping": [0.1, 0.1, 0.1]}],
  "interactions": [
    {"name": "rod", "kind": "distance", "bodies": ["floor", "bob"],
     "points": [[5, 0, 2], [0, 0, 0]]}],
  "inputs": [{"name": "push", "body": "crate", "component": "force_x", "min": -50, "max": 50}]
})";

/// Add and remove objects before a step.
void edit(World& w, int step) {
    const BodyId floor = w.find_body("floor");
    if (step == 30) {
        const BodyId ball = w.add_body({.name = "ball",
                                        .position = {1, 0, 0.5},
                                        .mass = 5.0,
                                        .inertia = Mat3::Identity() * 0.08,
                                        .angular_damping = Vec3::Constant(0.5)});
        w.add_shape({.name = "ball", .kind = ShapeKind::sphere, .body = ball, .radius = 0.2});
    }
    if (step == 60) w.remove_body(w.find_body("other"));
    if (step == 70)
        w.add_body({.name = "late",
                    .position = {2, 0, 3},
                    .velocity = {0, 1, 0},
                    .angular_velocity = {0, 0, 3},
                    .mass = 8.0,
                    .inertia = Vec3(0.2, 0.3, 0.4).asDiagonal()});
    if (step == 90)
        w.add(HingeDef{.name = "pin",
                       .a = floor,
                       .b = w.find_body("late"),
                       .point = w.pose(w.find_body("late")).position + Vec3(0, 0, 0.5),
                       .axis = {1, 0, 0}});
    if (step == 110)
        w.wires().add({.name = "line",
                       .from = floor,
                       .from_point = {8, 0, 3},
                       .elements = 4,
                       .length = 1.0,
                       .EA = 1e5,
                       .mass_per_length = 1.0,
                       .drag = 4.0});
    if (step == 150) w.remove_interaction(w.find_interaction("rod"));
    if (step == 155) w.remove_shape(w.find_shape("ball"));
    if (step == 160) w.remove_body(w.find_body("ball"));
    if (step == 170) w.remove_interaction(w.find_interaction("pin"));
    if (step == 180) w.remove_input(w.find_input("push"));
    if (step == 200) w.wires().remove(w.wires().find("line"));
    if (step == 210) w.remove_body(w.find_body("late"));
    if (step == 220) w.remove_body(w.find_body("bob"));
}

TEST(SessionEdits, EveryObserverFollowsWhatComesAndGoes) {
    const TempFolder folder;
    Session session({.scene_text = kYard,
                     .record = (folder.path / "run.hwr").string(),
                     .csv = (folder.path / "run.csv").string(),
                     .verify = true});
    for (int step = 0; step < 500; ++step) {
        edit(session.world(), step);
        ASSERT_EQ(session.step(), Status::ok) << "step " << step << ": " << session.objection();
    }
    EXPECT_EQ(session.world().verdict().grade, Grade::good);
    EXPECT_EQ(session.world().bodies().size(), 2U);
    // At rest: contacts are 1e-3 m deep at most and creep.
    EXPECT_LT(session.world().velocity(session.world().find_body("crate")).linear.norm(), 1e-4);
    EXPECT_EQ(session.finish(), record::Ending::finished);
    // A row has as many columns as the first one, despite removals.
    std::ifstream table(folder.path / "run.csv");
    std::string line;
    std::size_t columns = 0;
    while (std::getline(table, line)) {
        const auto commas = static_cast<std::size_t>(std::count(line.begin(), line.end(), ','));
        if (columns == 0) columns = commas;
        ASSERT_EQ(commas, columns) << line;
    }
}

TEST(SessionEdits, TheVerifierStillFindsWhatIsWrong) {
    for (const int wrong_at : {100, 165, 230}) {
        scene::Scene scene = scene::load_text(kYard, "yard");
        World& w = scene.world;
        verify::Verifier verifier(w);
        for (int step = 0; step <= wrong_at; ++step) {
            edit(w, step);
            verifier.before_step(w);
            ASSERT_EQ(w.step(), Status::ok);
            if (step == wrong_at) {
                const BodyId crate = w.find_body("crate");
                Twist twist = w.velocity(crate);
                twist.linear.y() += 1e-5;
                w.set_velocity(crate, twist);
            }
            const std::string said = verifier.after_step(w);
            EXPECT_EQ(said.empty(), step != wrong_at) << "step " << step << ": " << said;
        }
    }
}

/// Adds a body on a rod, and removes it again.
struct Builder final : System {
    [[nodiscard]] std::string_view name() const noexcept override { return "builder"; }
    void prestep(Prestep& now, Loads&) noexcept override {
        if (now.count == 20) {
            BodyDef def{.name = "built", .kind = BodyKind::lump, .position = {9, 0, 1}};
            def.mass = 2.0;
            const BodyId body = now.edits.add_body(def);
            InteractionDef rod;
            rod.kind = InteractionKind::Distance;
            rod.name = "stay";
            rod.body = {now.world.find_body("floor"), body};
            rod.point[0] = {9, 0, 2};
            (void)now.edits.add_interaction(rod);
        }
        if (now.count == 80) now.edits.remove_body(now.world.find_body("built"));
    }
};

TEST(SessionEdits, ARecordingRepeatsWhatSystemsBuiltWithoutThem) {
    const TempFolder folder;
    const std::string file = (folder.path / "built.hwr").string();
    std::size_t most = 0;
    {
        Session session({.scene_text = kYard, .record = file, .verify = true});
        session.world().add_system(std::make_unique<Builder>());
        for (int step = 0; step < 120; ++step) {
            ASSERT_EQ(session.step(), Status::ok) << step << ": " << session.objection();
            most = std::max(most, session.world().bodies().size());
        }
        EXPECT_EQ(most, 5U);
        EXPECT_EQ(session.world().bodies().size(), 4U);
        session.finish();
    }
    const record::Recording recording = record::Recording::open(file);
    (void)expect_repeats(recording, 1);
}

}  // namespace
}  // namespace hawser::test
