// SPDX-License-Identifier: Apache-2.0
#include "commands.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

namespace hawser::cli {
namespace {

/// Why `text` is no finite number of at least (or above) zero; empty if it is one.
std::string fault(const std::string& text, bool zero_too) {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    const bool number = end != text.c_str() && *end == '\0' && std::isfinite(value);
    if (number && (value > 0.0 || (zero_too && value == 0.0))) return {};
    return fmt::format("expected a number {}, found \"{}\"",
                       zero_too ? "of at least 0" : "greater than 0", text);
}

}  // namespace

CLI::Validator positive() {
    return {[](const std::string& text) { return fault(text, false); }, "> 0"};
}

CLI::Validator not_negative() {
    return {[](const std::string& text) { return fault(text, true); }, ">= 0"};
}

}  // namespace hawser::cli
