// SPDX-License-Identifier: Apache-2.0
#include "world/outputs.h"

#include <hawser/world.h>

#include "assembly/kinetic.h"
#include "step/step.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace hawser {
namespace world {
namespace {

bool has_orientation(const model::Bodies& b, std::int32_t body) noexcept {
    return b.dof(body) == 6 || b.dof(body) == 0;
}

/// Return a vector of the body's frame in world axes.
Vec3 in_world_axes(const model::Bodies& b, std::int32_t body, const Vec3& local) noexcept {
    if (!has_orientation(b, body)) return Vec3::Zero();
    const double* r = &b.r[9 * at(body)];
    Vec3 out;
    for (int i = 0; i < 3; ++i)
        out[i] = r[3 * i] * local[0] + r[3 * i + 1] * local[1] + r[3 * i + 2] * local[2];
    return out;
}

Vec3 position_in_world(const model::Bodies& b, std::int32_t body, const Vec3& point) noexcept {
    const double* x = &b.x[3 * at(body)];
    return Vec3(x[0], x[1], x[2]) + in_world_axes(b, body, point);
}

double pose_component(const model::Bodies& b, std::int32_t body, const Vec3& point,
                      int component) noexcept {
    if (component < kRoll) return position_in_world(b, body, point)[component];
    const double* q = &b.q[4 * at(body)];
    const double w = q[0], x = q[1], y = q[2], z = q[3];
    switch (component) {
        case kRoll:
            return std::atan2(2.0 * (w * x + y * z), 1.0 - 2.0 * (x * x + y * y));
        case kPitch:
            return std::asin(std::clamp(2.0 * (w * y - z * x), -1.0, 1.0));
        case kYaw:
            return std::atan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z));
        default:
            return q[component - kQuaternion];
    }
}

double velocity_component(const model::Bodies& b, const OutputDef& def, int component) noexcept {
    const std::int32_t body = def.body.index;
    const int dof = b.dof(body);
    const double* from = dof == 0 ? &b.v_fixed[6 * at(body)] : &b.v[at(b.dof_begin[at(body)])];
    double v[6] = {};
    std::copy_n(from, dof == 0 ? 6 : dof, v);
    const Vec3 omega(v[3], v[4], v[5]);
    Vec3 out = omega;
    if (component < kTurning)
        out = Vec3(v[0], v[1], v[2]) + omega.cross(in_world_axes(b, body, def.point));
    const int axis = component % kTurning;
    if (!def.local) return out[axis];
    const double* r = &b.r[9 * at(body)];
    return r[axis] * out[0] + r[3 + axis] * out[1] + r[6 + axis] * out[2];
}

double tension(const model::Interactions& in, InteractionId id) noexcept {
    const std::size_t i = at(id.index);
    const double* f = &in.force[at(in.row_begin[i])];
    const KindInfo& kind = kind_info(in.def[i].kind);
    if (kind.is(kPulls)) return -f[0];
    double sum = 0.0;
    for (int r = 0; r < kind.rows && r < 3 && kind.row_units[r] == 'm'; ++r) sum += f[r] * f[r];
    return std::sqrt(sum);
}

/// Return true if all objects that an output reads exist.
bool alive(const context::StepContext& ctx, const WireList& wires, const OutputDef& def) noexcept {
    const auto body = [&](BodyId id) { return !id.valid() || ctx.model.bodies.slots.names(id); };
    const auto one = [&](InteractionId id) {
        return !id.valid() || ctx.model.interactions.slots.names(id);
    };
    return body(def.body) && body(def.body_b) && one(def.interaction) &&
           (!def.wire.valid() || wires.slots.names(def.wire)) &&
           std::all_of(def.line.begin(), def.line.end(), one);
}

/// Return a component of the tensions of a wire's intact elements; NaN if the requested element has
/// been removed.
double wire_tension(const model::Interactions& in, const Wire& wire, int component) noexcept {
    double most = std::numeric_limits<double>::quiet_NaN();
    const auto of = [&](InteractionId id) { return in.slots.names(id) ? tension(in, id) : most; };
    if (component == kFirst) return of(wire.elements.front());
    if (component == kLast) return of(wire.elements.back());
    for (const InteractionId id : wire.elements) {
        const double t = of(id);
        if (!(most >= t)) most = t;
    }
    return most;
}

double line_tension(const model::Interactions& in, const std::vector<InteractionId>& line,
                    int component) noexcept {
    if (component == kFirst) return tension(in, line.front());
    if (component == kLast) return tension(in, line.back());
    double most = tension(in, line.front());
    for (const InteractionId id : line) most = std::max(most, tension(in, id));
    return most;
}

/// Return the output of a drum. A winch counts the length paid out, because it inserts elements and
/// its layers have different radii. For a bare drum the length follows from its coordinate.
double drum(const World& world, const context::StepContext& ctx, const Systems& systems,
            InteractionId id, int component) noexcept {
    const model::Interactions& in = ctx.model.interactions;
    if (component == kLength) return in.rest_length[at(id.index)];
    if (const double paid = systems.paid_out(world, id); !std::isnan(paid)) return paid;
    const InteractionDef& def = in.def[at(id.index)];
    const auto slot = at(kind_info(def.kind).scalar_slot);
    return def.get("radius") *
           (ctx.model.bodies.x[3 * at(def.body[slot].index)] - def.get("drum_zero"));
}

