// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file pieces.h
/// A loop as tasks.

#include "base/executor.h"

#include <cstdint>

namespace hawser::bench {

/// Call work(begin, end) on pieces of [0, count); one piece where there is one thread.
template <class F>
void in_pieces(std::int64_t count, base::Executor& executor, F work) {
    const int pieces = executor.threads() == 1 ? 1 : 16 * executor.threads();
    auto task = [&](int i, int) noexcept { work(count * i / pieces, count * (i + 1) / pieces); };
    executor.for_each(pieces, task);
}

}  // namespace hawser::bench
