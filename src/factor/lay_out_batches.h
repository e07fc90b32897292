// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file lay_out_batches.h
/// From chains to batches (batches.h): which chains go together, and where their panels are.

#include "factor/chains.h"
#include "factor/symbolic.h"

#include <cstdint>
#include <vector>

namespace hawser::factor {

/// Group the chains, give every node its step and slot, and lay out the panels behind the
/// ordinary ones. `s` has its fronts, rows and offsets; `front_of_chain` names the chains' fronts.
void lay_out_batches(const Pattern& pattern, const Chains& chains,
                     const std::vector<std::int32_t>& front_of_chain, Symbolic& s);

}  // namespace hawser::factor
