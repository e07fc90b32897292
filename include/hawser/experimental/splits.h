// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file splits.h
/// Splits of a world: World::splits(). Groups of bodies, the coupling of interactions between
/// groups, and partitions (docs/theory/splits.md). Experimental: names and behaviour may change in
/// any version.
///
/// ```cpp
/// #include <hawser/experimental/splits.h>
/// world.splits().set_groups(4);                       // by a partition of the present state
/// for (const hawser::CutView& cut : world.splits().cuts()) …
/// ```
/// Functions throw DefError for an invalid id, and UseError for a world in use by another thread.

#include <hawser/def.h>
#include <hawser/experimental/partition.h>
#include <hawser/facet.h>
#include <hawser/id.h>
#include <hawser/inspect.h>
#include <hawser/world.h>

#include <cstdint>
#include <string>
#include <vector>

namespace hawser {

/// Reads the splits of a world.
class WorldSplitsView : public Facet {
  public:
    explicit WorldSplitsView(const World& world) noexcept : Facet(world) {}

    /// Return the group index of each body, −1: fixed, or without a group if the world chooses
    /// none. Groups by hand come first if it does. Analyses if needed.
    [[nodiscard]] std::vector<std::int32_t> groups() const;
    /// Return how an interaction couples bodies of different groups.
    [[nodiscard]] Coupling coupling(InteractionId id) const;
    /// Return the cut interactions, ascending. Analyses if needed.
    [[nodiscard]] std::vector<CutView> cuts() const;
    /// Return parts of about equal cost of the present state: partition.h.
    /// @throws DefError on an invalid request.
    [[nodiscard]] PartitionView partition(const PartitionRequest& request) const;
};

/// Reads and sets the splits of a world.
class WorldSplits : public WorldSplitsView {
  public:
    explicit WorldSplits(World& world) noexcept : WorldSplitsView(world) {}

    /// Set the group of a body from the next step on (BodyDef::group).
    void set_group(BodyId id, const std::string& group);
    /// Set the groups of all bodies by hand, from partition() for cuts of the present state: "part
    /// 0", "part 1", … This ends groups that follow the state.
    /// @param parts  1, which ends groups, to 4096.
    void set_groups(int parts);
    /// Let the world choose groups from the next step on, for all bodies without a group by hand,
    /// and follow the state: WorldDef::parts and regroup_every.
    /// @param parts  0 to 4096; 0 ends it: only groups by hand. An unchanged number keeps the
    ///        groups.
    /// @param every  0 to 1,000,000 steps.
    /// @throws DefError.
    void follow_groups(int parts, int every = 60);
    /// Set how an interaction couples bodies of different groups, from the next step on; initially
    /// WorldDef::coupling.
    /// @throws DefError for drives, friction and limits, which cannot be cut.
    void set_coupling(InteractionId id, Coupling coupling);

  private:
    void regroup_all(int parts);
};

inline WorldSplits World::splits() noexcept { return WorldSplits(*this); }
inline WorldSplitsView World::splits() const noexcept { return WorldSplitsView(*this); }

}  // namespace hawser
