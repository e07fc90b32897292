// SPDX-License-Identifier: Apache-2.0
#include "step/sleep.h"

#include "assembly/kinetic.h"
#include "base/index.h"
#include "context/asleep.h"
#include "context/guarded.h"
#include "context/sleep_data.h"
#include "context/timer.h"
#include "context/undo_data.h"
#include "split/split.h"
#include "state/undo.h"
#include "step/ready.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hawser::step {
namespace {

/// Number of steps between searches for islands.
constexpr std::int64_t kEvery = 8;

/// True if a kinematic body moves.
bool carries(const model::Bodies& b, std::int32_t body) noexcept {
    const double* v = &b.v_fixed[6 * at(body)];
    return b.kind[at(body)] == BodyKind::kinematic &&
           std::any_of(v, v + 6, [](double x) { return x != 0.0; });
}

/// Return the first body of the island of a moving body, by path halving.
std::int32_t island_of(std::vector<std::int32_t>& island, std::int32_t body) noexcept {
    while (island[at(body)] != body) body = island[at(body)] = island[at(island[at(body)])];
    return body;
}

/// Bodies of an interaction and of its loads.
struct Members {
    std::int32_t body[kMaxInteractionBodies * (1 + kMaxFrictionLoads)];
    std::size_t count = 0;
    void add(const model::Interactions& in, std::int32_t id) noexcept {
        for (int b = 0; b < in.bodies[at(id)]; ++b)
            body[count++] = in.body[at(kMaxInteractionBodies * id + b)];
    }
};

/// Call f with the bodies of each interaction, contact and segment, which join islands. Friction
/// belongs to its loads, even if they have no common body.
template <class F>
void each_bond(const context::Model& model, const context::State& state, F&& f) noexcept {
    const model::Interactions& in = model.interactions;
    for (std::int32_t i = 0; i < in.count(); ++i) {
        Members m;
        m.add(in, i);
        if (in.load_begin[at(i)] >= 0)
            for (const FrictionLoad& load : in.def[at(i)].load)
                if (load.interaction.valid()) m.add(in, load.interaction.index);
        f(std::span<const std::int32_t>(m.body, m.count));
    }
    for (const collide::Contact& c : state.contacts.contacts)
        f(std::span<const std::int32_t>(c.body, c.slots));
    for (const collide::Shape& s : model.collider.shapes())
        if (s.segment()) f(std::span<const std::int32_t>(s.body));
}

void find_islands(context::StepContext& ctx) noexcept {
    std::vector<std::int32_t>& island = ctx.work.sleep.island;
    std::iota(island.begin(), island.end(), 0);
    each_bond(ctx.model, ctx.state, [&](std::span<const std::int32_t> bodies) {
        std::int32_t first = -1;
        for (const std::int32_t b : bodies) {
            if (!context::moves(ctx.model.bodies, b)) continue;
            const std::int32_t r = island_of(island, b);
            // The smallest index is the root, so that the result does not depend on numbering.
            if (first >= 0 && r != first) island[at(std::max(r, first))] = std::min(r, first);
            first = first < 0 ? r : std::min(r, first);
        }
    });
}

/// Mark the islands of bodies for which `wanted` holds, and islands in contact with a kinematic
/// body in motion.
template <class F>
void mark_islands(context::StepContext& ctx, F&& wanted) noexcept {
    context::Sleep& s = ctx.work.sleep;
    std::fill(s.mark.begin(), s.mark.end(), std::uint8_t{0});
    for (const std::int32_t b : ctx.model.bodies.moving)
        if (wanted(b)) s.mark[at(island_of(s.island, b))] = 1;
    if (std::none_of(ctx.model.bodies.driven.begin(), ctx.model.bodies.driven.end(),
                     [&](std::int32_t b) { return carries(ctx.model.bodies, b); }))
        return;
    each_bond(ctx.model, ctx.state, [&](std::span<const std::int32_t> bodies) {
        if (std::none_of(bodies.begin(), bodies.end(),
                         [&](std::int32_t b) { return carries(ctx.model.bodies, b); }))
            return;
        for (const std::int32_t b : bodies)
            if (context::moves(ctx.model.bodies, b)) s.mark[at(island_of(s.island, b))] = 1;
    });
}

/// Set a body asleep or awake. @return true if this is a change.
bool set_asleep(context::Model& model, StepStats& stats, std::int32_t body, bool asleep) noexcept {
    std::uint8_t& now = model.bodies.asleep[at(body)];
    if ((now != 0) == asleep) return false;
    now = asleep ? 1 : 0;
    stats.asleep += asleep ? 1 : -1;
    return true;
}

/// True if an island has to wake.
bool disturbed(const context::Model& model, const context::State& state) noexcept {
    const model::Bodies& b = model.bodies;
    for (const std::int32_t body : b.moving)
        if (b.asleep[at(body)] != 0 && b.quiet[at(body)] == 0) return true;
    bool found = false;
    each_bond(model, state, [&](std::span<const std::int32_t> bodies) {
        bool asleep = false, moving = false;
        for (const std::int32_t body : bodies) {
            asleep = asleep || b.asleep[at(body)] != 0;
            moving =
                moving || carries(b, body) || (context::moves(b, body) && b.asleep[at(body)] == 0);
        }
        found = found || (asleep && moving);
    });
    return found;
}

/// Wake islands with a body that is awake or disturbed. If a sleeping body and an active one have
/// come close, they belong to one island already. @return true if any island woke.
bool wake_islands(context::StepContext& ctx) noexcept {
    model::Bodies& b = ctx.model.bodies;
    find_islands(ctx);
    mark_islands(
        ctx, [&](std::int32_t body) { return b.asleep[at(body)] == 0 || b.quiet[at(body)] == 0; });
    bool woken = false;
    for (const std::int32_t body : b.moving) {
        if (ctx.work.sleep.mark[at(island_of(ctx.work.sleep.island, body))] == 0) continue;
        if (!set_asleep(ctx.model, ctx.work.stats, body, false)) continue;
        b.quiet[at(body)] = 0;
        woken = true;
    }
    return woken;
}

/// Analyse the system without sleeping bodies. @throws std::bad_alloc, LimitError.
void reanalyse(context::StepContext& ctx) {
    const context::StageTimer timer(ctx, Stage::analyse);
    // An analysis evaluates active limits; the step is to determine and report them.
    const base::Array<double> active = ctx.model.interactions.active;
    split::analyse(ctx);
    ctx.model.interactions.active = active;
}

/// Analyse after a finished step. If it fails, the next step does it.
void analyse_after_step(context::StepContext& ctx) noexcept {
    ctx.state.analysed_x = ctx.model.bodies.x;
    ctx.state.analysed_r = ctx.model.bodies.r;
    ctx.state.repair = context::PendingRepair::follow;
    const context::StageTimer timer(ctx, Stage::analyse);
    (void)context::guarded(ctx, [&] {
        // Completed joints of the step are read later; the next step chooses again.
        const base::Array<std::uint8_t> completed = ctx.model.interactions.completed;
        repair(ctx);
        ctx.model.interactions.completed = completed;
    });
}

}  // namespace

