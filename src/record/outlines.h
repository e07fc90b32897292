// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file outlines.h
/// Outlines of shapes with contact, for pictures: solids, planes, ground.

#include <hawser/recording.h>
#include "record/bytes.h"
#include "record/scene_info.h"

namespace hawser::record {

inline constexpr int kOutlineRim = 24;  ///< Number of points of the outline of a round shape.

/// Return the outlines of all shapes except those along cables, which are drawn as lines. Round
/// shapes become points with a radius or rims of 24 points; large grounds and meshes are thinned.
[[nodiscard]] std::vector<RecordedOutline> make_outlines(const SceneInfo& scene,
                                                         const World& world);

void write_outlines(ByteWriter& out, const std::vector<RecordedOutline>& outlines);
/// Read outlines. @throws BadBytes.
[[nodiscard]] std::vector<RecordedOutline> get_outlines(ByteReader& in, std::size_t bodies);

}  // namespace hawser::record
