// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file materials.h
/// Materials, and the table of what two of them make.

#include "collide/contacts.h"

#include <cstdint>
#include <vector>

namespace hawser::collide {

/// Material 0 is always there: that of shapes which name none, with the defaults of MaterialDef.
class Materials {
  public:
    Materials();
    /// The definition has been checked. @return its index.
    std::int32_t add(const MaterialDef& def);
    void add_pair(const MaterialPairDef& def);  ///< A later one for the same two replaces it.
    [[nodiscard]] int count() const noexcept { return static_cast<int>(defs_.size()); }
    [[nodiscard]] const MaterialDef& def(int index) const {
        return defs_[static_cast<std::size_t>(index)];
    }
    [[nodiscard]] const std::vector<MaterialPairDef>& pairs() const noexcept { return pairs_; }

    /// Index of the surface between two materials, in any order.
    [[nodiscard]] static std::int32_t surface(std::int32_t a, std::int32_t b) noexcept {
        return a < b ? b * (b + 1) / 2 + a : a * (a + 1) / 2 + b;
    }
    /// All surfaces, by that index, for a step of `h`: mixing rules of <hawser/shapes.h>, then the
    /// pairs. The tangential stiffnesses are in series like the normal ones.
    void surfaces(double h, std::vector<Surface>& out) const;

  private:
    std::vector<MaterialDef> defs_;
    std::vector<MaterialPairDef> pairs_;
};

}  // namespace hawser::collide
