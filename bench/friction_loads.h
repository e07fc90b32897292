// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file friction_loads.h
/// Two loads on which methods for friction and joints differ.

#include <hawser/def.h>

namespace hawser::bench {

/// A method with its number of sweeps.
struct Method {
    const char* name;
    Nonsmooth nonsmooth;
    int sweeps;
};

/// Return the creep from the first second to the end [m] of a block of 1 t at rest. Its slope is 80
/// % of the friction limit. NaN: a step failed.
[[nodiscard]] double creep(const Method& method, double duration);

/// A chain of 100 lumps of 1 kg hangs at rest from the ceiling with 10 t at its lower end. It
/// starts without known forces. Values: force of the top link over the weight below it.
struct Carried {
    double first = 0.0;   ///< In the first step.
    double second = 0.0;  ///< In the last step of one second.
};
[[nodiscard]] Carried chain_load(const Method& method);

}  // namespace hawser::bench
