// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file small_exercise.h
/// An exercise of some seconds: a load on a winch, a tow, and a wheel with motor and brake.

#include <hawser/exercise.h>
#include <hawser/hawser.h>

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

namespace hawser::test {

inline const char* const kYard = R"({
  "version": 1, "name": "yard", "settings": {"step": 0.02},
  "line_types": {"wire": {"mass_per_length": 5, "EA": 5e6, "drag": 40, "diameter": 0.04}},
  "bodies": [
    {"name": "tug", "kind": "fixed", "position": [0, 0, 10]},
    {"name": "barge", "kind": "fixed", "position": [60, 0, 10]},
    {"name": "load", "mass": 400, "sphere": 0.5, "position": [0, 10, 5]},
    {"name": "wheel", "mass": 100, "sphere": 1, "position": [0, -20, 5]}],
  "interactions": [
    {"name": "bearing", "kind": "hinge", "bodies": ["tug", "wheel"], "at": [0, -20, 5], "axis": [0, 1, 0]},
    {"name": "drive", "kind": "hinge_motor", "bodies": ["tug", "wheel"], "axis": [0, 1, 0],
     "speed": 1, "force_min": -50, "force_max": 50},
    {"name": "band", "kind": "hinge_friction", "bodies": ["tug", "wheel"], "axis": [0, 1, 0],
     "torque": 20}],
  "cables": [
    {"name": "tow", "line_type": "wire", "from": {"body": "tug"}, "to": {"body": "barge"},
     "length": 62, "elements": 31, "shape": "hanging"},
    {"name": "fall", "line_type": "wire", "from": {"at": [0, 10, 20]}, "to": {"body": "load"},
     "elements": 8}],
  "winches": [{"name": "hoist", "cable": "fall", "core_radius": 0.5, "width": 1, "stored": 30,
     "inertia": 60, "torque_haul": 4e4, "brake_static": 2e4, "wrap_friction": 0.1}],
  "inputs": [{"name": "push", "body": "load", "component": "force_x", "min": -500, "max": 500},
             {"name": "heave_half", "signal": "hoist.speed", "factor": -0.5}],
  "timeline": [{"at": 0, "set": {"hoist.mode": "speed"}}]
})";

inline const char* const kSmallExercise = R"({
  "version": 1, "exercise": "small", "scene": "yard.json", "duration": 6, "pass": 5,
  "outputs": [{"name": "load_z", "kind": "pose", "body": "load", "component": "z"},
              {"name": "tow_pull", "kind": "tension", "cable": "tow", "component": "largest"}],
  "stations": [{"name": "winch", "inputs": ["hoist.mode", "hoist.speed", "hoist.brake", "heave_half"]},
               {"name": "deck", "inputs": ["push"]}],
  "displays": ["load_z", "hoist.wire_left"],
  "faults": [
    {"name": "part", "kind": "line_parts", "wire": "tow", "s": 20, "at": 1.5},
    {"name": "blackout", "kind": "motor_loses_force", "motor": "hoist"},
    {"name": "weak_drive", "kind": "motor_loses_force", "motor": "drive", "share": 0.25},
    {"name": "worn", "kind": "brake_slips", "brake": "hoist", "share": 0.5},
    {"name": "glazed", "kind": "brake_slips", "brake": "band", "share": 0.1, "lasts": 0.4},
    {"name": "stuck", "kind": "input_stuck", "input": "push"},
    {"name": "late", "kind": "input_late", "input": "push", "delay": 0.1},
    {"name": "frozen", "kind": "output_frozen", "output": "load_z"}],
  "alarms": [{"name": "high", "when": [{"output": "load_z", "above": 5.5}]}],
  "goals": [{"name": "up", "when": [{"output": "load_z", "above": 6}], "hold": 0.5, "points": 10}],
  "penalties": [{"name": "parted", "event": "line_break", "of": "tow", "points": 3},
                {"name": "slow", "when": [{"output": "hoist.wire_left", "below": 31}], "per_second": 0.5}],
  "ends": [{"name": "down", "when": [{"output": "load_z", "below": 2}], "failed": true}]
})";

/// A folder with the scene, deleted by the destructor.
struct Yard {
    std::filesystem::path folder = std::filesystem::temp_directory_path() / "hawser_exercise" /
                                   (std::to_string(::getpid()) + "_" +
                                    testing::UnitTest::GetInstance()->current_test_info()->name());
    Yard() {
        std::filesystem::create_directories(folder);
        std::ofstream(folder / "yard.json") << kYard;
    }
    ~Yard() { std::filesystem::remove_all(folder); }
    [[nodiscard]] std::string file(const char* name) const { return (folder / name).string(); }
    [[nodiscard]] exercise::Loaded load(const std::string& text = kSmallExercise,
                                        int threads = 1) const {
        scene::Options options;
        options.threads = threads;
        return exercise::load_text(text, file("small.json"), options);
    }
};

/// An exercise that runs.
struct Running {
    exercise::Loaded loaded;
    std::unique_ptr<Session> session;
    std::unique_ptr<exercise::Run> run;
    explicit Running(exercise::Loaded given, const SessionDef& def = {})
        : loaded(std::move(given)),
          session(std::make_unique<Session>(std::move(loaded.scene), def)),
          run(std::make_unique<exercise::Run>(loaded.exercise, *session)) {}
    void steps(int count) {
        for (int i = 0; i < count; ++i) ASSERT_EQ(run->step(), Status::ok);
    }
    [[nodiscard]] double input(const char* name) const {
        const World& w = session->world();
        return w.find_input(name).valid() ? w.input(w.find_input(name)) : w.system_signal(name);
    }
};

}  // namespace hawser::test
