// SPDX-License-Identifier: Apache-2.0
#include "vessel/anchor_system.h"

#include <hawser/world.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace hawser::vessel {
namespace {

constexpr double kMinRestTime = 5.0;  ///< Time at rest after which dragging restarts from zero [s].
constexpr std::int32_t kMaxSteps = 1'000'000;
constexpr double kAtBound = 1e-9;  ///< Relative distance of a sliding row's force to its bound.

/// Compute the force on a body of the wires that end on it, or of the wire `only` if it is valid.
/// @return false if no wire ends on the body.
bool pull_of_lines(const World& world, BodyId body, WireId only, Vec3& pull) noexcept {
    bool any = false;
    pull.setZero();
    for (const WireId wire : world.wires().ids()) {
        const std::span<const BodyId> nodes = world.wires().nodes(wire);
        const std::span<const InteractionId> elements = world.wires().elements(wire);
        if (elements.empty() || (only.valid() && wire != only)) continue;
        for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
            const BodyId last = end == 0 ? nodes.front() : nodes.back();
            if (last != body) continue;
            const InteractionId id = end == 0 ? elements.front() : elements.back();
            if (!world.alive(id)) continue;
            any = true;
            if (!world.intact(id)) continue;
            const auto at = world.wires().ends(id);
            const Vec3 along = at[1 - end] - at[end];
            const double length = along.norm();
            const double tension = std::max(0.0, -world.force(id)[0]);
            if (length > 0.0) pull += tension / length * along;
        }
    }
    return any;
}

}  // namespace

AnchorBounds first_bounds(const AnchorDef& def, bool carried, bool grounded) {
    const AnchorCapacity law(def);
    const double strength = law.strength_at(def.drag), drags = def.friction * def.weight;
    if (def.set)
        return {law.capacity(def.drag, 0.0), std::max(def.breakout * strength, 2.0 * def.weight),
                std::max(strength, drags) * def.fluke_length};
    if (!grounded) return {};
    return {drags, carried ? 0.0 : def.weight, 0.0};
}

AnchorSystem::AnchorSystem(AnchorDef def, const AnchorRows& rows)
    : def_(std::move(def)),
      law_(def_),
      rows_(rows),
      drag_(def_.drag),
      previous_drag_(def_.drag),
      set_(def_.set ? 1 : 0),
      on_ground_(set_) {
    const AnchorBounds first = first_bounds(def_, rows_.carried, rows_.grounded);
    bound_[0] = bound_[1] = first.level;
    bound_[2] = first.up;
    turn_bound_ = first.turn;
    set_output_ = set_;
    depth_ = set_ != 0 ? law_.depth(drag_) : 0.0;
    capacity_ = set_ != 0 ? law_.capacity(drag_, 0.0) : def_.friction * def_.weight;
    breakout_ = set_ != 0 ? def_.breakout * law_.strength_at(drag_) : 0.0;
}

void AnchorSystem::visit_state(StateVisitor& v) {
    for (double* x : {&drag_, &previous_drag_, &scraped_, &turn_bound_, &capacity_, &tension_,
                      &angle_, &set_output_, &depth_, &breakout_, &utilisation_})
        v.visit(*x);
    for (double* x : {last_, speed_, bound_, pull_}) v.visit(std::span<double>(x, 3));
    for (std::int32_t* x : {&set_, &begun_, &dragging_, &on_ground_, &still_steps_}) v.visit(*x);
}

void AnchorSystem::check_state(const World& world, StateRules& rules) const {
    static_cast<void>(world);
    for (const std::int32_t x : {set_, begun_, dragging_, on_ground_})
        rules.flag(x, "a condition of the anchor is no flag");
    rules.require(still_steps_ >= 0 && still_steps_ < 2'000'000'000,
                  "the steps of rest are out of range");
    for (const double x : {drag_, previous_drag_, scraped_})
        rules.range(x, 0.0, 1e7, "the drag of the anchor is out of range");
    for (const double x : bound_)
        rules.range(x, 0.0, 1e30, "a bound of the anchor is out of range");
    rules.range(turn_bound_, 0.0, 1e30, "a bound of the anchor is out of range");
}

void AnchorSystem::signals(SignalTable& table) {
    table.output("drag", "m", drag_);
    table.output("capacity", "N", capacity_);
    table.output("tension", "N", tension_);
    table.output("line_angle", "rad", angle_);
    table.output("set", "1", set_output_);
    table.output("depth", "m", depth_);
    table.output("breakout", "N", breakout_);
    table.output("utilisation", "1", utilisation_);
}

void AnchorSystem::holds(HoldTable& table) const {
    table.hold(def_.body);
    for (std::size_t i = 0; i < 3; ++i) {
        table.hold(rows_.slide[i]);
        table.hold(rows_.slide_bound[i]);
        table.hold(rows_.turn[i]);
        table.hold(rows_.turn_bound[i]);
    }
}

AnchorView AnchorSystem::view() const {
    AnchorView out{.def = def_, .drag = drag_, .set = set_ != 0, .grounded = on_ground_ != 0};
    for (std::size_t i = 0; i < 3; ++i) {
        out.slide[i] = rows_.slide[i];
        out.turn[i] = rows_.turn[i];
        out.bound[i] = bound_[i];
        out.pull[static_cast<Eigen::Index>(i)] = pull_[i];
    }
    out.drag_before = previous_drag_;
    return out;
}

