// SPDX-License-Identifier: Apache-2.0
#include "solve/evaluate.h"

#include "access/rows.h"
#include "access/view.h"

namespace hawser::stepper {

void evaluate_strip(StepContext& ctx, const assembly::View& v, int strip) noexcept {
    for (const assembly::PoolRange& r : ctx.model.system.strips.pools(strip)) {
        const model::Pool& pool = ctx.model.interactions.pool[static_cast<std::size_t>(r.kind)];
        assembly::kernels().evaluate(v, r.kind, pool.ids.data(), pool.data.data(), r.begin, r.end);
    }
}

void evaluate_rows(StepContext& ctx) noexcept {
    assembly::View v = view(ctx);
    v.v_start = nullptr;  // nothing is solved
    auto strip = [&](int i, int) noexcept { evaluate_strip(ctx, v, i); };
    ctx.pool.for_each(ctx.model.system.strips.count(), strip);
}

void evaluate_keeping_ranges(StepContext& ctx) noexcept {
    const KeptRanges kept(ctx.work.before.active, ctx.model.interactions.active.data(),
                          ctx.model.system.bounded);
    evaluate_rows(ctx);
}

}  // namespace hawser::stepper
