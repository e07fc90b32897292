// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file impact_data.h
/// Scratch of the impact stage (step/impact_times.h).

#include <cstdint>
#include <vector>

namespace hawser::context {

struct ImpactWork {
    std::vector<std::uint8_t> hits;    ///< By contact, 1: an impact, or a candidate for one.
    std::vector<double> before;        ///< Packed like v: velocities before the impact.
    std::vector<double> change;        ///< Packed like v: change of velocity of a step without it.
    std::vector<double> time;          ///< By body: time of its impact in the step [s]; −1: none.
    std::vector<std::int32_t> parent;  ///< By body: tree of the bodies that an impact connects.
};

}  // namespace hawser::context
