// SPDX-License-Identifier: Apache-2.0
// Small systems with known stability under a split (docs/theory/splits.md).
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace hawser::bench::split {

/// Find the stiffness at which two bodies with kinematic coupling become unstable, by bisection.
/// Prints it with that of the theory. @param cases  Number of cases, at most six.
nlohmann::ordered_json two_body_boundaries(int cases = 6);

/// Find the largest spectral radius of twelve bodies in a chain, cut in the middle or beside a
/// heavy one. Prints it for stiffnesses k h²/m from 1 to 1e6, by coupling and predictor.
nlohmann::ordered_json chain_predictors();

}  // namespace hawser::bench::split
