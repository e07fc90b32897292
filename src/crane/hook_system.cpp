// SPDX-License-Identifier: Apache-2.0
#include "crane/hook_system.h"

#include <hawser/world.h>

#include "crane/common.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hawser::crane {

std::optional<ShapeDef> leg_shape_of(const World& world, BodyId hook, BodyId load, const Vec3& eye,
                                     std::string name) {
    if (world.body_def(hook).kind != BodyKind::lump) return std::nullopt;
    for (const ShapeId id : world.shapes()) {
        const ShapeDef& of_wire = world.shape_def(id);
        if (!of_wire.body_b.valid() || (of_wire.body != hook && of_wire.body_b != hook)) continue;
        ShapeDef leg = of_wire;
        leg.name = std::move(name);
        leg.body = hook;
        leg.body_b = load;
        leg.position = world.body_def(load).kind == BodyKind::lump ? Vec3(Vec3::Zero()) : eye;
        return leg;
    }
    return std::nullopt;
}

HookSystem::HookSystem(HookDef def)
    : def_(std::move(def)),
      attach_request_(def_.take),
      attached_load_(def_.take),
      attached_output_(def_.take) {
    std::size_t most = 0;
    for (const CraneLoad& load : def_.loads) most = std::max(most, load.eyes.size());
    for (std::size_t i = 0; i < most; ++i) leg_names_.push_back(leg_name(def_.name, i));
    set_state(attached_load_ > 0 ? HookState::holding : HookState::empty);
    as_ = state_;
}

void HookSystem::visit_state(StateVisitor& v) {
    for (double* x : {&attach_request_, &attached_output_, &load_, &leg_, &as_}) v.visit(*x);
    for (std::int32_t* x : {&attached_load_, &state_, &reported_}) v.visit(*x);
}

void HookSystem::check_state(const World& world, StateRules& rules) const {
    static_cast<void>(world);
    rules.require(
        attached_load_ >= 0 && static_cast<std::size_t>(attached_load_) <= def_.loads.size(),
        "there is no such load");
    rules.require(state_ >= 0 && state_ <= static_cast<std::int32_t>(HookState::opened),
                  "there is no such state of the hook");
    rules.flag(reported_, "whether a miss was reported is no flag");
}

void HookSystem::signals(SignalTable& table) {
    table.input("take", "1", attach_request_, 0.0, static_cast<double>(def_.loads.size()));
    table.output("held", "1", attached_output_);
    table.output("load", "N", load_);
    table.output("leg", "N", leg_);
    table.output("state", "1", as_);
}

/// Return the number of the requested load. A modified saved state may contain any value; invalid
/// values count as 0.
int HookSystem::requested_load() const noexcept {
    const int most = static_cast<int>(def_.loads.size());
    return attach_request_ >= 0.0 && attach_request_ <= most
               ? static_cast<int>(std::lround(attach_request_))
               : 0;
}

/// Measure the forces of the legs. @return true if at least one leg is attached and intact.
bool HookSystem::measure_load(const World& world) noexcept {
    const CraneLoad& load = load_of(attached_load_);
    const Vec3 point = world.world_point(def_.body, def_.point);
    Vec3 pull = Vec3::Zero();
    bool any_intact = false;
    leg_ = 0.0;
    for (std::size_t i = 0; i < load.eyes.size(); ++i) {
        const InteractionId leg = world.find_interaction(leg_names_[i]);
        if (!world.alive(leg) || !world.intact(leg)) continue;
        any_intact = true;
        const double tension = std::max(0.0, -world.force(leg)[0]);
        leg_ = std::max(leg_, tension);
        pull += tension * (world.world_point(load.body, load.eyes[i]) - point).normalized();
    }
    load_ = pull.norm();
    return any_intact;
}

void HookSystem::remove_leg_shape(Prestep& now, std::size_t i) noexcept {
    if (const ShapeId shape = now.world.find_shape(leg_names_[i]); now.world.alive(shape))
        now.edits.remove_shape(shape);
}

/// Remove the contact shapes of broken legs.
void HookSystem::remove_broken_shapes(Prestep& now) noexcept {
    for (std::size_t i = 0; i < load_of(attached_load_).eyes.size(); ++i) {
        const InteractionId leg = now.world.find_interaction(leg_names_[i]);
        if (!now.world.alive(leg) || !now.world.intact(leg)) remove_leg_shape(now, i);
    }
}

void HookSystem::detach_load(Prestep& now, EventKind kind) noexcept {
    const CraneLoad& load = load_of(attached_load_);
    for (std::size_t i = 0; i < load.eyes.size(); ++i) {
        if (const InteractionId leg = now.world.find_interaction(leg_names_[i]);
            now.world.alive(leg))
            now.edits.remove_interaction(leg);
        remove_leg_shape(now, i);
    }
    if (now.world.alive(load.body)) now.tell(kind, load.body, load_);
    attached_load_ = 0;
    load_ = leg_ = 0.0;
}

void HookSystem::check_load(Prestep& now) noexcept {
    const bool load_attached = measure_load(now.world);
    if (load_attached && load_ > def_.strength) {
        detach_load(now, EventKind::overload);
        return set_state(HookState::opened);
    }
    remove_broken_shapes(now);
    if (load_attached && requested_load() == attached_load_) return set_state(HookState::holding);
    if (load_attached && load_ > def_.latch) return set_state(HookState::latched);
    // Release is requested, or all legs are broken or were removed by others.
    detach_load(now, EventKind::detach);
    set_state(HookState::empty);
    // Broken legs are not replaced if the request has already been carried out.
    if (!load_attached && requested_load() > 0) set_state(HookState::opened);
}

void HookSystem::take(Prestep& now) noexcept {
    const int number = requested_load();
    const CraneLoad& load = load_of(number);
    if (!now.world.alive(load.body)) return set_state(HookState::waiting);
    const Vec3 point = now.world.world_point(def_.body, def_.point);
    double farthest = 0.0;
    for (const Vec3& eye : load.eyes)
        farthest = std::max(farthest, (now.world.world_point(load.body, eye) - point).norm());
    if (farthest > load.sling_length + load.reach) {
        if (reported_ == 0) now.tell(EventKind::missed, def_.body, farthest);
        reported_ = 1;
        return set_state(HookState::waiting);
    }
    for (std::size_t i = 0; i < load.eyes.size(); ++i) {
        const double way = (now.world.world_point(load.body, load.eyes[i]) - point).norm();
        (void)now.edits.add_interaction(
            sling_of(load, i, leg_names_[i], def_.body, def_.point, way));
        if (const auto shape =
                leg_shape_of(now.world, def_.body, load.body, load.eyes[i], leg_names_[i]))
            (void)now.edits.add_shape(*shape);
    }
    attached_load_ = number;
    now.tell(EventKind::join, load.body, farthest);
    set_state(HookState::holding);
}

void HookSystem::prestep(Prestep& now, Loads&) noexcept {
    if (attached_load_ < 0 || attached_load_ > static_cast<int>(def_.loads.size()))
        attached_load_ = 0;
    if (requested_load() == 0 && attached_load_ == 0) {
        set_state(HookState::empty);
        reported_ = 0;
    } else if (attached_load_ > 0) {
        check_load(now);
    } else if (state_ != static_cast<std::int32_t>(HookState::opened)) {
        take(now);
    }
    if (attached_load_ > 0) reported_ = 0;
    attached_output_ = attached_load_;
    as_ = state_;
}

}  // namespace hawser::crane
