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

/// Print the groups of a world that is coupled in parts; print no text for other worlds.
void print_groups(const World& world);

/// Print parts with separators, and parts with cuts, of the present state.
void print_parts(const World& world, int parts);

}  // namespace hawser::cli
