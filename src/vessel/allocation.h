// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file allocation.h
/// Allocate thrust: compute thrusts and angles for a force and moment.
///
/// ```
///     minimise  Σ c_i |f_i|²/T_i² + q |S(Σ B_i f_i − τ)|²
///     subject to  |f_i| ≤ T_i,  f_i in an allowed sector
/// ```
/// S divides forces by ΣT and the moment by ΣT times the longest lever. q is large, so that τ is
/// met as far as possible, the moment first. Discs are polygons of 32 sides. Allowed directions of
/// an azimuth are divided into sectors of at most 180°. If the program without sectors ends outside
/// of them, the sectors of these azimuths are tried one azimuth after the other. The present sector
/// is kept unless another costs less by 5 %.
///
/// A second program finds the thrusts at the present angles within their rates. Other thrusters
/// then compensate for azimuths that are still turning.
///
/// The solver is part of the project (quadratic_program.h). Well-kept ones in Debian (OSQP,
/// qpOASES) iterate to a tolerance or allocate memory, but a step needs reproducible bits and no
/// allocation.

#include <hawser/math.h>

#include "vessel/quadratic_program.h"

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace hawser::vessel {

/// Sector of thrust directions, clockwise from `from`.
struct ThrustSector {
    double from = 0.0, width = 0.0;  ///< [rad]; width at most π.
    bool reversed = false;           ///< Thrust astern: the azimuth points the other way.
};

struct AllocatedThruster {
    bool is_azimuth = false;
    double x = 0.0, y = 0.0;              ///< Marine frame, from O [m].
    double axis = 0.0;                    ///< Direction of ahead thrust of a fixed thruster [rad].
    double ahead = 0.0, astern = 0.0;     ///< Capacities ≥ 0 [N].
    double cost = 1.0;                    ///< c_i.
    std::vector<ThrustSector> sectors{};  ///< Allowed directions if it turns; empty: all.
};

/// Present state of a thruster and its limits in a step.
struct ThrusterNow {
    double angle = 0.0;                         ///< Direction of positive thrust [rad].
    double thrust_min = 0.0, thrust_max = 0.0;  ///< Thrust [N].
};

class Allocation {
  public:
    Allocation() = default;
    explicit Allocation(std::vector<AllocatedThruster> thrusters);

    /// Compute the forces of least cost for τ = (X, Y, N).
    /// @param available  Available fraction of the capacity of each thruster, 0 … 1; 0: failed;
    /// null: 1 for all.
    /// @param sectors  In and out: sector that each thruster uses; −1: none yet.
    void allocate(const Vec3& tau, const double* available, std::int32_t* sectors) noexcept;
    /// Return the force of a thruster after allocate(), in the marine frame [N].
    [[nodiscard]] double x(std::size_t i) const noexcept { return forces_[2 * i]; }
    [[nodiscard]] double y(std::size_t i) const noexcept { return forces_[2 * i + 1]; }
    /// Return the sum of forces and moments of all thrusters after allocate() or
    /// thrust_at_fixed_angles().
    [[nodiscard]] const Vec3& total() const noexcept { return total_; }

    /// Compute thrusts at fixed angles within their limits. @param thrusts  Output [N].
    void thrust_at_fixed_angles(const Vec3& tau, const ThrusterNow* now, double* thrusts) noexcept;

    /// Return the largest force of each axis alone, regardless of the others [N, N, N m].
    [[nodiscard]] Vec3 largest_axis_forces() const noexcept;
    /// Return the number of axes that thrusters can control independently, 0 to 3.
    [[nodiscard]] int independent_axes() const;
    /// Return the norm |S τ| of a demand, with the scales of the cost function.
    [[nodiscard]] double scaled_norm(const Vec3& tau) const noexcept;
    [[nodiscard]] const std::vector<AllocatedThruster>& thrusters() const noexcept {
        return thrusters_;
    }

  private:
    [[nodiscard]] double program(const Vec3& tau, const double* available,
                                 const std::int32_t* sectors) noexcept;
    void add_limits(std::size_t i, double available, std::int32_t sector) noexcept;
    [[nodiscard]] int sector_index(std::size_t i, double x, double y,
                                   double available) const noexcept;
    [[nodiscard]] Vec3 lever(std::size_t i, double x, double y) const noexcept;
    void set_cost(const Vec3& tau, int variables) noexcept;

    static constexpr std::size_t kSides = 32;  ///< Number of sides of the polygon of a disc.
    std::array<std::pair<double, double>, kSides> sides_{};  ///< Normals.
    std::vector<AllocatedThruster> thrusters_;
    std::vector<std::int32_t> first_;  ///< First variable of each thruster.
    std::vector<double> forces_;
    std::vector<std::int32_t> trial_sectors_;
    Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, QuadraticProgram::kMaxVariables> effect_;
    QuadraticProgram program_;
    double force_ = 1.0, moment_ = 1.0;  ///< Scales.
    int variables_ = 0;
    Vec3 total_ = Vec3::Zero();
};

}  // namespace hawser::vessel
