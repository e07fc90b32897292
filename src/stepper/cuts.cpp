// SPDX-License-Identifier: Apache-2.0
#include "stepper/cuts.h"

#include "base/index.h"
#include "stepper/clique.h"
#include "stepper/context.h"
#include "stepper/guarded.h"
#include "stepper/stages.h"
#include "stepper/timer.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <span>
#include <unordered_map>

namespace hawser::stepper {
namespace {

std::span<const std::int32_t> members(const model::Interactions& in, std::int32_t id) {
    return {&in.body[kMaxInteractionBodies * at(id)], in.bodies[at(id)]};
}

/// Groups of the bodies that move, in the order of the slots, each once.
std::vector<std::int32_t> sides_of(const StepContext& ctx, std::int32_t id) {
    std::vector<std::int32_t> sides;
    for (const std::int32_t b : members(ctx.interactions, id)) {
        if (ctx.bodies.dof(b) == 0) continue;
        const std::int32_t g = ctx.cuts.group[at(b)];
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
        if (ctx.cuts.coupling[at(id)] == Coupling::deadline) number[pair_of(sides_of(ctx, id))];
    int next = 0;
    for (auto& each : number) each.second = std::min(next++, 63);
    ctx.cuts.interfaces = std::min(next, 64);
    return number;
}

/// An image of a body: fixed, so that nothing counts it as a drive.
std::int32_t add_image(StepContext& ctx, std::int32_t body) {
    model::Bodies& b = ctx.bodies;
    const double *x = &b.x[3 * at(body)], *q = &b.q[4 * at(body)];
    BodyDef def;
    def.kind = BodyKind::fixed;
    def.position = {x[0], x[1], x[2]};
    def.orientation = Quat(q[0], q[1], q[2], q[3]);
    ctx.cuts.images.push_back({b.count(), body});
    return b.append(def);
}

/// The rows of an interaction for one side.
void add_copy(StepContext& ctx, std::int32_t id, std::int32_t side,
              std::unordered_map<std::int32_t, std::int32_t>& image) {
    model::Interactions& in = ctx.interactions;
    InteractionDef def = in.def[at(id)];
    def.name.clear();
    for (std::size_t b = 0; b < in.bodies[at(id)]; ++b) {
        const std::int32_t body = def.body[b].index;
        const int dof = ctx.bodies.dof(body);
        if (dof == 0 || ctx.cuts.group[at(body)] == side) continue;
        if (!image.contains(body)) image[body] = add_image(ctx, body);
        def.body[b] = BodyId{image[body]};
        if (dof < 6) def.point[b] = Vec3::Zero();  // an image would have arms, a lump has none
    }
    const int copy = in.append(def, ctx.bodies, ctx.def.step);
    const auto row = in.row_begin[at(id)], to = in.row_begin[at(copy)];
    std::copy_n(&in.lambda[at(row)], in.rows[at(id)], &in.lambda[at(to)]);
    in.active[at(copy)] = in.active[at(id)];
    in.parted[at(copy)] = in.parted[at(id)];
    ctx.cuts.of.push_back(id);
}

/// What acts on the bodies of images, be it in the system or not at the moment.
void list_pulls(StepContext& ctx) {
    const std::vector<Image>& images = ctx.cuts.images;
    std::vector<std::int32_t> index(at(ctx.cuts.bodies), -1);
    for (std::size_t k = 0; k < images.size(); ++k)
        index[at(images[k].of)] = static_cast<std::int32_t>(k);
    for (std::int32_t id = 0; id < ctx.interactions.count(); ++id) {
        std::int32_t slot = 0;
        for (const std::int32_t b : members(ctx.interactions, id)) {
            if (b < ctx.cuts.bodies && index[at(b)] >= 0)
                ctx.cuts.pulls.push_back({index[at(b)], id, slot});
            ++slot;
        }
    }
    std::stable_sort(ctx.cuts.pulls.begin(), ctx.cuts.pulls.end(),
                     [](const Pull& a, const Pull& b) { return a.image < b.image; });
}

}  // namespace

std::int32_t body_count(const StepContext& ctx) noexcept {
    return ctx.cuts.bodies >= 0 ? ctx.cuts.bodies : ctx.bodies.count();
}

std::int32_t interaction_count(const StepContext& ctx) noexcept {
    return ctx.cuts.interactions >= 0 ? ctx.cuts.interactions : ctx.interactions.count();
}

std::int32_t original(const StepContext& ctx, std::int32_t id) noexcept {
    const std::int32_t n = interaction_count(ctx);
    return id < n ? id : ctx.cuts.of[at(id - n)];
}

std::int32_t user_rows(const StepContext& ctx) noexcept {
    const model::Interactions& in = ctx.interactions;
    const std::int32_t count = interaction_count(ctx);
    return count < in.count() ? in.row_begin[at(count)] : in.row_count;
}

std::int32_t speaker(const StepContext& ctx, std::int32_t id) noexcept {
    const std::int32_t copy = id - interaction_count(ctx);
    if (copy < 0) return id;
    const std::int32_t of = ctx.cuts.of[at(copy)];
    return copy == 0 || ctx.cuts.of[at(copy - 1)] != of ? of : -1;
}

bool can_cut(const StepContext& ctx, std::int32_t id) noexcept {
    const model::Interactions& in = ctx.interactions;
    if (in.flags[at(id)] & (model::kMotor | model::kFriction | model::kRange)) return false;
    if (kind_info(in.def[at(id)].kind).is(kWoundUp)) return false;
    const std::int32_t row = in.row_begin[at(id)];
    return std::none_of(in.loads.begin(), in.loads.end(),
                        [row](const model::Load& l) { return l.rows > 0 && l.row_begin == row; });
}

bool may_have_cuts(const StepContext& ctx) noexcept {
    const std::vector<std::int32_t>& group = ctx.cuts.group;
    return ctx.cuts.bodies >= 0 || makes_groups(ctx) ||
           std::any_of(group.begin(), group.end(), [&](std::int32_t g) { return g != group[0]; });
}

void make_cuts(StepContext& ctx) {
    Cuts& cuts = ctx.cuts;
    drop_cuts(ctx);
    const std::int32_t bodies = ctx.bodies.count(), count = ctx.interactions.count();
    cuts.group.resize(at(bodies), 0);
    cuts.coupling.resize(at(count), ctx.def.coupling);
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
            {id, ctx.interactions.count(), static_cast<std::int32_t>(sides.size()), true});
        if (cuts.coupling[at(id)] == Coupling::deadline)
            cuts.list.back().interface = interface.at(pair_of(sides));
        for (const std::int32_t side : sides) add_copy(ctx, id, side, image);
    }
    ctx.bodies.v_before = ctx.bodies.v_fixed;
    cuts.part.resize(at(bodies));
    cuts.touch.assign(at(ctx.bodies.dofs), 0.0);
    if (ctx.def.predictor == Predictor::forces) list_pulls(ctx);
    if (ctx.def.predictor == Predictor::clique) make_clique(ctx);
}

