// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file matrix.h
/// A spy diagram: which scalars of a matrix are not zero, and which only the elimination makes.

#include "draw/drawing.h"
#include "draw/figures/block_graph.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace hawser::draw {

struct MatrixPicture {
    std::string title;
    std::vector<std::string> notes;
    bool fill = true;  ///< Show fill beside the matrix.
};

/// Both triangles, in elimination order. Nodes of one part that follow each other are framed in
/// the colour of the part. Bodies and rows have shades of their own where no fill is shown.
[[nodiscard]] Drawing draw_matrix(const BlockGraph& graph, std::span<const std::int32_t> order,
                                  const FactorBlocks& factor, const MatrixPicture& picture);

/// Of a part; parts beyond the palette repeat colours.
[[nodiscard]] Color part_color(std::int32_t part);

}  // namespace hawser::draw
