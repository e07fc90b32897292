// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file random_cases.h
/// Random mechanisms as scene documents: trees and loops of all joints with random bodies, wires,
/// redundant and contradictory joints.

#include <cstdint>
#include <string>

namespace hawser::bench {

struct RandomCase {
    std::string text;            ///< The scene (docs/scenes.md).
    double step = 0.0;           ///< [s].
    bool loops = false;          ///< Some joint closes a loop.
    bool repeated = false;       ///< A joint repeats another one.
    bool contradictory = false;  ///< Two joints cannot both hold in any pose.
    bool wires = false;          ///< Cables of lumps.
    bool extreme = false;        ///< Masses or stiffnesses with a ratio of 1e6 or more.
};

/// Return the case for two numbers, independent of other cases.
[[nodiscard]] RandomCase make_random_case(std::uint64_t seed, std::uint64_t number);

}  // namespace hawser::bench
