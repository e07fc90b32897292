// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wire_solve.h
/// One iteration of wire_newton.h: velocities of the nodes of a wire for given laws and statuses.

#include "base/index.h"
#include "context/context.h"

#include <cstddef>
#include <cstdint>

namespace hawser::contact {

/// Number of contacts of a chain.
[[nodiscard]] inline std::size_t chain_contact_count(const context::WireNewton& wire,
                                                     std::int32_t chain) noexcept {
    return at(wire.begin[at(chain) + 1] - wire.begin[at(chain)]);
}

/// Solve with the laws and statuses in `wire`; the result is in the elements and cones.
/// @return false if the matrix is singular.
[[nodiscard]] bool solve_wire(const context::Model& model, context::WireNewton& wire,
                              std::int32_t chain) noexcept;

}  // namespace hawser::contact
