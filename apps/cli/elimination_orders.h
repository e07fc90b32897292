// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file elimination_orders.h
/// Orders of elimination that figures compare.

#include <hawser/factor.h>

#include <cstdint>
#include <string>
#include <vector>

namespace hawser::cli {

enum class Ordering : std::uint8_t {
    natural,  ///< As the nodes come: bodies, then rows.
    amd,      ///< Approximate minimum degree.
    metis,    ///< Nested dissection of METIS (Karypis and Kumar 1998).
};
[[nodiscard]] const char* name_of(Ordering ordering);

/// Whether METIS was there when the program was built.
[[nodiscard]] bool metis_available();

/// All with rows after bodies. @throws std::runtime_error for METIS where it is not available.
[[nodiscard]] std::vector<std::int32_t> order_of(const BlockPattern& pattern, Ordering ordering);

}  // namespace hawser::cli
