// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file stability_curve.h
/// Compute righting levers of a ship, and the criteria of a towline (hawser/stability.h).

#include <hawser/hull.h>
#include <hawser/stability.h>

#include <array>
#include <vector>

namespace hawser::vessel {

/// Righting levers by heel and displacement, and the criteria.
class StabilityCurve {
  public:
    /// Compute the levers of a mesh with the centre of mass at its origin; of an empty mesh, GM sin
    /// φ.
    /// @param def  Without open defaults except `stern` and angles.
    StabilityCurve(const StabilityDef& def, const HullMesh& mesh, double density);

    /// Return GZ at a heel of 0 to 90° with an added weight at the pin's height on the centreline
    /// [m]. @param added  [kg].
    [[nodiscard]] double lever(double heel, double added) const noexcept;
    /// Return the largest righting lever GZ of the ship without added weight [m], and its angle
    /// [rad].
    [[nodiscard]] std::array<double, 2> max_lever() const noexcept { return most_; }
    /// Return y of the towline's point, y₀ + x tan α, limited to the half breadth of the mesh [m].
    [[nodiscard]] double towline_offset(double alpha) const noexcept;
    /// Return the height h of the pin above the line of thrust [m].
    [[nodiscard]] double height() const noexcept { return def_.pin.z() - def_.thrust_height; }
    [[nodiscard]] StabilityCheck check(double force, double alpha, double beta) const noexcept;
    /// Return the permissible tension in a direction. @param halvings  Number of bisections of the
    /// interval from 0 to the ship's weight.
    [[nodiscard]] double permissible_tension_at(double alpha, double beta,
                                                int halvings) const noexcept;
    [[nodiscard]] const StabilityDef& def() const noexcept { return def_; }

  private:
    static constexpr int kHeelAngles = 61;  ///< From 0 to 90°.
    using Levers = std::array<double, kHeelAngles>;
    struct Residual {
        double first, area, lever;
    };

    [[nodiscard]] double free_stern(double added) const noexcept;
    [[nodiscard]] Residual residual(double lever_of_wire, double added) const noexcept;

    StabilityDef def_;
    Levers light_{}, heavy_{};  ///< GZ of the mesh at the mass and at kSecondDisplacement times it.
    bool has_mesh_ = false;
    std::array<double, 2> most_{};
    double half_angle_ = 0.0;  ///< Heel with half of the largest GZ [rad].
    double half_breadth_;      ///< [m]
    double freeboard_ = 0.0;   ///< At the stern, afloat without a tow [m].
    double sinks_ = 0.0;       ///< Its change per added mass [m/kg].
};

}  // namespace hawser::vessel
