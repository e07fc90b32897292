// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file progress.h
/// Show the progress of a run: a bar on a terminal, plain lines elsewhere. It goes to standard
/// error, so that standard output contains the report alone.

#include <chrono>
#include <cstdint>
#include <string>

namespace hawser::cli {

class Progress {
  public:
    /// Start the progress display. @param steps    Steps of the whole run. @param step
    /// Simulated time of one step [s]. @param enabled  False: print nothing.
    Progress(std::int64_t steps, double step, bool enabled);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Show that `done` steps have been made. A call is cheap: it rarely reads the clock or writes.
    void update(std::int64_t done, const std::string& note = {});
    /// End the line of the progress bar.
    void close();

  private:
    using Clock = std::chrono::steady_clock;
    void draw_bar(std::int64_t done, const std::string& note);
    void line(std::int64_t done, const std::string& note);
    [[nodiscard]] double factor(std::int64_t done) const;

    std::int64_t steps_;
    double step_;
    bool enabled_, terminal_;
    Clock::time_point start_, last_shown_;
    std::int64_t next_tenth_ = 1;
    bool open_ = false;
};

}  // namespace hawser::cli
