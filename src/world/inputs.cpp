// SPDX-License-Identifier: Apache-2.0
/// Inputs of a world.
#include <hawser/world.h>

#include "context/asleep.h"
#include "world/checks.h"
#include "world/impl.h"
#include "world/lookup.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace hawser {

using world::claim_name;
using world::lookup;

namespace {

/// Reject a nominal value or a spring value of an input that a display could not use.
void check_display(const InputDef& def, const world::Where& where) {
    if (!(def.nominal >= 0.0) || !std::isfinite(def.nominal))
        throw DefError(where.text() + ": nominal = " + world::number(def.nominal) +
                       ": give a size above 0, or 0 where none is known");
    if (def.spring && !std::isfinite(*def.spring))
        throw DefError(where.text() + ": spring is not a finite number; leave it out for none");
}

/// Limit the range of an input to that of its parameter, because an input must not reach values
/// that add_interaction() rejects.
void limit_to_param(InputDef& def, const KindInfo& kind, const world::Where& where) {
    for (const ParamInfo& p : kind.params) {
        if (def.param != p.name) continue;
        if (!p.input)
            throw DefError(where.text() + ": parameter '" + def.param + "' of a " + kind.name +
                           " cannot change between steps");
        def.min = std::max(def.min, p.min);
        def.max = std::min(def.max, p.max);
        if (def.min > def.max)
            throw DefError(where.text() + ": the range lies outside that of parameter '" +
                           def.param + "', " + world::number(p.min) + " … " + world::number(p.max));
    }
}

constexpr double kMaxInputForce = 1e30;  ///< [N, N m]

/// Range of values that the physics of an input supports. InputDef::min and max may be narrower.
struct Followed {
    double min = -kMaxInputForce, max = kMaxInputForce;
    const char* unit = "";
};

Followed followed_target(const World& world, const InputDef& def) {
    if (!def.interaction.valid()) return {.unit = def.component < 3 ? "N" : "N m"};
    for (const ParamInfo& p : kind_info(world.interaction_def(def.interaction).kind).params)
        if (def.param == p.name) return {p.min, p.max, p.unit};
    return {};
}

constexpr std::pair<const char*, const char*> kRangeParams[] = {{"min", "max"},
                                                                {"force_min", "force_max"}};

/// Reject a value that would set a minimum above its maximum, as add_interaction() does.
void check_pair(const World& world, const InputDef& def, double value) {
    if (!def.interaction.valid()) return;
    const InteractionDef& d = world.interaction_def(def.interaction);
    for (const auto& [low, high] : kRangeParams) {
        if (def.param != low && def.param != high) continue;
        const char* const other = def.param == low ? high : low;
        const double other_value = d.get(other);
        if (def.param == low ? value <= other_value : value >= other_value) continue;
        throw DefError(world::label("input", def.name) + ": value = " + world::number(value) +
                       ": " + low + " would be above " + high + ", as " + other + " is " +
                       world::number(other_value) + "; set that first");
    }
}

/// Reject a second input of a parameter. A restored world could not determine which was set last.
void check_single_input(const InputDef& other, const InputDef& def, const world::Where& where) {
    if (other.interaction == def.interaction && other.param == def.param)
        throw DefError(where.text() + ": input '" + other.name + "' drives '" + def.param +
                       "' of the same interaction; one input a parameter");
}

}  // namespace

