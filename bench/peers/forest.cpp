// SPDX-License-Identifier: Apache-2.0
#include "forest.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace hawser::bench {
namespace {

/// Walk breadth-first from `tree[0]` over the joints in `use`; marks bodies as `placed`.
void extend_tree(const Scene& scene, const std::vector<std::vector<int>>& at,
                 const std::vector<char>& use, std::vector<char>& placed,
                 std::vector<TreeNode>& tree) {
    for (std::size_t k = 0; k < tree.size(); ++k) {
        const TreeNode from = tree[k];
        for (const int j : at[static_cast<std::size_t>(from.body)]) {
            if (!use[static_cast<std::size_t>(j)] || j == from.joint) continue;
            const BallJoint& joint = scene.joints[static_cast<std::size_t>(j)];
            const bool forward = joint.a == from.body;
            const int to = forward ? joint.b : joint.a;
            if (to == kWorld || placed[static_cast<std::size_t>(to)])
                throw std::invalid_argument(scene.name + ": a loop remains in the tree layout");
            placed[static_cast<std::size_t>(to)] = 1;
            tree.push_back({to, from.body, j, forward ? joint.arm_a : joint.arm_b,
                            forward ? joint.arm_b : joint.arm_a});
        }
    }
}

}  // namespace

std::vector<std::vector<TreeNode>> spanning_forest(const Scene& scene, const TreeLayout& layout) {
    const std::size_t n = scene.bodies.size();
    std::vector<char> use(scene.joints.size(), 1), placed(n, 0);
    for (const int j : layout.closures) use[static_cast<std::size_t>(j)] = 0;
    std::vector<std::vector<int>> at(n);
    for (std::size_t j = 0; j < scene.joints.size(); ++j)
        for (const int b : {scene.joints[j].a, scene.joints[j].b})
            if (b != kWorld) at[static_cast<std::size_t>(b)].push_back(static_cast<int>(j));

    std::vector<std::vector<TreeNode>> forest;
    for (std::size_t j = 0; j < scene.joints.size(); ++j) {
        const BallJoint& joint = scene.joints[j];
        if (!use[j] || (joint.a != kWorld && joint.b != kWorld)) continue;
        const bool forward = joint.a == kWorld;
        const int body = forward ? joint.b : joint.a;
        if (placed[static_cast<std::size_t>(body)])
            throw std::invalid_argument(scene.name + ": a loop remains in the tree layout");
        placed[static_cast<std::size_t>(body)] = 1;
        forest.push_back({{body, kWorld, static_cast<int>(j), joint.anchor,
                           forward ? joint.arm_b : joint.arm_a}});
        extend_tree(scene, at, use, placed, forest.back());
    }
    std::vector<std::size_t> heavy(n);
    std::iota(heavy.begin(), heavy.end(), std::size_t{0});
    std::stable_sort(heavy.begin(), heavy.end(), [&](std::size_t a, std::size_t b) {
        return scene.bodies[a].mass > scene.bodies[b].mass;
    });
    for (const std::size_t root : heavy) {
        if (placed[root]) continue;
        placed[root] = 1;
        forest.push_back({{static_cast<int>(root), kFree, -1, Vec3::Zero(), Vec3::Zero()}});
        extend_tree(scene, at, use, placed, forest.back());
    }
    return forest;
}

}  // namespace hawser::bench
