// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file coupling.h
/// What a split costs in accuracy: each step beside an exact one from the same state
/// (docs/methods.md, 10).

#include <hawser/hawser.h>
#include <hawser/observer.h>

#include <cstdint>
#include <vector>

namespace hawser::verify {

[[nodiscard]] const char* to_string(Coupling coupling) noexcept;
[[nodiscard]] const char* to_string(Predictor predictor) noexcept;

struct CouplingFigures {
    Coupling coupling = Coupling::exact;
    Predictor predictor = Predictor::hold;
    std::int64_t steps = 0;
    std::int32_t cuts = 0;                      ///< In force in the last step.
    double residual_max = 0.0;                  ///< StepStats::cut_residual [m/s or rad/s].
    double defect_rms = 0.0, defect_max = 0.0;  ///< StepStats::momentum_defect.
    /// max ‖v₊ − 2v + v₋‖/h² over bodies and steps: of the run, and of exact steps from the states
    /// of the run [m/s³].
    double jerk_max = 0.0, jerk_exact_max = 0.0;
    double jerk_difference_max = 0.0;  ///< max ‖v₊ − v₊ exact‖/h² [m/s³].
    /// Forces of cuts in metre rows against those of the exact step: over the rms of the latter.
    double tension_error_rms = 0.0, tension_error_max = 0.0;
    double spectral_radius = 0.0;  ///< See spectral_radius(), where the run ended.
};

/// Watches a run. Each step costs an exact one more.
class CouplingObserver : public Observer {
  public:
    explicit CouplingObserver(const World& world);
    void before_step(const World& world) override;
    void after_step(const World& world);
    void after_step(const World& world, std::span<const Event>) override { after_step(world); }
    /// @param radius  Find the spectral radius as well, which takes some 160 steps.
    [[nodiscard]] CouplingFigures result(const World& world, bool radius = true) const;

  private:
    World exact_;
    CouplingFigures figures_;
    std::vector<Vec3> now_, before_;  ///< v and v₋ by body.
    double defect_squares_ = 0.0, error_squares_ = 0.0, force_squares_ = 0.0, error_max_ = 0.0;
    std::int64_t forces_ = 0;
};

/// Largest |z| of the step linearised about the present state, which stays as it is: by power
/// iteration with finite differences. Free motion, for which z = 1 and velocities stay as they are,
/// does not count. Multipliers of the last step stay as they are, so that what predictor forces
/// makes of them is left out. Neutral motions let it say up to 1.02.
[[nodiscard]] double spectral_radius(const World& world);

}  // namespace hawser::verify
