// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file held_together.h
/// Groups of bodies that joints hold together: a hull with its derricks and cranes.

#include <hawser/world.h>

#include <cstddef>
#include <numeric>
#include <vector>

namespace hawser::base {

/// Disjoint sets of bodies, joined by all interactions of kinds with the trait kHoldsBodies.
class LinkedGroups {
  public:
    explicit LinkedGroups(const World& world)
        : group_of_body_(static_cast<std::size_t>(world.body_count())) {
        std::iota(group_of_body_.begin(), group_of_body_.end(), std::size_t{0});
        for (const InteractionId id : world.interactions()) {
            const InteractionDef& def = world.interaction_def(id);
            const KindInfo& kind = kind_info(def.kind);
            if (!kind.is(kHoldsBodies)) continue;
            for (std::size_t b = 1; b < static_cast<std::size_t>(kind.bodies); ++b)
                group_of_body_[group(def.body[b])] = group(def.body[0]);
        }
    }
    /// Return the number of a body's group: the index of one of its bodies.
    [[nodiscard]] std::size_t group(BodyId id) const {
        auto at = static_cast<std::size_t>(id.index);
        while (group_of_body_[at] != at) at = group_of_body_[at];
        return at;
    }

  private:
    std::vector<std::size_t> group_of_body_;
};

}  // namespace hawser::base
