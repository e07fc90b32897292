// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file along.h
/// Tension along wires over the frames of a recording.

#include <hawser/recording.h>
#include "record/series.h"

#include <cstddef>
#include <string>
#include <vector>

namespace hawser::draw {

/// Of one wire, or of a piece that was cut off one.
struct Along {
    std::string name;
    std::size_t cable = 0;  ///< Index in Recording::cables; of a piece that which it was cut off.
    /// Nodes come and go: places are lengths along the wire from its first end, as it lies in each
    /// frame, straight between nodes; what has parted has none. Else they are unstretched lengths,
    /// of elements of equal length.
    bool changes = false;
    double length = 0.0;                        ///< Greatest of the frames [m].
    std::vector<double> s;                      ///< Places [m], and there over the frames …
    std::vector<double> least, mean, greatest;  ///< … tensions [N].
    std::vector<double> elements, tensions;     ///< Middles [m] in the frame that is drawn; [N].
    std::vector<double> parted;                 ///< Middles of those in it, if `changes` [m].
};

/// Of the plotted cables and their pieces that are there in some frame, at most `most`. Before the
/// first step no tension is known. @param drawn  Which frame is.
[[nodiscard]] std::vector<Along> tensions_along(const record::Recording& recording,
                                                const record::Series& series, std::size_t most,
                                                std::size_t drawn);

}  // namespace hawser::draw
