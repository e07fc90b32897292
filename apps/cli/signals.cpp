// SPDX-License-Identifier: Apache-2.0
#include "signals.h"

#include <csignal>

namespace hawser::cli {

namespace {

volatile std::sig_atomic_t g_stop = 0;

extern "C" void on_signal(int) { g_stop = 1; }

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

}  // namespace hawser::cli
