// SPDX-License-Identifier: Apache-2.0
/// The anchor-handling exercise: its size, the first minute of each phase from saved states, equal
/// bits for any threads, whole runs and random controls.
#include <hawser/exercise.h>
#include <hawser/hawser.h>

#include "record/control.h"
#include "support/repeat.h"
#include "support/sanitizer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

namespace hawser::test {
namespace {

/// Values of the stations' inputs over time, by a control file.
class Crew {
  public:
    Crew(const exercise::Exercise& e, const std::string& file) {
        for (const exercise::Station& station : e.stations)
            for (const std::string& input : station.inputs) {
                inputs_.push_back(input);
                roles_.push_back(station.name);
            }
        changes_ = record::read_control(file, inputs_);
    }
    void set(double now, exercise::Run& run) {
        for (; next_ < changes_.size() && changes_[next_].time <= now; ++next_) {
            const auto k = static_cast<std::size_t>(changes_[next_].input);
            run.set_input(roles_[k], inputs_[k], changes_[next_].value);
        }
    }

  private:
    std::vector<std::string> inputs_, roles_;
    std::vector<record::ControlChange> changes_;
    std::size_t next_ = 0;
};

/// Case of an exercise.
struct Voyage {
    std::string name;                ///< Exercise; its control file is applied.
    std::string state{};             ///< Saved state, packed by gzip; "": start of the scene.
    double seconds = 1e6;            ///< Duration from there [s].
    std::vector<std::string> set{};  ///< Changes to the scene.
    int threads = 1;
    bool verify = false;
    std::string record{};  ///< Recording file; "": none.
    std::string save{};    ///< File for the state after half of the duration; "": none.
    std::string middle{};  ///< Saved state of an earlier run that this one continues.
};

/// Outcome of a run with the largest residuals of its steps.
struct Sailed {
    exercise::Result result;
    double natural_map = 0.0;  ///< Largest of all steps.
    double unexplained = 0.0;  ///< Largest change of the energy without a cause [J].
    double work = 0.0;         ///< Work of motors, and of the main propellers of ahts1 [J].
    std::string failure;       ///< Reason of a failed step; "": none.
    std::uint64_t hash = 0;    ///< State at the end.
};

/// Return the mechanical energy less all explained parts [J].
double unexplained(const Energy& e) {
    return e.mechanical() - e.applied - e.driven - e.system - e.edited + e.dissipated + e.friction +
           e.contact + e.damped;
}

/// Return the name of a new temporary file.
std::string temporary(const std::string& ending) {
    return (std::filesystem::temp_directory_path() /
            ("hawser_" + std::to_string(std::random_device{}()) + ending))
        .string();
}

/// Start the session of a voyage.
Session started(const Voyage& voyage, exercise::Exercise& task) {
    scene::Options options;
    options.set = voyage.set;
    options.threads = voyage.threads;
    exercise::Loaded loaded = exercise::load_file("exercises/" + voyage.name + ".json", options);
    SessionDef def{
        .restore = voyage.middle, .record = voyage.record, .every = 60, .verify = voyage.verify};
    if (!voyage.state.empty() && voyage.middle.empty()) {
        def.restore = temporary(".hws");
        const std::string unpack = "gzip -dc " + voyage.state + " > " + def.restore;
        EXPECT_EQ(std::system(unpack.c_str()), 0) << unpack;
    }
    Session session(std::move(loaded.scene), def);
    if (def.restore != voyage.middle) std::filesystem::remove(def.restore);
    EXPECT_TRUE(session.differences().empty()) << "the state belongs to another scene";
    task = loaded.exercise;
    if (session.time() > 0.0) exercise::start_at(task, session.time());
    return session;
}

/// Run an exercise with its control file.
Sailed sail(const Voyage& voyage) {
    exercise::Exercise task;
    Session session = started(voyage, task);
    const World& world = session.world();
    Crew crew(task, "exercises/" + voyage.name + ".control.csv");
    exercise::Run run(task, session);
    Sailed out;
    const double start = session.time(), until = start + voyage.seconds;
    double first = 0.0, driven = 0.0;
    bool saves = !voyage.save.empty();
    while (!run.ended() && session.time() < until - 1e-6) {
        crew.set(session.time() + 1e-6, run);
        const bool is_first = session.time() == start;
        if (const Status status = run.step(); status != Status::ok) {
            out.failure = std::string(to_string(status)) + ": " + session.objection();
            break;
        }
        const Energy e = world.energy();
        if (is_first) {
            first = unexplained(e);
            driven = e.driven;
        }
        out.natural_map = std::max(out.natural_map, world.stats().natural_map);
        out.unexplained = std::max(out.unexplained, std::abs(unexplained(e) - first));
        out.work += std::abs(e.driven - driven);
        driven = e.driven;
        for (const char* side : {"ahts1/ship.port_thrust", "ahts1/ship.starboard_thrust"})
            out.work +=
                std::abs(world.system_signal(side) * world.system_signal("ahts1/ship.speed")) /
                60.0;
        if (saves && session.time() >= start + voyage.seconds / 2) {
            session.save(voyage.save);
            saves = false;
        }
    }
    out.result = run.result();
    out.hash = world.state().hash();
    session.finish();
    return out;
}

/// Expect good steps and certified contacts. The contact tolerance is that of the default settings,
/// 1e-6.
void expect_certified(const Sailed& s) {
    EXPECT_EQ(s.failure, "");
    EXPECT_LE(s.natural_map, 1e-6);
}

/// Expect certified steps and no penalty.
void expect_good(const Sailed& s) {
    expect_certified(s);
    for (const exercise::Tally& penalty : s.result.penalties)
        EXPECT_EQ(penalty.times, 0) << penalty.name;
}

TEST(AnchorHandling, IsOneSystemOfTheRequiredSize) {
    exercise::Loaded loaded = exercise::load_file("exercises/anchor_handling_lower.json");
    World& world = loaded.scene.world;
    for (int i = 0; i < 3; ++i) ASSERT_EQ(world.step(), Status::ok);
    EXPECT_GE(world.stats().bodies, 1000);
    EXPECT_GE(world.stats().interactions, 3000);
    EXPECT_GE(world.stats().equations, 9500);
    EXPECT_EQ(world.stats().islands, 1) << "pennant hooked on, chain in the jaw: all is connected";
}

const std::string kStates = "tests/data/anchor_handling/";
/// Duration of a phase in the tests [s]. Sanitizers slow the steps down by a factor of 10.
const double kMinute = kSanitized ? 0.5 : 60.0;

TEST(AnchorHandling, PennantBeginsAtTheRig) {
    expect_good(sail({.name = "anchor_handling", .seconds = kMinute}));
}

TEST(AnchorHandling, HaulBeginsFromItsState) {
    expect_good(
        sail({.name = "anchor_handling", .state = kStates + "haul.hws.gz", .seconds = kMinute}));
}

TEST(AnchorHandling, RunBeginsFromItsState) {
    expect_good(
        sail({.name = "anchor_handling", .state = kStates + "run.hws.gz", .seconds = kMinute}));
}

TEST(AnchorHandling, LowerBeginsInTheJaw) {
    expect_good(sail({.name = "anchor_handling_lower", .seconds = kMinute}));
}

TEST(AnchorHandling, SetBeginsOnTheSeabed) {
    expect_good(
        sail({.name = "anchor_handling", .state = kStates + "set.hws.gz", .seconds = kMinute}));
}

TEST(AnchorHandling, DisconnectBeginsWithTheAnchorSet) {
    expect_good(sail(
        {.name = "anchor_handling", .state = kStates + "disconnect.hws.gz", .seconds = kMinute}));
}

/// Run three minutes with recording. Expect the same bits on other numbers of threads, from the
/// middle in a new session, and in a replay.
void expect_equal_bits(Voyage voyage) {
    voyage.seconds = 180.0;
    Voyage saved = voyage;
    saved.record = temporary(".hwr");
    saved.save = temporary(".hws");
    const Sailed one = sail(saved);
    EXPECT_EQ(one.failure, "");
    (void)expect_repeats(record::Recording::open(saved.record), 2);
    EXPECT_EQ(sail({.name = voyage.name, .seconds = 90.0, .middle = saved.save}).hash, one.hash)
        << "from the middle";
    std::filesystem::remove(saved.record);
    std::filesystem::remove(saved.save);
    for (const int threads : {2, 4, 8}) {
        voyage.threads = threads;
        EXPECT_EQ(sail(voyage).hash, one.hash) << threads << " threads";
    }
}

TEST(AnchorHandling, SameBitsWithTheAnchorComingOverTheRoller_long) {
    expect_equal_bits({.name = "anchor_handling", .state = kStates + "haul.hws.gz"});
}

TEST(AnchorHandling, SameBitsWhileTheLineRunsOut_long) {
    expect_equal_bits({.name = "anchor_handling", .state = kStates + "run.hws.gz"});
}

TEST(AnchorHandling, SameBitsWhileTheAnchorGoesDown_long) {
    expect_equal_bits({.name = "anchor_handling_lower"});
}

/// Expect all goals without penalty, each step verified, and the energy explained.
void expect_passed(const std::string& exercise) {
    const Sailed s = sail({.name = exercise, .verify = true});
    expect_good(s);
    EXPECT_EQ(s.result.outcome, exercise::Outcome::passed) << exercise::to_json(s.result);
    EXPECT_EQ(s.result.points, 100.0) << exercise::to_json(s.result);
    std::printf("%s: %.3g J without a cause of %.4g J\n", exercise.c_str(), s.unexplained, s.work);
    EXPECT_LE(s.unexplained, 1e-3 * s.work);
}

TEST(AnchorHandling, LowerPasses_long) { expect_passed("anchor_handling_lower"); }

TEST(AnchorHandling, WholePasses_long) { expect_passed("anchor_handling"); }

/// Result of a passed long case, kept in a file so that an interrupted suite continues after it.
class Kept {
  public:
    explicit Kept(const std::string& name)
        : file_(std::filesystem::path("out/anchor_handling_long") / (name + ".txt")) {}
    [[nodiscard]] bool done() const { return std::filesystem::exists(file_); }
    void keep(const std::string& text) const {
        std::filesystem::create_directories(file_.parent_path());
        std::ofstream(file_) << text << "\n";
    }

