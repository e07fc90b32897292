// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file shapes.h
/// Draws the recorded outlines of shapes that touch: solids, planes, ground.

#include "draw/projection.h"

namespace hawser::draw {

/// Solids widen a picture; planes and grounds, which may be endless, do not.
void add_outlines_to_bounds(const record::Recording& recording, const record::Frame& frame,
                            Bounds& bounds);

/// Planes and grounds, behind everything, cut at the panel's frame.
void draw_grounds(Drawing& drawing, const Axes& axes, const View& view,
                  const record::Recording& recording, const record::Frame& frame);
/// Silhouettes of solids.
void draw_solids(Drawing& drawing, const Axes& axes, const View& view,
                 const record::Recording& recording, const record::Frame& frame, bool ghost);

}  // namespace hawser::draw
