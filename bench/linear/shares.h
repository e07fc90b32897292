// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file shares.h
/// Times of the parts of Hawser's solution and update, and the fraction of code shared by all
/// solvers of the comparison.

#include "linear/problem.h"

namespace hawser::bench {

/// Condense, factor, solve and refine a system `rounds` times. For the paper's scene, also follow
/// it for this number of steps with 50 contacts changed in each. Prints medians of every part. One
/// thread, condensed form, wall time.
void print_fractions(const ProblemSource& source, int rounds);

}  // namespace hawser::bench
