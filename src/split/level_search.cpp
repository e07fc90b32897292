// SPDX-License-Identifier: Apache-2.0
#include "split/level_search.h"

#include "assembly/parts.h"
#include "base/index.h"
#include "budget/cut_levels.h"
#include "budget/deadline.h"
#include "context/cuts_data.h"
#include "context/undo_data.h"
#include "split/split.h"
#include "state/undo.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace hawser::split {
namespace {

/// Return the cost of cutting each interface, from the forces, velocities and violations of the
/// last step.
std::vector<double> interface_weights(context::Model& model) {
    assembly::PartGraph g;
    read_graph(model, g);
    weigh_graph(model, g);
    std::vector<double> weight(at(model.cuts.interfaces), 0.0);
    for (const context::Cut& c : model.cuts.list) {
        if (model.cuts.coupling[at(c.id)] != Coupling::deadline) continue;
        double sum = g.edge_weight[at(c.id)];
        for (std::int32_t k = g.begin[at(c.id)]; k < g.begin[at(c.id) + 1]; ++k)
            sum += g.node_weight[at(g.members[at(k)])];
        weight[at(c.interface)] += sum;
    }
    return weight;
}

/// Return the work of the matrix if the given interfaces are cut [flops].
double analysed_work(context::StepContext& ctx, std::uint64_t interfaces) {
    state::save_state(ctx, context::Undo::Depth::system);
    assembly::System cut_system;
    cut_system.max_bytes = ctx.model.def.max_memory;
    remove_cut_interactions(ctx.model, interfaces, cut_system);
    cut_system.contacts = ctx.model.system.contacts;
    // a copy, because the analysis chooses the forms of rows
    model::Interactions rows = ctx.model.interactions;
    cut_system.analyse(ctx.model.bodies, rows, ctx.model.def, ctx.pool.threads());
    return budget::matrix_work(static_cast<double>(cut_system.symbolic.flops),
                               static_cast<double>(cut_system.symbolic.factor_nnz));
}

}  // namespace

std::vector<budget::CutLevels::Level> find_cut_levels(context::StepContext& ctx) {
    const std::vector<double> weight = interface_weights(ctx.model);
    std::vector<int> order(weight.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return weight[at(a)] < weight[at(b)]; });
    std::vector<budget::CutLevels::Level> levels{{0, analysed_work(ctx, 0)}};
    for (const int i : order) {
        const std::uint64_t interfaces = levels.back().interfaces | std::uint64_t{1} << i;
        levels.push_back({interfaces, analysed_work(ctx, interfaces)});
    }
    return levels;
}

}  // namespace hawser::split
