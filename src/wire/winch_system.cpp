// SPDX-License-Identifier: Apache-2.0
#include "wire/winch_system.h"

#include <hawser/world.h>

#include "wire/band_brake.h"
#include "wire/bounds.h"
#include "wire/feed.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hawser::wire {
WinchSystem::WinchSystem(WinchDef def, const WinchWheel& wheel, const WinchIds& ids,
                         const WinchInputs& inputs, double at_drum)
    : def_(std::move(def)),
      drum_(wheel.drum),
      wheel_(wheel.gypsy),
      chain_(wheel.gypsy.value_or(GypsyWheel{})),
      ids_(ids),
      inputs_(inputs),
      mode_(static_cast<double>(def_.mode)),
      speed_(def_.speed),
      tension_(def_.tension),
      stored_(def_.stored),
      at_drum_(at_drum),
      last_inputs_{0.0, -kUnbounded, kUnbounded, 0.0, 1.0} {
    const DrumGeometry::Place at = wire_end();
    radius_ = leaving_radius();
    layer_ = at.layer;
    wraps_ = at.wraps;
    across_ = at.across;
    inertia_ = def_.inertia + def_.motor_inertia + wound_inertia();
    if (!(def_.overload_limit > 0.0)) aids_.aops = 0.0;
    pull_limit_ = def_.torque_haul / radius_;
}

/// Return the layer and wrap of the wire's end on the drum. For a gypsy, return the turns of the
/// chain in its locker.
DrumGeometry::Place WinchSystem::wire_end() const noexcept {
    if (!wheel_) return drum_.wire_end(stored_);
    return {.radius = wheel_->radius,
            .wraps = std::max(stored_, 0.0) / (kTurn * wheel_->radius),
            .across = 0.0};
}

double WinchSystem::leaving_radius() const noexcept {
    return wheel_ ? wheel_->radius : drum_.leaving_radius(stored_);
}

/// Return the length paid out [m]: the stored value plus the rotation of the drum since the last
/// update, which happens at the start of a step.
double WinchSystem::paid_out(const World& world, InteractionId element) const noexcept {
    if (element != ids_.line) return kDefault;
    const double since = parted_ == 0 && world.intact(element)
                             ? radius_ * (world.pose(paying_out_body()).position.x() - angle_)
                             : 0.0;
    return def_.stored - stored_ + since;
}

/// Return the inertia of the wire on the drum [kg m²]; 0 for a gypsy, whose chain is a body.
double WinchSystem::wound_inertia() const noexcept {
    return wheel_ ? 0.0 : drum_.inertia(stored_, def_.mass_per_length);
}

void WinchSystem::visit_state(StateVisitor& v) {
    for (double* x : {&mode_,
                      &speed_,
                      &tension_,
                      &brake_,
                      &clutch_,
                      &stored_,
                      &at_drum_,
                      &angle_,
                      &radius_,
                      &clock_,
                      &slip_,
                      &heat_,
                      &last_inputs_.speed,
                      &last_inputs_.low,
                      &last_inputs_.high,
                      &last_inputs_.hold,
                      &last_inputs_.back,
                      &layer_,
                      &wraps_,
                      &across_,
                      &pull_,
                      &pull_limit_,
                      &inertia_,
                      &state_})
        v.visit(*x);
    for (std::int32_t* x : {&slipping_, &parted_, &empty_, &released_, &engaged_, &rendering_})
        v.visit(*x);
    if (has_aids()) visit_aids(v);
    if (!wheel_) return;
    for (double* x : {&grip_set_.speed, &grip_set_.low, &grip_set_.high, &end_set_}) v.visit(*x);
    chain_.visit_state(v);
}