InputId World::add_input(const InputDef& def) {
    const world::Using use(impl_->use, "add_input");
    Impl& m = *impl_;
    const world::Where where("input", def.name);
    if (def.name.empty()) throw DefError("an input needs a name");
    if (!std::isfinite(def.min) || !std::isfinite(def.max) || def.min > def.max)
        throw DefError(where.text() + ": min = " + world::number(def.min) +
                       ", max = " + world::number(def.max) + ": the range is empty or not finite");
    check_display(def, where);
    double value = 0.0;
    InputDef allowed = def;
    if (def.interaction.valid()) {
        const InteractionDef& d = interaction_def(def.interaction);
        value = d.get(def.param);
        limit_to_param(allowed, kind_info(d.kind), where);
        for (const InputId other : m.input_ids)
            check_single_input(m.inputs[at(other.index)], def, where);
    } else {
        const std::size_t b = impl_->index_of(def.body);
        if (def.component < 0 || def.component > 5)
            throw DefError(where.text() + ": component must be 0 to 5");
        if (def.min > kMaxInputForce || def.max < -kMaxInputForce)
            throw DefError(where.text() + ": the range lies outside -1e30 to 1e30 N or N m");
        allowed.min = std::max(def.min, -kMaxInputForce);
        allowed.max = std::min(def.max, kMaxInputForce);
        if (def.local && m.ctx.model.bodies.kind[b] != BodyKind::rigid)
            throw DefError(where.text() + ": local: its body does not rotate; leave it false");
    }
    if (def.local && def.interaction.valid())
        throw DefError(where.text() +
                       ": local: only a force or torque on a body has a frame to turn in");
    if (def.spring && !(*def.spring >= allowed.min && *def.spring <= allowed.max))
        throw DefError(where.text() + ": spring = " + world::number(*def.spring) +
                       " is outside of its range, " + world::number(allowed.min) + " … " +
                       world::number(allowed.max));
    base::reserve_more(m.inputs, 1);
    base::reserve_more(m.input_values, 1);
    base::reserve_more(m.input_ids, 1);
    base::reserve_more(m.force_inputs, 1);
    base::reserve_more(m.ctx.model.interactions.working, 1);
    m.input_slots.reserve_more();
    if (def.local) {
        base::reserve_more(m.local_inputs, 1);
        m.forces_before.resize(6 * (m.local_inputs.size() + 1));
    }
    std::int32_t place = m.input_slots.find_vacant([](std::int32_t) { return true; });
    claim_name(m.input_names, def.name, place < 0 ? input_count() : place, "input");
    // No call below throws.
    if (def.interaction.valid()) m.ctx.model.interactions.mark_driven(def.interaction.index);
    if (place < 0) {
        place = m.input_slots.append();
        m.inputs.emplace_back();
        m.input_values.emplace_back();
    } else {
        m.input_slots.take(place);
    }
    if (def.local) m.local_inputs.push_back(place);
    if (!def.interaction.valid() && !def.local) {
        const Impl::ForceInput one{def.body.index, def.component, place};
        m.force_inputs.insert(std::lower_bound(m.force_inputs.begin(), m.force_inputs.end(), one),
                              one);
    }
    m.inputs[at(place)] = std::move(allowed);
    m.input_values[at(place)] = value;
    const auto id = m.input_slots.id<InputId>(place);
    m.input_ids.insert(std::lower_bound(m.input_ids.begin(), m.input_ids.end(), id), id);
    if (m.listener != nullptr) m.listener->added(def);
    return id;
}

int World::input_count() const noexcept { return static_cast<int>(impl_->inputs.size()); }
std::span<const InputId> World::inputs() const noexcept { return impl_->input_ids; }
const InputDef& World::input_def(InputId id) const { return impl_->inputs[impl_->index_of(id)]; }
InputId World::find_input(std::string_view name) const noexcept {
    return impl_->input_slots.id<InputId>(lookup(impl_->input_names, name));
}
double World::input(InputId id) const { return impl_->input_values[impl_->index_of(id)]; }

void World::set_input(InputId id, double value) {
    const world::Using use(impl_->use, "set_input");
    const std::size_t i = impl_->index_of(id);
    const InputDef& def = impl_->inputs[i];
    const Followed range = followed_target(*this, def);
    if (!(value >= range.min && value <= range.max))
        throw DefError(
            world::label("input", def.name) + ": value = " + world::number(value) + " " +
            range.unit +
            (std::isfinite(value) ? " is outside its range" : " is not a finite number") +
            "; give one from " + world::number(std::max(range.min, def.min)) + " to " +
            world::number(std::min(range.max, def.max)) + " " + range.unit);
    const double clamped = std::min(std::max(value, def.min), def.max);
    check_pair(*this, def, clamped);
    context::StepContext& c = impl_->ctx;
    if (clamped != value) {
        c.state.events.push({c.state.time, EventKind::input_clamped, def.interaction, value, id});
        ++c.work.stats.event_count[static_cast<std::size_t>(EventKind::input_clamped)];
    }
    // A change of elastic energy by a new length or target is work of the input.
    const auto elastic = [&] {
        return def.interaction.valid() && c.state.started
                   ? c.model.interactions.elastic(def.interaction.index, c.model.bodies,
                                                  c.model.def.step)
                   : 0.0;
    };
    const double before = elastic();
    const bool elsewhere = !def.local && clamped != impl_->applied(def);
    if (elsewhere || clamped != impl_->input_values[i]) impl_->disturb(def);
    impl_->apply_input(i, clamped);
    c.state.ledger.drive += elastic() - before;
    if (impl_->listener != nullptr) impl_->listener->set(id, value);
}