/// Read the line force on the anchor and the motion of the anchor in the last step.
void AnchorSystem::read_last_step(const Prestep& now) noexcept {
    const World& world = now.world;
    const Vec3 at = world.world_point(def_.body, def_.point);
    const Vec3 v = world.velocity(def_.body).linear;
    const Vec3 before(last_[0], last_[1], last_[2]), slow(speed_[0], speed_[1], speed_[2]);
    Vec3 rows;
    for (Eigen::Index i = 0; i < 3; ++i)
        rows[i] = world.force(rows_.slide[static_cast<std::size_t>(i)])[0];
    Vec3 total = -rows;
    if (begun_ != 0) total += rows_.mass / now.step * (v - slow);  // p = m Δv/h − F
    lift_ = begun_ != 0 ? total.z() + (rows_.carried ? 0.0 : def_.weight) : 0.0;
    Vec3 pull;
    const bool lines = pull_of_lines(world, def_.body, def_.wire, pull);
    if (!lines && !def_.wire.valid()) pull = Vec3(total.x(), total.y(), lift_);
    const auto slid = [&](std::size_t i) {
        const double f = std::abs(rows[static_cast<Eigen::Index>(i)]);
        return bound_[i] > 0.0 && f >= bound_[i] * (1.0 - kAtBound);
    };
    slides_ = begun_ != 0 && (slid(0) || slid(1));
    lifts_ = begun_ != 0 && slid(2) && rows.z() < 0.0;
    moved_ = begun_ != 0 ? (at - before).head<2>().norm() : 0.0;
    for (Eigen::Index i = 0; i < 3; ++i) {
        last_[i] = at[i];
        speed_[i] = v[i];
        pull_[i] = pull[i];
    }
    begun_ = 1;
    tension_ = pull.norm();
    angle_ = tension_ > 0.0 ? std::atan2(pull.z(), pull.head<2>().norm()) : 0.0;
    on_ground_ = set_ != 0 || at.z() - def_.seabed <= def_.touch ? 1 : 0;
}

/// Update the drag distance while the rows slide. A free anchor becomes set.
void AnchorSystem::follow_drag(Prestep& now) noexcept {
    const bool slides = slides_ && on_ground_ != 0;
    if (set_ != 0) {
        if (slides) drag_ += moved_;
        if (slides && dragging_ == 0) now.tell(EventKind::render, def_.body, tension_);
        still_steps_ = slides ? 0 : std::min(still_steps_ + 1, kMaxSteps);
        dragging_ = slides || (dragging_ != 0 && still_steps_ * now.step < kMinRestTime) ? 1 : 0;
        return;
    }
    dragging_ = 0;
    if (on_ground_ == 0) scraped_ = 0.0;
    if (slides) scraped_ += moved_;
    if (!slides || scraped_ < def_.set_after || !(angle_ <= anchor_steepest())) return;
    set_ = 1;
    now.tell(EventKind::join, def_.body, scraped_);
    scraped_ = drag_ = 0.0;
}

void AnchorSystem::break_out(Prestep& now) noexcept {
    if (set_ == 0) return;
    const bool steep = angle_ > anchor_steepest() && tension_ > def_.friction * def_.weight;
    if (!steep && !lifts_ && lift_ < def_.breakout * law_.strength_at(drag_)) return;
    now.tell(EventKind::detach, def_.body, std::max(tension_, lift_));
    set_ = dragging_ = 0;
    drag_ = scraped_ = 0.0;
}

void AnchorSystem::set_if_changed(Prestep& now, InputId input, double& last,
                                  double value) const noexcept {
    if (value != last) now.set_input(input, value);
    last = value;
}

void AnchorSystem::set_bounds(Prestep& now) noexcept {
    const double drags = def_.friction * def_.weight;
    const bool set = set_ != 0, grounded = on_ground_ != 0;
    // A slack line may have any angle; its force needs no capacity.
    const double angle = tension_ > drags ? angle_ : 0.0;
    depth_ = set ? law_.depth(drag_) : 0.0;
    breakout_ = set ? def_.breakout * law_.strength_at(drag_) : 0.0;
    capacity_ = set ? law_.capacity(drag_, angle) : (grounded ? drags : 0.0);
    utilisation_ = capacity_ > 0.0 ? tension_ / capacity_ : 0.0;
    const double level = capacity_ * std::cos(std::clamp(angle, 0.0, anchor_steepest()));
    const double across = std::hypot(pull_[0], pull_[1]);
    for (std::size_t i = 0; i < 2; ++i) {
        const double p = std::abs(pull_[i]);
        const double bound = across <= level
                                 ? std::sqrt(std::max(level * level - across * across + p * p, 0.0))
                                 : level * p / across;
        set_if_changed(now, rows_.slide_bound[i], bound_[i], bound);
    }
    // Without contacts, the soil carries the weight minus the lift.
    const double bears = rows_.carried || !grounded ? 0.0 : std::max(def_.weight - lift_, 0.0);
    set_if_changed(now, rows_.slide_bound[2], bound_[2],
                   set ? std::max(breakout_, 2.0 * def_.weight) : bears);
    const double turn = set ? std::max(law_.strength_at(drag_), drags) * def_.fluke_length : 0.0;
    if (turn != turn_bound_)
        for (const InputId id : rows_.turn_bound) now.set_input(id, turn);
    turn_bound_ = turn;
}

void AnchorSystem::prestep(Prestep& now, Loads&) noexcept {
    read_last_step(now);
    follow_drag(now);
    break_out(now);
    previous_drag_ = drag_;
    set_bounds(now);
    set_output_ = set_;
}

}  // namespace hawser::vessel
