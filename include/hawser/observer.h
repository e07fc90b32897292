// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file observer.h
/// Observers of a world: collect figures of a run, or check it, step by step.

#include <hawser/stats.h>

#include <span>
#include <string>

namespace hawser {

class World;

/// Interface that is called before and after each step; after a failed step, after_step() is not
/// called. Observers must not change the world, so that runs with and without them are equal.
struct Observer {
    Observer() = default;
    Observer(const Observer&) = default;
    Observer& operator=(const Observer&) = default;
    Observer(Observer&&) = default;
    Observer& operator=(Observer&&) = default;
    virtual ~Observer() = default;

    /// Prepare for the step that follows.
    virtual void before_step(const World&) {}
    /// Process a completed step.
    /// @param events  Events of this step.
    virtual void after_step(const World&, std::span<const Event> events) = 0;
    /// Return the fault of the last step, which ends the run; "": none.
    [[nodiscard]] virtual std::string objection() const { return {}; }
};

}  // namespace hawser
