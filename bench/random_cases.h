// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file random_cases.h
/// Random mechanisms as scene documents: trees and loops of all joints with random bodies, wires,
/// redundant and inconsistent joints.

#include <cstdint>
#include <string>

namespace hawser::bench {

struct RandomCase {
    std::string text;            ///< The scene (docs/scenes.md).
    double step = 0.0;           ///< [s].
    bool loops = false;          ///< True if a joint closes a loop.
    bool repeated = false;       ///< True if a joint is redundant.
    bool contradictory = false;  ///< True if no pose can close two joints together.
    bool wires = false;          ///< True if it has cables of point masses.
    bool extreme = false;        ///< True if masses or stiffnesses have a ratio of 1e6 or more.
};

/// Make a case. It depends on these two numbers only.
[[nodiscard]] RandomCase make_random_case(std::uint64_t seed, std::uint64_t number);

}  // namespace hawser::bench
