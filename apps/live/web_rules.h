// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file web_rules.h
/// Check requests before they are answered, and add headers to every answer.
///
/// A page of another site, open in the same browser, can send requests to this machine. The name of
/// its site then is in `Origin`. If it lets its own name point at 127.0.0.1 (DNS rebinding), that
/// name is in `Host`. Both must therefore be names of this server.

#include "live/page_files.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hawser::live {

/// Names of a server that requests may use.
struct HostNames {
    std::vector<std::string> names;  ///< Names with port, in lower case.
    bool any_number = false;         ///< Accept also any numeric address, with the port …
    std::uint16_t port = 0;          ///< … this.
};
/// Return the names of the server. @param address  Address of the listener. @param host_name  Name
/// of the machine.
[[nodiscard]] HostNames host_names(const std::string& address, std::uint16_t port,
                                   const std::string& host_name);
[[nodiscard]] bool host_allowed(const HostNames& names, std::string_view host);
/// True if the server accepts a request from this origin.
/// @param origin  Empty: the client is not a browser. Every client also needs a token.
[[nodiscard]] bool origin_allowed(std::string_view origin, std::string_view host);

/// Return the file of the page at a target; null: none. Other files are never searched.
[[nodiscard]] const PageFile* file_at(std::string_view target);
[[nodiscard]] bool is_compressed(const PageFile& file) noexcept;

/// Return the headers of every answer. @param host  Requested host, accepted by host_allowed().
[[nodiscard]] std::vector<std::pair<std::string, std::string>> safe_headers(std::string_view host);

}  // namespace hawser::live
