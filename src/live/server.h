// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file server.h
/// Serves the page and the socket /live (docs/live.md) from one thread of lower priority.
///
/// ```
///     accept ─► request ─┬─► file of the page, 403, 404, 405
///                        └─► /live: Host, Origin ─► hello with a token ─► scene, state, frames
/// ```
/// For each client one frame is on its way and the newest one waits; text goes first. Who takes
/// nothing for `slow_seconds` is dropped, who breaks the rules three times, too. Whatever a client
/// does, the thread that steps notices nothing but commands in a queue.

#include "live/hub.h"
#include "live/roles.h"

#include <cstdint>
#include <functional>
#include <memory>
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

class Server {
  public:
    /// Listens and starts its thread. @throws ServerError
    Server(Hub& hub, ServerOptions options);
    /// Says goodbye to all clients and waits for its thread.
    ~Server();
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;

    [[nodiscard]] std::uint16_t port() const noexcept;
    /// Where a role begins: "http://127.0.0.1:8080/#token=…".
    [[nodiscard]] std::string address_of(const Role& role) const;
    /// From any thread.
    [[nodiscard]] ServerFigures figures() const noexcept;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace hawser::live
