// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file guarded.h
/// Parts of a step that need memory, and end the step where there is none.

#include "context/context.h"

#include <new>

namespace hawser::stepper {

/// The status of f(), which may throw std::bad_alloc and LimitError.
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

}  // namespace hawser::stepper
