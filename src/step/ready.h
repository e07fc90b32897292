// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file ready.h
/// Preparation of the system for the state, before a step or between steps. The system is rebuilt
/// after a failed step, and additions are analysed, all or nothing (undo.h).

#include "context/context.h"

namespace hawser::step {

/// Analyse the system as ctx.state.repair requires. The state does not change, not even after a
/// failure. @throws std::bad_alloc, LimitError.
void repair(context::StepContext& ctx);

/// Update the analysed system to the state: rebuild it after a failed step, and analyse additions.
/// An undo copy is saved first. @throws std::bad_alloc, LimitError.
void make_ready(context::StepContext& ctx);

/// Restores the saved state on destruction without done(). If nested, the outer one does it.
class Transaction {
  public:
    explicit Transaction(context::StepContext& ctx) noexcept;
    ~Transaction();
    Transaction(const Transaction&) = delete;
    Transaction& operator=(const Transaction&) = delete;
    void done() noexcept;

  private:
    context::StepContext& ctx_;
    bool done_;
};

/// Call make_ready() between steps. After an exception nothing has changed. @throws std::bad_alloc,
/// LimitError.
void ready(context::StepContext& ctx);

}  // namespace hawser::step
