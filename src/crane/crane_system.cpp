// SPDX-License-Identifier: Apache-2.0
#include "crane/crane_system.h"

#include <hawser/world.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace hawser::crane {
namespace {

/// Gravity for scaling in a world without gravity [m/s²].
constexpr double kStandardGravity = 9.80665;
constexpr double kMaxShown = 10.0;  ///< Largest utilisation that is shown.
/// Fraction of the largest rated load below which the load counts as zero.
constexpr double kMinLoadFraction = 0.01;
constexpr double kAlarmHysteresis = 0.98;  ///< Fraction of a threshold below which its alarm ends.
constexpr const char* kMotionNames[] = {"slew", "luff", "knuckle", "hoist"};
constexpr const char* kMotionUnits[] = {"rad/s", "m/s", "m/s", "m/s"};

}  // namespace

double rated_load(const CraneRating& rating, double radius) noexcept {
    const auto& curve = rating.curve;
    if (curve.empty() || radius > curve.back().radius) return 0.0;
    if (radius <= curve.front().radius) return curve.front().mass;
    std::size_t i = 1;
    while (curve[i].radius < radius) ++i;
    const CraneRatedLoad &a = curve[i - 1], &b = curve[i];
    return a.mass + (b.mass - a.mass) * (radius - a.radius) / (b.radius - a.radius);
}

CraneSystem::CraneSystem(CraneTask task, CraneParts parts)
    : definition_(std::move(task)), parts_(std::move(parts)), attach_request_(definition_.take) {
    std::size_t max_eyes = 0;
    for (const CraneLoad& load : definition_.loads) max_eyes = std::max(max_eyes, load.eyes.size());
    for (std::size_t i = 0; i < max_eyes; ++i)
        sling_names_.push_back(definition_.name + "/sling" + std::to_string(i + 1));
    hoist_length_ = definition_.hook.hang;
    attached_load_ = definition_.take;
}

void CraneSystem::visit_state(StateVisitor& v) {
    for (Order& o : orders_) {
        v.visit(o.wanted);
        v.visit(o.ramped);
        v.visit(o.speed);
        v.visit(o.is_braked);
    }
    for (double* x : {&attach_request_, &clock_, &radius_, &height_, &hoist_length_, &load_,
                      &rated_, &utilisation_, &moment_, &alarm_, &attached_output_, &cut_})
        v.visit(*x);
    v.visit(step_);
    v.visit(attached_load_);
}

void CraneSystem::check_state(const World& world, StateRules& rules) const {
    static_cast<void>(world);
    for (std::size_t i = 0; i < orders_.size(); ++i) {
        const Order& o = orders_[i];
        const double max_speed =
            2.0 *
            parts_.drives[i].max_speed;  // margin for rounding: a ramp of zero duration overshoots
        rules.range(o.ramped, -max_speed, max_speed, "the speed of a motion is out of range");
        rules.flag(o.is_braked, "whether a brake is set is no flag");
    }
    rules.require(clock_ >= 0.0, "the clock of the alarm is below 0");
    rules.require(step_ >= 0 && step_ <= 2, "there is no such alarm");
    rules.require(
        attached_load_ >= 0 && static_cast<std::size_t>(attached_load_) <= definition_.loads.size(),
        "there is no such load");
}

void CraneSystem::signals(SignalTable& table) {
    for (std::size_t i = 0; i < kMaxMotions; ++i) {
        const Drive& d = parts_.drives[i];
        if (d.exists)
            table.input(kMotionNames[i], kMotionUnits[i], orders_[i].wanted, -d.max_speed,
                        d.max_speed);
    }
    table.input("take", "1", attach_request_, 0.0, static_cast<double>(definition_.loads.size()));
    table.output("radius", "m", radius_);
    table.output("height", "m", height_);
    table.output("hang", "m", hoist_length_);
    table.output("load", "kg", load_);
    table.output("rated", "kg", rated_);
    table.output("utilisation", "1", utilisation_);
    table.output("moment", "N m", moment_);
    table.output("alarm", "1", alarm_);
    table.output("held", "1", attached_output_);
    table.output("cut", "1", cut_);
}

