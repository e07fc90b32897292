// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file server_options.h
/// How a server begins (server.h), and what it counts.

#include "live/roles.h"

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace hawser::live {

/// The server cannot begin: an address that makes no sense, a port that is taken.
struct ServerError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct ServerOptions {
    std::string address = "127.0.0.1";
    std::uint16_t port = 8080;  ///< 0: any that is free.
    int clients = 16;           ///< At a time.
    std::vector<Role> roles{};
    bool recording = false;          ///< A recording is shown.
    double slow_seconds = 10.0;      ///< A client takes something within it [s].
    double handshake_seconds = 5.0;  ///< A request, and a hello, comes within it [s].
    /// Told what was refused, one line each, at most 20 in 10 s. From the server's thread.
    std::function<void(const std::string&)> log{};
};

/// Figures of a server, for tests and `hawser bench view`.
struct ServerFigures {
    std::int64_t frames_sent = 0, frames_left_out = 0, refused = 0, dropped = 0;
};

}  // namespace hawser::live
