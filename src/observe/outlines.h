// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file outlines.h
/// What pictures show of shapes that touch: solids, planes, ground.

#include "observe/bytes.h"
#include "observe/projection.h"
#include "observe/recording.h"

namespace hawser::observe {

/// Of all shapes but those along cables, which are drawn as lines already. Round shapes become
/// points with a radius or rims of 24 points; large grounds and meshes are thinned.
[[nodiscard]] std::vector<RecordedOutline> outlines_of(const SceneInfo& scene, const World& world);

void put_outlines(ByteWriter& out, const std::vector<RecordedOutline>& outlines);
/// @throws BadBytes.
[[nodiscard]] std::vector<RecordedOutline> get_outlines(ByteReader& in, std::size_t bodies);

/// Solids widen a picture; planes and grounds, which may be endless, do not.
void add_outlines_to_bounds(const Recording& recording, const Frame& frame, Bounds& bounds);

/// Planes and grounds, behind everything, cut at the panel's frame.
void draw_grounds(Drawing& drawing, const Axes& axes, const View& view, const Recording& recording,
                  const Frame& frame);
/// Silhouettes of solids.
void draw_solids(Drawing& drawing, const Axes& axes, const View& view, const Recording& recording,
                 const Frame& frame, bool ghost);

}  // namespace hawser::observe
