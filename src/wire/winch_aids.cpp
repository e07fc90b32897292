// SPDX-License-Identifier: Apache-2.0
/// Overload protection, heave compensation and displays of a winch.
///
/// The protection bounds the torque of motor and brake by the limit times the radius, so that the
/// drum is a row at its bound while wire runs out. The drive supplies the torque that accelerates
/// the drum; the inertia therefore leaves the equations, and the tension is that of the bound.
#include "wire/bounds.h"
#include "wire/winch_checks.h"
#include "wire/winch_system.h"

#include <hawser/world.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hawser {

double drum_mass(const WinchDef& def) noexcept {
    constexpr double kMinInertiaFraction = 1e-4;  // of the inertia
    return def.overload_limit > 0.0 ? kMinInertiaFraction * def.inertia : def.inertia;
}

}  // namespace hawser

namespace hawser::wire {

void check_aids(const WinchDef& def) {
    check_number(def, "overload_limit", def.overload_limit, 0.0, false);
    check_number(def, "overload_retained", def.overload_retained, 0.0, false);
    check_number(def, "heave_speed", def.heave_speed, 0.0, false);
    check_number(def, "heave_acceleration", def.heave_acceleration, 0.0, true);
    check_number(def, "heave_falls", def.heave_falls, 0.0, true);
    if (def.overload_retained > def.overload_limit)
        throw_def_error(def, "overload_retained = " + number(def.overload_retained) +
                                 " N is above overload_limit = " + number(def.overload_limit) +
                                 " N; give less, or a limit");
    if (def.mode == WinchMode::heave && !(def.heave_speed > 0.0))
        throw_def_error(def,
                        "heave_speed = 0: mode heave needs the largest speed of the compensation");
    if (!def.heave_point.allFinite() || def.heave_point.norm() > 1e4)
        throw_def_error(def, "heave_point: give a point within 10 km");
}

void WinchSystem::visit_aids(StateVisitor& v) {
    Aids& a = aids_;
    for (double* x : {&a.aops, &a.mops, &a.out, &a.rate, &a.peak, &a.protection_on, &a.lost_length,
                      &a.error, &a.first, &a.height, &a.paid, &a.pull, &a.speed})
        v.visit(*x);
    for (std::int32_t* x :
         {&a.is_begun, &a.balances_inertia, &a.pays_out_protection, &a.compensates_heave})
        v.visit(*x);
}

void WinchSystem::check_aids(StateRules& rules) const {
    for (const std::int32_t x : {aids_.is_begun, aids_.balances_inertia, aids_.pays_out_protection,
                                 aids_.compensates_heave})
        rules.flag(x, "a condition of the winch is no flag");
    rules.range(aids_.speed, -1e3, 1e3, "the speed of the compensation is out of range");
    rules.range(aids_.paid, -1e7, 1e7, "the wire of the compensation is out of range");
}

void WinchSystem::add_aid_signals(SignalTable& table) {
    table.input("aops", "1", aids_.aops, 0.0, 1.0);
    table.input("mops", "1", aids_.mops, 0.0, 1.0);
    table.output("wire_out", "m", aids_.out);
    table.output("wire_speed", "m/s", aids_.rate);
    table.output("peak_pull", "N", aids_.peak);
    table.output("overload", "1", aids_.protection_on);
    table.output("overload_out", "m", aids_.lost_length);
    table.output("heave_error", "m", aids_.error);
}

/// Return the tension at which the overload protection pays out wire [N].
double WinchSystem::max_tension() const noexcept {
    if (!(def_.overload_limit > 0.0) || parted_ != 0)
        return std::numeric_limits<double>::infinity();
    if (aids_.mops >= 0.5) return def_.overload_retained;
    return aids_.aops >= 0.5 ? def_.overload_limit : std::numeric_limits<double>::infinity();
}

void WinchSystem::limit_overload(MotorOrders& out) const noexcept {
    const double most = max_tension() * radius_;
    if (!(most < kUnbounded)) return;
    out.low = std::max(out.low, -most);
    out.high = std::max(out.high, out.low);
    out.hold = std::min(out.hold, most);
}

/// Set the drum speed that compensates the upward motion of the observed point. Its velocity in the
/// middle of the step that begins is used. An error of length decreases with a time constant of 1
/// s.
void WinchSystem::follow_heave(const Prestep& now) noexcept {
    Aids& a = aids_;
    const World& world = now.world;
    if (mode() != WinchMode::heave || parted_ != 0) {
        a.compensates_heave = 0;
        a.speed = a.error = 0.0;
        return;
    }
    const InteractionDef& line = world.interaction_def(ids_.line);
    const std::size_t fairlead = 1 - node_slot(world);
    const bool has_heave_body = def_.heave_body.valid() && world.alive(def_.heave_body);
    const BodyId body = has_heave_body ? def_.heave_body : line.body[fairlead];
    const Vec3 local = has_heave_body ? def_.heave_point : line.point[fairlead];
    const Vec3 arm = world.world_point(body, local) - world.pose(body).position;
    const Vec3 gravity = world.settings().gravity;
    const double g = gravity.norm();
    const Vec3 up = g > 0.0 ? Vec3(-gravity / g) : Vec3(Vec3::UnitZ());
    const Twist v = world.predicted_velocity(body);
    const double height = up.dot(world.pose(body).position + arm);
    const double rises = def_.heave_falls * up.dot(v.linear + v.angular.cross(arm));
    const double paid = def_.stored - stored_;
    if (a.compensates_heave == 0) {
        a.height = height;
        a.paid = paid;
        a.compensates_heave = 1;
    }
    constexpr double kReturnTime = 1.0;  // [s]
    a.error = def_.heave_falls * (height - a.height) - (paid - a.paid);
    const double most = def_.heave_speed, change = def_.heave_acceleration * now.step;
    const double target_speed = std::clamp(rises + a.error / kReturnTime, -most, most);
    a.speed = std::clamp(target_speed, a.speed - change, a.speed + change);
    a.paid += speed_ * now.step;
}

void WinchSystem::follow_aids(Prestep& now) noexcept {
    Aids& a = aids_;
    const double paid = def_.stored - stored_;
    if (a.is_begun == 0) {
        a.first = now.world.wires().length(def_.wire) - paid;
        a.is_begun = 1;
    }
    a.out = a.first + paid;
    a.rate = radius_ * leaving_;
    a.peak = std::max(a.peak, pull_);
    // The drive is ready two steps before the limit, so that the drum starts without a peak.
    constexpr double kReadyFraction = 0.95;
    const double soon = pull_ + 2.0 * std::max(pull_ - a.pull, 0.0);
    a.pull = pull_;
    const double most = max_tension();
    const bool near = soon >= kReadyFraction * most;
    a.balances_inertia =
        near || (a.balances_inertia != 0 && a.rate > kMaxStandingSpeed && most < kUnbounded) ? 1
                                                                                             : 0;
    const bool pays_out_protection =
        a.balances_inertia != 0 && a.rate > kMaxStandingSpeed &&
        (mode() != WinchMode::speed || speed_ < a.rate - kMaxStandingSpeed);
    if (pays_out_protection) a.lost_length += std::max(radius_ * turned_, 0.0);
    if (pays_out_protection && a.pays_out_protection == 0)
        now.tell(EventKind::render, ids_.drum, pull_);
    a.pays_out_protection = pays_out_protection ? 1 : 0;
    a.protection_on = a.pays_out_protection;
    follow_heave(now);
}

}  // namespace hawser::wire
