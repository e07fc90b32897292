// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file command.h
/// What a client asks for, as it goes to the thread that steps: of fixed size, so that neither
/// thread allocates or frees for the other (docs/live.md has the messages).

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
    fault,  ///< Of an exercise: begin it, or with value 0 end it.
    end,    ///< Of an exercise.
    left,   ///< The client has gone: what it held is let go.
};
/// The word that messages of the protocol have for a command.
[[nodiscard]] const char* to_string(CommandKind kind) noexcept;

/// A text of limited length in place.
template <std::size_t N>
class ShortText {
  public:
    static constexpr std::size_t kMost = N;
    /// @return false: it is too long, and nothing is taken.
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
    bool answer = true;     ///< Of several that came in one message only the last is answered.
    bool by_wire = false;   ///< Of drag, part, pick: `target_id` or `name` is a wire's …
    bool by_joint = false;  ///< … or a joint's; else a body's.
    bool by_name = false;
    std::uint32_t client = 0;
    std::int64_t id = kNoId;  ///< Of the message.
    std::int32_t target_id = -1;
    double value = 0.0;              ///< set, rate, step, seek, fault; s of drag, part, pick.
    double stiffness = 0.0;          ///< [N/m]
    std::array<double, 3> point{};   ///< In the body's frame [m].
    std::array<double, 3> target{};  ///< World frame [m].
    ShortText<160> name;             ///< Input, restore point, wire, fault.
    ShortText<40> role;              ///< Of whom it is.
};

/// What one message of a client is.
struct Request {
    bool hello = false;
    std::string token;  ///< Of hello.
    double version = 0.0;
    CommandKind kind = CommandKind::none;
    std::int64_t id = kNoId;
    std::vector<Command> commands;  ///< Several of `set`.
};

inline constexpr std::size_t kMostMessage = 16 * 1024;  ///< [bytes]
inline constexpr std::size_t kMostInputs = 64;          ///< Of one message.

/// Read a message. Nothing that it says makes it throw but std::bad_alloc.
/// @param reason  Why it is refused, in words. @return whether it is one.
[[nodiscard]] bool parse(std::string_view text, Request& out, std::string& reason);

}  // namespace hawser::live