double energy_output(const context::StepContext& ctx, const Energy& energy,
                     int component) noexcept {
    switch (component) {
        case kAsleep:
            return ctx.work.stats.asleep;
        case kKinetic:
            return assembly::kinetic_energy(ctx.model.bodies, ctx.model.bodies.v.data());
        case kApplied:
            return ctx.state.ledger.work;
        case kDriven:
            return ctx.state.ledger.drive;
        case kDissipated:
            return ctx.state.ledger.drag;
        case kFriction:
            return ctx.state.ledger.friction;
        case kContactLoss:
            return ctx.state.ledger.contact;
        case kDamped:
            return ctx.state.ledger.damped;
        case kGravity:
            return energy.gravity;
        case kElastic:
            return energy.elastic;
        default:
            return energy.mechanical();
    }
}

}  // namespace

OutputId Outputs::add(OutputDef def, int component) {
    base::reserve_more(defs_, 1);
    base::reserve_more(component_, 1);
    base::reserve_more(values_, 1);
    base::reserve_more(signal_, 1);
    base::reserve_more(ids_, 1);
    slots_.reserve_more();
    std::int32_t place = slots_.find_vacant([](std::int32_t) { return true; });
    claim_name(names_, def.name, place < 0 ? slots_.count() : place, "output");
    // No call below throws.
    needs_energy_ = needs_energy_ || (def.kind == OutputKind::statistic && component >= kGravity);
    if (place < 0) {
        place = slots_.append();
        defs_.emplace_back();
        component_.push_back(0);
        values_.push_back(0.0);
        signal_.push_back(nullptr);
    } else {
        slots_.take(place);
    }
    defs_[at(place)] = std::move(def);
    component_[at(place)] = static_cast<std::uint8_t>(component);
    values_[at(place)] = 0.0;
    const OutputId id = this->id(place);
    ids_.insert(std::lower_bound(ids_.begin(), ids_.end(), id), id);
    return id;
}

OutputId Outputs::add(const SystemSignal& signal) {
    const OutputId id = add({.name = signal.system + "." + signal.name,
                             .kind = OutputKind::signal,
                             .component = "value",
                             .unit = signal.unit,
                             .group = signal.system},
                            0);
    signal_[at(id.index)] = signal.value;
    return id;
}

void Outputs::remove(std::size_t place) noexcept {
    release(names_, defs_[place].name);
    defs_[place] = {};
    signal_[place] = nullptr;
    values_[place] = std::numeric_limits<double>::quiet_NaN();
    std::erase(ids_, id(static_cast<std::int32_t>(place)));
    slots_.vacate(static_cast<std::int32_t>(place));
    needs_energy_ = false;
    for (std::size_t i = 0; i < defs_.size(); ++i)
        needs_energy_ =
            needs_energy_ || (defs_[i].kind == OutputKind::statistic && component_[i] >= kGravity);
}

void Outputs::remove_signals(std::string_view system) noexcept {
    for (std::size_t i = 0; i < defs_.size(); ++i)
        if (signal_[i] != nullptr && defs_[i].group == system) remove(i);
}

void Outputs::bind(std::span<const SystemSignal> signals) noexcept {
    for (std::size_t i = 0; i < defs_.size(); ++i)
        if (signal_[i] != nullptr)
            for (const SystemSignal& s : signals)
                if (defs_[i].group == s.system &&
                    std::string_view(defs_[i].name).substr(s.system.size() + 1) == s.name)
                    signal_[i] = s.value;
}

std::size_t Outputs::index_of(OutputId id) const {
    return slot_index_of(id, slots_, slots_.count(), "output");
}

void Outputs::store_figures(const StepStats& s) noexcept {
    figures_[kResidual] = s.momentum_residual;
    figures_[kRowResidual] = s.constraint_residual;
    figures_[kViolation] = s.violation_max;
    figures_[kStretchError] = s.stretch_error_max;
    figures_[kNaturalMap] = s.natural_map;
    figures_[kContacts] = s.contacts;
    figures_[kStepTime] = s.step_seconds;
    figures_[kSolverTime] = s.solver_cpu_seconds;
}

void Outputs::evaluate(const World& world, const context::StepContext& ctx, const WireList& wires,
                       const Systems& systems, const Energy& energy) noexcept {
    const model::Bodies& b = ctx.model.bodies;
    const model::Interactions& in = ctx.model.interactions;
    for (std::size_t i = 0; i < defs_.size(); ++i) {
        const OutputDef& def = defs_[i];
        const int c = component_[i];
        if (!slots_.holds(static_cast<std::int32_t>(i)) || !world::alive(ctx, wires, def)) {
            values_[i] = std::numeric_limits<double>::quiet_NaN();
            continue;
        }
        switch (def.kind) {
            case OutputKind::pose:
                values_[i] = pose_component(b, def.body.index, def.point, c);
                break;
            case OutputKind::velocity:
                values_[i] = velocity_component(b, def, c);
                break;
            case OutputKind::coordinate:
                values_[i] = in.coordinate(def.interaction.index, b).value;
                break;
            case OutputKind::speed:
                values_[i] = in.coordinate(def.interaction.index, b).rate;
                break;
            case OutputKind::motor_force:
            case OutputKind::force:
                values_[i] = in.force[at(in.row_begin[at(def.interaction.index)] + c)];
                break;
            case OutputKind::tension:
                values_[i] = def.wire.valid() ? wire_tension(in, wires.wires[at(def.wire.index)], c)
                                              : line_tension(in, def.line, c);
                break;
            case OutputKind::drum:
                values_[i] = drum(world, ctx, systems, def.interaction, c);
                break;
            case OutputKind::distance:
                values_[i] = (position_in_world(b, def.body_b.index, def.point_b) -
                              position_in_world(b, def.body.index, def.point))
                                 .norm();
                break;
            case OutputKind::statistic:
                values_[i] = c < kStepFigures ? figures_[at(c)] : energy_output(ctx, energy, c);
                break;
            case OutputKind::signal:
                values_[i] = *signal_[i];
                break;
        }
    }
}

}  // namespace world

}  // namespace hawser
