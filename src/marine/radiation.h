// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file radiation.h
/// Compute the memory of radiated waves of a hull (hawser/hydro.h): K(t), its sums over the past,
/// and its state-space form.

#include <hawser/hydro.h>
#include <hawser/system.h>
#include <hawser/water_hull.h>

#include "base/memory.h"
#include "marine/memory_sums.h"

#include <array>
#include <cstdint>
#include <vector>

namespace hawser::marine {

using Vec6 = Eigen::Matrix<double, 6, 1>;

/// Return coefficients whose A(∞), A and B are positive semi-definite to rounding. Files have some
/// noise, which coefficients_fault() bounds.
[[nodiscard]] WaveCoefficients without_noise(const WaveCoefficients& c);

/// Interpolate a matrix linearly at a frequency. The value is constant beyond the first and last
/// frequency.
[[nodiscard]] Matrix6 linear_at(const std::vector<double>& frequency,
                                const std::vector<Matrix6>& matrix, double omega);
/// Return the nearest matrix without negative eigenvalues, where the distance is measured with the
/// diagonal scaled to ones.
[[nodiscard]] Matrix6 without_negative(const Matrix6& m);

/// Nodes of the piecewise linear B(ω), from 0 to its end.
struct DampingNodes {
    std::vector<double> frequency;  ///< [rad/s].
    std::vector<Matrix6> damping;
};
[[nodiscard]] DampingNodes damping_nodes(const WaveCoefficients& c);

/// Return K(t) = (2/π) ∫ B cos ωt dω from the nodes.
[[nodiscard]] Matrix6 retardation_of(const DampingNodes& nodes, double t);

/// Return the window of K at time t: 1 up to 0.8 T, then decreasing to 0 at T as cos².
[[nodiscard]] double memory_window(double t, double memory) noexcept;

/// Samples of K at h, 2h, … with the window, K(0), and the damping that passivity requires.
struct Retardation {
    double step = 0.0;
    Matrix6 first = Matrix6::Zero();  ///< K(0).
    std::vector<Matrix6> later;       ///< K(mh), m = 1 …
    Matrix6 added = Matrix6::Zero();  ///< Constant damping.
};
[[nodiscard]] Retardation sampled_retardation(const WaveCoefficients& c, double step,
                                              double memory);

/// K(t) ≈ C e^{At} B, in blocks of one or two states: A has poles σ ± iω.
struct MemoryModel {
    struct Block {
        double decay = 0.0, turn = 0.0;  ///< σ [1/s], ω [rad/s]; ω = 0: one state.
    };
    std::vector<Block> blocks;
    std::vector<std::array<double, 6>> b;  ///< Rows of B, one per state.
    std::vector<std::array<double, 6>> c;  ///< Columns of C, one per state.
    Matrix6 first = Matrix6::Zero();       ///< (C B + (C B)ᵀ)/2.
    Matrix6 added = Matrix6::Zero();
    double fit_error = 0.0;
    [[nodiscard]] Matrix6 at(double t) const;
};
/// Fit a state-space model to the memory. @param order  Maximum number of states.
/// @throws DefError if no stable model of this order exists.
[[nodiscard]] MemoryModel memory_model(const WaveCoefficients& c, int order, double memory);

/// Return the scale √K_ii(0) of each motion in the memory kernel K; 1 if K_ii(0) is 0.
[[nodiscard]] Vec6 memory_scale(const Matrix6& first) noexcept;

/// The memory of one hull.
class HullMemorySums {
  public:
    HullMemorySums() = default;
    HullMemorySums(const WaterHull& def, double step);

    /// Store the velocity after the last step in the memory. @param velocity  ν at the reference
    /// point, body axes.
    void push(const Vec6& velocity) noexcept;
    /// Return the velocity ν extrapolated by half a step from the last two velocities. Call before
    /// push().
    [[nodiscard]] Vec6 ahead(const Vec6& velocity) const noexcept {
        return begun_ != 0 ? Vec6(1.5 * velocity - 0.5 * last_) : velocity;
    }
    /// Return the force of the past motion; damping() is the implicit part.
    [[nodiscard]] Vec6 force() const noexcept;
    /// Return ½ h K(0) plus the damping that passivity requires.
    [[nodiscard]] const Matrix6& damping() const noexcept { return damping_; }
    void visit_state(StateVisitor& v);
    void check_state(StateRules& rules) const;
    void write_memory(HullMemory& out) const;
    [[nodiscard]] bool any() const noexcept { return kind_ != RadiationKind::none; }
    /// True if push() must be called, because a memory exists or ahead() is used.
    [[nodiscard]] bool follows() const noexcept { return any() || follows_; }

  private:
    RadiationKind kind_ = RadiationKind::none;
    double step_ = 0.0;
    bool follows_ = false;  ///< Keeps the last velocity without a memory, too.
    Matrix6 damping_ = Matrix6::Zero(), first_ = Matrix6::Zero(), added_ = Matrix6::Zero();
    [[nodiscard]] std::size_t place(int motion, std::int64_t sample) const noexcept {
        return static_cast<std::size_t>(motion * memory_stride(count_) + sample);
    }
    /// Repeat the first samples of the ring buffer behind its end, so that sums need no
    /// wrap-around.
    void go_on_behind() noexcept;

    // Convolution: h K of the pairs (i ≥ j) that are not 0, in the format of memory_sums.h.
    struct Pair {
        int i = 0, j = 0;
    };
    std::vector<Pair> pairs_;
    base::Array<double> kernel_;
    std::int64_t count_ = 0;
    std::vector<double> past_;  ///< ν̄ by motion, rings, newest at `newest_`.
    std::int64_t newest_ = 0;
    // State space.
    MemoryModel model_;
    std::vector<std::array<double, 3>> turn_;  ///< e^{σh} cos ωh, e^{σh} sin ωh, states.
    std::vector<double> states_;
    Vec6 last_ = Vec6::Zero();
    std::int64_t begun_ = 0;
};

}  // namespace hawser::marine
