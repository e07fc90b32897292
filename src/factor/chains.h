// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file chains.h
/// Wires in the graph of a matrix: sequences that are eliminated first, eight at a time.
///
/// Most unknowns of a scene belong to wires: bodies b₁ b₂ … that couple only to their next one
/// or two neighbours (two when three-body bending is present), each with the constraint rows r_i
/// between it and later bodies. Cut into *chains* by separators of one or two bodies, they can
/// be eliminated independently, and chains of equal shape in the lanes of vector registers:
///
/// ```
///   hub ─ b₁ ─ b₂ ─ … ─ b_n ─[ s ]─ b₁ ─ b₂ ─ … ─ b_n ─[ s ]─ …
///         └── chain, lane 0 ─┘      └── chain, lane 1 ─┘
/// ```
/// A *unit* is one body and the rows that belong to it: those whose first body in the chain it
/// is. Units are eliminated in sequence; all else that a chain touches (hubs, separators) is its
/// *boundary* and is eliminated after it.
///
/// The price is fill: a chain with a separator at its start carries that along to its end (for
/// rigid links 2.3 to 2.6 times the flops of a chain with a free start). So chains start at their
/// freer end, and the number of cuts is chosen with an estimate of the time.

#include "factor/pattern.h"

#include <cstdint>
#include <span>
#include <vector>

namespace hawser::factor {

/// Chains as flat arrays.
struct Chains {
    std::vector<std::int32_t> nodes;          ///< In the order of elimination.
    std::vector<std::int32_t> unit_begin{0};  ///< units + 1 offsets into nodes.
    std::vector<std::int32_t> begin{0};       ///< chains + 1 offsets into units.
    std::vector<std::int8_t> body_size;       ///< By chain: scalars of each of its bodies, 3 or 6.
    std::vector<std::int8_t> reach;           ///< By chain: neighbours to couple to, 1 or 2.

    [[nodiscard]] int count() const noexcept { return static_cast<int>(begin.size()) - 1; }
    [[nodiscard]] int units(int chain) const noexcept {
        return begin[static_cast<std::size_t>(chain) + 1] - begin[static_cast<std::size_t>(chain)];
    }
    /// Nodes of one unit, its body first; `unit` counts through all chains.
    [[nodiscard]] std::span<const std::int32_t> unit(int unit) const noexcept {
        const auto u = static_cast<std::size_t>(unit);
        return {nodes.data() + unit_begin[u], nodes.data() + unit_begin[u + 1]};
    }
    friend bool operator==(const Chains&, const Chains&) = default;
};

/// Find wires and cut them. Deterministic: depends on the pattern alone. @throws std::bad_alloc.
[[nodiscard]] Chains find_chains(const Pattern& pattern);

/// Whether chains from elsewhere (a file) are chains of this pattern, as batches.h needs them, and
/// eliminated as such. @param position  Of each node in the order of elimination.
[[nodiscard]] bool chains_fit(const Pattern& pattern, const Chains& chains,
                              std::span<const std::int32_t> position);

}  // namespace hawser::factor
