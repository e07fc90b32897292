// SPDX-License-Identifier: Apache-2.0
/// The anchor-handling exercise: its size, first seconds of its phases from saved states, whole
/// runs and random controls.
#include <hawser/exercise.h>
#include <hawser/hawser.h>

#include "record/control.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
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

/// Outcome of a run with the largest residuals of its steps.
struct Sailed {
    exercise::Result result;
    double natural_map = 0.0;  ///< Largest of all steps.
    std::int64_t steps = 0;
    std::string failure;  ///< Reason of a failed step; "": none.
};

/// Run an exercise with its control file. @param state  Saved state, packed by gzip; "": the start
/// of the scene. @param seconds  Duration from there [s].
Sailed sail(const std::string& name, const std::string& state, double seconds,
            const std::vector<std::string>& changes = {}) {
    scene::Options options;
    options.set = changes;
    exercise::Loaded loaded = exercise::load_file("exercises/" + name + ".json", options);
    SessionDef def;
    std::filesystem::path file;
    if (!state.empty()) {
        file = std::filesystem::temp_directory_path() /
               ("hawser_" + std::to_string(std::random_device{}()) + ".hws");
        const std::string unpack = "gzip -dc " + state + " > " + file.string();
        EXPECT_EQ(std::system(unpack.c_str()), 0) << unpack;
        def.restore = file.string();
    }
    Session session(std::move(loaded.scene), def);
    if (!file.empty()) std::filesystem::remove(file);
    EXPECT_TRUE(session.differences().empty()) << "the state belongs to another scene";
    if (!state.empty()) exercise::start_at(loaded.exercise, session.time());
    Crew crew(loaded.exercise, "exercises/" + name + ".control.csv");
    exercise::Run run(loaded.exercise, session);
    Sailed out;
    const double until = session.time() + seconds;
    while (!run.ended() && session.time() < until - 1e-6) {
        crew.set(session.time() + 1e-6, run);
        if (const Status status = run.step(); status != Status::ok) {
            out.failure = std::string(to_string(status)) + ": " + session.objection();
            break;
        }
        out.natural_map = std::max(out.natural_map, session.world().stats().natural_map);
        ++out.steps;
    }
    out.result = run.result();
    return out;
}

/// Expect good steps, certified contacts and no penalty. The contact tolerance is that of the
/// default settings, 1e-6.
void expect_good(const Sailed& s) {
    EXPECT_EQ(s.failure, "");
    EXPECT_LE(s.natural_map, 1e-6);
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

/// Seconds of each phase that the quick tests run; a minute in the full ones.
double stretch() { return by_tier(2, 60, 60); }

TEST(AnchorHandling, PennantBeginsAtTheRig) { expect_good(sail("anchor_handling", "", stretch())); }

TEST(AnchorHandling, HaulBeginsFromItsState) {
    expect_good(sail("anchor_handling", "tests/data/anchor_handling/haul.hws.gz", stretch()));
}

TEST(AnchorHandling, LowerBeginsInTheJaw) {
    expect_good(sail("anchor_handling_lower", "", stretch()));
}

TEST(AnchorHandling, SetBeginsOnTheSeabed) {
    expect_good(sail("anchor_handling_lower", "tests/data/anchor_handling/set.hws.gz", stretch()));
}

void expect_passed(const Sailed& s) {
    expect_good(s);
    EXPECT_EQ(s.result.outcome, exercise::Outcome::passed) << exercise::to_json(s.result);
    EXPECT_EQ(s.result.points, 100.0) << exercise::to_json(s.result);
}

TEST(AnchorHandling, LowerPasses_long) { expect_passed(sail("anchor_handling_lower", "", 1e6)); }

TEST(AnchorHandling, WholePasses_long) { expect_passed(sail("anchor_handling", "", 1e6)); }

/// Result of a long case, kept in a file so that an interrupted suite continues after it.
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
        EXPECT_FALSE(end.empty()) << seed;
        EXPECT_FALSE(end.starts_with("failed step")) << seed << ": " << end;
        kept.keep(end);
    }
}

TEST(AnchorHandling, OtherWavesOfFourMetres_long) {
    for (int seed = 2; seed <= 6; ++seed) {
        const Kept kept("waves_" + std::to_string(seed));
        if (kept.done()) continue;
        const Sailed s = sail("anchor_handling", "", 600.0,
                              {"sea.waves.0.height=4", "sea.waves.0.seed=" + std::to_string(seed)});
        EXPECT_EQ(s.failure, "") << seed;
        kept.keep(exercise::to_json(s.result));
    }
}

}  // namespace
}  // namespace hawser::test
