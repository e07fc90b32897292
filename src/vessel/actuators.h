// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file actuators.h
/// Compute the forces and states of propulsors and rudders of a vessel
/// (hawser/vessel_propulsion.h).

#include <hawser/vessel_propulsion.h>

#include "vessel/flow.h"

#include <cstdint>
#include <string>

namespace hawser::vessel {

/// Limit that an actuator met in a step.
struct Limit {
    bool is_met = false;
    double value = 0.0;
};

/// Move `now` towards `target`: first order with a time constant, limited in rate.
/// @return True if the rate is at its limit.
bool follow(double& now, double target, double rate, double lag, double step) noexcept;
/// Return the equivalent angle between −π and π [rad].
[[nodiscard]] double wrapped(double angle) noexcept;

/// State of a propulsor.
struct PropulsorState {
    double order = 0.0, angle_order = 0.0, pitch_order = 1.0;  ///< Inputs.
    double level =
        0.0;  ///< Revolutions over the maximum; for ideal propulsors, and those without a shaft.
    double rps = 0.0;    ///< [1/s].
    double angle = 0.0;  ///< Thrust direction from ahead, clockwise seen from above [rad].
    double pitch = 1.0;  ///< Over full pitch.
    double thrust = 0.0, power = 0.0;                     ///< Outputs [N], [W].
    std::int32_t turning_limited = 0, power_limited = 0;  ///< Limits in the last step.
    double failed = 0.0;                                  ///< Input, a Failure.
    std::int32_t failed_last = 0;                         ///< Failure in the last step.
    double thrust_fraction = 1.0,
           torque_fraction = 1.0;    ///< Thrust and torque over their values without losses.
    double loss = 0.0;               ///< Output: 1 − thrust_fraction.
    double torque = 0.0;             ///< Output: torque of the water on the shaft [N m].
    std::int32_t pitch_limited = 0;  ///< The pitch was at its rate in the last step.
};

/// Failure modes of the inputs NAME_failed.
enum class Failure : std::uint8_t { none, stopped, kept, full };
[[nodiscard]] Failure failure_from_input(double input) noexcept;

/// Propulsor of a vessel, at a point relative to O in the marine frame.
class Propulsor {
  public:
    Propulsor(const PropulsorDef& def, const Vec3& origin);
    /// Return thrust and torque in a flow, without thrust losses. @param along  Output: velocity of
    /// the water past the propulsor, along the thrust [m/s].
    [[nodiscard]] PropellerForce open(const PropulsorState& s, const Flow& flow,
                                      double& along) const noexcept;
    /// Compute the force on the ship. It depends on u, v, r and the density of the flow alone.
    [[nodiscard]] Wrench force(const PropulsorState& s, const Flow& flow) const noexcept;
    /// Return the wrench on the ship for a thrust computed by open() [N].
    [[nodiscard]] Wrench push(const PropulsorState& s, double thrust) const noexcept;
    /// Return the power that the propulsor would need in this step without a limit by the power bus
    /// [W].
    /// @param rated  Power of an ideal propulsor at full order.
    [[nodiscard]] double demand(const PropulsorState& s, const Flow& flow,
                                double rated) const noexcept;
    /// Advance the state by a step. `turn` and `power` report limits reached in this step.
    /// @param granted  Allowed power [W]. @param demanded  Result of demand() [W].
    void advance(PropulsorState& s, const Flow& flow, double step, double granted, double demanded,
                 Limit& turn, Limit& power) const noexcept;
    /// Return the direction of the thrust for a positive order [rad].
    [[nodiscard]] double direction(const PropulsorState& s) const noexcept;
    [[nodiscard]] const Vec3& at() const noexcept { return at_; }
    /// Return the diameter of the race; 0 if unknown [m].
    [[nodiscard]] double diameter() const noexcept {
        return is_screw() ? def_.propeller.diameter : def_.diameter;
    }
    /// Return the thrust of a propulsor at full order, at rest and without losses [N].
    [[nodiscard]] double max_thrust(double density) const noexcept;
    [[nodiscard]] const PropulsorDef& def() const noexcept { return def_; }
    [[nodiscard]] bool is_screw() const noexcept { return def_.propeller.diameter > 0.0; }

  private:
    /// Motor and water at the beginning of a step.
    struct Shaft {
        double target = 0.0;                         ///< Ordered n [1/s].
        double load = 0.0, slope = 0.0;              ///< Torque of the water Q and ∂Q/∂n.
        double unlimited_torque = 0.0, motor = 0.0;  ///< Torque without limits, within its own.
    };
    [[nodiscard]] Shaft shaft(const PropulsorState& s, const Flow& flow) const noexcept;
    /// Return the revolutions n at which a granted power limits the torque [1/s].
    [[nodiscard]] double turning(const PropulsorState& s) const noexcept;
    void turn_shaft(PropulsorState& s, const Flow& flow, double step, double granted,
                    Limit& power) const noexcept;
    void turn(PropulsorState& s, double step, Limit& turn) const noexcept;
    void turn_vector(PropulsorState& s, double order, double step) const noexcept;
    /// Return the order that is in force: the input, or the order set by a failure or a power
    /// limit.
    [[nodiscard]] double effective_order(const PropulsorState& s) const noexcept;
    PropulsorDef def_;
    Vec3 at_;  ///< Marine frame.
};

struct RudderState {
    double order = 0.0;  ///< Input [rad].
    double angle = 0.0;  ///< [rad].
    std::int32_t is_limited = 0;
    double failed = 0.0;           ///< Input, a Failure.
    std::int32_t failed_last = 0;  ///< Failure in the last step.
};

class Rudder {
  public:
    /// Create a rudder.
    /// @param behind  Index of the propulsor ahead of the rudder; −1: none.
    Rudder(const RudderDef& def, const Vec3& origin, int behind);
    /// Return the force of the rudder. @param thrust, diameter  Thrust [N] and diameter [m] of its
    /// propulsor; 0: none.
    [[nodiscard]] Wrench force(const RudderState& s, const Flow& flow, double thrust,
                               double diameter) const noexcept;
    void advance(RudderState& s, double step, Limit& rate) const noexcept;
    [[nodiscard]] const RudderDef& def() const noexcept { return def_; }
    [[nodiscard]] int behind() const noexcept { return behind_; }

  private:
    RudderDef def_;
    Vec3 at_;
    int behind_;
};

/// Return the wrench of a horizontal force (x, y) at a point, marine frame.
[[nodiscard]] Wrench push_at(const Vec3& at, double x, double y) noexcept;

}  // namespace hawser::vessel
