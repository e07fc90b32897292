// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file events.h
/// What happened in steps. Lines that go slack and come taut do so by the thousand; what a user
/// must not miss has room of its own, and of each kind the first and the worst stay for good.

#include <hawser/stats.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace hawser::stepper {

/// Events since they were last taken: of each kind the newest, in memory of fixed size. Nothing is
/// allocated after the construction, but by take().
class EventLog {
  public:
    /// Of slack and taut each, and of any other kind.
    static constexpr std::size_t kFrequent = 16'384, kRare = 4'096;

    EventLog() {
        for (std::size_t k = 0; k < rings_.size(); ++k) {
            const auto kind = static_cast<EventKind>(k);
            const bool frequent = kind == EventKind::slack || kind == EventKind::taut;
            rings_[k].events.resize(frequent ? kFrequent : kRare);
        }
    }

    void push(const Event& event) noexcept {
        Ring& ring = rings_[static_cast<std::size_t>(event.kind)];
        ring.events[static_cast<std::size_t>(ring.extremes.count) % ring.events.size()] = {total_++,
                                                                                           event};
        EventExtremes& extremes = ring.extremes;
        if (extremes.count++ == 0) extremes.first = extremes.worst = event;
        if (std::abs(event.value) > std::abs(extremes.worst.value)) extremes.worst = event;
    }

    /// Events since the last call, oldest first.
    [[nodiscard]] std::vector<Event> take() {
        std::vector<Numbered> found;
        for (Ring& ring : rings_) {
            const auto size = static_cast<std::int64_t>(ring.events.size());
            const std::int64_t end = ring.extremes.count;
            for (std::int64_t i = std::max(ring.taken, end - size); i < end; ++i)
                found.push_back(ring.events[static_cast<std::size_t>(i % size)]);
            ring.taken = end;
        }
        std::sort(found.begin(), found.end(),
                  [](const Numbered& a, const Numbered& b) { return a.number < b.number; });
        std::vector<Event> out;
        out.reserve(found.size());
        for (const Numbered& one : found) out.push_back(one.event);
        return out;
    }

    [[nodiscard]] const EventExtremes& extremes(EventKind kind) const noexcept {
        return rings_[static_cast<std::size_t>(kind)].extremes;
    }

  private:
    struct Numbered {
        std::int64_t number = 0;  ///< Of all kinds, in the order in which they happened.
        Event event;
    };
    struct Ring {
        std::vector<Numbered> events;
        EventExtremes extremes;
        std::int64_t taken = 0;
    };
    std::array<Ring, kEventKindCount> rings_;
    std::int64_t total_ = 0;
};

}  // namespace hawser::stepper
