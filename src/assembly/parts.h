// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file parts.h
/// The model as a hypergraph of integers, with physical weights for cuts.
///
/// Edges are the interactions in their order, then the pairs of bodies that touch.
/// Only rows of wires may be cut: stretch, bending, twist, distance and ball joints between bodies
/// of the same freedom with few interactions each. Weights are in thousandths, from the last step:
/// ```
///   node  α₁ ‖Σ_e G_eᵀλ_e‖ / (h F)     NET force: small in a taut steady wire, where Σ|λ| is not
///   edge  α₂ Σ|G v| / v₀ + α₅ Σ|g| / g₀
/// ```
/// F = m g + 1 % of the root mean square of all row forces, v₀ = 0.1 m/s, g₀ = 0.01 m, α = 1.
/// kTouchWeight is added for a body in contact.

#include <hawser/def.h>

#include "assembly/contacts.h"
#include "graph/hypergraph.h"
#include "model/bodies.h"
#include "model/interactions.h"

#include <cstdint>
#include <span>
#include <vector>

namespace hawser::assembly {

/// Weight of a body in contact. It is not physical: touching bodies are separated only as a last
/// resort.
inline constexpr std::int32_t kTouchWeight = 1'000'000;

/// Convert a weight to thousandths, between 0 and a million, so that sums of a few do not overflow.
/// NaN becomes the maximum.
[[nodiscard]] std::int32_t thousandths(double weight) noexcept;

class PartGraph {
  public:
    /// Build nodes and edges. @param body_count, interaction_count  Counts of the user, without the
    /// ghost bodies and duplicated interactions behind them (split/cuts.h).
    void build(const model::Bodies& bodies, std::int32_t body_count,
               const model::Interactions& interactions, std::int32_t interaction_count,
               std::span<const Contacts::Link> links);
    /// Forbid the partition to cut interaction i.
    void keep_whole(std::int32_t i) noexcept;
    /// Compute weights from the impulses of the last step, from velocities, and from the rows as
    /// last evaluated. @param cut  Interactions that are cut at present, ascending. The cut has
    /// caused their violation, which therefore does not increase their weight. It is the cost of a
    /// repair, because a row that becomes exact again pulls its bodies back into position.
    void compute_weights(const model::Bodies& bodies, const model::Interactions& interactions,
                         std::span<const std::int32_t> cut, const WorldDef& def);
    /// Add the weight of one contact to a body of the graph. Call after compute_weights().
    void add_contact_weight(std::int32_t body) noexcept;
    /// Flops of the pivots of each body, including rows that follow it; empty if unknown.
    std::vector<std::int64_t> cost;
    std::vector<std::int32_t> group;  ///< Part of each body as set by the user; may be empty.

    [[nodiscard]] graph::Hypergraph view() const noexcept {
        return {size, begin, members, edge_weight, node_weight, group, cost, repair_weight};
    }

    std::vector<std::uint8_t> size;
    std::vector<std::int32_t> begin, members, edge_weight, node_weight, repair_weight;
    std::vector<double> net_force;  ///< By body [N].
    std::vector<double> speed;      ///< By interaction: Σ|G v| [m/s, rad/s].
    std::vector<double> violation;  ///< By interaction: Σ|g| [m, rad].

  private:
    std::vector<std::int32_t> degree_;
    std::vector<std::uint8_t> whole_;  ///< By edge: 1 if it may not be cut.
    std::vector<double> net_;          ///< Three per body [N s].
};

}  // namespace hawser::assembly
