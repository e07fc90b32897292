// SPDX-License-Identifier: Apache-2.0
#pragma once
/// Cranes of usual size on a fixed body: a knuckle boom of 25 t, a lattice boom of 500 t.
#include <hawser/crane.h>
#include <hawser/hawser.h>

#include "validate/cranes.h"

namespace hawser::test {

inline constexpr double kG = 9.81;
using validate::knuckle_crane;
using validate::lattice_crane;

}  // namespace hawser::test
