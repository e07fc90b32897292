// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file observer.h
/// Nonlinear passive observer with wave filter and bias (hawser/vessel_control.h).

#include <hawser/math.h>
#include <hawser/state_visitor.h>

#include <array>

namespace hawser::vessel {

/// Position of O: north = x, east = −y of the world [m], heading clockwise [rad].
struct Planar {
    Vec3 planar_position = Vec3::Zero();
    Vec3 motion = Vec3::Zero();  ///< u, v, r over ground, in axes of the ship [m/s, rad/s].
};

class Observer {
  public:
    Observer() = default;
    /// Create an observer.
    /// @param mass  Diagonal of M with added mass. @param damping  Diagonal of D. @param period
    ///         Period of the waves [s].
    Observer(const Vec3& mass, const Vec3& damping, double period);
    /// Initialise the estimates of the observer with a measured motion.
    void start(const Planar& measured) noexcept;
    /// Advance by one step. @param force  τ that acts on the ship [N, N, N m].
    void step(const Planar& measured, const Vec3& force, double h) noexcept;
    /// Return the low-frequency part of the motion.
    [[nodiscard]] const Planar& low_frequency_motion() const noexcept { return low_frequency_; }
    /// Return the slowly varying force, in axes of the ship.
    [[nodiscard]] const Vec3& bias() const noexcept { return bias_; }
    void visit(StateVisitor& visitor);

  private:
    Vec3 mass_ = Vec3::Ones(), damping_ = Vec3::Zero();
    double frequency_ = 1.0;
    Planar low_frequency_{};
    Vec3 bias_ = Vec3::Zero();
    Vec3 swell_ = Vec3::Zero(), swell_rate_ = Vec3::Zero();  ///< ξ: integral and wave motion.
};

/// Rotate a vector from the axes of the ship to north and east. The next function is the inverse.
[[nodiscard]] Vec3 to_earth(const Vec3& of_ship, double heading) noexcept;
[[nodiscard]] Vec3 to_ship(const Vec3& of_earth, double heading) noexcept;

}  // namespace hawser::vessel
