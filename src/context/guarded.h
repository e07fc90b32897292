// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file guarded.h
/// Run the parts of a step that allocate, and end the step if allocation fails.

#include "context/context.h"

#include <new>

namespace hawser::context {

/// Call f(), which may throw std::bad_alloc or LimitError, and return its status.
template <class F>
Status guarded(StepContext& ctx, F&& f) noexcept {
    try {
        f();
    } catch (const std::bad_alloc&) {
        return Status::out_of_memory;
    } catch (const LimitError& error) {
        ctx.work.stats.bound_met = error.met();
        return Status::over_bound;
    }
    return Status::ok;
}

}  // namespace hawser::context
