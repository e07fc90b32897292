// SPDX-License-Identifier: Apache-2.0
// Small systems whose stability under a split is known (docs/theory/splits.md).
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace hawser::bench::split {

/// Find the stiffness from which two bodies with kinematic coupling are unstable, by bisection, and
/// compare it with theory. Prints. @param cases  Number of cases, at most six.
nlohmann::ordered_json two_body_boundaries(int cases = 6);

/// Compute the largest spectral radius of twelve bodies in a chain, by coupling and predictor. The
/// chain is cut in the middle or beside a heavy body; stiffnesses k h²/m are 1 to 1e6. Prints.
nlohmann::ordered_json chain_predictors();

}  // namespace hawser::bench::split
