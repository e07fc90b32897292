// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file view_labels.h
/// Names of bodies and cables in views of a scene.

#include "draw/projection.h"

#include <string>

namespace hawser::draw {

/// Names next to what they name, where there is room: the plotted bodies, others large enough, the
/// plotted cables. A name that finds no room close by stands farther off on a thin line.
/// @param assembly What names begin with that the picture is about anyway, such as "ahts1/"; left
///                 out of the names.
void draw_names(Drawing& drawing, const Axes& axes, const View& view,
                const record::Recording& recording, const record::Frame& frame,
                const std::string& assembly = "");

/// Range of tension for the colours of one frame [N].
[[nodiscard]] Range tension_range(const record::Frame& frame);

}  // namespace hawser::draw
