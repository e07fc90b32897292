// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file places.h
/// Slots for objects that are added and removed. An object keeps its slot until it is
/// removed. The next object that fits reuses a vacated slot with a new generation (hawser/id.h).
///
/// The first vacant slot is reused, so that slots depend only on the order of additions and
/// removals.

#include "base/index.h"
#include "base/memory.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace hawser::base {

class Slots {
  public:
    [[nodiscard]] std::int32_t count() const noexcept {
        return static_cast<std::int32_t>(generation_.size());
    }
    /// True if the index `place` is in range and its slot is occupied.
    [[nodiscard]] bool holds(std::int32_t place) const noexcept {
        return place >= 0 && place < count() &&
               !std::binary_search(vacant_.begin(), vacant_.end(), place);
    }
    [[nodiscard]] std::int32_t generation(std::int32_t place) const noexcept {
        return place >= 0 && place < count() ? generation_[at(place)] : 0;
    }
    /// True if an id refers to the object that occupies its slot now.
    template <class Id>
    [[nodiscard]] bool names(const Id& id) const noexcept {
        return holds(id.index) && generation_[at(id.index)] == id.generation;
    }
    template <class Id>
    [[nodiscard]] Id id(std::int32_t place) const noexcept {
        return Id{place, generation(place)};
    }

    /// Reserve capacity so that append() and vacate() do not throw. @throws std::bad_alloc.
    void reserve_more() {
        base::reserve_more(generation_, 1);
        if (vacant_.capacity() <= generation_.size()) vacant_.reserve(generation_.capacity());
    }
    /// Append a slot and return its index.
    std::int32_t append() {
        generation_.push_back(0);
        return count() - 1;
    }
    /// Return the first vacant slot for which `fits` is true; −1 if there is none.
    template <class F>
    [[nodiscard]] std::int32_t find_vacant(F&& fits) const noexcept {
        const auto found = std::find_if(vacant_.begin(), vacant_.end(), fits);
        return found == vacant_.end() ? -1 : *found;
    }
    /// Mark a vacant slot as occupied.
    void take(std::int32_t place) noexcept {
        vacant_.erase(std::lower_bound(vacant_.begin(), vacant_.end(), place));
    }
    /// Mark a slot as vacant and increment its generation.
    void vacate(std::int32_t place) noexcept {
        vacant_.insert(std::lower_bound(vacant_.begin(), vacant_.end(), place), place);
        ++generation_[at(place)];
    }
    /// Undo the increment of the generation by vacate().
    void undo_vacate(std::int32_t place) noexcept { --generation_[at(place)]; }
    /// Copy the generation counters of another list, for the slots that both lists have.
    void set_generations(const std::vector<std::int32_t>& from) noexcept {
        std::copy_n(from.begin(), std::min(from.size(), generation_.size()), generation_.begin());
    }
    /// Remove all slots with an index ≥ `kept`.
    void truncate(std::int32_t kept) noexcept {
        generation_.resize(at(kept));
        vacant_.erase(std::lower_bound(vacant_.begin(), vacant_.end(), kept), vacant_.end());
    }

    [[nodiscard]] const std::vector<std::int32_t>& vacant() const noexcept { return vacant_; }
    [[nodiscard]] const std::vector<std::int32_t>& generations() const noexcept {
        return generation_;
    }
    [[nodiscard]] std::size_t bytes() const noexcept {
        return base::bytes(generation_) + base::bytes(vacant_);
    }

  private:
    std::vector<std::int32_t> generation_;  ///< Number of earlier objects, by slot.
    std::vector<std::int32_t> vacant_;      ///< Vacant slots, ascending.
};

}  // namespace hawser::base
