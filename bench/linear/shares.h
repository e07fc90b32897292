// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file shares.h
/// What the parts of our solution and of our update take, and how much of a solution is code that
/// every solver of the comparison runs.

#include "linear/problem.h"

namespace hawser::bench {

/// Condense, factor, solve and refine a system `rounds` times, and, where it is the paper's scene,
/// follow it through as many steps with 50 contacts changed each; print medians of every part. One
/// thread, condensed form, wall time.
void print_shares(const ProblemSource& source, int rounds);

}  // namespace hawser::bench
