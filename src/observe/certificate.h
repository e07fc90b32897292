// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file certificate.h
/// Computes anew, from what a World shows, whether a step obeys its laws; nothing is shared with
/// the solver's code. docs/methods.md, 8.
///
/// **Contacts**: every point's Jacobian from poses, place and shapes; from it, v₊ and the impulses
/// the natural map (of resistance to rolling and spinning its own), whose largest is compared with
/// StepStats::natural_map.
///
/// **Momentum** of every body that no interaction holds, translation and rotation with its
/// gyroscopic terms: what changed against gravity, applied forces, drag and contacts. Bodies that
/// interactions hold are not covered: their rows' Jacobians are the solver's own.

#include <hawser/hawser.h>

#include <cstdint>
#include <string>
#include <vector>

namespace hawser::observe {

struct Verification {
    std::int64_t steps = 0;
    double natural_map = 0.0;      ///< Largest, of steps that no budget cut.
    double difference = 0.0;       ///< Largest |natural map − StepStats::natural_map|.
    double momentum = 0.0;         ///< Largest relative residual.
    std::int32_t free_bodies = 0;  ///< Whose momentum was computed.
};

class Verifier {
  public:
    /// Bodies and interactions stay as they are from now on.
    explicit Verifier(const World& world);
    void before_step(const World& world);
    /// @return what is wrong with the step; empty: nothing.
    [[nodiscard]] std::string after_step(const World& world);
    [[nodiscard]] const Verification& result() const noexcept { return result_; }

  private:
    struct Side {
        int count = 0;
        std::int32_t body[2] = {-1, -1};
        double share[2] = {1.0, 0.0};
    };
    [[nodiscard]] Side side_of(const World& world, ShapeId shape, const Vec3& on_axis) const;
    [[nodiscard]] double natural_map(const World& world, const ContactView& contact);
    /// Of its resistance to rolling and spinning.
    [[nodiscard]] double turn_map(const World& world, const ContactView& contact);
    [[nodiscard]] double momentum_residual(const World& world);
    [[nodiscard]] Vec3 spin_impulse(std::int32_t body, const Mat3& inertia, const Twist& now);

    std::vector<Pose> pose_;
    std::vector<Twist> twist_;
    std::vector<std::int32_t> free_;      ///< Bodies without interactions.
    std::vector<Vec3> change_;            ///< Of spin by torque in the last step, body frame.
    std::vector<Vec3> linear_, angular_;  ///< Impulses of contacts on each body.
    std::int64_t impacts_ = 0;            ///< Until the last step.
    int seen_ = 0;                        ///< Steps whose momentum was computed.
    double step_ = 0.0, floor_ = 0.0, momentum_floor_ = 0.0;
    Verification result_;
};

}  // namespace hawser::observe
