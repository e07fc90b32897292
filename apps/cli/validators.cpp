// SPDX-License-Identifier: Apache-2.0
#include "commands.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

namespace hawser::cli {
namespace {

bool to_number(const std::string& text, double& value) {
    char* end = nullptr;
    value = std::strtod(text.c_str(), &end);
    return end != text.c_str() && *end == '\0' && std::isfinite(value);
}

/// Return the reason why `text` is no finite number ≥ 0 (or > 0); empty if it is one.
std::string number_fault(const std::string& text, bool zero_too) {
    double value = 0.0;
    if (to_number(text, value) && (value > 0.0 || (zero_too && value == 0.0))) return {};
    return fmt::format("expected a number {}, found \"{}\"",
                       zero_too ? "of at least 0" : "greater than 0", text);
}

}  // namespace

CLI::Validator positive() {
    return {[](const std::string& text) { return number_fault(text, false); }, "> 0"};
}

CLI::Validator not_negative() {
    return {[](const std::string& text) { return number_fault(text, true); }, ">= 0"};
}

CLI::Validator finite() {
    return {[](const std::string& text) {
                double value = 0.0;
                return to_number(text, value)
                           ? std::string()
                           : fmt::format("expected a finite number, found \"{}\"", text);
            },
            "FINITE"};
}

}  // namespace hawser::cli
