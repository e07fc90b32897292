// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file command.h
/// A client's command for the stepping thread. It has a fixed size, so that neither thread
/// allocates or frees memory for the other (docs/live.md lists the messages).

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hawser::live {

enum class CommandKind : std::uint8_t {
    none,
    set,
    pause,
    resume,
    step,
    rate,
    drag,
    release,
    part,
    save,
    restore,
    pick,
    seek,
    fault,   ///< Start a fault of an exercise, or end it if the value is 0.
    end,     ///< End an exercise.
    note,    ///< Write a remark into the time line.
    report,  ///< Send the report of an exercise.
    left,    ///< The client has disconnected: release its drags.
};
/// Return all messages of clients except hello, in the order of docs/live.md.
[[nodiscard]] std::vector<CommandKind> message_kinds();
/// Return the word for a command in messages of the protocol.
[[nodiscard]] const char* to_string(CommandKind kind) noexcept;

/// A text of limited length without heap memory.
template <std::size_t N>
class ShortText {
  public:
    static constexpr std::size_t kMaximum = N;
    /// Assign a text. @return false if the text is too long; the old text then remains.
    bool assign(std::string_view text) noexcept {
        if (text.size() > N) return false;
        size_ = static_cast<std::uint16_t>(text.size());
        for (std::size_t i = 0; i < text.size(); ++i) text_[i] = text[i];
        return true;
    }
    [[nodiscard]] std::string_view view() const noexcept { return {text_.data(), size_}; }

  private:
    std::array<char, N> text_{};
    std::uint16_t size_ = 0;
};

inline constexpr std::int64_t kNoId = -1;

struct Command {
    CommandKind kind = CommandKind::none;
    bool answer = true;  ///< True if the command gets an answer. If a message has several commands,
                         ///< only the last one does.
    bool by_wire =
        false;  ///< True if `target_id` or `name` of drag, part, pick belongs to a wire …
    bool by_joint = false;  ///< … or to a joint; otherwise it belongs to a body.
    bool by_name = false;
    std::uint32_t client = 0;
    std::int64_t id = kNoId;  ///< Number of the message.
    std::int32_t target_id = -1;
    double value = 0.0;              ///< set, rate, step, seek, fault; s of drag, part, pick.
    double stiffness = 0.0;          ///< Stiffness [N/m].
    std::array<double, 3> point{};   ///< In the body's frame [m].
    std::array<double, 3> target{};  ///< World frame [m].
    ShortText<160> name;             ///< Input, restore point, wire, fault, note, people.
    ShortText<40> role;              ///< Role of the sender.
};

/// Contents of one message of a client.
struct Request {
    bool hello = false;
    std::string token;  ///< Token of hello.
    double version = 0.0;
    CommandKind kind = CommandKind::none;
    std::int64_t id = kNoId;
    std::vector<Command> commands;  ///< Several of `set`.
};

inline constexpr std::size_t kMaxMessage = 16 * 1024;  ///< Largest message [bytes].
inline constexpr std::size_t kMaxInputs = 64;          ///< Largest number of inputs in one message.

/// Read a message. No content of the message makes this throw, except std::bad_alloc. @param reason
/// Set to the reason of a rejection, in words. @return true if the message is valid.
[[nodiscard]] bool parse(std::string_view text, Request& out, std::string& reason);

}  // namespace hawser::live
