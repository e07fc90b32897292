// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file timing.h
/// Clock and median of the comparison.

#include <algorithm>
#include <ctime>
#include <vector>

namespace hawser::bench {

/// Return the processor time of this thread [s], which other load of the machine does not change.
inline double thread_seconds() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// Return the median, the larger of the two middle values if their number is even; 0 if empty.
inline double median(std::vector<double> v) {
    if (v.empty()) return 0.0;
    std::nth_element(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2), v.end());
    return v[v.size() / 2];
}

}  // namespace hawser::bench
