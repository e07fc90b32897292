// SPDX-License-Identifier: Apache-2.0
#include "edit/wire_ends.h"

#include "base/index.h"
#include "base/sorted.h"
#include "context/asleep.h"
#include "context/context.h"
#include "edit/edits.h"
#include "edit/node_pieces.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace hawser::edit {
namespace {

/// Set the rest length of an element so that it keeps its tension after its chord has changed.
void preserve_tension(context::StepContext& ctx, std::int32_t id, double tension) noexcept {
    if (!(tension > 0.0) || kind_info(ctx.model.interactions.kinds[at(id)]).is(kWoundUp)) return;
    const double stiffness = stiffness_of(ctx, id);
    const double chord = (point_of(ctx, id, 1) - point_of(ctx, id, 0)).norm();
    if (!(chord > 0.0)) return;
    set_element(ctx, id, chord / (1.0 + tension / stiffness), mass_of_element(ctx, id), tension);
}

double* velocity_of(base::Array<double>& packed, const context::StepContext& ctx,
                    std::int32_t body) noexcept {
    return &packed[at(ctx.model.bodies.dof_begin[at(body)])];
}

}  // namespace

NodeFraction fraction_of(const context::StepContext& ctx, std::int32_t lump, std::int32_t first,
                         std::int32_t second) noexcept {
    const double whole = ctx.model.bodies.mass[at(lump)];
    NodeFraction out;
    const double left = whole - (first >= 0 ? 0.5 * mass_of_element(ctx, first) : 0.0);
    out.mass = 0.5 * mass_of_element(ctx, second);
    if (!(out.mass > 0.0) && left > 0.0 && left < whole) {
        out.mass = left;
    } else if (!(out.mass > 0.0 && out.mass < whole)) {
        const auto& rest = ctx.model.interactions.rest_length;
        const double other = first >= 0 ? rest[at(first)] : 0.0;
        out.mass = whole * rest[at(second)] / (rest[at(second)] + other);
    }
    out.share = out.mass / whole;
    return out;
}

void split_node(context::StepContext& ctx, std::int32_t from, std::int32_t to,
                const NodeFraction& share) noexcept {
    model::Bodies& b = ctx.model.bodies;
    for (std::size_t k = 0; k < 3; ++k) {
        b.x[3 * at(to) + k] = b.x[3 * at(from) + k];
        for (base::Array<double>* v : {&b.v, &b.v_start})
            velocity_of(*v, ctx, to)[k] = velocity_of(*v, ctx, from)[k];
        double& drag = b.damping[6 * at(from) + k];
        b.damping[6 * at(to) + k] = share.share * drag;
        drag -= b.damping[6 * at(to) + k];
    }
    b.mass[at(to)] = share.mass;
    b.mass[at(from)] -= share.mass;
}

context::Edited splice_energy(const context::StepContext& ctx, std::int32_t a, std::int32_t b,
                              std::int32_t ea, std::int32_t eb) noexcept {
    context::Edited sum{energy_of_body(ctx, a) + (b >= 0 ? energy_of_body(ctx, b) : 0.0), 0.0};
    for (const std::int32_t id : {ea, eb == ea ? -1 : eb})
        if (id >= 0) sum += energy_of_element(ctx, id);
    const std::array<std::int32_t, 2> both{a, b};
    const std::span<const std::int32_t> bodies(both.data(), b >= 0 ? 2 : 1);
    for (std::int32_t id = -1; (id = next_bend(ctx, bodies, id)) >= 0;)
        sum.strained += energy_of_interaction(ctx, id);
    return sum;
}

void merge_nodes(context::StepContext& ctx, std::int32_t a, std::int32_t b, std::int32_t ea,
                 std::int32_t eb) noexcept {
    model::Bodies& bodies = ctx.model.bodies;
    const double pull[2] = {tension_of(ctx, ea), tension_of(ctx, eb)};
    const double ma = bodies.mass[at(a)], mb = bodies.mass[at(b)], share = mb / (ma + mb);
    bool moved = false;
    for (std::size_t k = 0; k < 3; ++k) {
        const double separation = bodies.x[3 * at(b) + k] - bodies.x[3 * at(a) + k];
        moved = moved || separation != 0.0;
        bodies.x[3 * at(a) + k] += share * separation;
        for (base::Array<double>* v : {&bodies.v, &bodies.v_start}) {
            double& to = velocity_of(*v, ctx, a)[k];
            to += share * (velocity_of(*v, ctx, b)[k] - to);
        }
        bodies.damping[6 * at(a) + k] += bodies.damping[6 * at(b) + k];
    }
    bodies.mass[at(a)] = ma + mb;
    move_end(ctx, eb, end_of(ctx, eb, 0) == b ? 0 : 1, a);
    if (!moved) return;
    preserve_tension(ctx, ea, pull[0]);
    preserve_tension(ctx, eb, pull[1]);
}

