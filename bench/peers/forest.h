// SPDX-License-Identifier: Apache-2.0
/// @file
/// Spanning forest of a scene, for engines in reduced coordinates.
#pragma once

#include "scenes.h"

#include <vector>

namespace hawser::bench {

/// A body placed in its tree. `parent` is a body, kWorld (attached to the world by `joint`), or
/// kFree (root of a floating tree, `joint` is -1).
struct TreeNode {
    int body = 0;
    int parent = kWorld;
    int joint = -1;
    Vec3 arm_parent = Vec3::Zero();  ///< Joint in the frame of the parent [m].
    Vec3 arm_child = Vec3::Zero();   ///< Joint in the frame of the body [m].
};

inline constexpr int kFree = -2;  ///< Parent of a body that floats freely.

/// Return trees in an order in which every parent precedes its children; one entry per tree.
///
/// Joints in `layout.closures` are left out; the rest must be a forest. A tree attached to the
/// world has its root there, any other at its heaviest body. Throws if a loop remains.
[[nodiscard]] std::vector<std::vector<TreeNode>> spanning_forest(const Scene& scene,
                                                                 const TreeLayout& layout);

}  // namespace hawser::bench