void drop_cuts(StepContext& ctx) {
    Cuts& cuts = ctx.cuts;
    if (cuts.bodies >= 0) {
        // What comes in their place is not the same.
        ctx.system.node_of_body.resize(std::min(ctx.system.node_of_body.size(), at(cuts.bodies)));
        ctx.system.node_of_interaction.resize(
            std::min(ctx.system.node_of_interaction.size(), at(cuts.interactions)));
        ctx.interactions.truncate(cuts.interactions);
        ctx.bodies.truncate(cuts.bodies);
    }
    cuts.bodies = cuts.interactions = -1;
    cuts.interfaces = 0;
    cuts.list.clear();
    cuts.images.clear();
    cuts.of.clear();
    cuts.pulls.clear();
    cuts.clique.reset();
    ctx.system.left_out.clear();
    ctx.system.sides.clear();
}

namespace {

std::int32_t root(std::vector<std::int32_t>& part, std::int32_t b) {
    while (part[at(b)] != b) b = part[at(b)] = part[at(part[at(b)])];
    return b;
}

/// Bodies hold together.
void join(StepContext& ctx, std::span<const std::int32_t> bodies) {
    std::int32_t first = -1;
    for (const std::int32_t b : bodies) {
        if (ctx.bodies.dof(b) == 0) continue;
        const std::int32_t r = root(ctx.cuts.part, b);
        if (first >= 0) ctx.cuts.part[at(std::max(r, first))] = std::min(r, first);
        first = first < 0 ? r : std::min(r, first);
    }
}

/// Whether two bodies of different groups hold to each other without this cut.
bool holds_otherwise(StepContext& ctx, const Cut& cut) {
    const auto bodies = members(ctx.interactions, cut.id);
    for (std::size_t i = 0; i < bodies.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const std::int32_t a = bodies[i], b = bodies[j];
            if (ctx.bodies.dof(a) == 0 || ctx.bodies.dof(b) == 0) continue;
            if (ctx.cuts.group[at(a)] != ctx.cuts.group[at(b)] &&
                root(ctx.cuts.part, a) == root(ctx.cuts.part, b))
                return true;
        }
    return false;
}

}  // namespace

