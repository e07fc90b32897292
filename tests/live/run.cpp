// SPDX-License-Identifier: Apache-2.0
#include "live/run.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace hawser::test {

const std::string& live_scene() {
    static const std::string text = R"({
  "version": 1, "name": "tow", "settings": {"step": 0.016666666666666666},
  "line_types": {"wire": {"mass_per_length": 5, "EA": 5e6, "drag": 40, "diameter": 0.04,
                          "breaking_load": 8e5}},
  "bodies": [
    {"name": "tug", "kind": "fixed", "position": [0, 0, 10]},
    {"name": "barge", "kind": "fixed", "position": [60, 0, 10]},
    {"name": "load", "mass": 400, "sphere": 0.5, "position": [0, 10, 5]}],
  "cables": [
    {"name": "tow", "line_type": "wire", "from": {"body": "tug"}, "to": {"body": "barge"},
     "length": 62, "elements": 31, "shape": "hanging"},
    {"name": "fall", "line_type": "wire", "from": {"at": [0, 10, 20]}, "to": {"body": "load"},
     "elements": 8}],
  "winches": [{"name": "hoist", "cable": "fall", "core_radius": 0.5, "width": 1, "stored": 30,
     "inertia": 60, "torque_haul": 4e4, "brake_static": 2e4, "wrap_friction": 0.1}],
  "inputs": [{"name": "push", "body": "load", "component": "force_x", "min": -500, "max": 500},
             {"name": "lift", "body": "load", "component": "force_z", "min": -500, "max": 500}],
  "outputs": [{"name": "height", "kind": "pose", "body": "load", "component": "z"}],
  "timeline": [{"at": 0.5, "set": {"hoist.mode": "speed", "hoist.speed": -0.2, "push": 100}},
               {"at": 6, "cut": "tow", "s": 30}]
})";
    return text;
}

LiveRun::LiveRun(const SessionDef& def, const Options& options)
    : session(def),
      roles{live::instructor(), live::watcher(),
            live::Role{.name = "deck", .inputs = {"push"}, .token = live::make_token()}},
      driver(std::make_unique<live::Driver>(
          session, hub,
          live::DriverOptions{.recording = def.record,
                              .paused = options.paused,
                              .states_fraction = options.states_fraction})) {
    live::ServerOptions to_serve;
    to_serve.port = 0;
    to_serve.clients = options.clients;
    to_serve.roles = roles;
    to_serve.slow_seconds = options.slow_seconds;
    to_serve.handshake_seconds = options.handshake_seconds;
    to_serve.log = [this](const std::string& line) {
        const std::lock_guard lock(mutex_);
        log_.push_back(line);
    };
    server = std::make_unique<live::Server>(hub, std::move(to_serve));
    thread_ = std::thread([this] {
        driver->run([this] {
            steps_ = session.world().step_count();
            return stop_.load();
        });
    });
}

void LiveRun::stop() {
    stop_ = true;
    if (thread_.joinable()) thread_.join();
}

LiveRun::~LiveRun() {
    stop();
    server.reset();
}

int LiveRun::logged(const std::string& part, int expected) {
    const auto count = [&] {
        const std::lock_guard lock(mutex_);
        return static_cast<int>(std::count_if(
            log_.begin(), log_.end(),
            [&](const std::string& line) { return line.find(part) != std::string::npos; }));
    };
    // A connection may end shortly before the line with the reason is written.
    for (int k = 0; k < 200 && count() < expected; ++k)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return count();
}

bool LiveRun::goes_on(double seconds) {
    const std::int64_t before = steps();
    for (int k = 0; k < static_cast<int>(100.0 * seconds); ++k) {
        if (steps() > before + 2) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
}

}  // namespace hawser::test
