// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file vessel_system.h
/// Apply the loads of a vessel at the beginning of each step (hawser/vessel.h).
///
/// ν* is the velocity of O at the beginning of the step. B maps velocities of the centre of mass in
/// the world frame to velocities of O in the marine frame. D_i = −∂τ_i/∂ν_i ≥ 0:
/// ```
///     f = Bᵀ (τ(ν*) + D ν* + A (Ω × ν)* − C_A ν* − G η)     A, D, K = Bᵀ (A, D, G) B
/// ```
/// Loads accept positive semi-definite masses only. Published sets may have another A. Then the
/// load uses the nearest such matrix A_s, and forces are multiplied by P = (M_RB + A_s)(M_RB +
/// A)⁻¹, which gives the same accelerations.
///
/// A (Ω × ν) converts the acceleration of the world frame, on which the mass of a load acts, to the
/// acceleration of the marine frame, which rotates with Ω = (0, 0, r).

#include <hawser/system.h>
#include <hawser/vessel.h>

#include "vessel/actuators.h"
#include "vessel/control.h"
#include "vessel/flow.h"
#include "vessel/hull_forces.h"
#include "vessel/losses.h"
#include "vessel/power.h"
#include "vessel/stern.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace hawser::vessel {

/// Return the mass matrix of a body at O, marine frame, upright. @param origin  O relative to the
/// centre of mass, in the body's frame [m].
[[nodiscard]] Matrix6 rigid_mass(double mass, const Mat3& inertia, const Vec3& origin);

class VesselSystem final : public System {
  public:
    /// Create the system of a vessel from a checked definition.
    /// @param mass, inertia  Mass and inertia of the body. @param surface  Surface of the water
    ///         over its propulsors. @param lines  Lines whose tension the control feeds forward.
    VesselSystem(VesselDef def, double mass, Mat3 inertia, Surface surface,
                 std::vector<FedLine> lines);

    [[nodiscard]] std::string_view name() const noexcept override { return def_.name; }
    void prestep(Prestep& now, Loads& loads) noexcept override;
    void visit_state(StateVisitor& visitor) override;
    void check_state(const World& world, StateRules& rules) const override;
    void signals(SignalTable& table) override;
    void holds(HoldTable& table) const override { table.hold(def_.body); }
    [[nodiscard]] std::unique_ptr<System> clone() const override;
    [[nodiscard]] const VesselDef& def() const noexcept { return def_; }
    /// True if the ship has a coefficient set whose rudder is driven by the input `rudder`.
    [[nodiscard]] static bool has_set(const VesselDef& def) noexcept;
    /// True if the revolutions of a propeller in a coefficient set act on the ship.
    [[nodiscard]] static bool has_shaft(const VesselDef& def) noexcept;

  private:
    /// Position and motion of the ship in one step.
    struct Motion {
        Flow flow;
        Wrench ground = Wrench::Zero();  ///< Velocity of O over ground, marine frame.
        Wrench centre = Wrench::Zero();  ///< Velocity of the centre of mass through the water.
        Vec3 arm{0.0, 0.0, 0.0};         ///< O relative to the centre of mass, marine frame [m].
        Mat3 axes = Mat3::Identity();    ///< Columns: marine axes in the world.
        Vec3 wind{0.0, 0.0, 0.0};        ///< Past the ship, marine frame.
        double air = 0.0;                ///< Density [kg/m³].
        double heave = 0.0, pitch = 0.0;
    };
    [[nodiscard]] Motion read_motion(const Prestep& now) noexcept;
    void read_sea(const World& world, Vec3& current, Vec3& wind, Motion& m) const noexcept;
    /// Compute the forces that depend on the velocity through the water.
    /// @param push  True: compute `pushes_`; false: they are those of the same u, v, r.
    [[nodiscard]] Wrench water_force(const Flow& flow, bool push) noexcept;
    /// Compute the forces of propulsors and rudders.
    void compute_pushes(const Flow& flow) noexcept;
    [[nodiscard]] Wrench wind_force(const Motion& m) const noexcept;
    [[nodiscard]] Wrench added_coriolis(const Motion& m) const noexcept;
    [[nodiscard]] Wrench marine_load(const Motion& m, const Wrench& force) const noexcept;
    void add_loads(Loads& loads, const Motion& m, const Wrench& force,
                   const Wrench& damping) const noexcept;
    void advance(Prestep& now, const Flow& flow) noexcept;
    void advance_steering(Prestep& now) noexcept;
    void advance_propulsors(Prestep& now, const Flow& flow) noexcept;
    /// Compute `thrust_fraction` of all propulsors.
    void update_losses(const Prestep& now, double density) noexcept;
    /// Advance the control by one step. @return a force that acts on the ship directly.
    [[nodiscard]] Wrench control(Prestep& now, const Motion& m) noexcept;

    VesselDef def_;
    double mass_;
    Mat3 inertia_;
    Matrix6 added_;    ///< Symmetric positive semi-definite part of A, as a load.
    Matrix6 balance_;  ///< P = M_s M⁻¹; identity if A_s = A.
    bool balanced_ = true;
    Polynomial polynomial_;
    std::vector<Propulsor> propulsors_;
    std::vector<Rudder> rudders_;
    Surface surface_;  ///< Water surface, updated in each step.
    // Scratch of water_force().
    std::vector<double> thrusts_;  ///< Thrusts of propulsors in open water [N].
    std::vector<Wrench> pushes_;   ///< Forces of propulsors, then of rudders.
    bool has_losses_ = false;
    std::vector<FedLine> lines_;
    std::unique_ptr<Control> control_;  ///< Null: VesselControl::active is false.

    // State.
    Vec3 last_velocity_{0.0, 0.0, 0.0}, last_spin_{0.0, 0.0, 0.0};
    std::int32_t started_ = 0, steering_limited_ = 0;
    double rudder_order_ = 0.0, rps_order_ = 0.0;  ///< Inputs.
    double rudder_ = 0.0, rps_ = 0.0;
    double rudder_failed_ = 0.0, rps_failed_ = 0.0;  ///< Inputs.
    std::int32_t rudder_failed_last_ = 0, rps_failed_last_ = 0;
    PowerBus bus_;
    std::vector<PropulsorState> propulsor_;
    std::vector<RudderState> rudder_state_;
    // Outputs, part of the state.
    double speed_ = 0.0, ground_speed_ = 0.0, drift_ = 0.0, turn_rate_ = 0.0;
    double surge_ = 0.0, sway_ = 0.0, yaw_ = 0.0;
};

}  // namespace hawser::vessel
