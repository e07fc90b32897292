// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file model_undo.h
/// Copy of model and state before the first edit of a system within a step.
///
/// A failed step returns to the last good state (state/undo.h). That copy begins behind the edits.
/// This one restores the earlier bodies, interactions and shapes with their indices, multipliers
/// and memories. Only the data that determine the order of the analysed system are copied. It is
/// rebuilt before its next use, like that of a restored world, to the same bits (Mend::all).
///
/// Memory is kept between steps: after warm-up, a copy allocates only for long names. Cost: linear
/// in the size of the model, about that of the analysis that an edit needs.

#include "context/context.h"

#include <cstdint>
#include <vector>

namespace hawser::state {

class ModelUndo {
  public:
    /// Save the model and state.
    /// @throws std::bad_alloc.
    void keep(const context::StepContext& ctx);
    /// Restore the saved data. Call once after keep(), after the step has been undone
    /// (restore_saved_values()).
    void go_back(context::StepContext& ctx) noexcept;

  private:
    // Model.
    model::Bodies bodies_;
    model::Interactions interactions_;
    collide::Collider::Kept collider_;
    assembly::System::Kept system_;
    std::vector<std::int32_t> omitted_;
    std::vector<assembly::Sides> sides_;
    base::Array<assembly::ContactMemory> memory_;
    base::Array<assembly::ResistanceMemory> resistances_;
    std::vector<assembly::Contacts::Link> links_;
    std::vector<std::int64_t> link_used_;
    context::Cuts cuts_;
    context::Wires wires_;
    graph::Partition parts_;
    std::vector<std::int32_t> manual_groups_;
    std::int64_t made_ = 0, seen_ = -1;
    bool stale_ = true;
    std::int32_t grouped_interactions_ = 0;

    // State.
    context::Ledger ledger_;
    double work_ = 0.0, water_ = 0.0, added_ = 0.0;
    context::MonitorState monitor_;
    collide::ContactSet contacts_;
    base::Array<double> contact_impulse_;
    base::Array<std::uint8_t> contact_sliding_;
    base::Array<double> analysed_x_, analysed_r_;
    context::Changed changed_ = context::Changed::all;
    context::Edits edits_;
    context::PendingRepair repair_ = context::PendingRepair::nothing;
    std::array<std::int64_t, kEventKindCount> event_count_{};
    std::int32_t asleep_ = 0, contact_count_ = 0;
};

}  // namespace hawser::state
