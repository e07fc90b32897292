// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file plots.h
/// Declare the pictures of a recording.

#include <hawser/recording.h>
#include "draw/drawing.h"
#include "record/series.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace hawser::draw {

/// Plot the tension of the cables over time. A line shows the tension at the first end, and a band
/// the range over the elements. Cables of very different tension have separate panels.
/// @return no value if the scene has no cables or the recording no frames.
[[nodiscard]] std::optional<Drawing> plot_tensions(const record::Recording& recording,
                                                   const record::Series& series);

/// Plot the tension along the plotted cables and the pieces cut off them, one panel each, at most
/// six. Each panel shows least, mean and greatest over the frames, and the tension of one frame.
/// The axis is the length along the wire if its number of nodes varies, else the unstretched
/// length.
/// @return no value if there are no such cables.
[[nodiscard]] std::optional<Drawing> plot_wires(const record::Recording& recording,
                                                const record::Series& series,
                                                std::size_t frame_index);

/// Plot displacement and rotation of bodies over time, one panel for each direction.
[[nodiscard]] std::optional<Drawing> plot_motions(const record::Recording& recording,
                                                  const record::Series& series);

enum class Shown : std::uint8_t { side_and_top, side, top, space };

/// Options for a picture of the scene.
struct ViewOptions {
    Shown shown = Shown::side_and_top;
    /// Corners of the visible box [m], for equal axes in pictures of several frames. No value: the
    /// bounds of the scene.
    std::optional<std::pair<Vec3, Vec3>> box{};
    bool around = false;  ///< True: add a margin to the box, which is the bounds of the scene.
    double width = 0.0, height = 0.0;  ///< Size of the picture [points]; 0: automatic.
    double azimuth = -60.0;   ///< Azimuth of the viewer of a view in space, from x to y [deg].
    double elevation = 22.0;  ///< Elevation of the viewer above the horizontal, 5 to 85 [deg].
};

/// Plot one frame in side view and top view, in one of them, or in space (plot_space()). Bodies are
/// outlined boxes, and cables are lines coloured by tension. Still water and seabed are shown. The
/// first frame and the paths of the plotted bodies are grey.
[[nodiscard]] std::optional<Drawing> plot_views(const record::Recording& recording,
                                                const record::Series& series,
                                                std::size_t frame_index,
                                                const ViewOptions& options = {});

/// Plot one frame in space, in parallel projection with hidden lines: solids, wires coloured by
/// tension, broken ends, water with a scale, seabed.
[[nodiscard]] std::optional<Drawing> plot_space(const record::Recording& recording,
                                                const record::Series& series,
                                                std::size_t frame_index,
                                                const ViewOptions& options);

/// Return the corners of the visible part of some frames, for ViewOptions::box. @return no value if
/// nothing has a position.
[[nodiscard]] std::optional<std::pair<Vec3, Vec3>> shown_box(
    const record::Recording& recording, const std::vector<std::size_t>& frames);

/// Plot side views close to each of the plotted bodies that are small in the scene, at most four.
/// @return no value if there are none.
[[nodiscard]] std::optional<Drawing> plot_details(const record::Recording& recording,
                                                  std::size_t frame_index);

}  // namespace hawser::draw
