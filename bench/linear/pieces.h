// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file pieces.h
/// Run a loop as tasks.

#include "base/executor.h"

#include <algorithm>
#include <cstdint>

namespace hawser::bench {

/// Call work(begin, end) on pieces of [0, count) of at least `least` each; one piece with one
/// thread. Pieces should take microseconds: starting a loop takes one.
template <class F>
void in_pieces(std::int64_t count, base::Executor& executor, F work, std::int64_t least = 1) {
    int pieces = executor.threads() == 1 ? 1 : 16 * executor.threads();
    if (count < pieces * least) pieces = static_cast<int>(std::max<std::int64_t>(count / least, 1));
    if (pieces == 1) {
        work(std::int64_t{0}, count);
        return;
    }
    auto task = [&](int i, int) noexcept { work(count * i / pieces, count * (i + 1) / pieces); };
    executor.for_each(pieces, task);
}

}  // namespace hawser::bench
