// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file server.h
/// Serve the page and the socket /live (docs/live.md) from one thread of lower priority.
///
/// ```
///     accept ─► request ─┬─► file of the page, 403, 404, 405
///                        └─► /live: Host, Origin ─► hello with a token ─► scene, state, frames
/// ```
/// For each client one frame is being sent and the newest one waits; text has priority. A client
/// that reads nothing for `slow_seconds`, or breaks the rules three times, is disconnected. Clients
/// affect the stepping thread only by commands in a queue.

#include "live/hub.h"
#include "live/server_options.h"

#include <cstdint>
#include <memory>
#include <string>

namespace hawser::live {

class Server {
  public:
    /// Start to listen, and start the server's thread. @throws ServerError
    Server(Hub& hub, ServerOptions options);
    /// Close all connections and wait for the thread.
    ~Server();
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;

    [[nodiscard]] std::uint16_t port() const noexcept;
    /// Return the start address of a role: "http://127.0.0.1:8080/#token=…".
    [[nodiscard]] std::string address_of(const Role& role) const;
    /// Return the numbers of frames sent and omitted, and of clients rejected and dropped, since
    /// the start. May be called from any thread.
    [[nodiscard]] ServerFigures figures() const noexcept;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace hawser::live
