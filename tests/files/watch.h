// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file watch.h
/// Measures the time of hostile inputs, and ends the process with a report if one of them loops
/// endlessly.
#include <hawser/scene.h>
#include <hawser/world.h>

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <string>
#include <string_view>

#include <unistd.h>

namespace hawser::test {

inline constexpr double kLongest = 1.0;  ///< Longest time of an input with a few steps [s].

/// Name of the running input, for the report of an endless loop.
inline char running[200] = "";

/// Ends the process with a report if an input does not end. gtest cannot interrupt a loop.
class Watch {
  public:
    Watch() {
        std::signal(SIGALRM, [](int) {
            [[maybe_unused]] const auto n = write(STDERR_FILENO, running, sizeof running);
            _exit(3);
        });
    }
    ~Watch() { alarm(0); }
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;
    void begin(const std::string& what) {
        constexpr unsigned kEndless = 60;  // [s], far above kLongest on a busy machine
        std::snprintf(running, sizeof running, "%s", what.c_str());
        start_ = std::chrono::steady_clock::now();
        alarm(kEndless);
    }
    /// Return the wall time since the start [s].
    [[nodiscard]] double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

  private:
    std::chrono::steady_clock::time_point start_;
};

/// Load a scene of `scenes`, or a text if one is given, and run 20 steps.
inline scene::Scene after_some_steps(const std::string& name, std::string_view text = {}) {
    scene::Scene scene =
        text.empty() ? scene::load_file("scenes/" + name + ".json") : scene::load_text(text, name);
    scene.world.prepare();
    for (int i = 0; i < 20; ++i) EXPECT_EQ(scene.world.step(), Status::ok) << name;
    return scene;
}

}  // namespace hawser::test
