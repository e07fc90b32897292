// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file view_labels.h
/// Names of bodies and cables in views of a scene.

#include "observe/projection.h"

namespace hawser::observe {

/// Names next to their bodies, where there is room: the plotted ones, and others large enough.
void draw_names(Drawing& drawing, const Axes& axes, const View& view, const Recording& recording,
                const Frame& frame);

/// Names of the plotted cables at their middle.
void draw_cable_names(Drawing& drawing, const Axes& axes, const View& view,
                      const Recording& recording, const Frame& frame);

/// Range of tension for the colours of one frame [N].
[[nodiscard]] Range tension_range(const Frame& frame);

}  // namespace hawser::observe
