// SPDX-License-Identifier: Apache-2.0
#include "realtime.h"

#include <fmt/format.h>
#include <sched.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <thread>

namespace hawser::cli {

namespace {

// Delay after which a run restarts its clock instead of catching up.
constexpr double kGiveUp = 0.25;  // [s]

// Above ordinary threads, below the kernel's own real-time threads at 50.
constexpr int kPriority = 40;

}  // namespace

Pacer::Pacer(double step) : step_(step), start_(Clock::now()) {}

void Pacer::wait() {
    ++frame_;
    const auto due =
        start_ + std::chrono::duration_cast<Clock::duration>(
                     std::chrono::duration<double>(static_cast<double>(frame_) * step_));
    const auto now = Clock::now();
    if (now <= due) {
        std::this_thread::sleep_until(due);
        return;
    }
    const double late = std::chrono::duration<double>(now - due).count();
    ++missed_;
    lateness_max_ = std::max(lateness_max_, late);
    if (late > kGiveUp) start_ += now - due;
}

std::string request_realtime(int threads) {
    std::string said;
    cpu_set_t allowed;
    CPU_ZERO(&allowed);
    if (sched_getaffinity(0, sizeof allowed, &allowed) == 0) {
        // Use the last processors: the first ones serve most interrupts.
        cpu_set_t mine;
        CPU_ZERO(&mine);
        int chosen_count = 0;
        for (int cpu = CPU_SETSIZE - 1; cpu >= 0 && chosen_count < threads; --cpu) {
            if (CPU_ISSET(cpu, &allowed)) {
                CPU_SET(cpu, &mine);
                ++chosen_count;
            }
        }
        said =
            sched_setaffinity(0, sizeof mine, &mine) == 0
                ? fmt::format("kept to {} processor{}", chosen_count, chosen_count == 1 ? "" : "s")
                : fmt::format("processors not chosen: {}", std::strerror(errno));
    }
    sched_param parameters{};
    parameters.sched_priority = kPriority;
    if (sched_setscheduler(0, SCHED_FIFO, &parameters) == 0)
        return said + fmt::format("; real-time scheduling (SCHED_FIFO, priority {})", kPriority);
    return said + fmt::format(
                      "; real-time scheduling not granted: {} (needs CAP_SYS_NICE or an "
                      "rtprio limit of at least {})",
                      std::strerror(errno), kPriority);
}

}  // namespace hawser::cli
