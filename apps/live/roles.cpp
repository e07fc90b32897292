// SPDX-License-Identifier: Apache-2.0
#include "live/roles.h"

#include <sys/random.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace hawser::live {
namespace {

constexpr std::size_t kTokenDigits = 32;

/// Compare tokens in constant time: no branch or index depends on their contents.
bool same_token(std::string_view a, std::string_view b) noexcept {
    if (a.size() != kTokenDigits || b.size() != kTokenDigits) return false;
    unsigned differ = 0;
    for (std::size_t i = 0; i < kTokenDigits; ++i)
        differ |= static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i]);
    return differ == 0;
}

}  // namespace

Role instructor() {
    return {.name = "instructor", .control = true, .all_inputs = true, .token = make_token()};
}

Role watcher() { return {.name = "watcher", .token = make_token()}; }

std::string make_token() {
    std::array<unsigned char, kTokenDigits / 2> bytes{};
    std::size_t have = 0;
    while (have < bytes.size()) {
        const auto got = getrandom(bytes.data() + have, bytes.size() - have, 0);
        if (got < 0 && errno != EINTR)
            throw std::runtime_error(std::string("no randomness for a token: ") +
                                     std::strerror(errno));
        if (got > 0) have += static_cast<std::size_t>(got);
    }
    constexpr char kDigits[] = "0123456789abcdef";
    std::string out;
    for (const unsigned char byte : bytes) {
        out += kDigits[byte >> 4];
        out += kDigits[byte & 15];
    }
    return out;
}

const Role* role_of(std::span<const Role> roles, std::string_view token) noexcept {
    const Role* found = nullptr;
    for (const Role& role : roles)
        if (same_token(role.token, token)) found = &role;
    return found;
}

std::string rejection_reason(const Role& role, const Command& command, bool recording) {
    switch (command.kind) {
        case CommandKind::set:
            if (recording) return "a recording has no levers";
            if (role.all_inputs) return {};
            if (std::find(role.inputs.begin(), role.inputs.end(), command.name.view()) !=
                role.inputs.end())
                return {};
            return "the role " + role.name + " does not have the input \"" +
                   std::string(command.name.view()) + "\"";
        case CommandKind::pick:
        case CommandKind::seek:
            return {};
        case CommandKind::pause:
        case CommandKind::resume:
        case CommandKind::step:
        case CommandKind::rate:
        case CommandKind::report:
            if (recording) return {};
            break;
        default:
            if (recording) return "a recording cannot be changed";
            break;
    }
    return role.control ? std::string()
                        : "the role " + role.name + " may not " + to_string(command.kind);
}

std::string role_text(const Role& role) {
    nlohmann::json out{{"name", role.name}, {"control", role.control}};
    if (role.all_inputs)
        out["inputs"] = "all";
    else
        out["inputs"] = role.inputs;
    return out.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace hawser::live
