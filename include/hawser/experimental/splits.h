// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file splits.h
/// Splits of a world, World::splits(): approximate separate solutions of groups of bodies
/// (docs/theory/splits.md).
///
/// Each body belongs to a *group*. An interaction between two groups whose coupling is not exact is
/// a *cut*: each side solves it separately. Groups come from the user or from a partition
/// (partition.h). Experimental: names and behaviour may change in any version.
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

    /// Return the index of the group of each body. −1: the body is fixed, or has no group and the
    /// world chooses none (WorldDef::parts). If the world chooses groups, groups by hand have the
    /// lowest indices. The model is analysed first if it has changed.
    [[nodiscard]] std::vector<std::int32_t> groups() const;
    /// Return the coupling of an interaction, which applies if its bodies are in different groups.
    [[nodiscard]] Coupling coupling(InteractionId id) const;
    /// Return the cut interactions, ascending. The model is analysed first if it has changed.
    [[nodiscard]] std::vector<CutView> cuts() const;
    /// Compute a partition of the present state into parts of about equal cost (partition.h).
    /// @throws DefError on an invalid request.
    [[nodiscard]] PartitionView partition(const PartitionRequest& request) const;
};

/// Reads and sets the splits of a world.
class WorldSplits : public WorldSplitsView {
  public:
    explicit WorldSplits(World& world) noexcept : WorldSplitsView(world) {}

    /// Set the group of a body from the next step on (BodyDef::group).
    void set_group(BodyId id, const std::string& group);
    /// Set the groups of all bodies by a partition of the present state, once. The groups have the
    /// names "part 0", "part 1", …. Automatic updates of groups end.
    /// @param parts  Number of groups, 1 to 4096; 1: no cuts.
    void set_groups(int parts);
    /// Let the world choose and update the groups of all bodies without a group by hand, from the
    /// next step on. Sets WorldDef::parts and regroup_every.
    /// @param parts  Number of groups, 0 to 4096; 0: only groups by hand. An unchanged number keeps
    /// the
    ///        present groups.
    /// @param every  Steps between updates, 0 to 1,000,000; 0: no updates.
    /// @throws DefError if a number is out of range.
    void follow_groups(int parts, int every = 60);
    /// Set the coupling of an interaction from the next step on. It applies if the bodies of the
    /// interaction are in different groups. Initial value: WorldDef::coupling.
    /// @throws DefError for motors, friction and limits, which cannot be cut.
    void set_coupling(InteractionId id, Coupling coupling);

  private:
    void regroup_all(int parts);
};

inline WorldSplits World::splits() noexcept { return WorldSplits(*this); }
inline WorldSplitsView World::splits() const noexcept { return WorldSplitsView(*this); }

}  // namespace hawser
