// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file cuts.h
/// Splits: interactions between parts that each part solves for on its own.
///
/// A cut interaction is left out of the system. In its place stand *copies*, one for each side: the
/// same rows, in which the bodies of the other sides are *images*, bodies without freedom that are
/// where those bodies are and move at a velocity v̄ that a predictor gives.
/// ```
///    a ── b ══ c ── d          a ── b ══ c̄      b̄ ══ c ── d
///       cut: ══                one island        another one
/// ```
/// So a matrix of independent parts comes about without code of its own in the analysis, the
/// factorisation, the friction solver or the schedule. After the solve a cut has as many
/// multipliers as sides; readers see their mean. docs/methods.md, 10 has the theory.
///
/// Images and copies stand behind all other bodies and interactions: the model of the user is the
/// front of the arrays.

#include <hawser/def.h>

#include "context/context.h"

#include <cstdint>

namespace hawser::stepper {

/// Make images and copies for the groups and couplings there are. @throws std::bad_alloc.
void make_cuts(Model& model);
/// Take all images and copies away: the model is whole again.
void drop_cuts(Model& model);

/// Which cuts are in force: those whose sides hold to each other in no other way. Contacts and what
/// cannot be cut make two groups one part. To be called before the system is analysed.
/// @return whether others are than before.
bool open_cuts(Model& model);

}  // namespace hawser::stepper
