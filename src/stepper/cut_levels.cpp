// SPDX-License-Identifier: Apache-2.0
#include "stepper/cut_levels.h"

#include "assembly/parts.h"
#include "base/index.h"
#include "stepper/context.h"
#include "stepper/regroup.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace hawser::stepper {
namespace {

/// What cutting each interface costs by the last step's forces, velocities and violations.
std::vector<double> interface_weights(StepContext& ctx) {
    assembly::PartGraph g;
    read_graph(ctx, g);
    weigh_graph(ctx, g);
    std::vector<double> weight(at(ctx.cuts.interfaces), 0.0);
    for (const Cut& c : ctx.cuts.list) {
        if (ctx.cuts.coupling[at(c.id)] != Coupling::deadline) continue;
        double sum = g.edge_weight[at(c.id)];
        for (std::int32_t k = g.begin[at(c.id)]; k < g.begin[at(c.id) + 1]; ++k)
            sum += g.node_weight[at(g.members[at(k)])];
        weight[at(c.interface)] += sum;
    }
    return weight;
}

/// The work of the matrix with these interfaces cut.
double analysed_work(StepContext& ctx, std::uint64_t interfaces) {
    ctx.undo.keep(ctx, Undo::Depth::system);
    const std::uint64_t asked = std::exchange(ctx.cuts.asked, interfaces);
    assembly::System beside;
    beside.most_bytes = ctx.def.max_memory;
    (void)open_cuts(ctx);
    beside.left_out = ctx.system.left_out;
    beside.sides = ctx.system.sides;
    ctx.cuts.asked = asked;
    (void)open_cuts(ctx);
    beside.contacts = ctx.system.contacts;
    model::Interactions rows = ctx.interactions;  // an analysis chooses forms
    beside.analyse(ctx.bodies, rows, ctx.def, ctx.pool.threads());
    return matrix_work(static_cast<double>(beside.symbolic.flops),
                       static_cast<double>(beside.symbolic.factor_nnz));
}

}  // namespace

std::vector<CutLevels::Level> find_cut_levels(StepContext& ctx) {
    const std::vector<double> weight = interface_weights(ctx);
    std::vector<int> order(weight.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return weight[at(a)] < weight[at(b)]; });
    std::vector<CutLevels::Level> levels{{0, analysed_work(ctx, 0)}};
    for (const int i : order) {
        const std::uint64_t interfaces = levels.back().interfaces | std::uint64_t{1} << i;
        levels.push_back({interfaces, analysed_work(ctx, interfaces)});
    }
    return levels;
}

void CutLevels::set(std::vector<Level> levels) {
    levels_ = std::move(levels);
    time_.resize(levels_.size());
    now_ = 0;
    since_ = 0;
    fresh_ = true;
}

std::size_t CutLevels::wanted(const std::vector<double>& time, double seconds) noexcept {
    if (time[now_] > seconds) {
        since_ = 0;
        std::size_t best = now_;
        for (std::size_t l = now_ + 1; l < time.size(); ++l) {
            if (time[l] < time[best]) best = l;
            if (time[l] <= seconds) break;
        }
        return time[best] <= kSaving * time[now_] ? best : now_;
    }
    std::size_t lower = 0;
    while (lower < now_ && time[lower] > kRoom * seconds) ++lower;
    since_ = lower < now_ ? since_ + 1 : 0;
    if (since_ < kStay) return now_;
    since_ = 0;
    return lower;
}

std::uint64_t CutLevels::choose(const Deadline& deadline, const Load& load, double seconds,
                                std::uint64_t asked) noexcept {
    if (levels_.size() < 2) return 0;
    // After a restore, or a step that was told what to cut, another one may be in force.
    for (std::size_t l = 0; l < levels_.size(); ++l) {
        if (levels_[l].interfaces != asked || l == now_) continue;
        now_ = l;
        fresh_ = true;
    }
    if (!deadline.settled()) return asked;
    const double sweeps = kRowWork * load.rows;
    const double matrix = load.matrix - sweeps, change = matrix - levels_[now_].matrix;
    // What comes and goes at the level in force (contacts) does so at the others.
    for (Level& l : levels_)
        if (!fresh_) l.matrix = std::max(0.0, l.matrix + change);
    levels_[now_].matrix = matrix;
    for (std::size_t l = 0; l < levels_.size(); ++l)
        time_[l] = deadline.predict({load.rows, levels_[l].matrix + sweeps}, 1);
    const std::size_t before = std::exchange(now_, wanted(time_, seconds));
    fresh_ = now_ != before;
    return levels_[now_].interfaces;
}

}  // namespace hawser::stepper
