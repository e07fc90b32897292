// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file number.h
/// Numbers as text for messages.

#include <cstdio>
#include <string>

namespace hawser {

/// Format a number with six digits, such as "0.25", "1e+06".
[[nodiscard]] inline std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value + 0.0);  // converts −0 to 0
    return text;
}

}  // namespace hawser
