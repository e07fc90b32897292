// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file structures.h
/// Systems of one shape each, which show the effect of an ordering and a schedule.

#include "paper_matrix/block_system.h"

namespace hawser::bench {

/// One chain of rigid links (6 DoF) with ball joints, hanging from the ground.
[[nodiscard]] BlockSystem chain(int links);

/// A binary tree of chains: 2^levels − 1 chains of `links` rigid links; two start at the end of
/// each, the first hangs from the ground.
[[nodiscard]] BlockSystem tree_of_chains(int levels, int links);

/// A fishing net: side × side knots (3 DoF) with an elastic string between neighbours.
[[nodiscard]] BlockSystem net(int side);

/// A solid body: side³ knots (3 DoF), each joined by elastic bars to the next one along three axes
/// and three diagonals, as its tangent stiffness: positive definite, without rows. Factors of
/// solids are large for their size, and the bars are soft for the masses.
[[nodiscard]] BlockSystem solid(int side);

/// `links` rigid links in `chains` chains between floats: one island. The first chains connect
/// floats in a row, the others hang from a float into the ground.
[[nodiscard]] BlockSystem moored_floats(int links, int chains, int floats);

}  // namespace hawser::bench
