// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file edits.h
/// Cost of contact changes: repair of the analysis (factor/repair.h) in long sequences, and partial
/// refactorisation.

namespace hawser::bench {

/// Repair the paper's scene for `steps` steps with 10, 50 and 200 contacts changed in each, without
/// a new plan and by update(). Prints times and fill growth. One thread, processor time; other data
/// pass through the caches between two repairs.
void print_edits(int steps, int scale);

/// Measure time and flops of partial refactorisations (factor/partial.h) of this scene, and the
/// cost of keeping all update matrices in the whole factorisation.
void print_parts(int scale);

}  // namespace hawser::bench
