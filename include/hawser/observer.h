// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file observer.h
/// Watches a world step by step: what collects figures of a run, and what judges it.

#include <hawser/stats.h>

#include <span>
#include <string>

namespace hawser {

class World;

/// Is called before and after each step that is taken; a step that fails has no after_step().
/// Observers read and change nothing: whether one watches makes no difference to the run.
struct Observer {
    Observer() = default;
    Observer(const Observer&) = default;
    Observer& operator=(const Observer&) = default;
    Observer(Observer&&) = default;
    Observer& operator=(Observer&&) = default;
    virtual ~Observer() = default;

    virtual void before_step(const World&) {}
    /// @param events  Those of this step.
    virtual void after_step(const World&, std::span<const Event> events) = 0;
    /// What is wrong with the last step, in words, which ends the run; "": nothing.
    [[nodiscard]] virtual std::string objection() const { return {}; }
};

}  // namespace hawser
