// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file separate.h
/// Signed distance of two convex cores, and its normal.

#include "collide/narrow/convex.h"
#include "collide/narrow/polish.h"

namespace hawser::collide::narrow {

/// Find the normal n with the largest separation s(n). If the cores are further apart than `enough`
/// [m], return any n with s(n) > enough.
Separation separate(const Convex& a, const Convex& b, double enough);

}  // namespace hawser::collide::narrow
