// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file matrix.h
/// Draw a spy diagram: the nonzero scalars of a matrix, and the fill of its elimination.

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
    bool fill = true;  ///< True: show fill together with the matrix.
};

/// Draw both triangles in elimination order. Consecutive nodes of one part are framed in the colour
/// of the part. Bodies and rows have shades of their own if fill is not shown.
[[nodiscard]] Drawing draw_matrix(const BlockGraph& graph, std::span<const std::int32_t> order,
                                  const FactorBlocks& factor, const MatrixPicture& picture);

/// Return the colour of a part; colours repeat beyond the palette.
[[nodiscard]] Color part_color(std::int32_t part);

}  // namespace hawser::draw
