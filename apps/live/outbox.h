// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file outbox.h
/// Text messages from the stepping thread to all clients or one (docs/live.md).

#include "live/hub.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <optional>
#include <string>

namespace hawser::live {

using Json = nlohmann::json;

/// Keeps unsent messages until they are sent. Only the newest of each kind is kept.
class Outbox {
  public:
    explicit Outbox(Hub& hub) noexcept : hub_(hub) {}

    /// Send an event. If the queue is full, the event is omitted and counted: the state that a
    /// client shows does not depend on events. @param control  True: only for roles with control.
    void event(double time, const std::string& kind, const std::string& name, double value,
               const std::string& words, bool control = false);
    /// Report a client's command to all clients.
    void command(double time, const Command& of, const std::string& words, bool control = false);
    void answer(const Command& to);  ///< Send `ok` if the message had an id.
    void reject(const Command& to, const std::string& reason);
    void send(std::uint32_t client, const Json& message);
    /// Send a report (HTML), or an error if the report exceeds the queue of a client.
    void report(const Command& to, std::string html);

    void scene(std::string text) { scene_ = std::move(text); }
    void state(const Json& message);
    void timeline(const Json& message);
    void exercise(const Json& message);
    void faults(const Json& message);
    /// Try to send waiting messages again. @return true if the newest scene has been sent to the
    /// clients.
    bool flush();

  private:
    bool post(MessageKind kind, std::uint32_t to, std::string text, bool control = false);

    Hub& hub_;
    std::optional<std::string> scene_, state_, timeline_, exercise_, faults_;
    std::string reported_faults_;
};

}  // namespace hawser::live
