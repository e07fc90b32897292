// SPDX-License-Identifier: Apache-2.0
#include "step/ready.h"

#include "access/asleep.h"
#include "access/undo.h"
#include "context/undo_data.h"
#include "split/split.h"
#include "step/prepare.h"

#include <utility>

namespace hawser::stepper {
namespace {

/// Poses and which rows are active are those of an analysis for as long as this lives.
class AnalysedPoses {
  public:
    explicit AnalysedPoses(StepContext& ctx)
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
    StepContext& ctx_;
    base::Array<double> x_, r_, active_;
};

}  // namespace

void mend(StepContext& ctx) {
    if (ctx.state.mend == Mend::nothing) return;
    assembly::System::Kept before;
    ctx.model.system.keep(before);
    try {
        const factor::AnalysisState order = before.analysis.state;
        ctx.model.system.contacts.make_blocks();
        const AnalysedPoses poses(ctx);
        analyse(ctx, ctx.state.mend == Mend::rebuild ? &order : nullptr);
    } catch (...) {
        ctx.model.system.go_back(before);
        throw;
    }
    reserve_sleep(ctx.model, ctx.work.sleep);
    ctx.work.before.lambda.resize(ctx.model.interactions.lambda.size());
    ctx.work.before.repeats.resize(ctx.model.interactions.repeats.size());
    reserve_undo(ctx.model, ctx.work.undo);
    ctx.state.mend = Mend::nothing;
}

void make_ready(StepContext& ctx) {
    if (ctx.state.changed != Changed::nothing) {
        keep_state(ctx, may_split(ctx.model) ? Undo::Depth::model : Undo::Depth::system);
        prepare(ctx);
        ctx.state.mend = Mend::nothing;
    } else {
        mend(ctx);
    }
}

Transaction::Transaction(StepContext& ctx) noexcept : ctx_(ctx), done_(ctx.work.undo.holds()) {}

Transaction::~Transaction() {
    if (!done_) restore_kept(ctx_);
}

void Transaction::done() noexcept {
    if (!done_) {
        drop_kept(ctx_.work.undo);
        ctx_.state.edits.clear();
    }
    done_ = true;
}

void ready(StepContext& ctx) {
    if (ctx.state.changed == Changed::nothing && ctx.state.mend == Mend::nothing) return;
    Transaction all(ctx);
    make_ready(ctx);
    all.done();
}

}  // namespace hawser::stepper
