// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file shares.h
/// Times of the parts of our solution and update. Also the fraction of a solution that is code
/// which every solver of the comparison runs.

#include "linear/problem.h"

namespace hawser::bench {

/// Condense, factor, solve and refine a system `rounds` times. For the scene of the paper, follow
/// as many steps with 50 contacts changed in each. Print medians of every part. One thread,
/// condensed form, wall time.
void print_shares(const ProblemSource& source, int rounds);

}  // namespace hawser::bench
