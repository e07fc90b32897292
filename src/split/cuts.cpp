// SPDX-License-Identifier: Apache-2.0
#include "split/cuts.h"

#include "access/copies.h"
#include "base/index.h"
#include "context/context.h"
#include "context/cuts_data.h"
#include "split/clique.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <span>
#include <unordered_map>

namespace hawser::stepper {
namespace {

/// Groups of the bodies that move, in the order of the slots, each once.
std::vector<std::int32_t> sides_of(const StepContext& ctx, std::int32_t id) {
    std::vector<std::int32_t> sides;
    for (const std::int32_t b : bodies_of(ctx.model.interactions, id)) {
        if (ctx.model.bodies.dof(b) == 0) continue;
        const std::int32_t g = ctx.model.cuts.group[at(b)];
        if (std::find(sides.begin(), sides.end(), g) == sides.end()) sides.push_back(g);
    }
    return sides;
}

using GroupPair = std::pair<std::int32_t, std::int32_t>;

GroupPair pair_of(const std::vector<std::int32_t>& sides) {
    return {std::min(sides[0], sides[1]), std::max(sides[0], sides[1])};
}

/// Interfaces of the cuts that deadlines may ask for.
std::map<GroupPair, int> number_interfaces(StepContext& ctx,
                                           const std::vector<std::int32_t>& wanted) {
    std::map<GroupPair, int> number;
    for (const std::int32_t id : wanted)
        if (ctx.model.cuts.coupling[at(id)] == Coupling::deadline)
            number[pair_of(sides_of(ctx, id))];
    int next = 0;
    for (auto& each : number) each.second = std::min(next++, 63);
    ctx.model.cuts.interfaces = std::min(next, 64);
    return number;
}

/// An image of a body: fixed, so that nothing counts it as a drive.
std::int32_t add_image(StepContext& ctx, std::int32_t body) {
    model::Bodies& b = ctx.model.bodies;
    const double *x = &b.x[3 * at(body)], *q = &b.q[4 * at(body)];
    BodyDef def;
    def.kind = BodyKind::fixed;
    def.position = {x[0], x[1], x[2]};
    def.orientation = Quat(q[0], q[1], q[2], q[3]);
    ctx.model.cuts.images.push_back({b.count(), body});
    return b.append(def);
}

/// The rows of an interaction for one side.
void add_copy(StepContext& ctx, std::int32_t id, std::int32_t side,
              std::unordered_map<std::int32_t, std::int32_t>& image) {
    model::Interactions& in = ctx.model.interactions;
    InteractionDef def = in.def[at(id)];
    def.name.clear();
    for (std::size_t b = 0; b < in.bodies[at(id)]; ++b) {
        const std::int32_t body = def.body[b].index;
        const int dof = ctx.model.bodies.dof(body);
        if (dof == 0 || ctx.model.cuts.group[at(body)] == side) continue;
        if (!image.contains(body)) image[body] = add_image(ctx, body);
        def.body[b] = BodyId{image[body]};
        if (dof < 6) def.point[b] = Vec3::Zero();  // an image would have arms, a lump has none
    }
    const int copy = in.append(def, ctx.model.bodies, ctx.model.def.step);
    const auto row = in.row_begin[at(id)], to = in.row_begin[at(copy)];
    std::copy_n(&in.lambda[at(row)], in.rows[at(id)], &in.lambda[at(to)]);
    in.active[at(copy)] = in.active[at(id)];
    in.parted[at(copy)] = in.parted[at(id)];
    ctx.model.cuts.of.push_back(id);
}

/// What acts on the bodies of images, be it in the system or not at the moment.
void list_pulls(StepContext& ctx) {
    const std::vector<Image>& images = ctx.model.cuts.images;
    std::vector<std::int32_t> index(at(ctx.model.cuts.bodies), -1);
    for (std::size_t k = 0; k < images.size(); ++k)
        index[at(images[k].of)] = static_cast<std::int32_t>(k);
    for (std::int32_t id = 0; id < ctx.model.interactions.count(); ++id) {
        std::int32_t slot = 0;
        for (const std::int32_t b : bodies_of(ctx.model.interactions, id)) {
            if (b < ctx.model.cuts.bodies && index[at(b)] >= 0)
                ctx.model.cuts.pulls.push_back({index[at(b)], id, slot});
            ++slot;
        }
    }
    std::stable_sort(ctx.model.cuts.pulls.begin(), ctx.model.cuts.pulls.end(),
                     [](const Pull& a, const Pull& b) { return a.image < b.image; });
}

}  // namespace

bool can_cut(const StepContext& ctx, std::int32_t id) noexcept {
    const model::Interactions& in = ctx.model.interactions;
    if (in.flags[at(id)] & (model::kMotor | model::kFriction | model::kRange)) return false;
    if (kind_info(in.def[at(id)].kind).is(kWoundUp)) return false;
    const std::int32_t row = in.row_begin[at(id)];
    return std::none_of(in.loads.begin(), in.loads.end(),
                        [row](const model::Load& l) { return l.rows > 0 && l.row_begin == row; });
}

bool makes_groups(const StepContext& ctx) noexcept {
    const auto split = [](Coupling c) { return c != Coupling::exact; };
    return ctx.model.def.parts > 0 &&
           (split(ctx.model.def.coupling) ||
            std::any_of(ctx.model.cuts.coupling.begin(), ctx.model.cuts.coupling.end(), split));
}

bool may_have_cuts(const StepContext& ctx) noexcept {
    const std::vector<std::int32_t>& group = ctx.model.cuts.group;
    return ctx.model.cuts.bodies >= 0 || makes_groups(ctx) ||
           std::any_of(group.begin(), group.end(), [&](std::int32_t g) { return g != group[0]; });
}

void make_cuts(StepContext& ctx) {
    Cuts& cuts = ctx.model.cuts;
    drop_cuts(ctx);
    const std::int32_t bodies = ctx.model.bodies.count(), count = ctx.model.interactions.count();
    cuts.group.resize(at(bodies), 0);
    cuts.coupling.resize(at(count), ctx.model.def.coupling);
    cuts.grouped = std::any_of(cuts.group.begin(), cuts.group.end(),
                               [&](std::int32_t g) { return g != cuts.group[0]; });
    if (!cuts.grouped) return;
    std::vector<std::int32_t> wanted;
    for (std::int32_t id = 0; id < count; ++id)
        if (cuts.coupling[at(id)] != Coupling::exact && can_cut(ctx, id) &&
            sides_of(ctx, id).size() > 1)
            wanted.push_back(id);
    if (wanted.empty()) return;
    cuts.bodies = bodies;
    cuts.interactions = count;
    std::unordered_map<std::int32_t, std::int32_t> image;
    const auto interface = number_interfaces(ctx, wanted);
    for (const std::int32_t id : wanted) {
        const std::vector<std::int32_t> sides = sides_of(ctx, id);
        cuts.list.push_back(
            {id, ctx.model.interactions.count(), static_cast<std::int32_t>(sides.size()), true});
        if (cuts.coupling[at(id)] == Coupling::deadline)
            cuts.list.back().interface = interface.at(pair_of(sides));
        for (const std::int32_t side : sides) add_copy(ctx, id, side, image);
    }
    ctx.model.bodies.v_before = ctx.model.bodies.v_fixed;
    cuts.part.resize(at(bodies));
    cuts.touch.assign(at(ctx.model.bodies.dofs), 0.0);
    if (ctx.model.def.predictor == Predictor::forces) list_pulls(ctx);
    if (ctx.model.def.predictor == Predictor::clique) make_clique(ctx);
}

void drop_cuts(StepContext& ctx) {
    Cuts& cuts = ctx.model.cuts;
    if (cuts.bodies >= 0) {
        // What comes in their place is not the same.
        ctx.model.system.node_of_body.resize(
            std::min(ctx.model.system.node_of_body.size(), at(cuts.bodies)));
        ctx.model.system.node_of_interaction.resize(
            std::min(ctx.model.system.node_of_interaction.size(), at(cuts.interactions)));
        ctx.model.interactions.truncate(cuts.interactions);
        ctx.model.bodies.truncate(cuts.bodies);
    }
    cuts.bodies = cuts.interactions = -1;
    cuts.interfaces = 0;
    cuts.list.clear();
    cuts.images.clear();
    cuts.of.clear();
    cuts.pulls.clear();
    cuts.clique.reset();
    ctx.model.system.left_out.clear();
    ctx.model.system.sides.clear();
}

}  // namespace hawser::stepper
