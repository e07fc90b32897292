// SPDX-License-Identifier: Apache-2.0
#include "progress.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace hawser::cli {

namespace {

constexpr auto kBarInterval = std::chrono::milliseconds(100);
// A short run needs no line for each tenth.
constexpr auto kTenthInterval = std::chrono::milliseconds(250);
constexpr auto kLineInterval = std::chrono::seconds(5);

int terminal_width() {
    winsize size{};
    return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

double seconds(std::chrono::steady_clock::duration d) {
    return std::chrono::duration<double>(d).count();
}

}  // namespace

Progress::Progress(std::int64_t steps, double step, bool enabled)
    : steps_(std::max<std::int64_t>(1, steps)),
      step_(step),
      enabled_(enabled),
      terminal_(isatty(STDERR_FILENO) == 1),
      start_(Clock::now()),
      last_shown_(start_) {}

Progress::~Progress() { close(); }

void Progress::update(std::int64_t done, const std::string& note) {
    if (!enabled_) return;
    const Clock::time_point now = Clock::now();
    if (terminal_) {
        if (now - last_shown_ < kBarInterval && done < steps_) return;
        last_shown_ = now;
        draw_bar(done, note);
    } else if (now - last_shown_ >= kLineInterval ||
               (done * 10 >= next_tenth_ * steps_ && now - last_shown_ >= kTenthInterval)) {
        last_shown_ = now;
        next_tenth_ = done * 10 / steps_ + 1;
        line(done, note);
    }
}

double Progress::factor(std::int64_t done) const {
    const double wall = seconds(Clock::now() - start_);
    return wall > 0.0 ? static_cast<double>(done) * step_ / wall : 0.0;
}

void Progress::draw_bar(std::int64_t done, const std::string& note) {
    const double share =
        std::clamp(static_cast<double>(done) / static_cast<double>(steps_), 0.0, 1.0);
    const double wall = seconds(Clock::now() - start_);
    const double left = share > 0.0 ? wall * (1.0 - share) / share : 0.0;
    std::string tail = fmt::format(
        " {:3.0f} %  {:.2f} of {:.2f} s  {:.3g}x real time  {:.0f} s left{}{}", 100.0 * share,
        static_cast<double>(done) * step_, static_cast<double>(steps_) * step_, factor(done), left,
        note.empty() ? "" : "  ", note);
    const int room = terminal_width() - 3 - static_cast<int>(tail.size());
    std::string text = "\r";
    if (room >= 8) {
        const int width = std::min(room, 40);
        const int full = static_cast<int>(share * width);
        text += "[" + std::string(static_cast<std::size_t>(full), '#') +
                std::string(static_cast<std::size_t>(width - full), '.') + "]";
    }
    text += tail.substr(0, static_cast<std::size_t>(std::max(10, terminal_width() - 1)));
    fmt::print(stderr, "{}\033[K", text);
    std::fflush(stderr);
    open_ = true;
}

void Progress::line(std::int64_t done, const std::string& note) {
    fmt::print(stderr, "{:3.0f} %  {:.2f} of {:.2f} s  {:.3g}x real time{}{}\n",
               100.0 * static_cast<double>(done) / static_cast<double>(steps_),
               static_cast<double>(done) * step_, static_cast<double>(steps_) * step_, factor(done),
               note.empty() ? "" : "  ", note);
    std::fflush(stderr);
}

void Progress::close() {
    if (open_) fmt::print(stderr, "\n");
    open_ = false;
}

}  // namespace hawser::cli
