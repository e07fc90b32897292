// SPDX-License-Identifier: Apache-2.0
/// Commands of a winch to its motor, brake and clutch.
#include "wire/band_brake.h"
#include "wire/bounds.h"
#include "wire/winch_system.h"

#include <hawser/world.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>

namespace hawser {

std::span<const char* const> winch_modes() noexcept {
    static constexpr const char* kModeNames[] = {"speed", "tension", "render", "brake",
                                                 "free",  "release", "heave"};
    static_assert(static_cast<int>(WinchMode::heave) + 1 == std::size(kModeNames));
    return kModeNames;
}

}  // namespace hawser

namespace hawser::wire {
/// Return true if the wire is hauled in completely.
bool WinchSystem::is_hauled_in() const noexcept {
    if (hauled_in_) return true;
    if (wheel_) return stored_ >= wheel_->locker;
    return static_cast<int>(layer_) > drum_.layers() ||
           stored_ >= drum_.capacity() - drum_.wire_diameter;
}

void WinchSystem::order_motor(MotorOrders& out) noexcept {
    const double haul = def_.torque_haul, pay = def_.torque_pay;
    const double in = -def_.max_speed / radius_;
    const double least = std::max(tension_ - def_.deadband, 0.0) * radius_;
    // The motor bounds its power by the speed at the end of the step (AxisMotor::power).
    pull_limit_ = std::min(haul, def_.power / std::max(std::abs(omega_), 1e-12)) / radius_;
    out.low = -haul;
    out.high = pay;
    bool pulls = true;
    switch (mode()) {
        case WinchMode::speed:
            out.speed = speed_ / radius_;
            if (wraps_ <= def_.dead_wraps && out.speed > 0.0) out.speed = 0.0;
            break;
        case WinchMode::heave:
            out.speed = (speed_ + aids_.speed) / radius_;
            if (wraps_ <= def_.dead_wraps && out.speed > 0.0) out.speed = 0.0;
            break;
        case WinchMode::tension:
            // Pull with the set torque up to the largest hauling speed.
            out.speed = in;
            out.low = -std::min(tension_ * radius_, haul);
            break;
        case WinchMode::render:
            if (omega_ < 0.999 * in) {  // hauling at the largest speed
                out.speed = in;
                out.low = -std::min(least, haul);
            } else {
                out.low = -std::min((tension_ + def_.deadband) * radius_, haul);
                out.high = -std::min(least, haul);
            }
            break;
        default:
            pulls = false;
            out.low = out.high = 0.0;
    }
    if (is_hauled_in()) {
        out.speed = std::max(out.speed, 0.0);
        if (pulls) out.high = pay;  // mode render pulls otherwise
    }
    if (clutch_ < 0.5 || parted_ != 0) out.low = out.high = out.speed = 0.0;
    // The remaining wire jams at the fairlead for any order of the motor: it can only move out.
    if (is_at_min_length_ && parted_ == 0) out.high = kUnbounded;
}

WinchSystem::MotorOrders WinchSystem::orders() noexcept {
    MotorOrders out;
    order_motor(out);
    const double slips = std::isnan(def_.brake_dynamic) ? def_.brake_static : def_.brake_dynamic;
    out.back = band_ratio(def_.band_friction, def_.band_angle);
    const WinchMode m = mode();
    if (parted_ != 0 || m == WinchMode::brake || (m == WinchMode::release && released_ == 0))
        out.hold = brake_ * (slipping_ != 0 ? slips : def_.brake_static);
    else if (m == WinchMode::release)
        out.hold = def_.release_load * radius_;
    limit_overload(out);
    if (empty_ != 0 && parted_ == 0 && !wheel_) {  // the fastening holds: the drum can only haul
        out.hold = kUnbounded;
        out.back = 0.0;
    }
    const double speed = radius_ * omega_;
    WinchState state = speed > kMaxStandingSpeed    ? WinchState::paying
                       : speed < -kMaxStandingSpeed ? WinchState::hauling
                                                    : WinchState::standing;
    const bool asks_out = m == WinchMode::speed && speed_ > 0.0;
    const bool asks_in =
        (m == WinchMode::speed && speed_ < 0.0) ||
        ((m == WinchMode::tension || m == WinchMode::render) && speed <= kMaxStandingSpeed);
    if (asks_out && wraps_ <= def_.dead_wraps) state = WinchState::last_wraps;
    if (asks_in && is_hauled_in()) state = WinchState::full;
    if (slipping_ != 0) state = WinchState::slipping;
    if (wheel_ && chain_.jumps()) state = WinchState::jumping;
    if (m == WinchMode::release)
        state = released_ != 0 ? WinchState::released : WinchState::waiting;
    if (empty_ != 0) state = WinchState::empty;
    if (parted_ != 0) state = WinchState::parted;
    state_ = static_cast<double>(state);
    return out;
}

void WinchSystem::apply_orders(Prestep& now, const MotorOrders& o) noexcept {
    const auto set = [&](InputId id, double& last, double value) {
        if (value != last) now.set_input(id, value);
        last = value;
    };
    set(inputs_.speed, last_inputs_.speed, o.speed);
    set(inputs_.low, last_inputs_.low, o.low);
    set(inputs_.high, last_inputs_.high, o.high);
    set(inputs_.hold, last_inputs_.hold, o.hold);
    set(inputs_.back, last_inputs_.back, o.back);
}

void WinchSystem::add_line_inertia(const Prestep& now, Loads& loads) noexcept {
    const bool engaged = clutch_ >= 0.5;
    double added = wound_inertia() + (def_.inertia - drum_mass(def_));
    if (engaged) added += def_.motor_inertia;
    if (engaged && engaged_ == 0)  // the motor at rest is accelerated
        loads.add_force(ids_.drum, {-def_.motor_inertia * omega_ / now.step, 0.0, 0.0});
    engaged_ = engaged ? 1 : 0;
    inertia_ = drum_mass(def_) + added;
    if (aids_.balances_inertia != 0) added = 0.0;
    loads.add_mass(ids_.drum, Eigen::Matrix<double, 1, 1>(added));
}

}  // namespace hawser::wire
