// SPDX-License-Identifier: Apache-2.0
// Small systems whose stability under a split is known (docs/theory/splits.md).
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace hawser::bench::split {

/// Two bodies with kinematic coupling: the stiffness from which they are unstable, found by
/// bisection, beside that of the theory. Printed. @param cases  How many, at most six.
nlohmann::ordered_json two_body_boundaries(int cases = 6);

/// Twelve bodies in a chain, cut in the middle or beside a heavy one: largest spectral radius for
/// stiffnesses k h²/m from 1 to 1e6, by coupling and predictor. Printed.
nlohmann::ordered_json chain_predictors();

}  // namespace hawser::bench::split
