// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file epa.h
/// Normal of least penetration of two overlapping convex cores: the expanding polytope of G. van
/// den Bergen ("Proximity queries and penetration depth computation on 3D game objects", GDC
/// 2001) in the difference of the two.

#include "collide/narrow/convex.h"

namespace hawser::collide::narrow {

/// Unit normal from a to b of (nearly) least penetration. Exact but for rounding where both are
/// polytopes; on curved cores the depth is within 1e-9 of the size, or what 160 corners give.
/// At least one core must have a volume.
V3 epa(const Convex& a, const Convex& b);

}  // namespace hawser::collide::narrow
