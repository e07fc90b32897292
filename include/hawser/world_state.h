// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file world_state.h
/// Dynamic state of a world: World::state().
///
/// ```cpp
/// const std::vector<std::byte> start = world.state().save();
/// for (int k = 0; k < 600; ++k) world.step();
/// world.state().restore(start);   // continues with equal bits
/// ```
/// Functions that save or restore throw UseError for a world in use by another thread.

#include <hawser/facet.h>
#include <hawser/state.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hawser {

struct Structure;  // structure.h

/// Reads the state of a world.
class WorldStateView : public Facet {
  public:
    explicit WorldStateView(const World& world) noexcept : Facet(world) {}

    /// Return poses and velocities of all bodies without a copy: state.h.
    [[nodiscard]] StateView arrays() const noexcept;
    /// Return the whole dynamic state, warm start included. A world built from the same definitions
    /// continues from it bit for bit. Parameters are not included, except those that inputs drive.
    /// @throws std::bad_alloc, LimitError.
    [[nodiscard]] std::vector<std::byte> save() const;
    void save(std::vector<std::byte>& out) const;  ///< In the caller's buffer, replaced.
    [[nodiscard]] std::vector<std::byte> save_motion() const;  ///< Without states of systems.
    /// Return the definitions, to restore with a state in a world with the same settings:
    /// structure.h.
    [[nodiscard]] Structure structure() const;
    [[nodiscard]] std::uint64_t identity() const;  ///< Equal if states of one fit the other.
    /// Return FNV-1a 64 over poses, velocities, multipliers, time, inputs, states of systems, and
    /// the name of the instruction set. Equal for any number of threads and after save/restore.
    [[nodiscard]] std::uint64_t hash() const noexcept;
    /// Return the same without states of systems: equal in a replay, which repeats their actions.
    [[nodiscard]] std::uint64_t motion_hash() const noexcept;

    /// Return arrays(), as World::state() did before.
    [[deprecated("use state().arrays()")]] operator StateView() const noexcept { return arrays(); }
};

/// Reads and replaces the state of a world.
class WorldState : public WorldStateView {
  public:
    explicit WorldState(World& world) noexcept;

    /// Restore a state.
    /// @throws std::bad_alloc, LimitError; DefError if the bytes are damaged or belong to another
    ///        world. Objects, step and parameters (masses, lengths, stiffnesses, …) must be equal;
    ///        names, form and threads may differ. The state is unchanged after an error.
    void restore(std::span<const std::byte> bytes);
    void restore_variant(std::span<const std::byte> bytes);  ///< Parameters and forces may differ.
    /// Restore objects and state, all or nothing.
    /// @param made_of  WorldStateView::structure() of the saved world.
    void restore(const Structure& made_of, std::span<const std::byte> bytes);
    /// Copy the state of a world with equal definitions, such as a twin (World::twin()).
    /// @throws DefError if definitions differ.
    void copy_from(const World& other);
};

}  // namespace hawser
