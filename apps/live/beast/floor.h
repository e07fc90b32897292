// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file floor.h
/// Shared data of the parts of the server: options, clients, broadcasts, the log. Only server.cpp
/// includes this folder, because Boost.Beast takes ten seconds to compile.

#include "live/hub.h"
#include "live/server_options.h"
#include "live/web_rules.h"

#include <utility>  // Asio 1.74 uses std::exchange without it

#include <boost/asio.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

#include <algorithm>
#include <atomic>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <string>
#include <string_view>

namespace hawser::live::net {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using Tcp = asio::ip::tcp;
using Error = beast::error_code;
using Text = std::shared_ptr<const std::string>;
using Frame = std::shared_ptr<const Bytes>;

[[nodiscard]] inline std::string_view view_of(beast::string_view text) {
    return {text.data(), text.size()};
}

class Client;

/// A connection that is neither answered nor a client yet.
struct OpenConnection {
    std::string address{};         ///< Address without port.
    std::function<void()> drop{};  ///< Closes the connection and removes it from the list.
};

/// Services of the server for its connections.
class Floor {
  public:
    Floor(Hub& hub, ServerOptions options) : hub_(hub), options_(std::move(options)) {}
    virtual ~Floor() = default;

    Hub& hub_;
    const ServerOptions options_;
    HostNames names_;
    std::map<std::uint32_t, std::shared_ptr<Client>> clients_;
    std::list<OpenConnection> connections_;  ///< Connections, oldest first.
    Text scene_, state_, timeline_, exercise_, faults_;
    Frame newest_;
    std::atomic<std::int64_t> sent_{0}, frames_skipped_{0}, rejected_{0}, dropped_{0};

    /// Write one line to the log. If too many lines follow each other, only count them.
    void log(const std::string& line) {
        constexpr int kMaxLines = 20;
        constexpr double kLogInterval = 10.0;  // Interval for counting lines [s].
        const double now = clock_now();
        if (now - log_since_ > kLogInterval) {
            if (lines_omitted_ > 0 && options_.log)
                options_.log("and " + std::to_string(lines_omitted_) + " more refusals");
            log_since_ = now;
            lines_ = lines_omitted_ = 0;
        }
        if (++lines_ > kMaxLines)
            ++lines_omitted_;
        else if (options_.log)
            options_.log(line);
    }
    void record_rejection(const std::string& line) {
        rejected_.fetch_add(1, std::memory_order_relaxed);
        log("refused: " + line);
    }
    /// True if one more client with this role may connect. A role with control has one additional
    /// slot, so that the instructor can always connect.
    [[nodiscard]] bool has_free_slot(const Role& role) const {
        const int kept = role.control ? 1 : 0;
        return hub_.clients.load(std::memory_order_relaxed) < options_.clients + kept;
    }
    /// Close the oldest connection of the address with the most connections, so that one address
    /// cannot block others.
    void free_connection_slot() {
        std::map<std::string, int> by_address;
        int most = 0;
        for (const OpenConnection& one : connections_)
            most = std::max(most, ++by_address[one.address]);
        for (const OpenConnection& one : connections_) {
            if (by_address[one.address] < most) continue;
            record_rejection("a connection of " + one.address +
                             ": too many are open; its oldest is closed");
            const std::function<void()> drop = one.drop;
            return drop();
        }
    }
    virtual void client_left(std::uint32_t number) = 0;
    virtual std::uint32_t next_number() = 0;

  private:
    double log_since_ = -1e9;
    int lines_ = 0, lines_omitted_ = 0;
};

}  // namespace hawser::live::net
