// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file separate.h
/// Signed distance of any two convex cores, and its normal.

#include "collide/narrow/convex.h"
#include "collide/narrow/polish.h"

namespace hawser::collide::narrow {

/// The largest s(n). Cores further apart than `enough` [m]: some n with s(n) > enough.
Separation separate(const Convex& a, const Convex& b, double enough);

}  // namespace hawser::collide::narrow
