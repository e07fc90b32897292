// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file coupling.h
/// Measure the loss of accuracy by a split: compare each step with an exact one from the same state
/// (docs/theory/splits.md).

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
    std::int32_t cuts = 0;                      ///< Number of cuts in the last step.
    double residual_max = 0.0;                  ///< StepStats::cut_residual [m/s or rad/s].
    double defect_rms = 0.0, defect_max = 0.0;  ///< StepStats::momentum_defect.
    /// Largest ‖v₊ − 2v + v₋‖/h² over bodies and steps [m/s³]. First: of the run. Second: of exact
    /// steps from the states of the run.
    double jerk_max = 0.0, jerk_exact_max = 0.0;
    double jerk_difference_max = 0.0;  ///< max ‖v₊ − v₊ exact‖/h² [m/s³].
    /// Differences of cut forces in metre rows from those of the exact step, over the rms of the
    /// latter.
    double tension_error_rms = 0.0, tension_error_max = 0.0;
    double spectral_radius =
        0.0;  ///< Spectral radius at the end of the run, see spectral_radius().
};

/// Observes a run. Each step costs an additional exact step.
class CouplingObserver : public Observer {
  public:
    explicit CouplingObserver(const World& world);
    void before_step(const World& world) override;
    void after_step(const World& world);
    void after_step(const World& world, std::span<const Event>) override { after_step(world); }
    /// Return the figures. @param radius  Compute the spectral radius, too, which needs some 160
    /// steps.
    [[nodiscard]] CouplingFigures result(const World& world, bool radius = true) const;

  private:
    World exact_world_;
    CouplingFigures figures_;
    std::vector<Vec3> now_, before_;  ///< v and v₋ by body.
    double defect_squares_ = 0.0, error_squares_ = 0.0, force_squares_ = 0.0, error_max_ = 0.0;
    std::int64_t forces_ = 0;
};

/// Return the largest |z| of the step linearised about the present state, by power iteration with
/// finite differences. The state stays unchanged. Free motion, with z = 1 and constant velocities,
/// does not count. The multipliers of the last step stay constant, so that their effect on
/// predictor forces is omitted. With neutral motions the result may be up to 1.02.
[[nodiscard]] double spectral_radius(const World& world);

}  // namespace hawser::verify
