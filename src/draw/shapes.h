// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file shapes.h
/// Draw the recorded outlines of collision shapes: solids, planes, ground.

#include "draw/projection.h"

namespace hawser::draw {

/// Add solids to the bounds of a picture; planes and grounds may be infinite and are not added.
void add_outlines_to_bounds(const record::Recording& recording, const record::Frame& frame,
                            Bounds& bounds);

/// Draw planes and grounds behind all other shapes, clipped to the panel's frame.
void draw_grounds(Drawing& drawing, const Axes& axes, const View& view,
                  const record::Recording& recording, const record::Frame& frame);
/// Draw silhouettes of solids.
void draw_solids(Drawing& drawing, const Axes& axes, const View& view,
                 const record::Recording& recording, const record::Frame& frame, bool ghost);

}  // namespace hawser::draw
