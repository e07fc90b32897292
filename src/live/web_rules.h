// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file web_rules.h
/// What is asked of a request before anything is answered, and the headers of every answer.
///
/// A page of somebody else, open in the same browser, can send requests to this machine: its name
/// stands in `Origin`, and where it has its own name point at 127.0.0.1 (DNS rebinding) that name
/// stands in `Host`. Both are therefore to be ours.

#include "live/page_files.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hawser::live {

/// Names that a server answers to.
struct HostNames {
    std::vector<std::string> names;  ///< With port, in small letters.
    bool any_number = false;         ///< Also any address in numbers, with the port …
    std::uint16_t port = 0;          ///< … this.
};
/// @param address  That it listens at. @param host_name  Of the machine.
[[nodiscard]] HostNames host_names(const std::string& address, std::uint16_t port,
                                   const std::string& host_name);
[[nodiscard]] bool host_allowed(const HostNames& names, std::string_view host);
/// @param origin  Empty: the client is no browser, and has to know a token all the same.
[[nodiscard]] bool origin_allowed(std::string_view origin, std::string_view host);

/// The file of the page at a target; null: there is none. Nothing else is ever looked for.
[[nodiscard]] const PageFile* file_at(std::string_view target);
[[nodiscard]] bool is_compressed(const PageFile& file) noexcept;

/// Headers of every answer. @param host  That was asked for, after host_allowed().
[[nodiscard]] std::vector<std::pair<std::string, std::string>> safe_headers(std::string_view host);

}  // namespace hawser::live
