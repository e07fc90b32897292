// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file world_state.h
/// Dynamic state of a world, World::state(): save, restore, copy and hash it.
///
/// The dynamic state contains all numbers that change in steps: poses, velocities, multipliers,
/// time, inputs, contacts, and states of systems. A world that restores it continues with equal
/// bits. Definitions are not part of it (structure.h).
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

    /// Return poses and velocities of all bodies without a copy (state.h).
    [[nodiscard]] StateView arrays() const noexcept;
    /// Return the whole dynamic state as bytes, including start values of the solver. A world built
    /// from equal definitions continues from it bit for bit. Parameters of interactions are
    /// included only if inputs drive them.
    /// @throws std::bad_alloc, LimitError.
    [[nodiscard]] std::vector<std::byte> save() const;
    /// Save into the caller's buffer. Its contents are replaced.
    void save(std::vector<std::byte>& out) const;
    /// Return the state as save(), but without states of systems, for replays.
    [[nodiscard]] std::vector<std::byte> save_motion() const;
    /// Return the definitions of all objects. A world with equal settings can restore them together
    /// with a state (structure.h).
    [[nodiscard]] Structure structure() const;
    /// Return a hash of the structure and parameters. Two worlds with equal identity can restore
    /// each other's states.
    [[nodiscard]] std::uint64_t identity() const;
    /// Return a hash (FNV-1a, 64 bits) of poses, velocities, multipliers, time, inputs, states of
    /// systems, and the name of the instruction set. It is equal for any number of threads, and
    /// after save() and restore().
    [[nodiscard]] std::uint64_t hash() const noexcept;
    /// Return a hash as hash(), but without states of systems. It is equal in a replay, which
    /// repeats the actions of systems without them.
    [[nodiscard]] std::uint64_t motion_hash() const noexcept;

    /// Return arrays(), for programs that use World::state() as a StateView.
    [[deprecated("use state().arrays()")]] operator StateView() const noexcept { return arrays(); }
};

/// Reads and replaces the state of a world.
class WorldState : public WorldStateView {
  public:
    explicit WorldState(World& world) noexcept;

    /// Restore a state of save(). Objects, step and parameters (masses, lengths, stiffnesses, …)
    /// must equal those of the saved world; names, form and threads may differ.
    /// @throws DefError if the bytes are damaged or belong to another world
    /// @throws std::bad_alloc, LimitError; the state is unchanged after any error
    void restore(std::span<const std::byte> bytes);
    /// Restore a state of a world with equal objects and step, whose parameters and applied forces
    /// may differ. Those of this world remain, and its monitors restart. Exceptions as restore().
    void restore_variant(std::span<const std::byte> bytes);
    /// Restore objects and state, all or nothing. Existing objects are replaced. Exceptions as
    /// restore().
    /// @param made_of  WorldStateView::structure() of the saved world.
    /// @param bytes  State of the same time.
    void restore(const Structure& made_of, std::span<const std::byte> bytes);
    /// Copy the state of a world with equal definitions, such as a twin (World::twin()).
    /// @throws DefError if the definitions differ.
    void copy_from(const World& other);
};

}  // namespace hawser
