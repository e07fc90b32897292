// SPDX-License-Identifier: Apache-2.0
/// @file
/// Converged trajectories that the engines are compared with.
#pragma once

#include "scenes.h"

#include <string>
#include <vector>

namespace hawser::bench {

/// A sampled reference; empty if a scene has none or has an exact solution (Scene::tension).
///
/// File: CSV with a header; column `t` [s], then `x,y,z` of the block [m] or one column per ship of
/// Scene::towed whose name begins with `tension` [N], both instantaneous at `t`.
struct Reference {
    std::vector<double> t;                     ///< Increasing [s].
    std::vector<Vec3> block;                   ///< Empty or one per time [m].
    std::vector<std::vector<double>> tension;  ///< One series per towed ship [N].

    /// True if `time` is inside the sampled range.
    [[nodiscard]] bool covers(double time) const;

    /// Return the block position, linear between samples. @pre covers(time) and `block` is not
    /// empty.
    [[nodiscard]] Vec3 block_at(double time) const;

    /// Return the tension at one ship, linear between samples. @pre covers(time).
    [[nodiscard]] double tension_at(std::size_t ship, double time) const;
};

/// Read `folder`/<scene name>.csv. A missing file gives an empty reference, a malformed one throws
/// std::runtime_error.
[[nodiscard]] Reference load_reference(const std::string& folder, const Scene& scene);

}  // namespace hawser::bench
