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

#include "factor/body_graph.h"
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
    void clear();
    [[nodiscard]] std::size_t bytes() const noexcept;
    friend bool operator==(const Chains&, const Chains&) = default;
};

/// Finds wires and cuts them. Deterministic: depends on the pattern alone. A used one needs no
/// memory for a pattern of about the same size.
class ChainFinder {
  public:
    /// @throws std::bad_alloc.
    void find(const Pattern& pattern, Chains& out);
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    /// A wire: consecutive bodies that nothing but hubs and its own neighbours touch.
    struct Stretch {
        std::int32_t begin, end;  ///< Range in Wires::bodies.
        std::int32_t reach;
        double unit;          ///< Scalars of a unit, rows included, on average.
        std::int32_t start;   ///< Boundary scalars that the chain must carry from its freer end on.
        std::int32_t across;  ///< Boundary scalars that touch the whole wire (a deck under it).
        double beside;        ///< Boundary scalars a body that touch the wire here and there.
    };
    struct Segment {
        std::int32_t run, from, to;  ///< Bodies [from, to) of the run, relative.
    };
    struct Shape {
        double q, p;
        std::int32_t length, number;
    };
    struct Neighbour {
        std::int32_t node, first, count;
    };

    [[nodiscard]] Stretch describe(const Pattern& pattern, const BodyGraph& graph,
                                   const Wires& wires, std::int32_t begin, std::int32_t end);
    void cut(std::int32_t target);
    [[nodiscard]] double plan_cost(int size, double most);
    void cut_best(std::int32_t bodies, std::int32_t longest, int size);
    void append(const Pattern& pattern, const BodyGraph& graph, const Wires& wires,
                const Stretch& run, const Segment& piece, Chains& out);
    [[nodiscard]] bool turns(const Pattern& pattern, const BodyGraph& graph, const Wires& wires,
                             std::int32_t from, std::int32_t to);

    WireFinder wires_;
    std::vector<Stretch> all_, runs_;
    std::vector<Segment> pieces_, best_;
    std::vector<Shape> shapes_;
    std::vector<Neighbour> hubs_;
    std::vector<std::int32_t> seen_;
};

[[nodiscard]] Chains find_chains(const Pattern& pattern);

/// Whether chains from elsewhere (a file) are chains of this pattern, as batches.h needs them, and
/// eliminated as such. @param position  Of each node in the order of elimination.
[[nodiscard]] bool chains_fit(const Pattern& pattern, const Chains& chains,
                              std::span<const std::int32_t> position);

}  // namespace hawser::factor
