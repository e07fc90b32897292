// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file outbox.h
/// Text messages of the thread that steps, to all clients or one (docs/live.md).

#include "live/hub.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <optional>
#include <string>

namespace hawser::live {

using Json = nlohmann::json;

/// What stays to be told until it has been: the newest of its kind counts.
class Outbox {
  public:
    explicit Outbox(Hub& hub) noexcept : hub_(hub) {}

    /// Where there is no room they are left out and counted: a client that is told nothing of a
    /// few events still shows the right picture.
    /// @param control  Only roles with control are told.
    void event(double time, const std::string& kind, const std::string& name, double value,
               const std::string& words, bool control = false);
    /// What a client did, for all of them.
    void command(double time, const Command& of, const std::string& words, bool control = false);
    void answer(const Command& to);  ///< `ok`, where the message had an id.
    void refuse(const Command& to, const std::string& reason);
    void send(std::uint32_t client, const Json& message);

    void scene(std::string text) { scene_ = std::move(text); }
    void state(const Json& message);
    void timeline(const Json& message);
    void exercise(const Json& message);
    void faults(const Json& message);
    /// Try again what found no room. @return whether clients have the newest scene.
    bool flush();

  private:
    bool post(MessageKind kind, std::uint32_t to, std::string text, bool control = false);

    Hub& hub_;
    std::optional<std::string> scene_, state_, timeline_, exercise_, faults_;
    std::string told_faults_;
};

}  // namespace hawser::live
