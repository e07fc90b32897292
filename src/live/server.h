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
#include "live/server_options.h"

#include <cstdint>
#include <memory>
#include <string>

namespace hawser::live {

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
    /// Frames sent and left out, clients refused and dropped so far. From any thread.
    [[nodiscard]] ServerFigures figures() const noexcept;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace hawser::live
