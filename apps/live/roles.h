// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file roles.h
/// Permissions of clients. A role is a set of permissions and a list of inputs, with a token as its
/// proof. A station of an exercise is a role without control and with its own inputs.

#include "live/command.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hawser::live {

struct Role {
    std::string name;         ///< At most 40 bytes; "instructor", "watcher", that of a station.
    bool control = false;     ///< Pause, step, rate, drag, part, save, restore.
    bool all_inputs = false;  ///< True: all inputs. False: those listed.
    std::vector<std::string> inputs{};
    std::string token{};  ///< 32 hexadecimal digits.
};

[[nodiscard]] Role instructor();
[[nodiscard]] Role watcher();

/// Return 128 bits of the kernel's randomness in hexadecimal digits. @throws std::runtime_error
[[nodiscard]] std::string make_token();

/// Return the role with this token; null: none. All tokens are compared completely, so that the
/// time does not depend on them.
[[nodiscard]] const Role* role_of(std::span<const Role> roles, std::string_view token) noexcept;

/// Return the reason why a role may not perform a command; "": it may. @param recording  True if a
/// recording is shown, in which all roles may seek.
[[nodiscard]] std::string rejection_reason(const Role& role, const Command& command,
                                           bool recording);

/// Return the text of a role, as in the message `scene`.
[[nodiscard]] std::string role_text(const Role& role);

}  // namespace hawser::live
