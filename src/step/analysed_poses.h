// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file analysed_poses.h
/// Analysis at the poses of the last analysis instead of the present ones.

#include "context/context.h"

namespace hawser::step {

/// Restores poses and active rows of the last analysis while it lives.
class AnalysedPoses {
  public:
    explicit AnalysedPoses(context::StepContext& ctx)
        : ctx_(ctx),
          x_(ctx.model.bodies.x),
          r_(ctx.model.bodies.r),
          active_(ctx.model.interactions.active) {
        ctx.model.bodies.x = ctx.state.analysed_x;
        ctx.model.bodies.r = ctx.state.analysed_r;
    }
    ~AnalysedPoses() {
        ctx_.model.bodies.x.swap(x_);
        ctx_.model.bodies.r.swap(r_);
        ctx_.model.interactions.active.swap(active_);
    }
    AnalysedPoses(const AnalysedPoses&) = delete;
    AnalysedPoses& operator=(const AnalysedPoses&) = delete;

  private:
    context::StepContext& ctx_;
    base::Array<double> x_, r_, active_;
};

}  // namespace hawser::step
