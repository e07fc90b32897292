// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file plots.h
/// Pictures of a recording.

#include <hawser/recording.h>
#include "draw/drawing.h"
#include "record/series.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace hawser::draw {

/// Tension of the cables over time: the first end's as a line, the spread over the cable's
/// elements as a band. Cables of very different tension get panels of their own.
/// @return Nothing when the scene has no cables or the recording no frames.
[[nodiscard]] std::optional<Drawing> plot_tensions(const record::Recording& recording,
                                                   const record::Series& series);

/// Tension along the plotted cables and the pieces that were cut off them (up to six), a panel
/// each: least, mean and greatest of the frames, and that of one frame, over the length along the
/// wire as it lies where nodes come and go, else over the unstretched length. @return Nothing when
/// there are none.
[[nodiscard]] std::optional<Drawing> plot_wires(const record::Recording& recording,
                                                const record::Series& series,
                                                std::size_t frame_index);

/// Displacement and rotation of bodies over time, one panel per direction.
[[nodiscard]] std::optional<Drawing> plot_motions(const record::Recording& recording,
                                                  const record::Series& series);

enum class Shown : std::uint8_t { side_and_top, side, top, space };

/// How a picture of the scene is taken.
struct ViewOptions {
    Shown shown = Shown::side_and_top;
    /// Corners of what is shown [m]: pictures of several frames have the same axes. None: what
    /// there is.
    std::optional<std::pair<Vec3, Vec3>> box{};
    bool around = false;  ///< A little around the box, too: it is that of what there is.
    double width = 0.0, height = 0.0;  ///< [points]; 0: as it fits.
    double azimuth = -60.0;            ///< Of a view in space: of the viewer, from x to y [deg] …
    double elevation = 22.0;           ///< … and above the level, 5 to 85 [deg].
};

/// Side view and top view of one frame, or one of them: bodies as outlined boxes, cables as lines
/// coloured by tension, still water and seabed; the first frame and the paths of the plotted bodies
/// in grey. Or all of it in space (plot_space()).
[[nodiscard]] std::optional<Drawing> plot_views(const record::Recording& recording,
                                                const record::Series& series,
                                                std::size_t frame_index,
                                                const ViewOptions& options = {});

/// One frame in space, in parallel projection with hidden lines: solids, wires coloured by tension,
/// ends that have parted, water with a scale, seabed.
[[nodiscard]] std::optional<Drawing> plot_space(const record::Recording& recording,
                                                const record::Series& series,
                                                std::size_t frame_index,
                                                const ViewOptions& options);

/// Corners of what some frames show, for ViewOptions::box. @return nothing where nothing has a
/// place.
[[nodiscard]] std::optional<std::pair<Vec3, Vec3>> shown_box(
    const record::Recording& recording, const std::vector<std::size_t>& frames);

/// Side views close to each of the plotted bodies (up to four) that are small in the scene.
/// @return Nothing when there are none.
[[nodiscard]] std::optional<Drawing> plot_details(const record::Recording& recording,
                                                  std::size_t frame_index);

}  // namespace hawser::draw
