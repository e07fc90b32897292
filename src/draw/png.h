// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file png.h
/// Write pictures to files.

#include "draw/drawing.h"
#include "draw/raster.h"

#include <filesystem>
#include <string>
#include <vector>

namespace hawser::draw {

/// Write a PNG file. @throws std::runtime_error with the name of the file if it cannot be written.
void write_png(const Image& image, const std::filesystem::path& file, const Drawing& about);

/// Write `base`.svg and `base`.png. Missing folders are created. @param scale  Pixels per point.
/// @return both files. @throws std::runtime_error with the name of the file if it cannot be
/// written.
std::vector<std::filesystem::path> write_pictures(const Drawing& drawing,
                                                  const std::filesystem::path& base,
                                                  double scale = 2.0);

}  // namespace hawser::draw