void WinchSystem::check_state(const World& world, StateRules& rules) const {
    static_cast<void>(world);
    constexpr double kMaxWire = 1e7, kMaxAngle = 1e15;  // [m], [rad]: as for positions of bodies
    rules.range(stored_, -kMaxWire, kMaxWire, "the wire on the drum is out of range");
    rules.range(at_drum_, -kMaxWire, kMaxWire, "the wire at the drum is out of range");
    rules.range(angle_, -kMaxAngle, kMaxAngle, "the angle of the drum is out of range");
    const double most = drum_.radius(DrumGeometry::kMaxLayers) + (wheel_ ? wheel_->radius : 0.0);
    rules.range(radius_, 1e-9, most, "the radius of the drum is out of range");
    // It follows from the wire on the drum, except for rounding.
    const double radius = leaving_radius();
    rules.require(parted_ != 0 || std::abs(radius_ - radius) <= 1e-9 * radius,
                  "the radius of the drum is not that of the wire on it");
    rules.range(layer_, 1.0, DrumGeometry::kMaxLayers, "the layer on the drum is out of range");
    rules.require(layer_ == std::round(layer_), "the layer on the drum is no whole number");
    rules.require(wraps_ >= 0.0 && clock_ >= 0.0 && slip_ >= 0.0 && heat_ >= 0.0,
                  "wraps, clock, slip or heat is below 0");
    for (const std::int32_t x : {slipping_, parted_, empty_, released_, engaged_, rendering_})
        rules.flag(x, "a condition of the winch is no flag");
    if (has_aids()) check_aids(rules);
    if (wheel_) chain_.check_state(rules);
}

void WinchSystem::signals(SignalTable& table) {
    table.input("mode", "1", mode_, 0.0, def_.heave_speed > 0.0 ? 6.0 : 5.0);
    table.input("speed", "m/s", speed_, -100.0, 100.0);
    table.input("tension", "N", tension_, 0.0, 1e15);
    table.input("brake", "1", brake_, 0.0, 1.0);
    table.input("clutch", "1", clutch_, 0.0, 1.0);
    table.output("layer", "1", layer_);
    table.output("wraps", "1", wraps_);
    table.output("wire_left", "m", stored_);
    table.output("radius", "m", radius_);
    table.output("across", "m", across_);
    table.output("at_drum", "m", at_drum_);
    table.output("pull", "N", pull_);
    table.output("pull_limit", "N", pull_limit_);
    table.output("inertia", "kg m^2", inertia_);
    table.output("slip", "m", slip_);
    table.output("heat", "J", heat_);
    table.output("state", "1", state_);
    if (wheel_) chain_.signals(table);
    if (has_aids()) add_aid_signals(table);
}

void WinchSystem::holds(HoldTable& table) const {
    table.hold(ids_.drum);
    for (const InteractionId id : {ids_.line, ids_.motor, ids_.brake}) table.hold(id);
    for (const InputId id : {inputs_.speed, inputs_.low, inputs_.high, inputs_.hold, inputs_.back,
                             inputs_.radius, inputs_.length, inputs_.drum_zero})
        table.hold(id);
    if (!wheel_) return;
    table.hold(ids_.chain);
    for (const InteractionId id : {ids_.grip, ids_.bitter_end}) table.hold(id);
    for (const InputId id : {inputs_.grip_speed, inputs_.grip_low, inputs_.grip_high, inputs_.end})
        table.hold(id);
}

WinchMode WinchSystem::mode() const noexcept {
    return static_cast<WinchMode>(static_cast<int>(std::lround(mode_)));
}

