// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file edits.h
/// Time of contact changes: repair of the analysis (factor/repair.h) through long sequences, and
/// partial refactorisation.

namespace hawser::bench {

/// Repair the paper's scene for `steps` steps with 10, 50 and 200 contacts changed in each, once
/// without a new plan and once as update() does it, and print times and fill growth. One thread,
/// processor time; between two repairs other data pass through the caches.
void print_edits(int steps, int scale);

/// Print time and flops of partial refactorisations (factor/partial.h) of the same scene. Also
/// print the extra time of a whole factorisation that keeps all update matrices.
void print_parts(int scale);

}  // namespace hawser::bench