void CraneSystem::holds(HoldTable& table) const {
    for (const BodyId id : {parts_.on, parts_.column, parts_.boom, parts_.tip, parts_.hook})
        table.hold(id);
    for (const InteractionId id : parts_.falls) table.hold(id);
    for (const Drive& d : parts_.drives) {
        if (!d.exists) continue;
        if (d.scalar.valid()) table.hold(d.scalar);
        table.hold(d.motor);
        if (d.friction_id.valid()) table.hold(d.friction_id);
        for (const InputId id : {d.speed, d.force_low, d.force_high, d.bound})
            if (id.valid()) table.hold(id);
    }
}

void CraneSystem::sample(const Prestep& now) noexcept {
    const World& w = now.world;
    const Pose on = w.pose(parts_.on);
    const Quat turn = on.orientation * parts_.orientation;
    const Vec3 bearing = on.position + on.orientation * parts_.mount;
    const auto seen = [&](BodyId body, const Vec3& point) {
        return Vec3(turn.conjugate() * (w.world_point(body, point) - bearing));
    };
    const Vec3 axle{0.0, 0.0, 0.5 * definition_.hook.height};
    const Vec3 hook = seen(parts_.hook, hook_point()), head = seen(parts_.tip, parts_.head);
    radius_ = std::hypot(hook.x(), hook.y());
    height_ = hook.z();
    hoist_length_ = (head - seen(parts_.hook, axle)).norm();
    boom_rise_ = head.z() - seen(parts_.boom, parts_.boom_pin).z();
    tip_rise_ = head.z() - seen(parts_.tip, parts_.tip_pin).z();
}

/// Measure the load from the tensions of the falls in the last step. Before the first step there
/// are none.
void CraneSystem::measure_load(const Prestep& now) noexcept {
    double pull = 0.0;
    for (const InteractionId fall : parts_.falls) pull += std::max(0.0, -now.world.force(fall)[0]);
    const double size = now.world.settings().gravity.norm();
    const double g = size > 0.0 ? size : kStandardGravity;
    const double mass = now.count > 0 ? std::max(0.0, pull / g - definition_.hook.mass) : 0.0;
    load_ += now.step / (now.step + definition_.rating.filter) * (mass - load_);
    rated_ = rated_load(definition_.rating, radius_);
    moment_ = load_ * g * radius_;
    utilisation_ = 0.0;
    if (definition_.rating.curve.empty()) return;
    if (rated_ > 0.0)
        utilisation_ = std::min(kMaxShown, load_ / rated_);
    else if (load_ > kMinLoadFraction * definition_.rating.curve.front().mass)
        utilisation_ = kMaxShown;
}

/// Update the alarm step (0 to 2) from the utilisation.
void CraneSystem::update_alarm(Prestep& now) noexcept {
    const CraneRating& r = definition_.rating;
    if (r.curve.empty()) return;
    std::int32_t step = utilisation_ >= r.overload ? 2 : utilisation_ >= r.warning ? 1 : 0;
    if (step < step_ && utilisation_ >= kAlarmHysteresis * (step_ == 2 ? r.overload : r.warning))
        step = step_;
    if (step == step_) {
        clock_ = 0.0;
        return;
    }
    clock_ += now.step;
    if (clock_ < r.hold) return;
    now.tell(step > step_ ? EventKind::alarm : EventKind::alarm_end, parts_.hook, utilisation_);
    step_ = step;
    alarm_ = step;
    clock_ = 0.0;
}

/// True if a motion has reached a limit at which it is cut out.
bool CraneSystem::at_end(const World& world, int motion, double wanted) const noexcept {
    if (motion == kHoist) return wanted > 0.0 && hoist_length_ <= definition_.hook.least_hang;
    const Drive& d = parts_.drives[static_cast<std::size_t>(motion)];
    if (motion == kSlew || !d.scalar.valid()) return false;
    const double length = d.start + world.pose(d.scalar).position.x();
    return (wanted > 0.0 && length >= d.longest_length) ||
           (wanted < 0.0 && length <= d.shortest_length);
}

/// True if a motion increases the moment. The radius of a head above its pin decreases when the
/// head rises.
bool CraneSystem::raises_moment(int motion, double wanted) const noexcept {
    if (motion == kHoist) return wanted > 0.0;
    if (motion == kLuff) return -boom_rise_ * parts_.luff_sign * wanted > 0.0;
    if (motion == kKnuckle) return -tip_rise_ * parts_.knuckle_sign * wanted > 0.0;
    return false;
}

