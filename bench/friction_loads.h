// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file friction_loads.h
/// Two loads for which methods for friction and joints differ.

#include <hawser/def.h>

namespace hawser::bench {

/// A method with its number of sweeps.
struct Method {
    const char* name;
    Nonsmooth nonsmooth;
    int sweeps;
};

/// Measure the displacement of a block of 1 t at rest on a slope of 80 % of the friction limit,
/// from the first second to the end [m]. NaN if a step failed.
[[nodiscard]] double creep(const Method& method, double duration);

/// A chain of 100 point masses of 1 kg at rest on the ceiling with 10 t at its lower end, started
/// from zero forces: force of the top link over the hanging weight.
struct Carried {
    double first = 0.0;   ///< In the first step.
    double second = 0.0;  ///< In the last step of one second.
};
[[nodiscard]] Carried chain_load(const Method& method);

}  // namespace hawser::bench
