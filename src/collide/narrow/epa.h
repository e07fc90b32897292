// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file epa.h
/// Normal of least penetration of two overlapping convex cores, by the expanding polytope in their
/// difference. Source: G. van den Bergen, "Proximity queries and penetration depth computation on
/// 3D game objects", GDC 2001.

#include "collide/narrow/convex.h"

namespace hawser::collide::narrow {

/// Return the unit normal from a to b of (nearly) least penetration. If both cores are polytopes,
/// it is exact up to rounding. On curved cores the depth is within 1e-9 of the size, or as accurate
/// as 160 corners permit. At least one core must have a volume.
V3 epa(const Convex& a, const Convex& b);

}  // namespace hawser::collide::narrow