  private:
    std::filesystem::path file_;
};

/// Run ten minutes with random values of all inputs of stations, one new value each second.
/// @return reason of the end.
std::string perform_at_random(std::uint32_t seed) {
    exercise::Loaded loaded = exercise::load_file("exercises/anchor_handling.json");
    Session session(std::move(loaded.scene));
    exercise::Run run(loaded.exercise, session);
    std::mt19937 random(seed);
    double next = 0.0;
    while (!run.ended() && session.time() < 600.0 - 1e-6) {
        if (session.time() >= next - 1e-6) {
            next += 1.0;
            const auto& stations = loaded.exercise.stations;
            const exercise::Station& station = stations[random() % stations.size()];
            const std::string& input = station.inputs[random() % station.inputs.size()];
            for (const scene::SignalInput& s : session.scene().signal_inputs)
                if (s.name == input)
                    run.set_input(station.name, input,
                                  s.min + (s.max - s.min) * (random() % 1001) / 1000.0);
        }
        if (const Status status = run.step(); status != Status::ok)
            return std::string("failed step: ") + to_string(status);
    }
    return run.ended() ? run.result().end : "ten minutes";
}

TEST(AnchorHandling, RandomControlsEndWithACause_long) {
    for (std::uint32_t seed = 1; seed <= 10; ++seed) {
        const Kept kept("controls_" + std::to_string(seed));
        if (kept.done()) continue;
        const std::string end = perform_at_random(seed);
        const bool has_cause = !end.empty() && !end.starts_with("failed step");
        EXPECT_TRUE(has_cause) << seed << ": " << end;
        if (has_cause) kept.keep(end);
    }
}

TEST(AnchorHandling, OtherWavesOfFourMetres_long) {
    for (int seed = 2; seed <= 6; ++seed) {
        const Kept kept("waves_" + std::to_string(seed));
        if (kept.done()) continue;
        const Sailed s =
            sail({.name = "anchor_handling",
                  .seconds = 600.0,
                  .set = {"sea.waves.0.height=4", "sea.waves.0.seed=" + std::to_string(seed)}});
        EXPECT_EQ(s.failure, "") << seed;
        if (s.failure.empty()) kept.keep(exercise::to_json(s.result));
    }
}

}  // namespace
}  // namespace hawser::test
