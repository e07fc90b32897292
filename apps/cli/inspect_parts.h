// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file inspect_parts.h
/// Tables of `hawser inspect`: comparison of elimination orders, and parts.

#include <hawser/inspect.h>
#include <hawser/world.h>

namespace hawser::cli {

/// Print nnz(L), flops and critical path of AMD, METIS nested dissection (if built in) and our
/// order, on the same block matrix.
void print_orders(const SystemView& view);

/// Print the groups of a world with approximate coupling; print nothing for other worlds.
void print_groups(const World& world);

/// Print the partitions of the present state, with separators and with cuts.
void print_parts(const World& world, int parts);

}  // namespace hawser::cli