void CraneSystem::drive(Prestep& now, int motion) noexcept {
    const auto i = static_cast<std::size_t>(motion);
    const Drive& d = parts_.drives[i];
    if (!d.exists) return;
    Order& o = orders_[i];
    double target_speed = std::clamp(o.wanted, -d.max_speed, d.max_speed);
    const double going = target_speed != 0.0 ? target_speed : o.ramped;
    const bool cut = definition_.rating.cut_out && step_ == 2 && raises_moment(motion, going);
    if (cut) cut_ = 1.0;
    if (cut || at_end(now.world, motion, going)) {
        target_speed = 0.0;
        if (!cut) o.ramped = 0.0;
    }
    const double change =
        definition_.ramp > 0.0 ? d.max_speed * now.step / definition_.ramp : 2.0 * d.max_speed;
    o.ramped += std::clamp(target_speed - o.ramped, -change, change);
    const double speed = d.ratio * o.ramped;
    if (speed != o.speed) now.set_input(d.speed, speed);
    o.speed = speed;
    if (!d.friction_id.valid()) return;
    const std::int32_t is_braked = target_speed == 0.0 && o.ramped == 0.0 ? 1 : 0;
    if (is_braked == o.is_braked) return;
    o.is_braked = is_braked;
    now.set_input(d.bound, is_braked != 0 ? d.brake : d.friction);
    now.set_input(d.force_low, is_braked != 0 ? 0.0 : d.low);
    now.set_input(d.force_high, is_braked != 0 ? 0.0 : d.high);
}

bool CraneSystem::in_reach(const World& world, const CraneLoad& load) const noexcept {
    if (!world.alive(load.body)) return false;
    const Vec3 point = world.world_point(parts_.hook, hook_point());
    for (const Vec3& eye : load.eyes)
        if ((world.world_point(load.body, eye) - point).norm() > load.sling_length + load.reach)
            return false;
    return true;
}

void CraneSystem::attach_load(Prestep& now, int number) noexcept {
    const CraneLoad& load = definition_.loads[static_cast<std::size_t>(number - 1)];
    const Vec3 point = now.world.world_point(parts_.hook, hook_point());
    double farthest = 0.0;
    for (std::size_t i = 0; i < load.eyes.size(); ++i) {
        const double way = (now.world.world_point(load.body, load.eyes[i]) - point).norm();
        farthest = std::max(farthest, way);
        (void)now.edits.add_interaction(
            sling_of(load, i, sling_names_[i], parts_.hook, hook_point(), way));
    }
    attached_load_ = number;
    now.tell(EventKind::join, load.body, farthest);
}

void CraneSystem::detach_load(Prestep& now) noexcept {
    double tension = 0.0;
    const CraneLoad& load = definition_.loads[static_cast<std::size_t>(attached_load_ - 1)];
    for (std::size_t i = 0; i < load.eyes.size(); ++i) {
        const InteractionId sling = now.world.find_interaction(sling_names_[i]);
        if (!now.world.alive(sling)) continue;
        tension = std::max(tension, -now.world.force(sling)[0]);
        now.edits.remove_interaction(sling);
    }
    attached_load_ = 0;
    if (now.world.alive(load.body)) now.tell(EventKind::detach, load.body, tension);
}

void CraneSystem::update_attachment(Prestep& now) noexcept {
    const int load_count = static_cast<int>(definition_.loads.size());
    // A modified state may hold any value.
    const int load_number = attach_request_ >= 0.0 && attach_request_ <= load_count
                                ? static_cast<int>(std::lround(attach_request_))
                                : 0;
    if (attached_load_ < 0 || attached_load_ > load_count) attached_load_ = 0;
    if (attached_load_ != 0) {
        // The load may have been removed by others.
        const auto& eyes = definition_.loads[static_cast<std::size_t>(attached_load_ - 1)].eyes;
        bool exists = false;
        for (std::size_t i = 0; i < eyes.size(); ++i) {
            const InteractionId sling = now.world.find_interaction(sling_names_[i]);
            exists = exists || (now.world.alive(sling) && now.world.intact(sling));
        }
        if (load_number != attached_load_ || !exists) detach_load(now);
    } else if (load_number > 0 &&
               in_reach(now.world, definition_.loads[static_cast<std::size_t>(load_number - 1)])) {
        attach_load(now, load_number);
    }
    attached_output_ = attached_load_;
}

void CraneSystem::prestep(Prestep& now, Loads&) noexcept {
    sample(now);
    measure_load(now);
    update_alarm(now);
    cut_ = 0.0;
    for (int i = 0; i < kMaxMotions; ++i) drive(now, i);
    update_attachment(now);
}

}  // namespace hawser::crane
