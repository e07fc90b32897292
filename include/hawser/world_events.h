// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file world_events.h
/// Events of a world: World::events(). Kinds and fields: stats.h.

#include <hawser/facet.h>
#include <hawser/stats.h>

#include <cstdint>
#include <vector>

namespace hawser {

/// Reads the events of a world, for any number of readers.
class WorldEventsView : public Facet {
  public:
    explicit WorldEventsView(const World& world) noexcept : Facet(world) {}

    /// Read events from a reader's cursor on, oldest first, and advance it. 0 starts with the
    /// oldest stored event. Independent of WorldEvents::take().
    /// @param out  Its contents are replaced.
    /// @return the number of events lost since the cursor.
    /// @throws UseError, std::bad_alloc.
    std::uint64_t since(std::uint64_t& cursor, std::vector<Event>& out) const;
    /// Return the cursor after all events, for a reader that skips them.
    [[nodiscard]] std::uint64_t cursor() const noexcept;
    /// Return the count of a kind, its first and its worst event, independent of
    /// WorldEvents::take().
    [[nodiscard]] EventExtremes extremes(EventKind kind) const noexcept;
};

/// Reads and takes the events of a world.
class WorldEvents : public WorldEventsView {
  public:
    explicit WorldEvents(World& world) noexcept;

    /// Return events since the last call, oldest first: at most the newest 16,384 of slack and of
    /// taut each, and 4,096 of any other kind.
    /// @throws UseError, std::bad_alloc.
    [[nodiscard]] std::vector<Event> take();
};

}  // namespace hawser
