// SPDX-License-Identifier: Apache-2.0
#include "solve/evaluate.h"

#include "assembly/rows.h"
#include "context/view.h"

namespace hawser::solve {

void evaluate_block(const context::Model& model, const assembly::View& v, int strip) noexcept {
    for (const assembly::PoolRange& r : model.system.strips.pools(strip)) {
        const model::Pool& pool = model.interactions.pool[static_cast<std::size_t>(r.kind)];
        assembly::kernels().evaluate(v, r.kind, pool.ids.data(), pool.data.data(), r.begin, r.end);
    }
}

void evaluate_rows(context::Model& model, runtime::Pool& pool) noexcept {
    assembly::View v = context::row_view(model);
    v.v_start = nullptr;  // nothing is solved
    auto strip = [&](int i, int) noexcept { evaluate_block(model, v, i); };
    pool.for_each(model.system.strips.count(), strip);
}

void evaluate_keeping_ranges(context::Model& model, context::Before& before,
                             runtime::Pool& pool) noexcept {
    const assembly::KeptRanges kept(before.active, model.interactions.active.data(),
                                    model.system.bounded);
    evaluate_rows(model, pool);
}

}  // namespace hawser::solve
