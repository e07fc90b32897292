// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file along.h
/// Compute the tension along wires over the frames of a recording.

#include <hawser/recording.h>
#include "record/series.h"

#include <cstddef>
#include <string>
#include <vector>

namespace hawser::draw {

/// Tension along one wire, or along a piece that was cut off one.
struct Along {
    std::string name;
    /// Index in Recording::cables; for a piece, of the cable that it was cut off.
    std::size_t cable = 0;
    /// True: the number of nodes varies. Positions are then lengths along the wire from its first
    /// end in each frame, straight between nodes; a broken element has length 0. False: positions
    /// are unstretched lengths of elements of equal length.
    bool changes = false;
    double length = 0.0;    ///< Greatest length in any frame [m].
    std::vector<double> s;  ///< Positions [m].
    /// Least, mean and greatest tension over the frames at each position [N].
    std::vector<double> least, mean, greatest;
    /// Midpoints of elements in the frame that is drawn [m]; their tensions [N].
    std::vector<double> elements, tensions;
    /// Midpoints of broken elements in that frame, if `changes` is true [m].
    std::vector<double> parted;
};

/// Return the tension along the plotted cables and their pieces that exist in some frame, at most
/// `most`. The frame before the first step has no tensions. @param drawn  Index of the frame that
/// is drawn.
[[nodiscard]] std::vector<Along> tensions_along(const record::Recording& recording,
                                                const record::Series& series, std::size_t most,
                                                std::size_t drawn);

}  // namespace hawser::draw
