// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file facet.h
/// Base of the facets of a world.
///
/// A facet is a part of the interface of World with its own class: World::wires(), state(),
/// events(), solver() and splits(). It stores one pointer to the world, so it is passed by value.
/// It is valid until the world is moved or destroyed. A facet of a const world has a class that
/// only reads, such as WorldWiresView.

namespace hawser {

class World;
struct WorldImpl;  // inside the library

/// Pointer to the world of a facet.
class Facet {
  protected:
    explicit Facet(const World& world) noexcept : world_(const_cast<World*>(&world)) {}
    // Data of a world; defined inside the library.
    [[nodiscard]] static inline WorldImpl& impl(const World& world) noexcept;
    [[nodiscard]] inline WorldImpl& impl() const noexcept;

    World* world_;  ///< Not const, because the classes that edit derive from those that read.
};

}  // namespace hawser
