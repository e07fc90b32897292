// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file certificate.h
/// Check the laws of a step from the public data of a World, without the solver's code
/// (docs/theory/newton.md).
///
/// Contacts: the Jacobian of every point comes from poses, position and shapes. With v₊ and the
/// impulses the natural map follows; resistance to rolling and spinning has its own natural map.
/// The largest is compared with StepStats::natural_map. The values μ, Σ and the target velocity b
/// along the normal are computed from the materials, gap and velocities.
///
/// Momentum of bodies: translation and rotation with gyroscopic terms. The change of momentum is
/// compared with the sum of all impulses. These are gravity, applied forces, drag, contacts, row
/// forces of interactions, geometric stiffness and damping of joints (interaction_forces.h). If
/// rounding decides on an interaction's force, its bodies are omitted in that step.
///
/// Water: loads of the sea on lines, bodies and hulls (sea_loads.h).
///
/// States: energy, joints, lines and rotations (certificate_state.h).
///
/// Bounds: one-sided rows only pull, and motors stay in their range. Friction in joints stays
/// within the bound that follows from its loads. Ranges push only at an end.

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

/// Return the matrix of the cross product a ×.
[[nodiscard]] Mat3 cross_matrix(const Vec3& a);

/// Return the label of a body or an interaction in a message: its name, or `what` and its index.
[[nodiscard]] std::string object_label(const char* what, const std::string& name,
                                       std::int32_t index);

struct Verification {
    std::int64_t steps = 0;
    double natural_map = 0.0;  ///< Largest, of steps that no budget cut.
    double difference = 0.0;   ///< Largest |natural map − StepStats::natural_map|.
    double momentum = 0.0;     ///< Largest relative residual.
    double bounds = 0.0;       ///< Largest relative excess over the bound of a row.
    double sea = 0.0;          ///< Largest relative difference of a load of the sea.
    StateFigures states;       ///< Figures of states, see certificate_state.h.
    std::int32_t moving_bodies = 0;
    /// Number of these bodies whose momentum was checked; the least over all checked steps.
    std::int32_t covered_bodies = 0;
    /// Steps in which the guard of wires rejected a wire: the bodies of that wire are left out, and
    /// covered_bodies does not count these steps.
    std::int64_t rejected_steps = 0;
};

/// Tolerances and subjects of the checks.
struct Checks {
    /// True: tolerance of rounding, and a step that reports itself as unsolved is a failure. False:
    /// tolerance of 1e-5, and the world's own monitors check unsolved steps.
    bool strict = true;
    bool sea = true;     ///< Loads of the sea.
    bool states = true;  ///< Energy, joints, lines and turns (certificate_state.h).
};

class Verifier : public Observer {
  public:
    /// Create a verifier. It also checks objects that are added later. A step in which systems add
    /// or remove objects is not checked. @throws DefError if groups of bodies may be split, because
    /// their coupling is not exact.
    explicit Verifier(const World& world, Checks checks = {});
    /// Continue from a restored state. Data of wires in water remain those of the creation of the
    /// verifier.
    void begin_at(const World& world);
    void before_step(const World& world) override;
    /// Check the last step. @return a description of the failure; empty: none.
    [[nodiscard]] std::string after_step(const World& world);
    void after_step(const World& world, std::span<const Event>) override {
        objection_ = after_step(world);
    }
    [[nodiscard]] std::string objection() const override { return objection_; }
    [[nodiscard]] const Verification& result() const noexcept { return result_; }

  private:
    [[nodiscard]] double natural_map(const World& world, const ContactView& contact);
    /// Check the friction μ, the compliance Σ and the right-hand side b of a contact along the
    /// normal. @param speed  Normal velocity before the step; > 0: separating. @param speeds  Sum
    /// of the magnitudes of its terms, for its rounding.
    void check_law(const World& world, const ContactView& contact, double mobility, double speed,
                   double speeds);
    /// Return the natural map of the resistance to rolling and spinning.
    [[nodiscard]] double rotation_natural_map(const World& world, const ContactView& contact);
    /// Return the largest natural map of the contacts.
    [[nodiscard]] double step_map(const World& world);
    /// Check the bounds of rows. @return the largest excess; 0: within the tolerance.
    [[nodiscard]] double bound_excess(const World& world);
    /// Describe the row with the largest excess: its name, its force, its bound.
    [[nodiscard]] std::string describe_worst_bound(const World& world) const;
    void add_interactions(const World& world);
    /// True if the verifier's tables contain all present bodies and interactions. Otherwise call
    /// update_tables().
    [[nodiscard]] bool covers(const World& world) const;
    void update_tables(const World& world);
    /// Add the loads of systems to the momentum balance.
    void add_loads(const World& world);
    /// True if the body sleeps during the whole step.
    [[nodiscard]] bool sleeps(const World& world, BodyId body) const;
    [[nodiscard]] double momentum_residual(const World& world);
    [[nodiscard]] Vec3 spin_impulse(std::size_t body, const Mat3& inertia, const Twist& now);

    std::vector<Pose> pose_;
    std::vector<Twist> twist_,
        earlier_;  ///< Velocities before this step, and before the last one …
    std::vector<Twist>
        velocity_after_;  ///< … and after the last step; NaN: the body was added since.
    std::vector<int>
        damped_before_;  ///< WorldWires::damped_steps() before the step, for each interaction.
    std::vector<BodyId> bodies_, moving_;
    std::vector<InteractionId> interactions_;
    std::vector<std::vector<double>> last_;  ///< Forces of each interaction's rows before the step.
    std::vector<bool>
        intact_;  ///< True if the interaction was intact before the step, for each interaction.
    std::vector<bool> slept_;  ///< True if the body slept before the step, for each body.
    std::vector<bool>
        turning_;  ///< True for bodies at joints that are closed at the end of the step.
    std::vector<bool> unsure_;    ///< True for bodies that are omitted in this step.
    std::vector<Mat3> mobility_;  ///< Inverse inertia, body frame.
    std::vector<Vec3>
        change_;  ///< Change of angular velocity by torque in the last step, body frame.
    std::vector<Vec3> linear_, angular_;  ///< Impulses of contacts and interactions on each body.
    std::vector<double> rounded_;         ///< Rounding of the impulses of loads on each body [N s].
    bool loads_ = false;                  ///< True if friction in joints depends on other forces.
    double within_rounding_ = 0.0;        ///< Largest natural map that counts as rounding.
    double impulse_ = 0.0;      ///< Σ of the squares of these impulses in the norm of M⁻¹.
    std::string law_error_;     ///< Description of the first contact with a wrong law in the step.
    std::int64_t impacts_ = 0;  ///< Number of impacts up to the last step.
    int checked_steps_ = 0;     ///< Number of steps whose momentum was computed.
    std::int32_t omitted_bodies_ = 0;  ///< Largest number of omitted moving bodies over all steps.
    double unsolved_ = 0.0;  ///< Time for which the natural map has been above the tolerance [s].
    double step_ = 0.0, rounding_floor_ = 0.0, momentum_floor_ = 0.0;
    double scalar_floor_ = 0.0;  ///< Floor of rows on scalar bodies.
    Checks checks_;
    StateVerifier state_verifier_;
    SeaVerifier sea_;
    /// Row with the largest excess over its bound.
    struct Bound {
        InteractionId row{};
        double force = 0.0, bound = 0.0;  ///< Force and bound [N or N m].
    } worst_excess_;
    BodyId worst_momentum_body_{};  ///< Body with the largest part of the step's residual.
    std::string objection_;         ///< Result of the last step.
    Verification result_;
};

}  // namespace hawser::verify
