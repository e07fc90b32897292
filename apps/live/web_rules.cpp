// SPDX-License-Identifier: Apache-2.0
#include "live/web_rules.h"

#include <algorithm>
#include <cctype>

namespace hawser::live {
namespace {

std::string lower_case(std::string_view text) {
    std::string out(text);
    std::transform(out.begin(), out.end(), out.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return out;
}

bool is_number(std::string_view host) {
    if (host.starts_with('[') && host.ends_with(']'))
        return host.find_first_not_of("0123456789abcdef:.", 1) == host.size() - 1;
    return !host.empty() && host.find_first_not_of("0123456789.") == std::string_view::npos;
}

}  // namespace

HostNames host_names(const std::string& address, std::uint16_t port, const std::string& host_name) {
    HostNames out{.names = {}, .any_number = address == "0.0.0.0" || address == "::", .port = port};
    std::vector<std::string> hosts{"127.0.0.1", "localhost", "[::1]"};
    const bool loopback = address == "127.0.0.1" || address == "::1" || address == "localhost";
    if (!loopback) {
        if (!out.any_number)
            hosts.push_back(address.find(':') == std::string::npos ? address : "[" + address + "]");
        if (!host_name.empty()) hosts.push_back(host_name);
    }
    constexpr std::uint16_t kUsualPort = 80;  // browsers omit this port
    for (const std::string& host : hosts) {
        out.names.push_back(lower_case(host) + ":" + std::to_string(port));
        if (port == kUsualPort) out.names.push_back(lower_case(host));
    }
    return out;
}

bool host_allowed(const HostNames& names, std::string_view host) {
    const std::string lower_host = lower_case(host);
    if (std::find(names.names.begin(), names.names.end(), lower_host) != names.names.end())
        return true;
    const std::string port = ":" + std::to_string(names.port);
    return names.any_number && lower_host.ends_with(port) &&
           is_number(std::string_view(lower_host).substr(0, lower_host.size() - port.size()));
}

bool origin_allowed(std::string_view origin, std::string_view host) {
    return origin.empty() || lower_case(origin) == "http://" + lower_case(host);
}

const PageFile* file_at(std::string_view target) {
    const std::string_view path = target.substr(0, target.find('?'));
    for (const PageFile& file : page_files())
        if (file.path == path) return &file;
    return nullptr;
}

bool is_compressed(const PageFile& file) noexcept {
    return file.gzip.size() > 2 && file.gzip[0] == 0x1f && file.gzip[1] == 0x8b;
}

std::vector<std::pair<std::string, std::string>> safe_headers(std::string_view host) {
    const std::string policy =
        "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' "
        "data: blob:; font-src 'self'; connect-src 'self' ws://" +
        std::string(host) +
        "; worker-src 'self' blob:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";
    return {{"Content-Security-Policy", policy},
            {"X-Content-Type-Options", "nosniff"},
            {"Referrer-Policy", "no-referrer"},
            {"Cache-Control", "no-cache"},
            {"Cross-Origin-Resource-Policy", "same-origin"},
            {"Cross-Origin-Opener-Policy", "same-origin"}};
}

}  // namespace hawser::live
