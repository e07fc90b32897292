// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file actors.h
/// The systems of a world (hawser/system.h) in the interface of a step.

#include <hawser/stats.h>

namespace hawser::context {

struct StepContext;

class Actors {
  public:
    /// Run each system once, in order. Systems write loads and inputs to the context. Their states
    /// are saved before they change. @return ok, or the status that ends the step.
    [[nodiscard]] virtual Status act(StepContext& ctx) noexcept = 0;
    /// Discard the saved states after a successful step.
    virtual void accept(StepContext& ctx) noexcept = 0;
    /// Restore the states of systems, inputs, and sleeping bodies that were woken, after a failed
    /// step.
    virtual void go_back(StepContext& ctx) noexcept = 0;

  protected:
    ~Actors() = default;
};

}  // namespace hawser::context
