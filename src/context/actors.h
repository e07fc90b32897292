// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file actors.h
/// The systems of a world (hawser/system.h) as a step sees them.

#include <hawser/stats.h>

namespace hawser::stepper {

struct StepContext;

class Actors {
  public:
    /// Each acts once, in order; loads and inputs go to the context. Before anything changes, their
    /// states are kept. @return ok, or what ends the step.
    [[nodiscard]] virtual Status act(StepContext& ctx) noexcept = 0;
    /// The step is done: what was kept is no longer needed.
    virtual void accept(StepContext& ctx) noexcept = 0;
    /// The step has failed: states of systems, inputs, and what waking disturbed are as they were.
    virtual void go_back(StepContext& ctx) noexcept = 0;

  protected:
    ~Actors() = default;
};

}  // namespace hawser::stepper
