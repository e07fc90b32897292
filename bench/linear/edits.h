// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file edits.h
/// What contact changes cost: the repair of the analysis (factor/repair.h) through long sequences,
/// and the refactorisation of a part.

namespace hawser::bench {

/// Repair the paper's scene for `steps` steps with 10, 50 and 200 contacts changed in each, once
/// without a new plan and once as update() does it, and print times and fill growth. One thread,
/// processor time; between two repairs other data pass through the caches.
void print_edits(int steps, int scale);

/// Time and flops of partial refactorisations (factor/partial.h) of the same scene, and what it
/// costs the whole factorisation to keep all update matrices for them.
void print_parts(int scale);

}  // namespace hawser::bench
