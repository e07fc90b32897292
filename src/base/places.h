// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file places.h
/// Places of things that come and go: a thing keeps its place for its life, a place that became
/// empty is taken by the next thing that fits, with another generation (hawser/id.h).
///
/// The first empty place is taken, so that places depend on what was added and removed in which
/// order and on nothing else.

#include "base/index.h"
#include "base/memory.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace hawser::base {

class Places {
  public:
    [[nodiscard]] std::int32_t count() const noexcept {
        return static_cast<std::int32_t>(generation_.size());
    }
    /// Whether a place exists and something is there.
    [[nodiscard]] bool holds(std::int32_t place) const noexcept {
        return place >= 0 && place < count() &&
               !std::binary_search(vacant_.begin(), vacant_.end(), place);
    }
    [[nodiscard]] std::int32_t generation(std::int32_t place) const noexcept {
        return place >= 0 && place < count() ? generation_[at(place)] : 0;
    }
    /// Whether an id names what is at its place now.
    template <class Id>
    [[nodiscard]] bool names(const Id& id) const noexcept {
        return holds(id.index) && generation_[at(id.index)] == id.generation;
    }
    template <class Id>
    [[nodiscard]] Id id(std::int32_t place) const noexcept {
        return Id{place, generation(place)};
    }

    /// So that append() and vacate() do not throw. @throws std::bad_alloc.
    void make_room() {
        base::make_room(generation_, 1);
        if (vacant_.capacity() <= generation_.size()) vacant_.reserve(generation_.capacity());
    }
    /// A new place behind all others.
    std::int32_t append() {
        generation_.push_back(0);
        return count() - 1;
    }
    /// First empty place that fits; −1: none. @param fits  Asked with a place.
    template <class F>
    [[nodiscard]] std::int32_t find_vacant(F&& fits) const noexcept {
        const auto found = std::find_if(vacant_.begin(), vacant_.end(), fits);
        return found == vacant_.end() ? -1 : *found;
    }
    /// An empty place is taken again.
    void take(std::int32_t place) noexcept {
        vacant_.erase(std::lower_bound(vacant_.begin(), vacant_.end(), place));
    }
    /// What was there is gone.
    void vacate(std::int32_t place) noexcept {
        vacant_.insert(std::lower_bound(vacant_.begin(), vacant_.end(), place), place);
        ++generation_[at(place)];
    }
    /// A vacate() is taken back as far as generations go: nothing was there in the end.
    void step_back(std::int32_t place) noexcept { --generation_[at(place)]; }
    /// Generations as elsewhere, of as many places.
    void set_generations(const std::vector<std::int32_t>& from) noexcept {
        std::copy_n(from.begin(), std::min(from.size(), generation_.size()), generation_.begin());
    }
    /// Take away the places from `kept` on.
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
    std::vector<std::int32_t> generation_;  ///< How many had the place before.
    std::vector<std::int32_t> vacant_;      ///< Empty places, ascending.
};

}  // namespace hawser::base
