// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file parts.h
/// The model as a hypergraph of integers, and what physics says about cutting it.
///
/// Edges are the interactions in their order, then the pairs of bodies that touch. Only rows of
/// wires may be cut: stretch, bending, twist, distance and ball joints between bodies of the same
/// freedom with few interactions each. Weights are in thousandths, from the last step:
/// ```
///   node  α₁ ‖Σ_e G_eᵀλ_e‖ / (h F)     NET force: small in a taut steady wire, where Σ|λ| is not
///   edge  α₂ Σ|G v| / v₀ + α₅ Σ|g| / g₀
/// ```
/// F = m g + a hundredth of the root mean square of all row forces, v₀ = 0.1 m/s, g₀ = 0.01 m,
/// α = 1. A body that touches something adds kTouchWeight.

#include <hawser/def.h>

#include "assembly/contacts.h"
#include "graph/hypergraph.h"
#include "model/bodies.h"
#include "model/interactions.h"

#include <cstdint>
#include <span>
#include <vector>

namespace hawser::assembly {

/// Weights that are not physical but forbid: touching bodies are cut apart last.
inline constexpr std::int32_t kTouchWeight = 1'000'000;

/// A weight in thousandths, from 0 to a million, so that sums of a few do not overflow; what is no
/// number is the largest one.
[[nodiscard]] std::int32_t thousandths(double weight) noexcept;

class PartGraph {
  public:
    /// Nodes and edges. @param body_count, interaction_count  Those of the user, who knows nothing
    /// of the images and copies behind them (split/cuts.h).
    void build(const model::Bodies& bodies, std::int32_t body_count,
               const model::Interactions& interactions, std::int32_t interaction_count,
               std::span<const Contacts::Link> links);
    /// Interaction i must stay whole.
    void keep_whole(std::int32_t i) noexcept;
    /// Weights from the last step's impulses, from velocities, and from rows as they were evaluated
    /// last. @param cut  Interactions that are cut at present, ascending. Their violation comes of
    /// the cut and does not count against it; it is the price of mending it, since a row that gets
    /// its own compliance back pulls its bodies to where they belong.
    void weigh(const model::Bodies& bodies, const model::Interactions& interactions,
               std::span<const std::int32_t> cut, const WorldDef& def);
    /// The body touches something: after weigh().
    void touch(std::int32_t body) noexcept;
    /// Flops of each body's pivots, rows that follow it included; empty: none known.
    std::vector<std::int64_t> cost;
    std::vector<std::int32_t> group;  ///< Part of each body by hand; may be empty.

    [[nodiscard]] graph::Hypergraph view() const noexcept {
        return {size, begin, members, edge_weight, node_weight, group, cost, mend_weight};
    }

    std::vector<std::uint8_t> size;
    std::vector<std::int32_t> begin, members, edge_weight, node_weight, mend_weight;
    std::vector<double> net_force;  ///< By body [N].
    std::vector<double> speed;      ///< By interaction: Σ|G v| [m/s, rad/s].
    std::vector<double> violation;  ///< By interaction: Σ|g| [m, rad].

  private:
    std::vector<std::int32_t> degree_;
    std::vector<std::uint8_t> whole_;  ///< By edge: may not be cut.
    std::vector<double> net_;          ///< Three a body [N s].
};

}  // namespace hawser::assembly
