// SPDX-License-Identifier: Apache-2.0
/// Access of users to the systems of a world, and of systems to its inputs within a step.
#include <hawser/world.h>

#include "context/context.h"
#include "world/checks.h"
#include "world/impl.h"
#include "world/lookup.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>

namespace hawser {

System& World::add_system(std::unique_ptr<System> system) {
    Impl& m = *impl_;
    const Nonsmooth method = m.ctx.model.def.nonsmooth;
    if (method == Nonsmooth::pgs || method == Nonsmooth::split)
        throw DefError(
            "add_system: nonsmooth = pgs and split process bodies one by one and do not support "
            "loads of systems; choose newton");
    const std::size_t before = m.systems.signals().size();
    System& out = m.systems.add(std::move(system));
    const auto signals = std::span(m.systems.signals()).subspan(before);
    try {
        for (const SystemSignal& signal : signals) m.outputs.add(signal);
    } catch (...) {
        m.outputs.remove_signals(out.name());
        (void)m.systems.remove(out);
        throw;
    }
    m.ctx.actors = &m.systems;
    return out;
}

std::unique_ptr<System> World::remove_system(const System& system) {
    Impl& m = *impl_;
    std::unique_ptr<System> out = m.systems.remove(system);
    m.outputs.remove_signals(out->name());
    if (m.systems.count() == 0) m.ctx.actors = nullptr;
    return out;
}

int World::system_count() const noexcept { return static_cast<int>(impl_->systems.count()); }
System& World::system(int index) {
    if (index < 0 || index >= system_count())
        throw DefError("there is no system " + std::to_string(index));
    return impl_->systems.at(at(index));
}
System* World::find_system(std::string_view name) noexcept { return impl_->systems.find(name); }
const System* World::find_system(std::string_view name) const noexcept {
    return impl_->systems.find(name);
}
std::span<const SystemSignal> World::system_signals() const noexcept {
    return impl_->systems.signals();
}
double World::system_signal(std::string_view name) const {
    return *impl_->systems.signal(name).value;
}
void World::set_system_signal(std::string_view name, double value) {
    const SystemSignal& s = impl_->systems.signal(name);
    if (!s.input)
        throw DefError("signal '" + std::string(name) + "' is an output, which is only read");
    if (!std::isfinite(value))
        throw DefError("signal '" + std::string(name) + "': value = " + world::number(value) + " " +
                       s.unit + " is not a finite number; give one from " + world::number(s.min) +
                       " to " + world::number(s.max) + " " + s.unit);
    *s.value = std::clamp(value, s.min, s.max);
    if (*s.value == value) return;
    Event clamped{.time = impl_->ctx.state.time, .kind = EventKind::input_clamped, .value = value};
    clamped.signal = static_cast<std::int32_t>(&s - impl_->systems.signals().data());
    impl_->ctx.state.events.push(clamped);
    ++impl_->ctx.work.stats.event_count[static_cast<std::size_t>(EventKind::input_clamped)];
}
std::vector<LoadView> World::loads() const { return impl_->ctx.state.loads.view(); }
LoadRecord World::load_record() const { return impl_->ctx.state.loads.record(); }
const BadLoad& World::bad_load() const noexcept { return impl_->systems.bad; }

bool WorldImpl::set(InputId id, double value, Before& before) noexcept {
    if (!input_slots.names(id) || !std::isfinite(value)) return false;
    const InputDef& def = inputs[at(id.index)];
    before.input = id.index;
    before.value = input_values[at(id.index)];
    before.applied = applied(def);
    before.asked = value;
    const double within = std::min(std::max(value, def.min), def.max);
    before.clamped = within != value;
    if (def.interaction.valid()) {
        const std::size_t first = kMaxInteractionBodies * at(def.interaction.index);
        for (std::size_t b = 0; b < ctx.model.interactions.bodies[at(def.interaction.index)]; ++b)
            before.body[b] = ctx.model.interactions.body[first + b];
    } else {
        before.body[0] = def.body.index;
    }
    for (std::size_t b = 0; b < 3; ++b)
        if (before.body[b] >= 0) before.quiet[b] = ctx.model.bodies.quiet[at(before.body[b])];
    const auto elastic = [&] {
        return def.interaction.valid() && ctx.state.started
                   ? ctx.model.interactions.elastic(def.interaction.index, ctx.model.bodies,
                                                    ctx.model.def.step)
                   : 0.0;
    };
    const double held = elastic();
    before.moved = within != before.applied;
    if (before.moved || within != before.value) disturb(def);
    apply_input(at(id.index), within);
    ctx.state.ledger.drive += elastic() - held;
    // Reported as if set before the step, which is equivalent: a recording needs no systems.
    if (listener != nullptr) listener->set(id, value);
    return true;
}

void WorldImpl::take_back(const Before& before) noexcept {
    apply_input(at(before.input), before.applied);
    input_values[at(before.input)] = before.value;
    for (std::size_t b = 0; b < 3; ++b)
        if (before.body[b] >= 0) ctx.model.bodies.quiet[at(before.body[b])] = before.quiet[b];
}

void WorldImpl::tell(const Before& before) noexcept {
    ctx.state.events.push({ctx.state.time, EventKind::input_clamped,
                           inputs[at(before.input)].interaction, before.asked,
                           input_slots.id<InputId>(before.input)});
    ++ctx.work.stats.event_count[static_cast<std::size_t>(EventKind::input_clamped)];
}

std::string to_string(const BadLoad& load, const World& world) {
    if (load.reason[0] == '\0') return "";
    const std::string who = "system '" + std::string(load.system) + "'";
    if (load.of_edit) return who + ": " + load.reason;
    if (load.of_input) {
        const bool input_exists = world.alive(load.input);
        const std::string which = input_exists ? "input '" + world.input_def(load.input).name + "'"
                                               : "input " + std::to_string(load.input.index);
        return who + ": " + which + ": " + load.reason;
    }
    const bool body_exists = world.alive(load.body);
    return who + ": its load" +
           (body_exists ? " on " + world::label("body", world.body_def(load.body).name)
                        : std::string()) +
           ": " + load.reason;
}

}  // namespace hawser