bool WorldImpl::leaves_empty_range(std::int32_t input) const noexcept {
    const InputDef& def = inputs[at(input)];
    if (!def.interaction.valid()) return false;
    const InteractionDef& d = ctx.model.interactions.def[at(def.interaction.index)];
    for (const auto& [low, high] : kRangeParams)
        if ((def.param == low || def.param == high) && d.get(low) > d.get(high)) return true;
    return false;
}

double WorldImpl::applied(const InputDef& input) const {
    if (input.interaction.valid())
        return ctx.model.interactions.def[at(input.interaction.index)].get(input.param);
    return input_values[at(&input - inputs.data())];
}

void WorldImpl::disturb(const InputDef& input) noexcept {
    if (!input.interaction.valid()) {
        context::wake_island(ctx.model, input.body.index);
        return;
    }
    const std::size_t first = kMaxInteractionBodies * at(input.interaction.index);
    for (std::size_t b = 0; b < ctx.model.interactions.bodies[at(input.interaction.index)]; ++b) {
        context::wake_island(ctx.model, ctx.model.interactions.body[first + b]);
    }
}

void WorldImpl::apply_input(std::size_t index, double value) {
    const InputDef& def = inputs[index];
    input_values[index] = value;
    if (def.interaction.valid()) {
        ctx.model.interactions.def[at(def.interaction.index)].set(def.param, value);
        ctx.model.interactions.refresh(def.interaction.index, ctx.model.bodies, ctx.model.def.step);
    } else if (!def.local) {
        add_up_force(def.body, def.component);
    }
}

double WorldImpl::user_force(std::size_t body, int component) const noexcept {
    const BodyDef& def = body_defs[body];
    return component < 3 ? def.force[component] : def.torque[component - 3];
}

void WorldImpl::add_up_force(BodyId body, int component) noexcept {
    double sum = user_force(at(body.index), component);
    auto input = std::lower_bound(force_inputs.begin(), force_inputs.end(),
                                  ForceInput{body.index, component, 0});
    for (;
         input != force_inputs.end() && input->body == body.index && input->component == component;
         ++input)
        sum += input_values[at(input->input)];
    ctx.model.bodies.force[6 * at(body.index) + at(component)] = sum;
}

void WorldImpl::remove_user_forces() noexcept {
    for (const ForceInput& input : force_inputs)
        ctx.model.bodies.force[6 * at(input.body) + at(input.component)] =
            user_force(at(input.body), input.component);
}

void WorldImpl::add_up_forces() noexcept {
    for (const ForceInput& input : force_inputs) add_up_force(BodyId{input.body}, input.component);
}

void WorldImpl::set_user_forces() noexcept {
    for (const BodyId id : body_ids)
        for (int c = 0; c < 6; ++c)
            ctx.model.bodies.force[6 * at(id.index) + at(c)] = user_force(at(id.index), c);
    add_up_forces();
}

void WorldImpl::add_user_forces() noexcept {
    for (const BodyId id : body_ids) {
        const double* force = &ctx.model.bodies.force[6 * at(id.index)];
        BodyDef& def = body_defs[at(id.index)];
        def.force = Vec3(force[0], force[1], force[2]);
        def.torque = Vec3(force[3], force[4], force[5]);
    }
    add_up_forces();
}

void WorldImpl::rotate_forces() noexcept {
    double* before = forces_before.data();
    for (const std::int32_t i : local_inputs) {
        const InputDef& def = inputs[at(i)];
        double* force = &ctx.model.bodies.force[6 * at(def.body.index)];
        before = std::copy_n(force, 6, before);
        const double* r = &ctx.model.bodies.r[9 * at(def.body.index)];
        const int axis = def.component % 3, first = def.component - axis;
        for (int k = 0; k < 3; ++k) force[first + k] += r[3 * k + axis] * input_values[at(i)];
    }
}

void WorldImpl::unrotate_forces() noexcept {
    // Reverse order, because several inputs may act on one body.
    for (std::size_t k = local_inputs.size(); k-- > 0;) {
        const InputDef& def = inputs[at(local_inputs[k])];
        std::copy_n(&forces_before[6 * k], 6, &ctx.model.bodies.force[6 * at(def.body.index)]);
    }
}

}  // namespace hawser
