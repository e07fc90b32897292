// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file plots.h
/// Pictures of a recording.

#include <hawser/recording.h>
#include "draw/drawing.h"
#include "record/series.h"

#include <optional>

namespace hawser::draw {

/// Tension of the cables over time: the first end's as a line, the spread over the cable's
/// elements as a band. Cables of very different tension get panels of their own.
/// @return Nothing when the scene has no cables or the recording no frames.
[[nodiscard]] std::optional<Drawing> plot_tensions(const record::Recording& recording,
                                                   const record::Series& series);

/// Least, mean and greatest tension of the plotted cables (up to six) along them, a panel each.
/// @return Nothing when there are none.
[[nodiscard]] std::optional<Drawing> plot_wires(const record::Recording& recording,
                                                const record::Series& series);

/// Displacement and rotation of bodies over time, one panel per direction.
[[nodiscard]] std::optional<Drawing> plot_motions(const record::Recording& recording,
                                                  const record::Series& series);

/// Side view and top view of one frame: bodies as outlined boxes, cables as lines coloured by
/// tension; the first frame and the paths of the plotted bodies in grey.
[[nodiscard]] std::optional<Drawing> plot_views(const record::Recording& recording,
                                                const record::Series& series,
                                                std::size_t frame_index);

/// Side views close to each of the plotted bodies (up to four) that are small in the scene.
/// @return Nothing when there are none.
[[nodiscard]] std::optional<Drawing> plot_details(const record::Recording& recording,
                                                  std::size_t frame_index);

}  // namespace hawser::draw
