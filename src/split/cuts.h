// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file cuts.h
/// Split the system: interactions between parts are solved by each part separately.
///
/// The system does not contain a cut interaction. One *copy* for each side replaces it. A copy has
/// the same rows, but the bodies of the other sides are *ghost bodies*. A
/// ghost body has no degrees of freedom. It has the pose of its original and moves at a velocity v̄
/// from a predictor.
/// ```
///    a ── b ══ c ── d          a ── b ══ c̄      b̄ ══ c ── d
///       cut: ══                one island        another one
/// ```
/// The matrix therefore falls into independent parts without special code in the analysis, the
/// factorisation, the friction solver or the schedule. After the solve a cut has as many
/// multipliers as sides; outputs contain their mean. For the theory see docs/theory/splits.md.
///
/// Ghost bodies and copies follow all other bodies and interactions: the model of the user is the
/// front of the arrays.

#include <hawser/def.h>

#include "context/context.h"

#include <cstdint>

namespace hawser::split {

/// Make ghost bodies and duplicated interactions for the present groups and couplings. @throws
/// std::bad_alloc.
void make_cuts(context::Model& model);
/// Remove all ghost bodies and duplicated interactions.
void remove_cuts(context::Model& model);

/// Determine the active cuts. A cut is active if nothing else connects its two sides; contacts and
/// interactions that cannot be cut unite two groups to one part. Call before the system is
/// analysed.
/// @return true if the set of cuts in force has changed.
bool open_cuts(context::Model& model);

}  // namespace hawser::split
