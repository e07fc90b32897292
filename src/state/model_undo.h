// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file model_undo.h
/// Copy of model and state from before the first edit that a system makes within a step.
///
/// A step that fails returns to the last good state (state/undo.h). That copy begins behind the
/// edits; this one brings back the bodies, interactions and shapes of before, with their indices,
/// multipliers and memories. The analysed system is not copied but for what its order goes on from:
/// it is rebuilt before its next use, like that of a restored world, to the same bits (Mend::all).
///
/// Memory is kept from step to step: once warm, a copy allocates nothing but long names.
/// Cost: linear in the size of the model, about as much as the analysis that an edit needs.

#include "context/context.h"

#include <cstdint>
#include <vector>

namespace hawser::stepper {

class ModelUndo {
  public:
    /// Copy. @throws std::bad_alloc.
    void keep(const StepContext& ctx);
    /// Put the copy back. Call once after keep(), when the step has gone back (restore_kept()).
    void go_back(StepContext& ctx) noexcept;

  private:
    // Model.
    model::Bodies bodies_;
    model::Interactions interactions_;
    collide::Collider::Kept collider_;
    assembly::System::Kept system_;
    std::vector<std::int32_t> left_out_;
    std::vector<assembly::Sides> sides_;
    base::Array<assembly::ContactMemory> memory_;
    base::Array<assembly::ResistanceMemory> resistances_;
    std::vector<assembly::Contacts::Link> links_;
    std::vector<std::int64_t> link_used_;
    Cuts cuts_;
    Wires wires_;
    graph::Partition parts_;
    std::vector<std::int32_t> by_hand_;
    std::int64_t made_ = 0, seen_ = -1;
    bool stale_ = true;
    std::int32_t grouped_interactions_ = 0;

    // State.
    Ledger ledger_;
    double work_ = 0.0, water_ = 0.0, added_ = 0.0;
    JudgeState judge_;
    collide::ContactSet contacts_;
    base::Array<double> contact_impulse_;
    base::Array<std::uint8_t> contact_sliding_;
    base::Array<double> analysed_x_, analysed_r_;
    Changed changed_ = Changed::all;
    Edits edits_;
    Mend mend_ = Mend::nothing;
    std::array<std::int64_t, kEventKindCount> event_count_{};
    std::int32_t asleep_ = 0, contact_count_ = 0;
};

}  // namespace hawser::stepper
