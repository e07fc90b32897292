// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file png.h
/// Writes pictures to files.

#include "draw/drawing.h"
#include "draw/raster.h"

#include <filesystem>
#include <string>
#include <vector>

namespace hawser::draw {

/// @throws std::runtime_error naming the file when it cannot be written.
void write_png(const Image& image, const std::filesystem::path& file, const Drawing& about);

/// Write `base`.svg and `base`.png. Missing folders are made. @param scale  Pixels a point.
/// @return Both files. @throws std::runtime_error naming the file when it cannot be written.
std::vector<std::filesystem::path> write_pictures(const Drawing& drawing,
                                                  const std::filesystem::path& base,
                                                  double scale = 2.0);

}  // namespace hawser::draw
