// SPDX-License-Identifier: Apache-2.0
#include "passive_energy.h"

#include <algorithm>
#include <cmath>

namespace hawser::bench {

void PassiveEnergy::sample(const World& world) {
    const Energy e = world.energy();
    energy_.push_back(e.mechanical() - e.applied);
    kinetic_ = std::max(kinetic_, e.kinetic);
}

PassiveEnergy::Rise PassiveEnergy::largest(double step) const {
    constexpr double kLasting = 0.3;  // [s]
    Rise out;
    if (energy_.empty()) return out;
    const auto window = std::max<std::size_t>(5, static_cast<std::size_t>(kLasting / step + 0.5));
    const double lowest = *std::min_element(energy_.begin(), energy_.end());
    const double exchanged = std::max({1.0, kinetic_, energy_[0] - lowest});
    double least = energy_[0];
    for (std::size_t i = window; i < energy_.size(); ++i) {
        least = std::min(least, energy_[i - window]);
        const auto end = energy_.begin() + static_cast<std::ptrdiff_t>(i) + 1;
        const double rise =
            *std::min_element(end - static_cast<std::ptrdiff_t>(window), end) - least;
        if (!(rise > out.joules)) continue;
        out = {rise / exchanged, rise, static_cast<double>(i + 1) * step};
    }
    return out;
}

}  // namespace hawser::bench
