// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file world_events.h
/// Events of a world, World::events(): incidents in steps, such as a broken line or a motor at its
/// limit. Kinds and fields: stats.h.
///
/// ```cpp
/// std::uint64_t cursor = world.events().cursor();      // from now on
/// std::vector<hawser::Event> events;
/// world.step();
/// world.events().since(cursor, events);
/// ```
/// A world stores a limited number of events: WorldEvents::take(). Readers with a cursor are
/// independent of each other and of take().

#include <hawser/facet.h>
#include <hawser/stats.h>

#include <cstdint>
#include <vector>

namespace hawser {

/// Reads the events of a world, for any number of readers.
class WorldEventsView : public Facet {
  public:
    explicit WorldEventsView(const World& world) noexcept : Facet(world) {}

    /// Read the events since a cursor, oldest first, and advance the cursor.
    /// @param cursor  Cursor of the reader; 0: starts with the oldest stored event.
    /// @param out  Receives the events; its contents are replaced.
    /// @return the number of events since the cursor that were lost, because newer ones replaced
    /// them.
    /// @throws UseError, std::bad_alloc.
    std::uint64_t since(std::uint64_t& cursor, std::vector<Event>& out) const;
    /// Return the cursor behind the newest event, for a reader that skips earlier events.
    [[nodiscard]] std::uint64_t cursor() const noexcept;
    /// Return the number of events of a kind, its first and its worst event.
    [[nodiscard]] EventExtremes extremes(EventKind kind) const noexcept;
};

/// Reads and removes the events of a world.
class WorldEvents : public WorldEventsView {
  public:
    explicit WorldEvents(World& world) noexcept;

    /// Return the events since the last call, oldest first. A world stores the newest 16,384 events
    /// of the kinds slack and taut each, and the newest 4,096 of any other kind; older ones are
    /// lost.
    /// @throws UseError, std::bad_alloc.
    [[nodiscard]] std::vector<Event> take();
};

}  // namespace hawser