/// Read speed, tension and length of the last step.
void WinchSystem::sample(const Prestep& now) noexcept {
    const double angle = now.world.pose(paying_out_body()).position.x();
    turned_ = angle - angle_;
    angle_ = angle;
    leaving_ = now.world.velocity(paying_out_body()).linear.x();
    omega_ = now.world.velocity(ids_.drum).linear.x();
    if (parted_ == 0 && !now.world.intact(ids_.line)) parted_ = 1;
    if (parted_ == 0) {
        stored_ -= radius_ * turned_;
        at_drum_ += radius_ * turned_;
    }
    pull_ = parted_ == 0 ? std::max(0.0, -now.world.force(ids_.line)[0]) : 0.0;
    if (parted_ == 0 && makes_nodes())
        pull_ = std::max(
            0.0, pull_ + weight_of_half(now.world).dot(element_chord(now.world).normalized()));
    // An element keeps its law down to a fraction of its length (interactions.h), and while it
    // turns slowly (feed.h).
    const InteractionDef& line = now.world.interaction_def(ids_.line);
    const double length = line.get("length");
    const double rest = length + radius_ * (angle_ - line.get("drum_zero"));
    double least = kLeastOfDrumElement * length;
    if (makes_nodes() && parted_ == 0 && carries_body(now.world))
        least = std::max(least, min_hauled_length(now.world, ids_.line, def_.element));
    const auto jams = [&](double turned) {
        return rest - radius_ * turned < least ||
               (makes_nodes() && at_drum_ - radius_ * turned <= 0.0);
    };
    is_at_min_length_ = jams(0.0);
    began_to_jam_ = is_at_min_length_ && !jams(turned_) && parted_ == 0;
    hauled_in_ = is_at_min_length_ || rest < least + 2.0 * now.step * radius_ * std::abs(leaving_);
}

/// Accumulate the slip of the brake. It slips if its torque is at the bound and the drum turns
/// against this torque.
void WinchSystem::count_slip(Prestep& now) noexcept {
    const double torque = now.world.force(ids_.brake)[0];
    const double most = torque < 0.0 ? last_inputs_.hold : last_inputs_.hold * last_inputs_.back;
    const double turned = wheel_ ? omega_ * now.step : turned_;
    const bool held = empty_ != 0 && !wheel_;  // by the fastening, not the brake
    const bool slips = !held && most > 0.0 &&
                       std::abs(torque) >= most * (1.0 - kAtBoundTolerance) &&
                       torque * turned < 0.0;
    if (slips) {
        slip_ += radius_ * std::abs(turned);
        heat_ += std::abs(torque * turned);
        if (slipping_ == 0 && released_ == 0)
            now.tell(EventKind::brake_slip, ids_.drum, std::abs(torque));
    }
    slipping_ = slips ? 1 : 0;
}

/// Send an event if a motor in mode `render` pays out at its largest holding torque. In other modes
/// the upper bound of the torque is above 0.
void WinchSystem::count_rendering(Prestep& now) noexcept {
    const bool gives =
        mode() == WinchMode::render && last_inputs_.high <= 0.0 && last_inputs_.low < 0.0 &&
        now.world.force(ids_.motor)[0] <= last_inputs_.low * (1.0 - kAtBoundTolerance) &&
        radius_ * omega_ > kMaxStandingSpeed;
    if (gives && rendering_ == 0) now.tell(EventKind::render, ids_.drum, pull_);
    rendering_ = gives ? 1 : 0;
}

void WinchSystem::follow_layer(Prestep& now) noexcept {
    if (parted_ != 0) return;
    const DrumGeometry::Place at = wire_end();
    wraps_ = at.wraps;
    across_ = at.across;
    if (at.layer != static_cast<int>(layer_)) {
        layer_ = at.layer;
        now.tell(EventKind::layer, ids_.drum, layer_);
    }
    const double radius = leaving_radius();
    if (radius == radius_) return;
    const InteractionDef& line = now.world.interaction_def(ids_.line);
    const double rest = line.get("length") + radius_ * (angle_ - line.get("drum_zero"));
    radius_ = radius;
    // Keep a positive length if all wire has been wound in.
    now.set_input(inputs_.length, std::max(rest, 1e-6));
    now.set_input(inputs_.drum_zero, angle_);
    now.set_input(inputs_.radius, radius_);
}

