// SPDX-License-Identifier: Apache-2.0
#include "edit/node_pieces.h"

#include "base/index.h"

#include <algorithm>

namespace hawser::edit {
namespace {

constexpr std::size_t kSlotsOfInteraction = kMaxInteractionBodies;

using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

bool is_routed(const context::StepContext& ctx, std::int32_t id) noexcept {
    return kind_info(ctx.model.interactions.kinds[at(id)]).is(kRouted);
}

Vec3 arm_of(const context::StepContext& ctx, std::int32_t id, std::size_t slot) noexcept {
    const model::Bodies& b = ctx.model.bodies;
    const auto body = at(end_of(ctx, id, slot));
    if (is_routed(ctx, id))
        return ctx.model.interactions.line_shape(id, b).at[slot] -
               Vec3(b.x[3 * body], b.x[3 * body + 1], b.x[3 * body + 2]);
    if (!b.turns(static_cast<int>(body))) return Vec3::Zero();
    return Eigen::Map<const RowMajor>(&b.r[9 * body]) *
           ctx.model.interactions.def[at(id)].point[slot];
}

}  // namespace

bool is_bend(const context::StepContext& ctx, std::int32_t id) noexcept {
    const KindInfo& kind = kind_info(ctx.model.interactions.kinds[at(id)]);
    return kind.is(kOfWires) && !kind.is(kAlongLine) && kind.bodies == 3;
}

std::int32_t end_of(const context::StepContext& ctx, std::int32_t id, std::size_t slot) noexcept {
    return ctx.model.interactions.body[kSlotsOfInteraction * at(id) + slot];
}
bool is_free_node(const context::StepContext& ctx, std::int32_t body) noexcept {
    return ctx.model.bodies.kind[at(body)] == BodyKind::lump;
}

NodeLinks adjacent_elements(const context::StepContext& ctx, std::int32_t body) noexcept {
    NodeLinks out;
    const model::Interactions& in = ctx.model.interactions;
    in.for_each_holder(body, ctx.model.bodies, [&](std::int32_t id, std::size_t slot) {
        if (in.parted[at(id)] != 0 || is_bend(ctx, id)) return;
        if (!kind_info(in.kinds[at(id)]).is(kWireElement) || slot > 1) {
            out.has_only_bends = false;
            return;
        }
        std::int32_t& side = slot == 0 ? out.after : out.before;
        if (side >= 0) out.has_only_bends = false;
        if (side < 0 || id < side) side = id;
    });
    return out;
}

std::int32_t bend_at(const context::StepContext& ctx, std::int32_t middle, std::int32_t other,
                     std::size_t side) noexcept {
    const model::Interactions& in = ctx.model.interactions;
    std::int32_t out = -1;
    in.for_each_holder(middle, ctx.model.bodies, [&](std::int32_t id, std::size_t slot) {
        if (slot == 1 && in.kinds[at(id)] == InteractionKind::Bend &&
            end_of(ctx, id, side) == other && (out < 0 || id < out))
            out = id;
    });
    return out;
}

std::int32_t next_bend(const context::StepContext& ctx, std::span<const std::int32_t> bodies,
                       std::int32_t after) noexcept {
    const model::Interactions& in = ctx.model.interactions;
    std::int32_t out = -1;
    for (const std::int32_t body : bodies)
        in.for_each_holder(body, ctx.model.bodies, [&](std::int32_t id, std::size_t) {
            if (id > after && in.kinds[at(id)] == InteractionKind::Bend && (out < 0 || id < out))
                out = id;
        });
    return out;
}

double mass_of_element(const context::StepContext& ctx, std::int32_t element) noexcept {
    return 6.0 * ctx.model.interactions.pair_mass[at(element)];
}

bool is_of_material(const context::StepContext& ctx, std::int32_t element) noexcept {
    const model::Interactions& in = ctx.model.interactions;
    return (in.flags[at(element)] & model::kFromLength) != 0 &&
           !kind_info(in.kinds[at(element)]).is(kWoundUp);
}

bool is_at_drum(const context::StepContext& ctx, std::int32_t element) noexcept {
    return kind_info(ctx.model.interactions.kinds[at(element)]).is(kWoundUp);
}
std::size_t drum_side(const context::StepContext& ctx, std::int32_t element) noexcept {
    if (is_routed(ctx, element))
        return ctx.model.interactions.def[at(element)].get("radius") > 0.0 ? 0 : 1;
    return is_free_node(ctx, end_of(ctx, element, 0)) ? 1 : 0;
}
Vec3 inflow_velocity(const context::StepContext& ctx, std::int32_t element, double beyond,
                     const base::Array<double>& packed) noexcept {
    const model::Bodies& b = ctx.model.bodies;
    const auto drum = at(end_of(ctx, element, 2));
    const std::size_t side = drum_side(ctx, element);
    const Vec3 chord = point_of(ctx, element, 1 - side) - point_of(ctx, element, side);
    const double speed =
        ctx.model.interactions.def[at(element)].get("radius") * packed[at(b.dof_begin[drum])];
    // The fraction of the path between drum and position is that of the straight part, times
    // straight over path, because the part on the wheel does not count.
    const double more = length_beyond_chord(ctx, element);
    return more * beyond * speed / ctx.model.interactions.rest_length[at(element)] * (more * chord);
}

double length_of(const context::StepContext& ctx, std::int32_t id) noexcept {
    if (!is_routed(ctx, id)) return (point_of(ctx, id, 1) - point_of(ctx, id, 0)).norm();
    const InteractionDef& d = ctx.model.interactions.def[at(id)];
    const double slide = ctx.model.bodies.x[3 * at(end_of(ctx, id, 2))];
    return ctx.model.interactions.line_shape(id, ctx.model.bodies).longer + d.params[0] +
           d.params[4] * (slide - d.params[5]);
}
double length_beyond_chord(const context::StepContext& ctx, std::int32_t id) noexcept {
    if (!is_routed(ctx, id)) return 1.0;
    return length_of(ctx, id) / (point_of(ctx, id, 1) - point_of(ctx, id, 0)).norm();
}
double straight_fraction(const context::StepContext& ctx, std::int32_t id, double share) noexcept {
    if (!is_routed(ctx, id)) return share;
    const double more = length_beyond_chord(ctx, id);
    // Counted from the end that is not at a drum or guide.
    const double out = drum_side(ctx, id) == 0 ? 1.0 - more * (1.0 - share) : more * share;
    return std::clamp(out, 0.0, 1.0);
}
Vec3 attachment_point(const context::StepContext& ctx, std::int32_t id, std::size_t slot) noexcept {
    if (!is_routed(ctx, id)) return ctx.model.interactions.def[at(id)].point[slot];
    const model::Bodies& b = ctx.model.bodies;
    const auto body = end_of(ctx, id, slot);
    if (!b.turns(body)) return Vec3::Zero();
    return Eigen::Map<const RowMajor>(&b.r[9 * at(body)]).transpose() * arm_of(ctx, id, slot);
}

Vec3 point_of(const context::StepContext& ctx, std::int32_t id, std::size_t slot) noexcept {
    const double* x = &ctx.model.bodies.x[3 * at(end_of(ctx, id, slot))];
    return Vec3(x[0], x[1], x[2]) + arm_of(ctx, id, slot);
}

Vec3 speed_of(const context::StepContext& ctx, std::int32_t id, std::size_t slot,
              const base::Array<double>& packed) noexcept {
    const model::Bodies& b = ctx.model.bodies;
    const auto body = at(end_of(ctx, id, slot));
    const int dof = b.dof(static_cast<int>(body));
    const double* v = dof > 0 ? &packed[at(b.dof_begin[body])] : &b.v_fixed[6 * body];
    const Vec3 lin(v[0], v[1], v[2]);
    return dof == 3 ? lin : Vec3(lin + Vec3(v[3], v[4], v[5]).cross(arm_of(ctx, id, slot)));
}

double tension_of(const context::StepContext& ctx, std::int32_t id) noexcept {
    const model::Interactions& in = ctx.model.interactions;
    const double length = length_of(ctx, id);
    const double pull = (length - in.rest_length[at(id)]) / in.epsilon[at(in.row_begin[at(id)])];
    return (in.flags[at(id)] & model::kOneSided) ? std::max(0.0, pull) : pull;
}
double stiffness_of(const context::StepContext& ctx, std::int32_t id) noexcept {
    const model::Interactions& in = ctx.model.interactions;
    return in.rest_length[at(id)] / in.epsilon[at(in.row_begin[at(id)])];
}

double stretching_speed(const context::StepContext& ctx, std::int32_t id) noexcept {
    const model::Bodies& b = ctx.model.bodies;
    const Vec3 u = (point_of(ctx, id, 1) - point_of(ctx, id, 0)).normalized();
    double rate = u.dot(speed_of(ctx, id, 1, b.v) - speed_of(ctx, id, 0, b.v));
    if (is_at_drum(ctx, id))
        rate -= ctx.model.interactions.def[at(id)].get("radius") *
                b.v[at(b.dof_begin[at(end_of(ctx, id, 2))])];
    return rate;
}
/// Return the damping time τ with which the law of a row at a constant rate ġ is λ = −(h/ε)(g + τ
/// ġ): τ = (h/4)(1/Υ − recall). It includes the numerical damping of stiff rows (row_constants.h).
double damping_time_of(const context::StepContext& ctx, std::int32_t id) noexcept {
    const model::Interactions& in = ctx.model.interactions;
    const auto row = at(in.row_begin[at(id)]);
    return 0.25 * ctx.model.def.step * (1.0 / in.upsilon[row] - in.recall[row]);
}
double force_of(const context::StepContext& ctx, std::int32_t id) noexcept {
    const model::Interactions& in = ctx.model.interactions;
    const auto row = at(in.row_begin[at(id)]);
    const double length = length_of(ctx, id);
    const double pull =
        (length - in.rest_length[at(id)] + damping_time_of(ctx, id) * stretching_speed(ctx, id)) /
        in.epsilon[row];
    return (in.flags[at(id)] & model::kOneSided) ? std::max(0.0, pull) : pull;
}
double rest_length_for_force(const context::StepContext& ctx, std::int32_t id, double force,
                             double stiffness) noexcept {
    const double length = length_of(ctx, id);
    const double damped = damping_time_of(ctx, id) * stretching_speed(ctx, id);
    // A rate that would move by about the length of the element is not a strain.
    constexpr double kMaxRateStrain = 0.1;
    return (length + std::clamp(damped, -kMaxRateStrain * length, kMaxRateStrain * length)) /
           (1.0 + force / stiffness);
}

Vec3 weight_of(const context::StepContext& ctx, std::int32_t id, double mass) noexcept {
    const model::Bodies& b = ctx.model.bodies;
    Vec3 applied = Vec3::Zero();
    int lumps = 0;
    for (std::size_t slot = 0; slot < 2; ++slot) {
        const auto body = at(end_of(ctx, id, slot));
        if (!is_free_node(ctx, static_cast<std::int32_t>(body))) continue;
        if (b.weight[body] == 0) return Vec3::Zero();
        for (std::size_t k = 0; k < 3; ++k)
            applied[static_cast<int>(k)] += b.force[6 * body + k] / b.mass[body];
        ++lumps;
    }
    if (lumps > 1) applied *= 0.5;
    return mass * (ctx.model.def.gravity + applied);
}

Vec3 sag_below_chord(const Vec3& chord, double share, const Vec3& weight, double tension) noexcept {
    const double length = chord.norm();
    if (!(tension > 0.0) || !(length > 0.0)) return Vec3::Zero();
    const Vec3 along = chord / length, across = weight - weight.dot(along) * along;
    // Far from taut the equilibrium is that of a chain instead of a small sag.
    constexpr double kMaxSag = 0.1;
    const double sag = length * share * (1.0 - share) / tension;
    const double most = kMaxSag * length * std::min(share, 1.0 - share);
    return across * std::min(sag, most / std::max(across.norm(), 1e-300));
}

void set_element(context::StepContext& ctx, std::int32_t id, double rest, double mass,
                 double tension) noexcept {
    model::Interactions& in = ctx.model.interactions;
    InteractionDef& d = in.def[at(id)];
    const double before = in.rest_length[at(id)];
    d.params[0] = rest;
    const auto row = at(in.row_begin[at(id)]);
    if (is_at_drum(ctx, id)) {
        d.set("drum_zero", ctx.model.bodies.x[3 * at(end_of(ctx, id, 2))]);
    } else if (in.row_flags[row] & model::kRowDamper) {
        // A fraction of critical damping is proportional to the length.
        d.damping_time[0] *= rest / before;
        in.tau[row] = d.damping_time[0];
    }
    in.refresh(id, ctx.model.bodies, ctx.model.def.step);
    in.set_mass(id, mass);
    if (is_of_material(ctx, id)) d.compliance[0] = in.epsilon[row];
    in.lambda[row] = -ctx.model.def.step * tension;
    in.force[row] = -tension;
    if (tension > 0.0) in.active[at(id)] = 1.0;
}

void add_mass(context::StepContext& ctx, std::int32_t body, double more,
              const Vec3& damping) noexcept {
    model::Bodies& b = ctx.model.bodies;
    if (!is_free_node(ctx, body)) return;
    b.mass[at(body)] += more;
    for (std::size_t k = 0; k < 3; ++k) b.damping[6 * at(body) + k] += damping[static_cast<int>(k)];
}
Vec3 damping_of(const context::StepContext& ctx, std::int32_t body) noexcept {
    if (!is_free_node(ctx, body)) return Vec3::Zero();
    const double* d = &ctx.model.bodies.damping[6 * at(body)];
    return {d[0], d[1], d[2]};
}

void set_bend(context::StepContext& ctx, std::int32_t id, std::int32_t one,
              std::int32_t other) noexcept {
    if (id < 0 || one < 0 || other < 0) return;
    model::Interactions& in = ctx.model.interactions;
    InteractionDef& d = in.def[at(id)];
    d.params[1] = 0.5 * (in.rest_length[at(one)] + in.rest_length[at(other)]);
    for (std::size_t r = 0; r < 2; ++r) {
        const auto row = at(in.row_begin[at(id)]) + r;
        d.compliance[r] = in.epsilon[row] = d.params[1] / d.params[0];
        in.update_damping_of_row(row, false, ctx.model.def.step);
    }
    in.refresh(id, ctx.model.bodies, ctx.model.def.step);
}

void update_for_masses(context::StepContext& ctx, const NodeSurroundings& place) noexcept {
    model::Interactions& in = ctx.model.interactions;
    // Ends of the elements at the node; gear may hold them as well.
    std::int32_t lumps[4] = {-1, -1, -1, -1};
    std::size_t next = 0;
    for (const std::int32_t id : {place.first, place.second})
        for (std::size_t slot = 0; slot < 2; ++slot, ++next)
            if (id >= 0) lumps[next] = end_of(ctx, id, slot);
    for (const std::int32_t lump : lumps)
        if (lump >= 0)
            in.for_each_holder(lump, ctx.model.bodies, [&](std::int32_t id, std::size_t slot) {
                if (slot < 2 && kind_info(in.kinds[at(id)]).is(kAlongLine))
                    in.rewire(id, 0, in.def[at(id)].body[0], ctx.model.bodies);
            });
}

}  // namespace hawser::edit
