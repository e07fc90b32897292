// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file certificate.h
/// Computes anew, from what a World shows, whether a step obeys its laws; nothing is shared with
/// the solver's code. docs/methods.md, 8.
///
/// **Contacts**: every point's Jacobian from poses, place and shapes; from it, v₊ and the impulses
/// the natural map (of resistance to rolling and spinning its own), whose largest is compared with
/// StepStats::natural_map. μ, Σ and the target velocity b along the normal are computed from the
/// materials, gap and velocities.
///
/// **Momentum** of bodies, translation and rotation with its gyroscopic terms: what changed against
/// gravity, applied forces, drag, contacts, interactions by the forces of their rows, geometric
/// stiffness and damping of joints (interaction_forces.h). Left out in a step are the bodies of an
/// interaction whose force rounding decides on.
///
/// **Water**: loads of the sea on lines, bodies and hulls (sea_loads.h).
///
/// **States**: energy, joints, lines and turns (certificate_state.h).
///
/// **Bounds**: what only pulls does not push, motors keep to their range, friction in joints to its
/// bound with its loads, limits push only at an end.

#include "verify/certificate_state.h"
#include "verify/interaction_forces.h"
#include "verify/sea_loads.h"

#include <hawser/hawser.h>
#include <hawser/observer.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace hawser::verify {

/// a × as a matrix.
[[nodiscard]] Mat3 cross_matrix(const Vec3& a);

/// What a message calls a body or an interaction: its name, or `what` and its index.
[[nodiscard]] std::string called(const char* what, const std::string& name, std::int32_t index);

struct Verification {
    std::int64_t steps = 0;
    double natural_map = 0.0;  ///< Largest, of steps that no budget cut.
    double difference = 0.0;   ///< Largest |natural map − StepStats::natural_map|.
    double momentum = 0.0;     ///< Largest relative residual.
    double bounds = 0.0;       ///< Largest relative excess over the bound of a row.
    double sea = 0.0;          ///< Largest relative difference of a load of the sea.
    StateFigures states;       ///< See certificate_state.h.
    std::int32_t moving_bodies = 0;
    /// Of them, those whose momentum was computed; the fewest of all steps that were.
    std::int32_t covered_bodies = 0;
};

/// How closely, and what.
struct Checks {
    /// To rounding, and steps that a step itself reports as not solved are wrong; else to 1e-5, and
    /// these are left to the world's own monitors.
    bool strict = true;
    bool sea = true;     ///< Loads of the sea.
    bool states = true;  ///< Energy, joints, lines and turns (certificate_state.h).
};

class Verifier : public Observer {
  public:
    /// What is added and removed from now on, it follows. A step in which systems do that is not
    /// judged. @throws DefError where groups of bodies may be split: coupling is not exact.
    explicit Verifier(const World& world, Checks checks = {});
    /// Another state has been restored: judges go on from there. What the water has of wires is
    /// that of the start, at which it was made.
    void begin_at(const World& world);
    void before_step(const World& world) override;
    /// @return what is wrong with the step; empty: nothing.
    [[nodiscard]] std::string after_step(const World& world);
    void after_step(const World& world, std::span<const Event>) override {
        objection_ = after_step(world);
    }
    [[nodiscard]] std::string objection() const override { return objection_; }
    [[nodiscard]] const Verification& result() const noexcept { return result_; }

  private:
    [[nodiscard]] double natural_map(const World& world, const ContactView& contact);
    /// μ, Σ, b along the normal. @param speed  Along the normal, before the step; > 0: apart.
    /// @param speeds  Sizes of what that adds up to, for its rounding.
    void check_law(const World& world, const ContactView& contact, double mobility, double speed,
                   double speeds);
    /// Of its resistance to rolling and spinning.
    [[nodiscard]] double turn_map(const World& world, const ContactView& contact);
    /// Largest of contacts.
    [[nodiscard]] double step_map(const World& world);
    /// Rows outside their bounds. @return by how much at most, 0: within what counts as nothing.
    [[nodiscard]] double bound_excess(const World& world);
    /// The worst of them in words: its name, its force, its bound.
    [[nodiscard]] std::string beyond_bound(const World& world) const;
    void add_interactions(const World& world);
    /// Whether bodies and interactions are those of the tables; and tables of those that are.
    [[nodiscard]] bool knows(const World& world) const;
    void follow(const World& world);
    /// What systems did.
    void add_loads(const World& world);
    /// All through the step.
    [[nodiscard]] bool sleeps(const World& world, BodyId body) const;
    [[nodiscard]] double momentum_residual(const World& world);
    [[nodiscard]] Vec3 spin_impulse(std::size_t body, const Mat3& inertia, const Twist& now);

    std::vector<Pose> pose_;
    std::vector<Twist> twist_, earlier_;  ///< Before this step, and before the last one …
    std::vector<Twist> left_;             ///< … and as the last step left them; NaN: it came since.
    std::vector<int> alert_;              ///< Of wires, before the step, by interaction.
    std::vector<BodyId> bodies_, moving_;
    std::vector<InteractionId> interactions_;
    std::vector<std::vector<double>> last_;  ///< Forces of each interaction's rows before the step.
    std::vector<bool> intact_;               ///< Before the step, by interaction.
    std::vector<bool> slept_;                ///< Likewise, by body.
    std::vector<bool> turning_;              ///< Bodies at joints that hold at the step's end.
    std::vector<bool> unsure_;               ///< Bodies left out in this step.
    std::vector<Mat3> mobility_;             ///< Inverse inertia, body frame.
    std::vector<Vec3> change_;               ///< Of spin by torque in the last step, body frame.
    std::vector<Vec3> linear_, angular_;  ///< Impulses of contacts and interactions on each body.
    bool loads_ = false;                  ///< Friction in joints depends on other forces.
    double within_rounding_ = 0.0;        ///< The most of a natural map that is taken for rounding.
    double impulse_ = 0.0;                ///< Σ of their squares in the norm of M⁻¹.
    std::string wrong_law_;               ///< The first contact of the step that has one.
    std::int64_t impacts_ = 0;            ///< Until the last step.
    int seen_ = 0;                        ///< Steps whose momentum was computed.
    std::int32_t left_out_ = 0;           ///< Most moving bodies without, of all steps.
    double unsolved_ = 0.0;               ///< Natural map above the tolerance for so long [s].
    double step_ = 0.0, floor_ = 0.0, momentum_floor_ = 0.0;
    double scalar_floor_ = 0.0;  ///< That of rows on scalar bodies.
    Checks checks_;
    StateVerifier states_;
    SeaVerifier sea_;
    /// Of the row that is farthest beyond its bound.
    struct Bound {
        InteractionId row{};
        double force = 0.0, bound = 0.0;  ///< [N or N m]
    } worst_bound_;
    BodyId worst_momentum_{};  ///< The body with the largest share of the step's residual.
    std::string objection_;    ///< To the last step.
    Verification result_;
};

}  // namespace hawser::verify
