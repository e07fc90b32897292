// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file inspect_parts.h
/// Tables of `hawser inspect`: orders of elimination beside each other, and parts.

#include <hawser/inspect.h>
#include <hawser/world.h>

namespace hawser::cli {

/// nnz(L), flops and critical path of AMD, METIS nested dissection (where built in) and our order,
/// on the same block matrix.
void print_orders(const SystemView& view);

/// Groups that are in force in a world that is coupled in parts; else nothing.
void print_groups(const World& world);

/// Parts with separators, and parts with cuts, of the present state.
void print_parts(const World& world, int parts);

}  // namespace hawser::cli
