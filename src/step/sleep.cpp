// SPDX-License-Identifier: Apache-2.0
#include "step/sleep.h"

#include "access/asleep.h"
#include "access/guarded.h"
#include "access/kinetic.h"
#include "access/timer.h"
#include "access/undo.h"
#include "base/index.h"
#include "context/sleep_data.h"
#include "context/undo_data.h"
#include "split/split.h"
#include "step/ready.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hawser::stepper {
namespace {

/// Islands are looked for every so many steps.
constexpr std::int64_t kEvery = 8;

/// A kinematic body that is under way.
bool carries(const model::Bodies& b, std::int32_t body) noexcept {
    const double* v = &b.v_fixed[6 * at(body)];
    return b.kind[at(body)] == BodyKind::kinematic &&
           std::any_of(v, v + 6, [](double x) { return x != 0.0; });
}

/// First body of the island of a body that moves, by path halving.
std::int32_t island_of(std::vector<std::int32_t>& island, std::int32_t body) noexcept {
    while (island[at(body)] != body) body = island[at(body)] = island[at(island[at(body)])];
    return body;
}

/// Bodies of an interaction and of what loads it.
struct Members {
    std::int32_t body[kMaxInteractionBodies * (1 + kMaxFrictionLoads)];
    std::size_t count = 0;
    void add(const model::Interactions& in, std::int32_t id) noexcept {
        for (int b = 0; b < in.bodies[at(id)]; ++b)
            body[count++] = in.body[at(kMaxInteractionBodies * id + b)];
    }
};

/// Call f with the bodies of each interaction, contact and segment: what holds together. Friction
/// belongs to its loads, whether they share a body or not.
template <class F>
void each_bond(const Model& model, const State& state, F&& f) noexcept {
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

void find_islands(StepContext& ctx) noexcept {
    std::vector<std::int32_t>& island = ctx.work.sleep.island;
    std::iota(island.begin(), island.end(), 0);
    each_bond(ctx.model, ctx.state, [&](std::span<const std::int32_t> bodies) {
        std::int32_t first = -1;
        for (const std::int32_t b : bodies) {
            if (!moves(ctx.model.bodies, b)) continue;
            const std::int32_t r = island_of(island, b);
            // The smallest index is the root, so that numbering does not matter.
            if (first >= 0 && r != first) island[at(std::max(r, first))] = std::min(r, first);
            first = first < 0 ? r : std::min(r, first);
        }
    });
}

/// Mark the islands of bodies for which `wanted` holds, and those that a body under way touches.
template <class F>
void mark_islands(StepContext& ctx, F&& wanted) noexcept {
    Sleep& s = ctx.work.sleep;
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
            if (moves(ctx.model.bodies, b)) s.mark[at(island_of(s.island, b))] = 1;
    });
}

/// A body sleeps from now on, or wakes. @return whether that is new.
bool set_asleep(Model& model, StepStats& stats, std::int32_t body, bool asleep) noexcept {
    std::uint8_t& now = model.bodies.asleep[at(body)];
    if ((now != 0) == asleep) return false;
    now = asleep ? 1 : 0;
    stats.asleep += asleep ? 1 : -1;
    return true;
}

/// Whether an island has to wake.
bool disturbed(const Model& model, const State& state) noexcept {
    const model::Bodies& b = model.bodies;
    for (const std::int32_t body : b.moving)
        if (b.asleep[at(body)] != 0 && b.quiet[at(body)] == 0) return true;
    bool found = false;
    each_bond(model, state, [&](std::span<const std::int32_t> bodies) {
        bool asleep = false, moving = false;
        for (const std::int32_t body : bodies) {
            asleep = asleep || b.asleep[at(body)] != 0;
            moving = moving || carries(b, body) || (moves(b, body) && b.asleep[at(body)] == 0);
        }
        found = found || (asleep && moving);
    });
    return found;
}

/// Islands with a body that is awake or disturbed wake whole: where one that sleeps and one that is
/// awake have come close, they are one by now. @return whether any woke.
bool wake_islands(StepContext& ctx) noexcept {
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

/// The system without what sleeps. @throws std::bad_alloc, LimitError.
void analyse_anew(StepContext& ctx) {
    const StageTimer timer(ctx, Stage::analyse);
    // An analysis looks at which limits are met, which is for the step to find and to report.
    const base::Array<double> active = ctx.model.interactions.active;
    analyse(ctx);
    ctx.model.interactions.active = active;
}

/// The same after a step, which is done: where it fails it is left to the next one.
void analyse_after_step(StepContext& ctx) noexcept {
    ctx.state.analysed_x = ctx.model.bodies.x;
    ctx.state.analysed_r = ctx.model.bodies.r;
    ctx.state.mend = Mend::follow;
    const StageTimer timer(ctx, Stage::analyse);
    (void)guarded(ctx, [&] {
        // Which joints the step has completed is read after it; the next one chooses anew.
        const base::Array<std::uint8_t> completed = ctx.model.interactions.completed;
        mend(ctx);
        ctx.model.interactions.completed = completed;
    });
}

}  // namespace

Status wake_disturbed(StepContext& ctx) noexcept {
    if (ctx.work.stats.asleep == 0) return Status::ok;
    if (disturbed(ctx.model, ctx.state)) {
        const Status status = guarded(ctx, [&] {
            keep_state(ctx, Undo::Depth::system);
            if (wake_islands(ctx)) analyse_anew(ctx);
        });
        if (status != Status::ok) return status;
    }
    const bool room = ctx.work.stats.asleep == 0 ||
                      ctx.model.collider.set_aside(ctx.state.contacts, ctx.model.bodies.asleep);
    return room ? Status::ok : Status::out_of_memory;
}

void fall_asleep(StepContext& ctx) noexcept {
    if (!(ctx.model.def.sleep_after > 0.0)) return;
    model::Bodies& b = ctx.model.bodies;
    // The other methods end where they end.
    const bool certified = ctx.model.def.nonsmooth != Nonsmooth::newton ||
                           (!ctx.work.stats.cut && ctx.work.stats.flips_left == 0 &&
                            ctx.work.stats.natural_map <= ctx.model.def.contact_tolerance);
    const auto most = static_cast<std::int32_t>(
        std::min<double>(std::ceil(ctx.model.def.sleep_after / ctx.model.def.step), kMostQuiet));
    bool any = false;
    for (const std::int32_t body : b.moving) {
        if (b.asleep[at(body)] != 0) continue;
        const double limit = ctx.model.def.sleep_speed * ctx.model.def.sleep_speed;
        const double square = 2.0 * kinetic_energy_of(b, body, b.v.data()) / b.mass[at(body)];
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

}  // namespace hawser::stepper
