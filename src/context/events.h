// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file events.h
/// Events of steps. Lines become slack and taut by the thousand, so other kinds have separate
/// capacity. The first and worst event of each kind are kept permanently.

#include <hawser/stats.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace hawser::context {

/// Events since the last take(): the newest of each kind, in memory of fixed size. After
/// construction only take() allocates.
class EventLog {
  public:
    /// Capacities: of slack and of taut each, and of any other kind.
    static constexpr std::size_t kFrequentCapacity = 16'384, kRareCapacity = 4'096;

    EventLog() {
        for (std::size_t k = 0; k < rings_.size(); ++k) {
            const auto kind = static_cast<EventKind>(k);
            const bool frequent = kind == EventKind::slack || kind == EventKind::taut;
            rings_[k].events.resize(frequent ? kFrequentCapacity : kRareCapacity);
        }
    }

    /// Defer events until release(), because their step may fail. At most `most` events are
    /// deferred. @throws std::bad_alloc.
    void hold_back(std::size_t most) {
        pending_.clear();
        pending_.reserve(most);
        is_holding_ = true;
    }
    /// Log the deferred events if the step succeeded; otherwise discard them.
    void release(bool happened) noexcept {
        if (!is_holding_) return;
        is_holding_ = false;
        for (std::size_t k = 0; happened && k < pending_.size(); ++k) push(pending_[k]);
        pending_.clear();
    }

    void push(const Event& event) noexcept {
        if (is_holding_ && pending_.size() < pending_.capacity()) {
            pending_.push_back(event);
            return;
        }
        Ring& ring = rings_[static_cast<std::size_t>(event.kind)];
        ring.events[static_cast<std::size_t>(ring.extremes.count) % ring.events.size()] = {total_++,
                                                                                           event};
        EventExtremes& extremes = ring.extremes;
        if (extremes.count++ == 0) extremes.first = extremes.worst = event;
        if (std::abs(event.value) > std::abs(extremes.worst.value)) extremes.worst = event;
    }

    /// Return the events since the last call, oldest first.
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

    /// Copy events from number `cursor` on, oldest first, and advance the cursor.
    /// @return the number of lost events.
    /// @throws std::bad_alloc; then only `out` has changed.
    std::uint64_t since(std::uint64_t& cursor, std::vector<Event>& out) const {
        out.clear();
        const auto total = static_cast<std::uint64_t>(total_);
        const auto from = static_cast<std::int64_t>(std::min(cursor, total));
        // Each kind's ring is ascending: the smallest of their next numbers follows.
        std::array<std::int64_t, kEventKindCount> next{};
        std::size_t found = 0;
        for (std::size_t k = 0; k < rings_.size(); ++k) {
            const Ring& ring = rings_[k];
            const auto size = static_cast<std::int64_t>(ring.events.size());
            const std::int64_t end = ring.extremes.count,
                               begin = std::max<std::int64_t>(0, end - size);
            std::int64_t low = begin, high = end;
            while (low < high) {
                const std::int64_t middle = low + (high - low) / 2;
                (ring.at(middle).number < from ? low : high) =
                    ring.at(middle).number < from ? middle + 1 : middle;
            }
            next[k] = low;
            found += static_cast<std::size_t>(end - low);
        }
        out.reserve(found);
        while (out.size() < found) {
            std::size_t least = rings_.size();
            for (std::size_t k = 0; k < rings_.size(); ++k)
                if (next[k] < rings_[k].extremes.count &&
                    (least == rings_.size() ||
                     rings_[k].at(next[k]).number < rings_[least].at(next[least]).number))
                    least = k;
            out.push_back(rings_[least].at(next[least]++).event);
        }
        const std::uint64_t lost = total - static_cast<std::uint64_t>(from) - found;
        cursor = total;
        return lost;
    }
    /// Return the number of events since the start, including those no longer stored.
    [[nodiscard]] std::uint64_t count() const noexcept {
        return static_cast<std::uint64_t>(total_);
    }

    [[nodiscard]] const EventExtremes& extremes(EventKind kind) const noexcept {
        return rings_[static_cast<std::size_t>(kind)].extremes;
    }

  private:
    struct Numbered {
        std::int64_t number = 0;  ///< Number among all kinds, in the order of occurrence.
        Event event;
    };
    struct Ring {
        std::vector<Numbered> events;
        EventExtremes extremes;
        std::int64_t taken = 0;
        /// Return the i-th event of its kind, which must still be stored.
        [[nodiscard]] const Numbered& at(std::int64_t i) const noexcept {
            return events[static_cast<std::size_t>(i) % events.size()];
        }
    };
    std::array<Ring, kEventKindCount> rings_;
    std::vector<Event> pending_;
    bool is_holding_ = false;
    std::int64_t total_ = 0;
};

}  // namespace hawser::context
