// SPDX-License-Identifier: Apache-2.0
#include "split/cuts.h"

#include "base/index.h"
#include "context/context.h"
#include "context/copies.h"
#include "context/cuts_data.h"
#include "split/clique.h"
#include "split/split.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <span>
#include <unordered_map>

namespace hawser::split {
namespace {

/// Return the groups of the moving bodies in the order of the slots, without duplicates.
std::vector<std::int32_t> groups_of_interaction(const context::Model& model, std::int32_t id) {
    std::vector<std::int32_t> sides;
    for (const std::int32_t b : context::bodies_of(model.interactions, id)) {
        if (model.bodies.dof(b) == 0) continue;
        const std::int32_t g = model.cuts.group[at(b)];
        if (std::find(sides.begin(), sides.end(), g) == sides.end()) sides.push_back(g);
    }
    return sides;
}

using GroupPair = std::pair<std::int32_t, std::int32_t>;

GroupPair pair_of(const std::vector<std::int32_t>& sides) {
    return {std::min(sides[0], sides[1]), std::max(sides[0], sides[1])};
}

/// Number the interfaces (pairs of groups) with cuts that a deadline may activate.
std::map<GroupPair, int> number_interfaces(context::Model& model,
                                           const std::vector<std::int32_t>& wanted) {
    std::map<GroupPair, int> number;
    for (const std::int32_t id : wanted)
        if (model.cuts.coupling[at(id)] == Coupling::deadline)
            number[pair_of(groups_of_interaction(model, id))];
    int next = 0;
    for (auto& each : number) each.second = std::min(next++, 63);
    model.cuts.interfaces = std::min(next, 64);
    return number;
}

/// Add a ghost body for a body. It is fixed, so that its motion does not count as driven.
std::int32_t add_ghost(context::Model& model, std::int32_t body) {
    model::Bodies& b = model.bodies;
    const double *x = &b.x[3 * at(body)], *q = &b.q[4 * at(body)];
    BodyDef def;
    def.kind = BodyKind::fixed;
    def.position = {x[0], x[1], x[2]};
    def.orientation = Quat(q[0], q[1], q[2], q[3]);
    model.cuts.ghosts.push_back({b.count(), body});
    return b.append(def);
}

/// Add the duplicate of an interaction for one side of a cut.
void add_copy(context::Model& model, std::int32_t id, std::int32_t side,
              std::unordered_map<std::int32_t, std::int32_t>& ghost) {
    model::Interactions& in = model.interactions;
    InteractionDef def = in.def[at(id)];
    def.name.clear();
    for (std::size_t b = 0; b < in.bodies[at(id)]; ++b) {
        const std::int32_t body = def.body[b].index;
        const int dof = model.bodies.dof(body);
        if (dof == 0 || model.cuts.group[at(body)] == side) continue;
        if (!ghost.contains(body)) ghost[body] = add_ghost(model, body);
        def.body[b] = BodyId{ghost[body]};
        if (dof < 6) def.point[b] = Vec3::Zero();  // a ghost body would have arms, a node has none
    }
    const int copy = in.append(def, model.bodies, model.def.step);
    const auto row = in.row_begin[at(id)], to = in.row_begin[at(copy)];
    std::copy_n(&in.lambda[at(row)], in.rows[at(id)], &in.lambda[at(to)]);
    in.active[at(copy)] = in.active[at(id)];
    in.parted[at(copy)] = in.parted[at(id)];
    model.cuts.of.push_back(id);
}

/// List the interactions that act on the originals of ghost bodies, including those outside the
/// system.
void list_pulls(context::Model& model) {
    const std::vector<context::GhostBody>& ghosts = model.cuts.ghosts;
    std::vector<std::int32_t> index(at(model.cuts.bodies), -1);
    for (std::size_t k = 0; k < ghosts.size(); ++k)
        index[at(ghosts[k].of)] = static_cast<std::int32_t>(k);
    for (std::int32_t id = 0; id < model.interactions.count(); ++id) {
        std::int32_t slot = 0;
        for (const std::int32_t b : context::bodies_of(model.interactions, id)) {
            if (b < model.cuts.bodies && index[at(b)] >= 0)
                model.cuts.pulls.push_back({index[at(b)], id, slot});
            ++slot;
        }
    }
    std::stable_sort(
        model.cuts.pulls.begin(), model.cuts.pulls.end(),
        [](const context::Pull& a, const context::Pull& b) { return a.ghost < b.ghost; });
}

}  // namespace

bool can_cut(const context::Model& model, std::int32_t id) noexcept {
    const model::Interactions& in = model.interactions;
    if (in.flags[at(id)] & (model::kMotor | model::kFriction | model::kRange)) return false;
    if (kind_info(in.def[at(id)].kind).is(kWoundUp)) return false;
    if (kind_info(in.def[at(id)].kind).is(kRouted)) return false;
    // Its mass matrix couples the two nodes outside its row. A copy with a ghost body would lose
    // this coupling.
    if (in.pair_mass[at(id)] > 0.0) return false;
    const std::int32_t row = in.row_begin[at(id)];
    return std::none_of(in.loads.begin(), in.loads.end(),
                        [row](const model::Load& l) { return l.rows > 0 && l.row_begin == row; });
}

bool makes_groups(const context::Model& model) noexcept {
    const auto split = [](Coupling c) { return c != Coupling::exact; };
    return model.def.parts > 0 &&
           (split(model.def.coupling) ||
            std::any_of(model.cuts.coupling.begin(), model.cuts.coupling.end(), split));
}

bool may_split(const context::Model& model) noexcept {
    const std::vector<std::int32_t>& group = model.cuts.group;
    return model.cuts.bodies >= 0 || makes_groups(model) ||
           std::any_of(group.begin(), group.end(), [&](std::int32_t g) { return g != group[0]; });
}

void make_cuts(context::Model& model) {
    context::Cuts& cuts = model.cuts;
    remove_cuts(model);
    const std::int32_t bodies = model.bodies.count(), count = model.interactions.count();
    cuts.group.resize(at(bodies), 0);
    cuts.coupling.resize(at(count), model.def.coupling);
    cuts.grouped = std::any_of(cuts.group.begin(), cuts.group.end(),
                               [&](std::int32_t g) { return g != cuts.group[0]; });
    if (!cuts.grouped) return;
    std::vector<std::int32_t> cut_interactions;
    for (std::int32_t id = 0; id < count; ++id)
        if (cuts.coupling[at(id)] != Coupling::exact && can_cut(model, id) &&
            groups_of_interaction(model, id).size() > 1)
            cut_interactions.push_back(id);
    if (cut_interactions.empty()) return;
    cuts.bodies = bodies;
    cuts.interactions = count;
    std::unordered_map<std::int32_t, std::int32_t> ghost;
    const auto interface = number_interfaces(model, cut_interactions);
    for (const std::int32_t id : cut_interactions) {
        const std::vector<std::int32_t> sides = groups_of_interaction(model, id);
        cuts.list.push_back(
            {id, model.interactions.count(), static_cast<std::int32_t>(sides.size()), true});
        if (cuts.coupling[at(id)] == Coupling::deadline)
            cuts.list.back().interface = interface.at(pair_of(sides));
        for (const std::int32_t side : sides) add_copy(model, id, side, ghost);
    }
    model.bodies.v_before = model.bodies.v_fixed;
    cuts.part.resize(at(bodies));
    cuts.touch.assign(at(model.bodies.dofs), 0.0);
    if (model.def.predictor == Predictor::forces) list_pulls(model);
    if (model.def.predictor == Predictor::clique) make_clique(model);
}

void remove_cuts(context::Model& model) {
    context::Cuts& cuts = model.cuts;
    if (cuts.bodies >= 0) {
        // Later bodies and interactions at these indices are new ones.
        model.system.node_of_body.resize(
            std::min(model.system.node_of_body.size(), at(cuts.bodies)));
        model.system.node_of_interaction.resize(
            std::min(model.system.node_of_interaction.size(), at(cuts.interactions)));
        model.interactions.truncate(cuts.interactions, model.bodies);
        model.bodies.truncate(cuts.bodies);
    }
    cuts.bodies = cuts.interactions = -1;
    cuts.interfaces = 0;
    cuts.list.clear();
    cuts.ghosts.clear();
    cuts.of.clear();
    cuts.pulls.clear();
    cuts.clique.reset();
    model.system.left_out.clear();
    model.system.sides.clear();
}

void join_model(context::Model& model) noexcept {
    remove_cuts(model);
    model.regroup.stale = true;
}

}  // namespace hawser::split
