// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file friction_loads.h
/// Two loads that tell methods for friction and joints apart.

#include <hawser/def.h>

namespace hawser::bench {

/// A method with its number of sweeps.
struct Method {
    const char* name;
    Nonsmooth nonsmooth;
    int sweeps;
};

/// A block of 1 t at rest on a slope of 80 % of the friction limit: how far it moves from the
/// first second to the end [m]. Not a number: a step failed.
[[nodiscard]] double creep(const Method& method, double duration);

/// A chain of 100 lumps of 1 kg hanging from the ceiling, 10 t at its lower end, at rest, started
/// without knowing any force: force of the top link over the weight that hangs on it.
struct Carried {
    double first = 0.0;   ///< In the first step.
    double second = 0.0;  ///< In the last step of one second.
};
[[nodiscard]] Carried chain_load(const Method& method);

}  // namespace hawser::bench
