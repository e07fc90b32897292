// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file server_options.h
/// Options of a server (server.h), and its counters.

#include "live/roles.h"

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace hawser::live {

/// The server cannot start: an invalid address, or a port that is in use.
struct ServerError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct ServerOptions {
    std::string address = "127.0.0.1";
    std::uint16_t port = 8080;  ///< Port; 0: any free port.
    int clients = 16;           ///< Largest number of clients.
    std::vector<Role> roles{};
    bool recording = false;          ///< True if a recording is shown.
    double slow_seconds = 10.0;      ///< Time within which a client must read data [s].
    double handshake_seconds = 5.0;  ///< Time within which a request, and a hello, must arrive [s].
    /// Called with one line for each rejected request, at most 20 in 10 s. Runs in the server's
    /// thread.
    std::function<void(const std::string&)> log{};
};

/// Figures of a server, for tests and `hawser bench view`.
struct ServerFigures {
    std::int64_t frames_sent = 0, frames_left_out = 0, refused = 0, dropped = 0;
};

}  // namespace hawser::live
