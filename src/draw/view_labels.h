// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file view_labels.h
/// Draw names of bodies and cables in views of a scene.

#include "draw/projection.h"

#include <string>

namespace hawser::draw {

/// Draw names next to their objects: the plotted bodies, other large bodies, the plotted cables. A
/// name without space nearby is placed farther away, with a thin line to its object.
/// @param assembly  Prefix of names to omit because it is the subject of the picture, such as
/// "ahts1/".
void draw_names(Drawing& drawing, const Axes& axes, const View& view,
                const record::Recording& recording, const record::Frame& frame,
                const std::string& assembly = "");

/// Return the range of tension for the colours of one frame [N].
[[nodiscard]] Range tension_range(const record::Frame& frame);

}  // namespace hawser::draw
