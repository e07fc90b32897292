// SPDX-License-Identifier: Apache-2.0
/// @file
/// Measure a run of any engine from the states of its bodies: gap, tension, energy, path.
#pragma once

#include "reference.h"
#include "scenes.h"

#include <optional>
#include <string>
#include <vector>

namespace hawser::bench {

/// Limits of *holds*: all of them, over the whole run.
inline constexpr double kGapLimit = 1e-3;      ///< Largest joint position error [m].
inline constexpr double kTensionLimit = 0.02;  ///< Relative rms tension error after 1 s.
inline constexpr double kEnergyLimit = 0.01;   ///< Largest relative energy drift.
inline constexpr double kBlockLimit = 0.1;     ///< Largest error of the block's path [m].
inline constexpr double kMovedLimit = 1e-3;    ///< Drop and sideways motion of Scene::top [m].
inline constexpr double kSettle = 1.0;         ///< Tension counts after this time [s].

/// Measures since the start. An empty optional: no reference.
struct Measures {
    double gap = 0.0;                      ///< Largest distance between joint ends [m].
    std::optional<double> tension_error;   ///< rms of (T - T_ref) / T_ref, T the mean of a frame.
    std::optional<double> substep_ripple;  ///< rms of (T - T_ref) / T_ref, T of single substeps.
    std::optional<double> tension_mean;    ///< (mean T - mean T_ref) / mean T_ref.
    std::optional<double> tension_ripple;  ///< rms of T about its mean / mean T_ref.
    std::optional<double> tension_worst;   ///< Largest |T - T_ref| / T_ref.
    /// Value of largest size, signed, relative. 0 in a scene with contacts, whose losses are not
    /// reported.
    double energy_drift = 0.0;
    double energy_end = 0.0;               ///< At the end of the run, signed, relative.
    std::optional<double> block_error;     ///< Largest distance to the reference path [m].
    std::optional<double> mode_amplitude;  ///< Sine mode over the last second / its start.
    std::optional<double> drop;            ///< Largest vertical motion of Scene::top [m].
    std::optional<double> sideways;        ///< Largest horizontal motion of Scene::top [m].
    std::optional<double> sink;            ///< Deepest point of a capsule below the floor [m].
    bool finite = true;
};

/// Accumulates the measures of one run.
///
/// Energy drift: E(t) - E(0) - W(t) over Scene::energy_scale, E kinetic energy plus gravity and
/// hydrostatic springs, W the work of thrust, drag and dampers with the mean velocity of each
/// substep. Tension: |m dv/dt - other forces| on each towed ship.
class Meter {
  public:
    /// Start. @param staggered  Velocities belong to half a substep before the poses
    /// (Runner::staggered).
    Meter(const Scene& scene, const Reference& reference, bool staggered);

    /// Add a substep of length `h` from `before` (where `loads` were evaluated) to `after`. `tow`:
    /// force of the line on each towed ship if the engine reports it, otherwise null.
    void substep(const std::vector<BodyState>& before, const std::vector<Load>& loads,
                 const std::vector<BodyState>& after, double h, const std::vector<Vec3>* tow);

    /// End a frame at time `t`, after its substeps.
    void frame(const std::vector<BodyState>& before, const std::vector<BodyState>& now, double t);

    [[nodiscard]] const Measures& measures() const { return m_; }

    /// Return the first broken limit, or an empty text. `frames` is the length of the whole run, so
    /// that an rms that cannot recover is detected early.
    [[nodiscard]] std::string reason_unusable(int frames) const;

    /// Return the mechanical energy without the work of external forces [J].
    [[nodiscard]] double energy(const std::vector<BodyState>& s) const;

    /// Return the middle of every frame [s] and the mean tension at each towed ship in that frame
    /// [N].
    [[nodiscard]] const std::vector<double>& tension_times() const { return times_; }
    [[nodiscard]] const std::vector<std::vector<double>>& tensions() const { return tensions_; }

    [[nodiscard]] double largest_gap(const std::vector<BodyState>& s) const;

  private:
    void measure_tension(double t);
    void measure_mode(const std::vector<BodyState>& s, double t);
    void measure_contact(const std::vector<BodyState>& s);
    void measure_energy(const std::vector<BodyState>& before, const std::vector<BodyState>& now);
    [[nodiscard]] std::optional<double> reference_tension(std::size_t ship, double t) const;

    const Scene& scene_;
    const Reference& reference_;
    bool staggered_;
    Measures m_;
    std::vector<char> loaded_;  ///< Bodies with possible loads other than gravity.
    double energy_start_ = 0.0, work_ = 0.0, last_work_ = 0.0;
    std::vector<Vec3> impulse_;  ///< Impulse of the tow line in this frame [N s].
    std::vector<std::vector<double>> substep_tension_;
    std::vector<double> times_;
    std::vector<std::vector<double>> tensions_;
    double frame_time_ = 0.0, substep_time_ = 0.0;
    double sum_e2_ = 0.0, sum_sub2_ = 0.0, sum_t_ = 0.0, sum_t2_ = 0.0, sum_ref_ = 0.0;
    int count_ = 0, count_sub_ = 0;
    double mode_sum_ = 0.0;
    int mode_count_ = 0;
};

}  // namespace hawser::bench
