// SPDX-License-Identifier: Apache-2.0
#include "vessel/stability_system.h"

#include <hawser/world.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace hawser::vessel {
namespace {

/// Return which end of a wire is on a body, 0 or 1; −1 if neither is.
int end_on(const World& world, WireId wire, BodyId body) noexcept {
    const std::span<const BodyId> nodes = world.wires().nodes(wire);
    if (nodes.empty()) return -1;
    return nodes.front() == body ? 0 : (nodes.back() == body ? 1 : -1);
}

double tension(const World& world, InteractionId element) noexcept {
    return std::max(0.0, -world.force(element)[0]);
}

/// Return a vector of a given length in a given direction; zero if the direction is zero.
Vec3 with_length(const Vec3& direction, double length) noexcept {
    const double norm = direction.norm();
    return norm > 0.0 ? Vec3(direction * (length / norm)) : Vec3::Zero();
}

}  // namespace

StabilitySystem::StabilitySystem(std::shared_ptr<const StabilityCurve> curve)
    : curve_(std::move(curve)) {
    gz_max_ = curve_->max_lever()[0];
    gz_max_angle_ = curve_->max_lever()[1];
}

void StabilitySystem::visit_state(StateVisitor& v) {
    for (double* x : {&tension_, &alpha_, &beta_, &moment_, &lever_, &worst_beta_, &heel_gm_,
                      &heel_, &gz_, &gz_max_, &gz_max_angle_, &static_heel_, &area_, &residual_,
                      &permissible_tension_, &criterion_, &used_, &alarm_})
        v.visit(*x);
    v.visit(begun_);
}

void StabilitySystem::check_state(const World& world, StateRules& rules) const {
    static_cast<void>(world);
    rules.flag(begun_, "whether the gauge has begun is no flag");
    rules.require(alarm_ == 0.0 || alarm_ == 1.0 || alarm_ == 2.0, "there is no such alarm");
    rules.require(permissible_tension_ >= 0.0, "the permissible tension is below 0");
}

void StabilitySystem::signals(SignalTable& table) {
    table.output("tension", "N", tension_);
    table.output("alpha", "rad", alpha_);
    table.output("beta", "rad", beta_);
    table.output("moment", "N m", moment_);
    table.output("lever", "m", lever_);
    table.output("worst_beta", "rad", worst_beta_);
    table.output("heel_gm", "rad", heel_gm_);
    table.output("heel", "rad", heel_);
    table.output("gz", "m", gz_);
    table.output("gz_max", "m", gz_max_);
    table.output("gz_max_angle", "rad", gz_max_angle_);
    table.output("static_heel", "rad", static_heel_);
    table.output("residual_area", "m rad", area_);
    table.output("residual_lever", "m", residual_);
    table.output("permissible", "N", permissible_tension_);
    table.output("criterion", "1", criterion_);
    table.output("utilisation", "1", used_);
    table.output("alarm", "1", alarm_);
}

/// Return the tension of the first element of the towline beyond the pin [N]; 0 if the towline is
/// slack, broken or aboard. @param along  Vector from the pin to the outer end of the element.
double StabilitySystem::read_towline(const World& world, Vec3& along) const noexcept {
    const StabilityDef& def = curve_->def();
    const int end = world.alive(def.wire) ? end_on(world, def.wire, def.body) : -1;
    if (end < 0) return 0.0;
    const std::span<const InteractionId> elements = world.wires().elements(def.wire);
    const Vec3 pin = world.world_point(def.body, def.pin);
    Vec3 aboard = pin;
    for (std::size_t k = 0; k < elements.size(); ++k) {
        const InteractionId id = elements[end == 0 ? k : elements.size() - 1 - k];
        if (!world.alive(id) || !world.intact(id)) return 0.0;
        const auto at = world.wires().ends(id);
        if (k == 0) aboard = at[static_cast<std::size_t>(end)];
        const Vec3& outer = at[static_cast<std::size_t>(1 - end)];
        if ((outer - aboard).norm() <= (pin - aboard).norm()) continue;
        along = outer - pin;
        return tension(world, id);
    }
    return 0.0;
}

