// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file tools.h
/// Shared parts of the validation cases: open scenes, step, and measure motions.

#include <hawser/hawser.h>
#include <hawser/scene.h>

#include "validate/report.h"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace hawser::validate {

inline constexpr double kGravity = 9.81;  ///< Gravity [m/s²].
inline constexpr double kPi = 3.14159265358979323846;

/// Numbers in [0, 1), the same on every machine.
class Chance {
  public:
    explicit Chance(std::uint64_t seed) : state_(seed) {}
    double next() {
        state_ = state_ * 6364136223846793005u + 1442695040888963407u;
        return static_cast<double>(state_ >> 11) * 0x1p-53;
    }
    double between(double a, double b) { return a + (b - a) * next(); }

  private:
    std::uint64_t state_;
};

/// Open scenes/NAME.json. The folders are searched in this order: that of the environment variable
/// HAWSER_SCENES, ./scenes, ../share/hawser/scenes beside the program, and the source tree.
[[nodiscard]] scene::Scene open_scene(const std::string& name, double step,
                                      const std::vector<std::string>& set = {});

/// Perform `steps` steps. @throws std::runtime_error if one fails.
void advance(World& world, long steps);
/// Return the number of steps to `time`. @throws std::runtime_error if `time` is not a whole number
/// of steps.
[[nodiscard]] long steps_to(const World& world, double time);

/// Find an object by name. @throws std::runtime_error if there is none.
[[nodiscard]] BodyId body(const World& world, const std::string& name);
[[nodiscard]] InteractionId interaction(const World& world, const std::string& name);

[[nodiscard]] std::vector<double> list(const Vec3& v);
/// Return the tension of a line element [N].
[[nodiscard]] double tension(const World& world, InteractionId id);

/// Return the times at which a signal crosses zero upwards [s]. It is sampled every `step` from
/// time 0. Interpolation is cubic, so that the error is of fourth order in the step.
[[nodiscard]] std::vector<double> upward_zeros(std::span<const double> signal, double step);
/// Interpolate a signal by a cubic. @param at  Time, in steps.
[[nodiscard]] double interpolate(std::span<const double> signal, double at);

/// Counts the rotation about a fixed axis beyond ±π.
class AngleCounter {
  public:
    AngleCounter(Vec3 axis, const Quat& start);
    double update(
        const Quat& now);  ///< Update once for each step. @return the angle since the start [rad].
    [[nodiscard]] double angle() const noexcept { return angle_; }

  private:
    Vec3 axis_;
    Quat last_;
    double angle_ = 0.0;
};

/// Return the complete elliptic integral K(k) by the arithmetic-geometric mean.
[[nodiscard]] double elliptic_k(double k);
/// Return Jacobi's sn(u, k) by descending Landen transformations.
[[nodiscard]] double jacobi_sn(double u, double k);

}  // namespace hawser::validate
