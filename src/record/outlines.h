// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file outlines.h
/// What pictures show of shapes that touch: solids, planes, ground.

#include <hawser/recording.h>
#include "record/bytes.h"
#include "record/scene_info.h"

namespace hawser::record {

inline constexpr int kOutlineRim = 24;  ///< Points around something round.

/// Of all shapes but those along cables, which are drawn as lines already. Round shapes become
/// points with a radius or rims of 24 points; large grounds and meshes are thinned.
[[nodiscard]] std::vector<RecordedOutline> outlines_of(const SceneInfo& scene, const World& world);

void put_outlines(ByteWriter& out, const std::vector<RecordedOutline>& outlines);
/// @throws BadBytes.
[[nodiscard]] std::vector<RecordedOutline> get_outlines(ByteReader& in, std::size_t bodies);

}  // namespace hawser::record