/// Return the sum of the forces of the other wires on the ship, at the points where they cross the
/// transverse plane through the towing pin [N].
Vec3 StabilitySystem::other_wire_forces(const World& world) const noexcept {
    const StabilityDef& def = curve_->def();
    const Vec3 pin = world.world_point(def.body, def.pin);
    const Vec3 ahead = world.pose(def.body).orientation * Vec3::UnitX();
    Vec3 sum = Vec3::Zero();
    for (const WireId wire : def.others) {
        if (!world.alive(wire)) continue;
        for (const InteractionId id : world.wires().elements(wire)) {
            if (!world.alive(id) || !world.intact(id)) continue;
            const auto at = world.wires().ends(id);
            const double first = ahead.dot(at[0] - pin), last = ahead.dot(at[1] - pin);
            if (first >= 0.0 && last < 0.0) sum += with_length(at[1] - at[0], tension(world, id));
            if (first < 0.0 && last >= 0.0) sum += with_length(at[0] - at[1], tension(world, id));
        }
    }
    return sum;
}

/// Compute tension and direction of the sum of the wires' forces. A slack towline has the direction
/// of its element; without any wire over the stern the last direction remains.
void StabilitySystem::read_wires(const World& world) noexcept {
    const StabilityDef& def = curve_->def();
    Vec3 along = Vec3::Zero();
    tension_ = read_towline(world, along);
    const Vec3 others = other_wire_forces(world);
    if (others != Vec3::Zero()) {
        const Vec3 force = others + with_length(along, tension_);
        tension_ = force.norm();
        along = force;
    }
    if (!(along.norm() > 0.0)) return;
    const Vec3 ahead = world.pose(def.body).orientation * Vec3::UnitX();
    const double heading = std::atan2(ahead.y(), ahead.x());
    const double c = std::cos(heading), s = std::sin(heading);
    // Aft and to starboard: the body's x points to the bow, its y to port.
    const double aft = -(c * along.x() + s * along.y());
    const double starboard = s * along.x() - c * along.y();
    alpha_ = std::atan2(starboard, aft);
    beta_ = std::atan2(-along.z(), std::hypot(aft, starboard));
}

void StabilitySystem::read_ship(const World& world) noexcept {
    const StabilityDef& def = curve_->def();
    const Mat3 axes = world.pose(def.body).orientation.toRotationMatrix();
    heel_ = std::atan2(axes(2, 1), axes(2, 2));
    gz_ = std::copysign(curve_->lever(std::abs(heel_), 0.0), heel_);
    const double alpha = std::abs(alpha_), y = curve_->towline_offset(alpha_);
    moment_ = towing_moment(tension_, alpha, std::max(beta_, 0.0), curve_->height(), y);
    lever_ = moment_ / (def.mass * def.gravity);
    worst_beta_ = worst_towing_angle(tension_, alpha, curve_->height(), y, def.bollard_pull);
    heel_gm_ = def.gm > 0.0 ? std::atan(lever_ / def.gm) : 0.0;
}

/// Update the alarm levels, with hysteresis.
void StabilitySystem::update_alarms(Prestep& now) noexcept {
    const StabilityDef& def = curve_->def();
    const double heeled = std::abs(heel_) / def.most_heel;
    const auto at = [&](double level, bool was) { return level - (was ? def.hysteresis : 0.0); };
    const bool high = used_ >= at(1.0, alarm_ >= 2.0) || heeled >= at(1.0, alarm_ >= 2.0);
    const bool low = high || used_ >= at(def.warn, alarm_ >= 1.0);
    const double level = high ? 2.0 : (low ? 1.0 : 0.0);
    if (level > alarm_) now.tell(EventKind::alarm, def.body, std::max(used_, heeled));
    if (level < alarm_) now.tell(EventKind::alarm_end, def.body, std::max(used_, heeled));
    alarm_ = level;
}

void StabilitySystem::prestep(Prestep& now, Loads&) noexcept {
    read_wires(now.world);
    read_ship(now.world);
    if (begun_ == 0 || now.count % kStepsBetweenUpdates == 0) {
        constexpr int kHalvings = 24;  // bisections of the weight, to 1e-7 of it
        permissible_tension_ = curve_->permissible_tension_at(alpha_, beta_, kHalvings);
        const double next = std::max(permissible_tension_ * (1.0 + 1e-6), 1.0);
        criterion_ = curve_->check(next, alpha_, beta_).criterion;
        const StabilityCheck of = curve_->check(tension_, alpha_, beta_);
        static_heel_ = std::isnan(of.static_heel) ? 0.5 * std::numbers::pi : of.static_heel;
        area_ = of.residual_area;
        residual_ = of.residual_lever;
        begun_ = 1;
    }
    constexpr double kOverloadedUtilisation = 1e3;  // utilisation if nothing is permissible
    used_ = permissible_tension_ > 0.0
                ? std::min(tension_ / permissible_tension_, kOverloadedUtilisation)
                : (tension_ > 0.0 ? kOverloadedUtilisation : 0.0);
    update_alarms(now);
}

}  // namespace hawser::vessel
