// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file point.h
/// Define positions in a picture: x to the right, y downwards, in points of 1/96 inch.

namespace hawser::draw {

struct Point {
    double x = 0.0, y = 0.0;
};

struct Box {
    double x = 0.0, y = 0.0, width = 0.0, height = 0.0;
    [[nodiscard]] double right() const noexcept { return x + width; }
    [[nodiscard]] double bottom() const noexcept { return y + height; }
};

}  // namespace hawser::draw
