// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file materials.h
/// Materials, and the table of their pairs.

#include "collide/contacts.h"

#include <cstdint>
#include <vector>

namespace hawser::collide {

/// Material 0 always exists. Shapes that name no material use it. It has the defaults of
/// MaterialDef.
class Materials {
  public:
    Materials();
    /// Add a material definition that has been checked. @return its index.
    std::int32_t add(const MaterialDef& def);
    /// Add a pair of materials. It replaces an earlier pair of the same materials.
    void add_pair(const MaterialPairDef& def);
    [[nodiscard]] int count() const noexcept { return static_cast<int>(defs_.size()); }
    [[nodiscard]] const MaterialDef& def(int index) const {
        return defs_[static_cast<std::size_t>(index)];
    }
    [[nodiscard]] const std::vector<MaterialPairDef>& pairs() const noexcept { return pairs_; }

    /// Return the index of the surface between two materials, in any order.
    [[nodiscard]] static std::int32_t surface(std::int32_t a, std::int32_t b) noexcept {
        return a < b ? b * (b + 1) / 2 + a : a * (a + 1) / 2 + b;
    }
    /// Compute the surfaces of all pairs of materials for a step of `h`: first by the mixing rules
    /// of <hawser/shapes.h>, then by the given pairs. Tangential stiffnesses act in series, like
    /// normal ones.
    void surfaces(double h, std::vector<Surface>& out) const;

  private:
    std::vector<MaterialDef> defs_;
    std::vector<MaterialPairDef> pairs_;
};

}  // namespace hawser::collide
