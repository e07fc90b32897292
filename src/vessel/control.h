// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file control.h
/// Control a vessel by joystick, autopilot and dynamic positioning (hawser/vessel_control.h).

#include <hawser/system.h>
#include <hawser/vessel.h>

#include "vessel/actuators.h"
#include "vessel/allocation.h"
#include "vessel/observer.h"
#include "vessel/power.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace hawser::vessel {

/// Line whose tension is fed forward, with the ends of its element.
struct FedLine {
    InteractionId element{};
    BodyId other{};  ///< Invalid: fixed in the world.
    Vec3 ship_point = Vec3::Zero(),
         other_point = Vec3::Zero();  ///< End points in the frames of both bodies [m].
};

/// Motion and loads of a step at O, as input of the control.
struct ControlSense {
    Planar measured{};
    double surge = 0.0;          ///< Through the water [m/s].
    Vec3 wind = Vec3::Zero();    ///< X, Y and N of the wind [N, N, N m].
    Vec3 target = Vec3::Zero();  ///< Position of the target in the world, if there is one [m].
    Vec3 target_motion = Vec3::Zero();  ///< Its velocity in the world.
    Vec3 lines = Vec3::Zero();  ///< X, Y and N of the lines that are fed forward [N, N, N m].
};

/// Actuators that the control orders.
struct ControlledActuators {
    std::vector<PropulsorState>& propulsors;
    std::vector<RudderState>& rudders;
    double& rudder_order;
    double& rps_order;
    const PowerBus& bus;
};

class Control {
  public:
    /// Create the control of a vessel.
    /// @param mass  Diagonal of M with added mass for surge, sway and yaw.
    Control(const VesselDef& def, const Vec3& mass);

    /// Choose the mode and the orders, and allocate the demand to the propulsors. @return Force
    /// that acts directly (VesselControl:: direct), else 0.
    [[nodiscard]] Vec3 step(Prestep& now, const ControlSense& sense,
                            ControlledActuators act) noexcept;
    void visit(StateVisitor& visitor);
    void check(StateRules& rules) const;
    void signals(SignalTable& table);
    /// Return the names of the signals of the control, which propulsors and rudders must not have.
    [[nodiscard]] static const std::vector<std::string>& signal_names();
    /// Return the reason why a mode is not possible; "" if it is.
    [[nodiscard]] const char* rejection_reason(ControlMode mode) const noexcept;

  private:
    void choose_mode(Prestep& now, const ControlSense& sense,
                     const ControlledActuators& act) noexcept;
    void engage(ControlMode mode, const ControlSense& sense,
                const ControlledActuators& act) noexcept;
    void follow_orders(const ControlSense& sense, double h) noexcept;
    [[nodiscard]] Vec3 demand(const ControlSense& sense, double h) noexcept;
    [[nodiscard]] Vec3 speed_demand(const ControlSense& sense, double h) noexcept;
    void steer(const ControlSense& sense, ControlledActuators act, double h) noexcept;
    /// Compute the available fraction of each propulsor's thrust, and the sum of the forces of
    /// propulsors without control.
    void find_available(const ControlledActuators& act, double h) noexcept;
    void order_thrusters(const Vec3& tau, ControlledActuators act, double h) noexcept;
    void limit_thruster(const PropulsorState& s, std::size_t i, double h) noexcept;
    void order_angle(PropulsorState& s, std::size_t i) noexcept;
    void integrate(const Vec3& tau, double h) noexcept;
    /// Return the present force of a propulsor, X, Y, N.
    [[nodiscard]] Vec3 push(const PropulsorState& s, std::size_t i) const noexcept;
    [[nodiscard]] Vec3 last_propulsor_force(const ControlledActuators& act) const noexcept;
    void report(Prestep& now) noexcept;
    void analyse_failure(Prestep& now, double h) noexcept;
    [[nodiscard]] double heading_error() const noexcept;
    [[nodiscard]] bool steers_by_rudder(const ControlSense& sense) const noexcept;
    [[nodiscard]] ControlMode mode() const noexcept {
        return static_cast<ControlMode>(active_mode_ > 0.0 ? static_cast<int>(active_mode_) : 0);
    }

    const VesselDef def_;
    Vec3 mass_;
    Vec3 proportional_, derivative_, integral_;
    Allocation allocation_;
    Vec3 largest_ = Vec3::Zero();
    int authority_ = 0;
    double length_ = 100.0;
    std::vector<double> rps_;   ///< Revolutions at capacity over most_rps; 1 if ideal.
    std::vector<double> full_;  ///< Power of each propulsor at capacity, at the shaft [W].
    std::vector<std::vector<std::uint8_t>> failures_;
    // Work arrays.
    std::vector<ThrusterNow> present_thrust_;
    std::vector<double> thrusts_;
    std::vector<std::int32_t> spare_;
    std::vector<double> available_;     ///< Fractions of capacities in this step.
    std::vector<double> remaining_;     ///< Fractions after one more failure.
    Vec3 uncontrolled_ = Vec3::Zero();  ///< Force of propulsors that do not obey.

    // Input signals.
    double mode_input_ = 0.0;
    double x_order_ = 0.0, y_order_ = 0.0, heading_order_ = 0.0, speed_order_ = 0.0;
    double stick_x_ = 0.0, stick_y_ = 0.0, stick_n_ = 0.0;
    // State.
    std::int32_t started_ = 0, arrived_ = 1, critical_ = 0, next_failure_ = 0;
    Vec3 last_orders_ = Vec3::Zero();  ///< Orders of the last step: x, y, heading.
    Vec3 desired_ = Vec3::Zero();      ///< η_d: north, east, heading.
    Vec3 error_ = Vec3::Zero();        ///< e in axes of the ship.
    Vec3 sum_ = Vec3::Zero();          ///< ∫e dt, north, east, heading.
    Vec3 offset_ = Vec3::Zero();       ///< Distance to the target, in the world.
    Vec3 feed_ = Vec3::Zero();         ///< Filtered feed-forward.
    Vec3 acting_ = Vec3::Zero();  ///< τ that acted on the ship in the last step, for the observer.
    Vec3 mean_ = Vec3::Zero();    ///< Filtered demand, for the consequence analysis.
    double steer_sum_ = 0.0, speed_sum_ = 0.0;
    Observer observer_;
    std::vector<std::int32_t> sectors_;
    std::vector<double> shortfalls_;  ///< Shortfall of each failure.
    std::vector<double> powered_;     ///< Fractions of capacities by the bus; empty without one.
    // Output signals.
    double active_mode_ = 0.0, heading_ = 0.0, worst_ = 0.0, worst_failure_ = -1.0;
    Vec3 offsets_ = Vec3::Zero(), demand_ = Vec3::Zero(), allocated_ = Vec3::Zero();
};

}  // namespace hawser::vessel
