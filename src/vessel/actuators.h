// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file actuators.h
/// Propulsors and rudders of a vessel with their state (hawser/vessel_propulsion.h).

#include <hawser/vessel_propulsion.h>

#include "vessel/flow.h"

#include <cstdint>
#include <string>

namespace hawser::vessel {

/// What an actuator did in a step.
struct Limit {
    bool met = false;
    double value = 0.0;
};

/// Move `now` towards `target`: first order with a time constant, limited in rate.
/// @return True if the rate is at its limit.
bool follow(double& now, double target, double rate, double lag, double step) noexcept;
/// The same angle from −π to π [rad].
[[nodiscard]] double wrapped(double angle) noexcept;

/// State of a propulsor.
struct PropulsorState {
    double order = 0.0, angle_order = 0.0, pitch_order = 1.0;  ///< Inputs.
    double level = 0.0;  ///< Revolutions over most, of ideal ones and those without a shaft.
    double rps = 0.0;    ///< [1/s].
    double angle = 0.0;  ///< Thrust direction from ahead, clockwise seen from above [rad].
    double pitch = 1.0;  ///< Over full pitch.
    double thrust = 0.0, power = 0.0;                     ///< Outputs [N], [W].
    std::int32_t turning_limited = 0, power_limited = 0;  ///< Limits in the last step.
};

/// A propulsor of a vessel; its point from O in the marine frame.
class Propulsor {
  public:
    Propulsor(const PropulsorDef& def, const Vec3& origin);
    /// Thrust along its axis at a flow [N]. @param along  Out: velocity of the water past it along
    /// the thrust [m/s].
    [[nodiscard]] PropellerForce open(const PropulsorState& s, const Flow& flow,
                                      double& along) const noexcept;
    [[nodiscard]] Wrench force(const PropulsorState& s, const Flow& flow) const noexcept;
    /// From one step to the next. `turn` and `power` are limits that begin.
    void advance(PropulsorState& s, const Flow& flow, double step, Limit& turn,
                 Limit& power) const noexcept;
    [[nodiscard]] const PropulsorDef& def() const noexcept { return def_; }
    [[nodiscard]] bool screw() const noexcept { return def_.propeller.diameter > 0.0; }

  private:
    void turn_shaft(PropulsorState& s, const Flow& flow, double step, Limit& power) const noexcept;
    [[nodiscard]] double direction(const PropulsorState& s) const noexcept;
    PropulsorDef def_;
    Vec3 at_;  ///< Marine frame.
};

struct RudderState {
    double order = 0.0;  ///< Input [rad].
    double angle = 0.0;  ///< [rad].
    std::int32_t limited = 0;
};

class Rudder {
  public:
    /// @param behind  Its propulsor; −1: none.
    Rudder(const RudderDef& def, const Vec3& origin, int behind);
    /// @param thrust, diameter  Of its propulsor [N], [m]; 0: none.
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

/// Force along a horizontal direction at a point: marine frame.
[[nodiscard]] Wrench push_at(const Vec3& at, double x, double y) noexcept;

}  // namespace hawser::vessel
