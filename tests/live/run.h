// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file run.h
/// A session that is shown and controlled while a test runs: `hawser view` without its command
/// line.

#include "live/driver.h"
#include "live/server.h"

#include <hawser/session.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace hawser::test {

/// Return a scene: a tow, beside which a winch hoists, with controls, a timeline and a wire that
/// may break.
[[nodiscard]] const std::string& live_scene();

class LiveRun {
  public:
    struct Options {
        double slow_seconds = 10.0, handshake_seconds = 5.0;
        int clients = 16;
        bool paused = false;
        double states_fraction = live::DriverOptions{}.states_fraction;
    };
    explicit LiveRun(const SessionDef& def) : LiveRun(def, Options{}) {}
    LiveRun(const SessionDef& def, const Options& options);
    ~LiveRun();

    [[nodiscard]] std::uint16_t port() const { return server->port(); }
    [[nodiscard]] std::string host() const { return "127.0.0.1:" + std::to_string(port()); }
    /// Return the number of logged lines that contain a text; waits until the expected number is
    /// reached.
    [[nodiscard]] int logged(const std::string& part, int expected = 0);
    [[nodiscard]] std::int64_t steps() const { return steps_.load(); }
    /// True if the session makes steps.
    [[nodiscard]] bool goes_on(double seconds = 2.0);
    void stop();

    Session session;
    live::Hub hub;
    std::vector<live::Role> roles;  ///< Instructor, observer, and a station with the control
                                    ///< "push".
    std::unique_ptr<live::Driver> driver;
    std::unique_ptr<live::Server> server;

  private:
    std::mutex mutex_;
    std::vector<std::string> log_;
    std::atomic<bool> stop_{false};
    std::atomic<std::int64_t> steps_{0};
    std::thread thread_;
};

}  // namespace hawser::test
