// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file chains.h
/// Chains: sequences of bodies in the graph of a matrix that are eliminated first, eight at a time.
///
/// Most unknowns of a scene belong to wires: bodies b₁ b₂ … that couple only to their next one or
/// two neighbours. Three-body bending needs two. Each body also has the constraint rows r_i between
/// it and later bodies. Separators of one or two bodies cut wires into *chains*. Chains are
/// eliminated independently, and chains of equal shape occupy the lanes of common vector
/// registers:
///
/// ```
///   hub ─ b₁ ─ b₂ ─ … ─ b_n ─[ s ]─ b₁ ─ b₂ ─ … ─ b_n ─[ s ]─ …
///         └── chain, lane 0 ─┘      └── chain, lane 1 ─┘
/// ```
/// A *unit* is one body and its rows. A row belongs to its first body in the chain. Units are
/// eliminated in sequence. All other neighbours of a chain (hubs, separators) are its *boundary*
/// and are eliminated after it.
///
/// Limits: chains cause fill. If a chain starts at a separator, the rows of this separator remain
/// to its end. For rigid links this costs 2.3 to 2.6 times the flops of a chain with a free start.
/// Chains therefore start at the end with fewer neighbours, and the number of cuts follows from an
/// estimate of the time.

#include "factor/body_graph.h"
#include "factor/pattern.h"

#include <cstdint>
#include <span>
#include <vector>

namespace hawser::factor {

/// Chains as flat arrays.
struct Chains {
    std::vector<std::int32_t> nodes;          ///< Nodes in the order of elimination.
    std::vector<std::int32_t> unit_begin{0};  ///< units + 1 offsets into nodes.
    std::vector<std::int32_t> begin{0};       ///< chains + 1 offsets into units.
    std::vector<std::int8_t> body_size;       ///< Scalars of each body of a chain, 3 or 6.
    std::vector<std::int8_t> reach;  ///< Neighbours that each body of a chain couples to, 1 or 2.

    [[nodiscard]] int count() const noexcept { return static_cast<int>(begin.size()) - 1; }
    [[nodiscard]] int units(int chain) const noexcept {
        return begin[static_cast<std::size_t>(chain) + 1] - begin[static_cast<std::size_t>(chain)];
    }
    /// Return the nodes of one unit (a body and its rows), the body first. `unit` counts through
    /// all chains.
    [[nodiscard]] std::span<const std::int32_t> unit(int unit) const noexcept {
        const auto u = static_cast<std::size_t>(unit);
        return {nodes.data() + unit_begin[u], nodes.data() + unit_begin[u + 1]};
    }
    void clear();
    [[nodiscard]] std::size_t bytes() const noexcept;
    friend bool operator==(const Chains&, const Chains&) = default;
};

/// Finds wires and cuts them into chains. Deterministic: the result depends on the pattern alone. A
/// second search in a pattern of similar size allocates nothing.
class ChainFinder {
  public:
    /// Find the chains of a pattern.
    /// @throws std::bad_alloc.
    void find(const Pattern& pattern, Chains& out);
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    /// A wire: consecutive bodies that only hubs and their own neighbours touch.
    struct Stretch {
        std::int32_t begin, end;  ///< Range in Wires::bodies.
        std::int32_t reach;
        double unit;         ///< Scalars of a unit, rows included, on average.
        std::int32_t start;  ///< Boundary scalars that the chain carries from its freer end.
        std::int32_t
            common_touch_rows;  ///< Boundary scalars that touch the whole wire (a deck under it).
        double
            single_touch_rows;  ///< Boundary scalars per body that touch single bodies of the wire.
    };
    struct Segment {
        std::int32_t run, from, to;  ///< Bodies [from, to), relative to the start of the run.
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
    void cut_runs(std::int32_t target);
    [[nodiscard]] double plan_cost(int size, double most);
    void choose_chains(std::int32_t bodies, std::int32_t longest, int size);
    void append(const Pattern& pattern, const BodyGraph& graph, const Wires& wires,
                const Stretch& run, const Segment& piece, Chains& out);
    [[nodiscard]] bool is_cheaper_backwards(const Pattern& pattern, const BodyGraph& graph,
                                            const Wires& wires, std::int32_t from, std::int32_t to);

    WireFinder wires_;
    std::vector<Stretch> all_stretches_, runs_;
    std::vector<Segment> pieces_, best_cut_;
    std::vector<Shape> shapes_;
    std::vector<Neighbour> hubs_;
    std::vector<std::int32_t> seen_bodies_;
};

[[nodiscard]] Chains find_chains(const Pattern& pattern);

/// Return true if chains read from a file match this pattern, as batches.h requires, and are
/// eliminated as chains.
/// @param position  Position of each node in the order of elimination.
[[nodiscard]] bool chains_fit(const Pattern& pattern, const Chains& chains,
                              std::span<const std::int32_t> position);

}  // namespace hawser::factor
