// SPDX-License-Identifier: Apache-2.0
/// Part of the loads of a body that belongs to water (Energy::water). Loads of all systems are
/// summed in one entry per body. If water alone loads it, the entry belongs to water. Otherwise the
/// part of water is the difference of two sums. They are sampled when the water system begins and
/// when the next one begins.
#include "assembly/load_matrix.h"
#include "assembly/loads.h"
#include "base/index.h"

#include <algorithm>
#include <new>

namespace hawser::assembly {

bool LoadStore::needs_shared(std::size_t entry) const noexcept {
    return sources_[entry] != kNobody && (last_water_[entry] != 0) != water_now_ &&
           shared_of_[entry] < 0;
}

bool LoadStore::make_shared(std::size_t entry) noexcept {
    try {
        shared_.emplace_back();
    } catch (const std::bad_alloc&) {
        out_of_memory_ = true;
        return false;
    }
    shared_of_[entry] = static_cast<std::int32_t>(shared_.size() - 1);
    return true;
}

void LoadStore::note_source(std::size_t entry) noexcept {
    const std::uint8_t source = water_now_ ? kWater : kOther;
    if (sources_[entry] != kNobody && (last_water_[entry] != 0) != water_now_) {
        Shared& s = shared_[at(shared_of_[entry])];
        const Entry& e = entries_[entry];
        const double* all = &data_[at(e.place)];
        const int n = e.freedom + 3 * entries_of(e.freedom);
        const bool second = sources_[entry] == (kOther | kWater);
        if (!second) std::fill_n(s.water, n, 0.0);
        // the water system was the first
        if (!second && !water_now_) std::fill_n(s.before, n, 0.0);
        if (water_now_)
            std::copy_n(all, n, s.before);
        else
            for (int i = 0; i < n; ++i) s.water[i] += all[i] - s.before[i];
    }
    sources_[entry] |= source;
    last_water_[entry] = water_now_ ? 1 : 0;
}

void LoadStore::finish_water(std::size_t entry) noexcept {
    if (sources_[entry] != (kOther | kWater) || last_water_[entry] == 0) return;
    Shared& s = shared_[at(shared_of_[entry])];
    const Entry& e = entries_[entry];
    const double* all = &data_[at(e.place)];
    for (int i = 0; i < e.freedom + 3 * entries_of(e.freedom); ++i)
        s.water[i] += all[i] - s.before[i];
}

const double* LoadStore::water_of(std::size_t entry) const noexcept {
    if ((sources_[entry] & kWater) == 0) return nullptr;
    if (sources_[entry] == kWater) return &data_[at(entries_[entry].place)];
    return shared_[at(shared_of_[entry])].water;
}

}  // namespace hawser::assembly
