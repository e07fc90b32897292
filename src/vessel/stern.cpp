// SPDX-License-Identifier: Apache-2.0
#include "vessel/stern.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hawser::vessel {
namespace {

/// Return the thrust of K_T = k0 + k1 J + k2 J², without dividing by n [N].
double quadratic_thrust(double k0, double k1, double k2, double rps, double flow, double d,
                        double density) noexcept {
    return density * d * d *
           (k0 * rps * std::abs(rps) * d * d + k1 * std::abs(rps) * d * flow +
            k2 * flow * std::abs(flow));
}

/// Return the velocity √(u² + k 8 T/(π ρ D²)) in the slipstream, at least 0 [m/s].
double slipstream(double flow, double thrust, double factor, double d, double density) noexcept {
    const double square =
        flow * flow + factor * 8.0 * thrust / (std::numbers::pi * density * d * d);
    return std::sqrt(std::max(0.0, square));
}

}  // namespace

Wrench stern_force(const MmgStern& s, const Flow& flow) noexcept {
    Wrench out = Wrench::Zero();
    if (!(s.diameter > 0.0)) return out;
    const double u = flow.u(), v = flow.v(), speed = std::hypot(u, v);
    const double drift = std::atan2(-v, u);
    const double turn = speed > 1e-9 ? flow.r() * s.length / speed : 0.0;
    const double at_propeller = drift - s.propeller_x * turn;
    const double change = at_propeller > 0.0 ? s.wake_port : s.wake_star;
    const double inflow_fraction =
        (1.0 - s.wake) * (1.0 + (1.0 - std::exp(-2.0 * std::abs(at_propeller))) * (change - 1.0));
    const double inflow = u * inflow_fraction;
    const double thrust =
        quadratic_thrust(s.k0, s.k1, s.k2, flow.rps, inflow, s.diameter, flow.density);
    // U β_R stays finite at rest: U (β − l r') = U β − l r L.
    const double across = speed * drift - s.inflow_x * flow.r() * s.length;
    const double v_r = across * (across < 0.0 ? s.straight_port : s.straight_star);
    const double jet =
        inflow +
        s.slipstream * (slipstream(inflow, thrust, 1.0, s.diameter, flow.density) - inflow);
    const double u_r =
        s.wake_ratio *
        std::sqrt(s.height_share * jet * jet + (1.0 - s.height_share) * inflow * inflow) *
        (inflow < 0.0 && thrust <= 0.0 ? -1.0 : 1.0);
    const double attack = flow.rudder - std::atan2(v_r, u_r);
    const double normal = 0.5 * flow.density * s.rudder_area * (u_r * u_r + v_r * v_r) *
                          s.lift_slope * std::sin(attack);
    const double c = std::cos(flow.rudder), sn = std::sin(flow.rudder);
    out[0] = (1.0 - s.thrust_deduction) * thrust - (1.0 - s.steering_deduction) * normal * sn;
    out[1] = -(1.0 + s.hull_increase) * normal * c;
    out[5] = -(s.rudder_x + s.hull_increase * s.hull_x) * s.length * normal * c;
    return out;
}

Wrench stern_force(const SonNomotoStern& s, const Flow& flow) noexcept {
    Wrench out = Wrench::Zero();
    if (!(s.diameter > 0.0)) return out;
    const double speed = std::max(std::hypot(flow.u(), flow.v()), 1e-9), length = s.length;
    const double u = flow.u() / speed, v = flow.v() / speed;
    // Beyond the published range the polynomials of the turn keep their value at r' = 1.5.
    const double turn = std::clamp(flow.r() * length / speed, -1.5, 1.5);
    const double side = v + s.propeller_x * turn;
    const double inflow = speed * u * ((1.0 - s.wake) + s.wake_turn * side * side);
    const double thrust =
        quadratic_thrust(s.k0, s.k1, 0.0, flow.rps, inflow, s.diameter, flow.density);
    const double v_r = speed * (s.gamma * v + s.c_r * turn + s.c_rrr * turn * turn * turn +
                                s.c_rrv * turn * turn * v);
    const double u_r = s.wake_ratio *
                       slipstream(inflow, thrust, s.slipstream, s.diameter, flow.density) *
                       (inflow < 0.0 && thrust <= 0.0 ? -1.0 : 1.0);
    const double attack = flow.rudder + std::atan2(v_r, u_r);
    const double normal = -6.13 * s.aspect / (s.aspect + 2.25) * 0.5 * flow.density *
                          s.rudder_area * (u_r * u_r + v_r * v_r) * std::sin(attack);
    const double c = std::cos(flow.rudder), sn = std::sin(flow.rudder);
    out[0] = (1.0 - s.thrust_deduction) * thrust + s.drag_share * normal * sn;
    out[1] = (1.0 + s.hull_increase) * normal * c;
    out[3] = -(1.0 + s.hull_increase) * s.rudder_z * length * normal * c;
    out[5] = (s.rudder_x + s.hull_increase * s.hull_x) * length * normal * c;
    return out;
}

}  // namespace hawser::vessel