/// Compute the tension at the wire's end on the drum, and check whether its fastening holds.
void WinchSystem::check_fastening(Prestep& now) noexcept {
    if (parted_ != 0) return;
    // A drum stopped by its fastening springs back slightly. It counts as empty until it has
    // hauled.
    constexpr double kMinHauledWraps = 0.25;  // wraps
    const bool none = stored_ <= 0.0 || (empty_ != 0 && wraps_ < kMinHauledWraps);
    if (none && empty_ == 0) now.tell(EventKind::drum_empty, ids_.drum, pull_);
    empty_ = none ? 1 : 0;
    const double fastening_load = wheel_ ? std::abs(now.world.force(ids_.bitter_end)[0]) / radius_
                                         : tension_behind_wraps(pull_, def_.wrap_friction, wraps_);
    const bool breaks = def_.weak_link > 0.0 && fastening_load > def_.weak_link;
    if (breaks) now.tell(EventKind::weak_link, ids_.drum, fastening_load);
    if (!breaks && !(none && def_.weak_link == 0.0)) return;
    now.edits.part(ids_.line);
    parted_ = 1;
}

/// Update the chain on the wheel of a gypsy, and the load of the chain behind it.
void WinchSystem::follow_chain(const GypsyWheel& wheel, Prestep& now, Loads& loads) noexcept {
    const World& world = now.world;
    const double out = std::max(leaving_, 0.0) * radius_;  // [m/s]
    const double line = def_.mass_per_length;
    const double weight = parted_ == 0 ? line * world.settings().gravity.norm() * wheel.fall : 0.0;
    const double rate = parted_ == 0 ? line * out : 0.0;  // lifted from the heap [kg/s]
    chain_.set_tail_tension(weight + rate * out);
    const double separation = angle_ - world.pose(ids_.drum).position.x();
    const double jumped = chain_.sample(separation, leaving_ - omega_, world.force(ids_.grip)[0],
                                        pull_ - chain_.tail());
    if (jumped > 0.0 && parted_ == 0) now.tell(EventKind::chain_jump, ids_.drum, jumped);
    loads.add_force(ids_.chain, {-weight * radius_, 0.0, 0.0});
    loads.add_damping(ids_.chain, Eigen::Matrix<double, 1, 1>(rate * radius_ * radius_));
    const GripOrder grip = chain_.order(now.step);
    const auto set = [&](InputId id, double& last, double value) {
        if (value != last) now.set_input(id, value);
        last = value;
    };
    set(inputs_.grip_speed, grip_set_.speed, grip.speed);
    set(inputs_.grip_low, grip_set_.low, grip.low);
    set(inputs_.grip_high, grip_set_.high, grip.high);
    // The bitter end holds against running out and allows hauling.
    set(inputs_.end, end_set_, empty_ != 0 && parted_ == 0 ? kUnbounded : 0.0);
}

void WinchSystem::count_release(Prestep& now) noexcept {
    if (mode() != WinchMode::release) {
        clock_ = 0.0;
        released_ = 0;
        return;
    }
    constexpr double kRounding = 1e-6;  // of a sum of steps
    if (released_ == 0 && clock_ >= def_.release_delay - kRounding * now.step) {
        released_ = 1;
        now.tell(EventKind::release, ids_.drum, pull_);
    }
    clock_ += now.step;
}

void WinchSystem::prestep(Prestep& now, Loads& loads) noexcept {
    sample(now);
    count_slip(now);
    count_rendering(now);
    follow_layer(now);
    check_fastening(now);
    if (wheel_) follow_chain(*wheel_, now, loads);
    count_release(now);
    if (has_aids()) follow_aids(now);
    apply_orders(now, orders());
    if (insertion_failed_) now.tell(EventKind::no_node, ids_.drum, at_drum_);
    if (began_to_jam_) now.tell(EventKind::hauled_in, ids_.drum, pull_);
    add_line_inertia(now, loads);
    weigh_element(now.world, loads);
}

}  // namespace hawser::wire
