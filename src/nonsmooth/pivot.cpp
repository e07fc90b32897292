// SPDX-License-Identifier: Apache-2.0
#include "nonsmooth/pivot.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace hawser::nonsmooth {

int pivot(std::span<const Cone> cones, std::span<Bound> rows, std::span<const double> limit,
          double floor, PivotProgress& progress) noexcept {
    const bool single = progress.trials == 0;
    int count = 0;
    for (std::size_t k = cones.size(); k-- > 0;) {
        Bound* at = &rows[3 * k];
        std::array<Bound, 3> wanted{};
        const int here = box_pivots(cones[k], at, limit[k], floor, wanted.data());
        if (here > 0 && !single) std::copy_n(wanted.data(), 3, at);
        for (std::size_t i = 3; single && count == 0 && here > 0 && i-- > 0;) {
            if (wanted[i] == at[i]) continue;
            at[i] = wanted[i];
            break;
        }
        count += here;
    }
    if (count < progress.best) {
        progress.best = count;
        progress.trials = kPivotTrials;
    } else if (progress.trials > 0) {
        --progress.trials;
    }
    return count;
}

}  // namespace hawser::nonsmooth
