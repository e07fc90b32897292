// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file ready.h
/// The system as the state needs it, before a step or between steps: what a failed step left is
/// mended, what is new is prepared, all or nothing (undo.h).

#include "context/context.h"

namespace hawser::stepper {

/// Analyse as ctx.state.mend says. The state stays as it is, whatever happens. @throws
/// std::bad_alloc, LimitError.
void mend(StepContext& ctx);

/// Have the system be one for the state: mend what failed, prepare what is new. What changes is
/// kept first. @throws std::bad_alloc, LimitError.
void make_ready(StepContext& ctx);

/// Goes back where it is left without done(); within another one, that one does.
class Transaction {
  public:
    explicit Transaction(StepContext& ctx) noexcept;
    ~Transaction();
    Transaction(const Transaction&) = delete;
    Transaction& operator=(const Transaction&) = delete;
    void done() noexcept;

  private:
    StepContext& ctx_;
    bool done_;
};

/// make_ready(), all or nothing, between steps. @throws std::bad_alloc, LimitError.
void ready(StepContext& ctx);

}  // namespace hawser::stepper
