// SPDX-License-Identifier: Apache-2.0
#include "solve/factor.h"

#include "base/index.h"
#include "context/view.h"
#include "solve/capstans.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace hawser::solve {
namespace {

using assembly::View;

/// Writes the matrix piece by piece, or its dirty part.
struct Writer {
    const assembly::System& system;
    const View& view;
    static void write(void* self, int piece, double* panel) noexcept {
        const Writer& w = *static_cast<Writer*>(self);
        w.system.write_blocks(w.view, piece, panel);
    }
    static void skew(void* self, int piece, double* panel, double* upper) noexcept {
        const Writer& w = *static_cast<Writer*>(self);
        // Without contacts, blocks have the laws of earlier contacts.
        if (w.system.contacts.count() > 0) w.system.write_skew(w.view, piece, upper);
        w.system.write_capstans(piece, panel, upper);
    }
};

/// List the nodes of the matrix columns that contain a marked contact block.
void collect_columns(const assembly::System& s, const std::vector<std::uint8_t>& marks,
                     std::vector<std::int32_t>& columns) noexcept {
    columns.clear();
    for (std::size_t k = 0; k < marks.size(); ++k)
        if (marks[k]) columns.push_back(s.column_of(s.contacts.blocks[k]));
}

/// Add the nodes of rows that became active or inactive since the matrix was factored.
void add_switched_rows(const context::Model& model, const std::vector<double>& factored,
                       std::vector<std::int32_t>& columns) noexcept {
    const assembly::System& s = model.system;
    const model::Interactions& in = model.interactions;
    for (std::size_t i = 0; i < s.bounded.size(); ++i) {
        const std::int32_t id = s.bounded[i];
        if (in.active[at(id)] == factored[i]) continue;
        const std::int32_t* body = &in.body[kMaxInteractionBodies * at(id)];
        for (int j = 0; j < in.bodies[at(id)]; ++j)
            if (const std::int32_t node = s.node_of_body[at(body[j])]; node >= 0)
                columns.push_back(node);
        if (const std::int32_t node = s.node_of_interaction[at(id)]; node >= 0)
            columns.push_back(node);
    }
}

void keep_factored(const context::Model& model, std::vector<double>& factored) noexcept {
    for (std::size_t i = 0; i < factored.size(); ++i)
        factored[i] = model.interactions.active[at(model.system.bounded[i])];
}

/// Return true if wrong pivots make a factorisation fail. Wrong pivots that sliding contacts can
/// cause do not (factor/unsymmetric.h).
bool is_singular(const factor::Numeric& numeric, int wrong) noexcept {
    return wrong > 0 && numeric.nodes_with_wrong_pivots().empty();
}

}  // namespace

std::size_t max_columns(const context::Model& model) noexcept {
    const assembly::System& s = model.system;
    std::size_t rows = 0;
    for (const std::int32_t id : s.bounded) rows += at(model.interactions.bodies[at(id)]) + 1;
    return s.contacts.blocks.size() + std::max(rows, s.capstan_entries.size());
}

Status factor(context::StepContext& ctx, bool whole) noexcept {
    if (ctx.pool.stopping()) return Status::cancelled;
    const View v = context::view(ctx);
    assembly::System& s = ctx.model.system;
    ++ctx.work.stats.factorisations;
    ctx.work.solve.rhs_ready = false;
    const factor::Unsymmetric* set = nullptr;
    const bool runs = couple_capstans(ctx.model);
    if (s.contacts.count() > 0 || runs) {
        ctx.work.solve.columns.clear();
        if (s.contacts.count() > 0)
            collect_columns(s, s.contacts.block_skew, ctx.work.solve.columns);
        for (const assembly::CapstanEntry& e : s.capstan_entries)
            if (e.value != 0.0) ctx.work.solve.columns.push_back(e.column);
        s.unsymmetric.find(s.symbolic, ctx.work.solve.columns);
        set = &s.unsymmetric;
    }
    const std::int64_t all = set ? set->flops : s.symbolic.flops;
    if (!whole && !ctx.work.solve.factor_whole && set && !runs) {
        collect_columns(s, s.contacts.block_changed, ctx.work.solve.columns);
        add_switched_rows(ctx.model, ctx.work.solve.factored_active, ctx.work.solve.columns);
        s.dirty.find(s.symbolic, ctx.work.solve.columns, set);
        // Above this fraction, one pass through memory takes less time than fewer flops.
        constexpr double kMaxPartialFlops = 0.7;
        if (static_cast<double>(s.dirty.flops) < kMaxPartialFlops * static_cast<double>(all)) {
            ctx.work.solve.step_flops += s.dirty.flops;
            keep_factored(ctx.model, ctx.work.solve.factored_active);
            ++ctx.work.stats.substitutions;
            ++ctx.work.stats.partial_factorisations;
            s.numeric.clear(s.symbolic, s.dirty, ctx.pool);
            s.write_blocks(v, s.dirty, s.numeric.values(), ctx.pool);
            s.numeric.copy_to_upper(s.symbolic, s.dirty, *set, ctx.pool);
            s.write_skew(v, s.dirty, s.numeric.upper(), ctx.pool);
            if (is_singular(s.numeric, s.numeric.refactor(s.symbolic, s.dirty, ctx.pool, set)))
                return Status::wrong_pivot;
            s.numeric.solve(s.symbolic, v.solution, ctx.pool);
            return Status::ok;
        }
    }
    ctx.work.solve.step_flops += all;
    keep_factored(ctx.model, ctx.work.solve.factored_active);
    ++ctx.work.stats.substitutions;
    Writer writer{s, v};
    const factor::Fill fill{Writer::write, &writer, Writer::skew};
    if (is_singular(s.numeric,
                    s.numeric.factor_forward(s.symbolic, fill, v.solution, ctx.pool, set)))
        return Status::wrong_pivot;
    s.numeric.backward(s.symbolic, v.solution, ctx.pool);
    return Status::ok;
}

}  // namespace hawser::solve