void reverse_ends(context::StepContext& ctx, std::int32_t id) noexcept {
    model::Interactions& in = ctx.model.interactions;
    InteractionDef& d = in.def[at(id)];
    const std::size_t last = in.bodies[at(id)] == 3 && !kind_info(d.kind).is(kWoundUp) ? 2 : 1;
    const BodyId first = d.body[0];
    std::swap(d.point[0], d.point[last]);
    in.rewire(id, 0, d.body[last], ctx.model.bodies);
    in.rewire(id, last, first, ctx.model.bodies);
}

void move_end(context::StepContext& ctx, std::int32_t id, std::size_t slot,
              std::int32_t to) noexcept {
    model::Interactions& in = ctx.model.interactions;
    model::Bodies& b = ctx.model.bodies;
    in.rewire(id, slot, b.id(to), b);
    const int before = in.flags[at(id)];
    int flags = before & ~model::kCarried;
    for (std::size_t k = 0; k < in.bodies[at(id)]; ++k)
        if (b.kind[at(end_of(ctx, id, k))] == BodyKind::kinematic) flags |= model::kCarried;
    in.flags[at(id)] = static_cast<std::uint8_t>(flags);
    constexpr int kWorkFlags = model::kCarried | model::kByInput | model::kMotor | model::kFriction;
    if ((before & kWorkFlags) != 0 && (flags & kWorkFlags) == 0) base::erase_sorted(in.working, id);
}

void update_elements_of_node(context::StepContext& ctx, std::int32_t lump) noexcept {
    model::Interactions& in = ctx.model.interactions;
    in.for_each_holder(lump, ctx.model.bodies, [&](std::int32_t id, std::size_t slot) {
        if (kind_info(in.kinds[at(id)]).is(kAlongLine))
            in.rewire(id, slot, in.def[at(id)].body[slot], ctx.model.bodies);
    });
    context::wake_island(ctx.model, lump);
}

std::int32_t bend_at_body(const context::StepContext& ctx, std::int32_t middle,
                          std::int32_t end) noexcept {
    const std::int32_t first = bend_at(ctx, middle, end, 0), last = bend_at(ctx, middle, end, 2);
    return first < 0 || last < 0 ? std::max(first, last) : std::min(first, last);
}

std::vector<std::int32_t> chain_from(const context::StepContext& ctx, std::int32_t element,
                                     std::size_t slot) {
    const model::Interactions& in = ctx.model.interactions;
    // Unbroken elements of each body; −2: it has another interaction, too.
    std::vector<std::array<std::int32_t, 2>> held(at(ctx.model.bodies.count()), {-1, -1});
    for (std::int32_t id = 0; id < in.count(); ++id) {
        const KindInfo& kind = kind_info(in.kinds[at(id)]);
        if (in.parted[at(id)] != 0 || is_bend(ctx, id)) continue;
        for (std::size_t k = 0; k < in.bodies[at(id)]; ++k) {
            auto& of = held[at(end_of(ctx, id, k))];
            if (!kind.is(kWireElement) || k > 1 || of[1] != -1)
                of = {-2, -2};
            else if (of[0] != -2)
                (of[0] < 0 ? of[0] : of[1]) = id;
        }
    }
    std::vector<std::int32_t> out{element};
    for (std::int32_t far = end_of(ctx, element, 1 - slot); is_free_node(ctx, far);) {
        const auto& of = held[at(far)];
        const std::int32_t next = of[0] == out.back() ? of[1] : of[0];
        if (next < 0 || next == element) break;
        far = end_of(ctx, next, end_of(ctx, next, 0) == far ? 1 : 0);
        out.push_back(next);
    }
    return out;
}

}  // namespace hawser::edit
