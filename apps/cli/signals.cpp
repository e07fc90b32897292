// SPDX-License-Identifier: Apache-2.0
#include "signals.h"

#include <hawser/world.h>

#include <atomic>
#include <csignal>

namespace hawser::cli {

namespace {

volatile std::sig_atomic_t g_stop = 0;
std::atomic<World*> g_world{nullptr};
static_assert(std::atomic<World*>::is_always_lock_free);

extern "C" void on_signal(int) {
    g_stop = 1;
    if (World* const world = g_world.load(); world != nullptr) world->cancel();
}

}  // namespace

void catch_signals() noexcept {
    struct sigaction action{};
    action.sa_handler = on_signal;
    sigemptyset(&action.sa_mask);
    // The default action returns after the first signal: a second Ctrl-C always works.
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

bool stop_requested() noexcept { return g_stop != 0; }

CancelledBySignal::CancelledBySignal(World& world) noexcept { g_world = &world; }

// A handler that read the pointer earlier has finished: worker threads block signals
// (runtime/tasks.cpp), so it ran on this thread.
CancelledBySignal::~CancelledBySignal() { g_world = nullptr; }

}  // namespace hawser::cli
