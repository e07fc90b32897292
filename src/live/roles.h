// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file roles.h
/// Who may do what. A role is a set of permissions and a list of inputs, with a token that proves
/// it: a station of an exercise is a role without control and with its own inputs.

#include "live/command.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hawser::live {

struct Role {
    std::string name;         ///< At most 40 bytes; "instructor", "watcher", that of a station.
    bool control = false;     ///< Pause, step, rate, drag, part, save, restore.
    bool all_inputs = false;  ///< Else those listed.
    std::vector<std::string> inputs{};
    std::string token{};  ///< 32 hexadecimal digits.
};

[[nodiscard]] Role instructor();
[[nodiscard]] Role watcher();

/// 128 bits of the kernel's randomness in hexadecimal digits. @throws std::runtime_error
[[nodiscard]] std::string make_token();

/// The role whose token it is; null: none. All tokens are looked at whole, so that the time tells
/// nothing about them.
[[nodiscard]] const Role* role_of(std::span<const Role> roles, std::string_view token) noexcept;

/// Why a role may not do this; "": it may. @param recording  Whether a recording is shown, through
/// which everybody may seek.
[[nodiscard]] std::string forbidden(const Role& role, const Command& command, bool recording);

/// As in the message `scene`.
[[nodiscard]] std::string role_text(const Role& role);

}  // namespace hawser::live
