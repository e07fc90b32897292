// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file edits.h
/// What long sequences of contact changes do to an analysis that is repaired (factor/repair.h).

namespace hawser::bench {

/// Repair the paper's scene for `steps` steps with 10, 50 and 200 contacts changed in each, once
/// without a new plan and once as update() does it, and print times and fill growth. One thread,
/// processor time; between two repairs other data pass through the caches.
void print_edits(int steps, int scale);

}  // namespace hawser::bench
