// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file certificate_state.h
/// Check states like the step's monitors (docs/limits.md), from the public data of a World:
/// definitions, poses, velocities and forces. The checks detect mechanical energy without a source,
/// open joints, and lines whose tension does not match their length. They also detect too large
/// rotations within a step, and ranges and contacts that stay violated.
///
/// Energy is that at the poses, with the mean of the kinetic energies before and after. Elastic
/// energy is that of interactions whose rows are all elastic, by their compliance. Work is done by
/// applied forces, contacts and all interactions that are neither rigid joints nor elastic, such as
/// motors. It is also done by interactions with bodies of prescribed motion. Work is the sum of
/// wrenches times the displacements of the bodies. Drag and damping can only lower the energy and
/// are not counted there.
///
/// Lost energy is a second account: kinetic and gravity energy minus the work of all forces. These
/// include springs, drag and the geometric stiffness of lines, by which long steps damp
/// under-resolved motion (docs/theory/stiffness.md). Rigid joints do no work. Neither their rows
/// nor a compliance or damping of them therefore explains a loss. Steps with impacts are omitted,
/// and so are all steps after the first edit between steps.

#include <hawser/hawser.h>

#include "verify/edited_stretch.h"
#include "verify/interaction_forces.h"
#include "verify/lasting_faults.h"

#include <array>
#include <string>
#include <vector>

namespace hawser::verify {

/// Largest values since the start, relative to the limit of failure.
struct StateFigures {
    double created = 0.0, lost = 0.0, open = 0.0, cable = 0.0, turn = 0.0;
    double edited = 0.0;  ///< Stretch that edits of wires add.
};

/// True if the kind is a line that stretches.
[[nodiscard]] constexpr bool is_elastic_line(InteractionKind kind) {
    return kind == InteractionKind::Stretch || kind == InteractionKind::WinchStretch;
}

class StateVerifier {
  public:
    explicit StateVerifier(const World& world);
    void before_step(const World& world);
    /// Count an impulse of the geometric stiffness of an interaction in this step among the forces
    /// that may dissipate energy. For a rigid joint it may not. @param impulse  Impulse on `body`.
    void add_stiffness(InteractionId id, BodyId body, const Wrench& impulse);
    /// Add the work of an impulse in this step to the forces that may dissipate energy.
    void add_impulse(BodyId body, const Wrench& impulse);
    /// Check the state after a step. @return a description of the failure; empty: none.
    [[nodiscard]] std::string after_step(const World& world);
    /// Restart after a step that has added or removed objects itself. The next step is treated as
    /// the first one. In the present step, only the stretch of wires is checked. @return as
    /// after_step().
    [[nodiscard]] std::string restart(const World& world);
    [[nodiscard]] const StateFigures& result() const noexcept { return result_; }

  private:
    enum class Role : std::uint8_t { joint, spring, source };
    [[nodiscard]] Role energy_role(const World& world, InteractionId id) const;
    /// Update the tables of bodies and interactions.
    void update_tables(const World& world);
    /// Count the energy of edits since the last step (additions, removals, moves) as supplied
    /// energy.
    void count_edit_energy(const World& world);
    /// Add the initial opening of new joints to their allowance. @param known  Interactions that
    /// existed before.
    void allow_initial_gaps(const World& world, const std::vector<InteractionId>& known);
    [[nodiscard]] double kinetic(const World& world) const;
    [[nodiscard]] double gravity(const World& world) const;
    [[nodiscard]] double elastic(const World& world) const;
    /// Add the work of springs and drag, which the account of lost energy counts in addition to
    /// sources.
    void add_springs_and_drag(const World& world);
    [[nodiscard]] std::string check_loss(const World& world, double kinetic_now);
    void add_sources(const World& world);
    [[nodiscard]] std::string check_energy(const World& world);
    [[nodiscard]] std::string check_edits(const World& world);
    [[nodiscard]] std::string check_joints(const World& world);
    [[nodiscard]] double law_deviation(const World& world, InteractionId id) const;
    [[nodiscard]] std::string check_lines(const World& world);
    [[nodiscard]] std::string check_turns(const World& world);

    std::vector<BodyId> bodies_, moving_;
    std::vector<InteractionId> interactions_;
    std::vector<InputId> inputs_;
    std::vector<Role> role_;    ///< Role of each interaction.
    std::vector<bool> driven_;  ///< True if an input changes the interaction, for each interaction.
    std::vector<Pose> pose_,
        pose_before_;  ///< Poses at the start of this step, and of the previous one …
    std::vector<Pose> now_, arrived_;   ///< … and at the end of the previous step, before edits.
    std::vector<Twist> twist_;          ///< Velocities before the step.
    std::vector<Vec3> force_, torque_;  ///< Forces of sources in the step, for each body.
    std::vector<Vec3> force_before_, torque_before_;
    std::vector<Vec3> other_force_,
        other_torque_;  ///< Forces of springs and drag in the step, for each body …
    std::vector<Vec3> other_force_before_, other_torque_before_;  ///< … and in the previous step.
    std::vector<Vec3> impulse_, turn_impulse_;    ///< Impulses of add_impulse() in the step.
    double gravity_ = 0.0, gravity_after_ = 0.0;  ///< Like potential_.
    double other_work_ =
        0.0;  ///< Work of springs and drag, and energy of edits that is not in work_ [J].
    double moving_energy_ = 0.0,
           moved_ = 0.0;  ///< Kinetic plus gravity energy, and the exchange between them [J].
    double peak_ = 0.0;   ///< Largest kinetic energy of the last seconds [J].
    double line_work_ =
        0.0;  ///< Absolute work of elastic lines on their ends, in the last seconds [J].
    double mean_moving_ = 0.0,
           most_ = 0.0;  ///< Mean and maximum of moving_energy_ minus all work [J].
    std::int64_t impacts_ = 0;
    bool loss_ends_ = false;      ///< True after an edit: lost energy is no longer counted.
    bool impact_before_ = false;  ///< True if the previous step had an impact.
    double potential_ = 0.0,
           kinetic_ = 0.0;          ///< Energies at the start of the step; of the previous one.
    double potential_after_ = 0.0;  ///< Potential energy at the end of the last step.
    double energy_ = 0.0, vibration_energy_ = 0.0;  ///< Before [J].
    double work_ = 0.0, exchanged_ = 0.0;           ///< Work, and exchanged energy [J].
    double mean_ = 0.0, least_ = 0.0;               ///< Mean and minimum of energy minus work [J].
    LastingFaults lasting_faults_;
    EditedStretch edited_stretch_;
    double edited_ = 0.0, min_edited_ = 0.0;  ///< Stretch added by edits, and its minimum [J].
    double gap_allowance_ = 0.0;              ///< Opening of joints at the start.
    std::array<double, 2>
        previous_deviations_{};  ///< Deviations of the worst elements in the two previous steps.
    std::int64_t steps_ = 0;
    StateFigures result_;
};

}  // namespace hawser::verify