Status wake_disturbed(context::StepContext& ctx) noexcept {
    if (ctx.work.stats.asleep == 0) return Status::ok;
    if (disturbed(ctx.model, ctx.state)) {
        const Status status = context::guarded(ctx, [&] {
            state::save_state(ctx, context::Undo::Depth::system);
            if (wake_islands(ctx)) reanalyse(ctx);
        });
        if (status != Status::ok) return status;
    }
    const bool room = ctx.work.stats.asleep == 0 ||
                      ctx.model.collider.set_aside(ctx.state.contacts, ctx.model.bodies.asleep);
    return room ? Status::ok : Status::out_of_memory;
}

void fall_asleep(context::StepContext& ctx) noexcept {
    if (!(ctx.model.def.sleep_after > 0.0)) return;
    model::Bodies& b = ctx.model.bodies;
    // Other methods have no certificate.
    const bool certified = ctx.model.def.nonsmooth != Nonsmooth::newton ||
                           (!ctx.work.stats.cut && ctx.work.stats.flips_left == 0 &&
                            ctx.work.stats.natural_map <= ctx.model.def.contact_tolerance);
    const auto most = static_cast<std::int32_t>(std::min<double>(
        std::ceil(ctx.model.def.sleep_after / ctx.model.def.step), context::kMaxQuiet));
    bool any = false;
    for (const std::int32_t body : b.moving) {
        if (b.asleep[at(body)] != 0) continue;
        const double limit = ctx.model.def.sleep_speed * ctx.model.def.sleep_speed;
        const double square =
            2.0 * assembly::kinetic_energy_of(b, body, b.v.data()) / b.mass[at(body)];
        std::int32_t& quiet = b.quiet[at(body)];
        const bool rests = certified && square < limit && !ctx.state.loads.loaded(body);
        quiet = rests ? std::min(quiet + 1, most) : 0;
        any = any || quiet == most;
    }
    if (!any || ctx.state.step % kEvery != 0) return;
    find_islands(ctx);
    mark_islands(ctx, [&](std::int32_t body) { return b.quiet[at(body)] < most; });
    bool fallen = false;
    for (const std::int32_t body : b.moving)
        if (ctx.work.sleep.mark[at(island_of(ctx.work.sleep.island, body))] == 0)
            fallen = set_asleep(ctx.model, ctx.work.stats, body, true) || fallen;
    if (fallen) analyse_after_step(ctx);
}

}  // namespace hawser::step
