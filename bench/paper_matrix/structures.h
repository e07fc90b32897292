// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file structures.h
/// Systems of one structure each, which show its effect on an ordering and a schedule.

#include "paper_matrix/block_system.h"

namespace hawser::bench {

/// Make one chain of rigid links (6 DoF) with ball joints, hanging from the ground.
[[nodiscard]] BlockSystem chain(int links);

/// Make a binary tree of chains: 2^levels − 1 chains of `links` rigid links. Two start at the end
/// of each; the first hangs from the ground.
[[nodiscard]] BlockSystem tree_of_chains(int levels, int links);

/// Make a fishing net: side × side knots (3 DoF) with an elastic string between neighbours.
[[nodiscard]] BlockSystem net(int side);

/// Make a solid body: side³ knots (3 DoF), each joined by elastic bars to the next one along three
/// axes and three diagonals. The matrix is its tangent stiffness: positive definite, without rows.
/// Factors of solids are large for their size, and the bars are soft for the masses.
[[nodiscard]] BlockSystem solid(int side);

/// Make `links` rigid links in `chains` chains between floats: one island. The first chains connect
/// floats in a row, the others hang from a float into the ground.
[[nodiscard]] BlockSystem moored_floats(int links, int chains, int floats);

}  // namespace hawser::bench
