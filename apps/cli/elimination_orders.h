// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file elimination_orders.h
/// Elimination orders for the comparison in figures.

#include <hawser/factor.h>

#include <cstdint>
#include <string>
#include <vector>

namespace hawser::cli {

enum class Ordering : std::uint8_t {
    natural,  ///< Order of the nodes: bodies, then rows.
    amd,      ///< Approximate minimum degree.
    metis,    ///< Nested dissection of METIS (Karypis and Kumar 1998).
};
[[nodiscard]] const char* name_of(Ordering ordering);

/// True if the program was built with METIS.
[[nodiscard]] bool metis_available();

/// Return an order with rows after their bodies. @throws std::runtime_error for METIS if it is not
/// available.
[[nodiscard]] std::vector<std::int32_t> elimination_order(const BlockPattern& pattern,
                                                          Ordering ordering);

}  // namespace hawser::cli
