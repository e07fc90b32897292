// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file observer.h
/// Observers of the steps of a world, which collect figures of a run or check it.
/// Session::observe() adds one to a session.

#include <hawser/stats.h>

#include <span>
#include <string>

namespace hawser {

class World;

/// Interface with functions that are called before and after each step. After a failed step,
/// after_step() is not called. Observers must not change the world, so that runs with and without
/// them are equal.
struct Observer {
    Observer() = default;
    Observer(const Observer&) = default;
    Observer& operator=(const Observer&) = default;
    Observer(Observer&&) = default;
    Observer& operator=(Observer&&) = default;
    virtual ~Observer() = default;

    /// Called before each step. Read here the state that after_step() compares with.
    virtual void before_step(const World&) {}
    /// Process a completed step.
    /// @param events  Events of this step.
    virtual void after_step(const World&, std::span<const Event> events) = 0;
    /// Return a fault of the last step in words, which rejects the step and ends the run; "": none.
    [[nodiscard]] virtual std::string objection() const { return {}; }
};

}  // namespace hawser