bool open_cuts(StepContext& ctx) {
    Cuts& cuts = ctx.cuts;
    assembly::System& system = ctx.system;
    if (cuts.list.empty()) return false;
    const std::vector<std::int32_t> before = std::move(system.left_out);
    system.left_out.clear();
    system.sides.clear();
    std::iota(cuts.part.begin(), cuts.part.end(), 0);
    // Bodies of one group are one part where anything joins them; copies see to that.
    auto cut = cuts.list.begin();
    for (std::int32_t id = 0; id < cuts.interactions; ++id) {
        if (cut != cuts.list.end() && cut->id == id)
            ++cut;
        else
            join(ctx, members(ctx.interactions, id));
    }
    for (std::size_t k = 0; k < cuts.of.size(); ++k) {
        std::vector<std::int32_t> own;
        for (const std::int32_t b :
             members(ctx.interactions, cuts.interactions + static_cast<std::int32_t>(k)))
            if (b < cuts.bodies) own.push_back(b);
        join(ctx, own);
    }
    for (const assembly::Contacts::Link& l : system.contacts.links)
        join(ctx, std::array<std::int32_t, 2>{l.first, l.second});
    for (Cut& c : cuts.list) {
        c.open = cuts.coupling[at(c.id)] != Coupling::deadline || (cuts.asked >> c.interface & 1U);
        if (!c.open) join(ctx, members(ctx.interactions, c.id));
    }
    for (bool again = true; again;) {
        again = false;
        for (Cut& c : cuts.list) {
            if (!c.open || !holds_otherwise(ctx, c)) continue;
            c.open = false;
            join(ctx, members(ctx.interactions, c.id));
            again = true;
        }
    }
    for (const Cut& c : cuts.list) {
        if (c.open) {
            system.left_out.push_back(c.id);
            const bool soften = cuts.coupling[at(c.id)] != Coupling::kinematic;
            system.sides.push_back({c.first, c.sides, soften});
        } else {
            for (std::int32_t i = 0; i < c.sides; ++i) system.left_out.push_back(c.first + i);
        }
    }
    return before != system.left_out;
}

std::uint64_t open_interfaces(const StepContext& ctx) noexcept {
    std::uint64_t interfaces = 0;
    for (const Cut& c : ctx.cuts.list)
        if (c.open && ctx.cuts.coupling[at(c.id)] == Coupling::deadline)
            interfaces |= std::uint64_t{1} << c.interface;
    return interfaces;
}

Status ask_for_cuts(StepContext& ctx, std::uint64_t interfaces) noexcept {
    if (interfaces == ctx.cuts.asked) return Status::ok;
    const StageTimer timer(ctx, Stage::analyse);
    return guarded(ctx, [&] {
        ctx.undo.keep(ctx, Undo::Depth::system);
        ctx.cuts.asked = interfaces;
        if (!ctx.cuts.list.empty() && open_cuts(ctx)) analyse(ctx);
    });
}

}  // namespace hawser::stepper
