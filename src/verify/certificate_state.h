// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file certificate_state.h
/// Judges states as the step does (docs/limits.md), computed anew from definitions, poses,
/// velocities and the forces that a World shows: mechanical energy that no work explains, joints
/// that stand open, lines whose tension is not that of their length, turns within a step, ranges
/// and contacts that stay violated.
///
/// Energy is taken at the poses, with the mean of the kinetic energies before and after; elastic
/// energy is that of rows that are all elastic, by their compliance. Work is done by applied
/// forces, contacts and all interactions that are neither rigid joints nor elastic, such as motors,
/// and by those on bodies that move as prescribed: their wrenches along the way of the bodies.
/// What drag and damping take can only lower the energy, and is not counted there.
///
/// Lost energy is a second account: kinetic and gravity energy less the work of all forces, those
/// of springs, drag and the geometric stiffness of lines included (long steps damp motion that they
/// cannot follow by it, docs/methods.md, 4). Rigid joints do no work, so that neither their rows
/// nor a compliance or damping given to them explains a fall of it. Steps with impacts are left
/// out, and all behind the first edit between steps.

#include <hawser/hawser.h>

#include "verify/interaction_forces.h"
#include "verify/lasting_faults.h"

#include <array>
#include <string>
#include <vector>

namespace hawser::verify {

/// Largest so far, over the limit beyond which a step is wrong.
struct StateFigures {
    double created = 0.0, lost = 0.0, open = 0.0, cable = 0.0, turn = 0.0;
};

/// Of a line that stretches.
[[nodiscard]] constexpr bool is_elastic_line(InteractionKind kind) {
    return kind == InteractionKind::Stretch || kind == InteractionKind::WinchStretch;
}

class StateVerifier {
  public:
    explicit StateVerifier(const World& world);
    void before_step(const World& world);
    /// Count an impulse of the geometric stiffness of an interaction in this step as a force that
    /// may take energy, unless the interaction is a rigid joint. @param impulse  On `body`.
    void add_stiffness(InteractionId id, BodyId body, const Wrench& impulse);
    /// Count an impulse in this step as a force that may take energy.
    void add_impulse(BodyId body, const Wrench& impulse);
    /// @return what is wrong with the step; empty: nothing.
    [[nodiscard]] std::string after_step(const World& world);
    /// The step added or removed things itself: it is not judged, and the next one as if it were
    /// the first.
    void begin_anew(const World& world);
    [[nodiscard]] const StateFigures& result() const noexcept { return result_; }

  private:
    enum class Role : std::uint8_t { joint, spring, source };
    [[nodiscard]] Role role_of(const World& world, InteractionId id) const;
    /// Tables of what there is.
    void follow(const World& world);
    /// What was added, removed and moved since the last step is given, and no energy out of
    /// nothing.
    void take_edits(const World& world);
    /// @param known  Interactions that were there before.
    void excuse_joints(const World& world, const std::vector<InteractionId>& known);
    [[nodiscard]] double kinetic(const World& world) const;
    [[nodiscard]] double gravity(const World& world) const;
    [[nodiscard]] double elastic(const World& world) const;
    /// Springs and drag, which `lost` counts beside sources.
    void add_others(const World& world);
    [[nodiscard]] std::string check_loss(const World& world, double kinetic_now);
    void add_sources(const World& world);
    [[nodiscard]] std::string check_energy(const World& world);
    [[nodiscard]] std::string check_joints(const World& world);
    [[nodiscard]] double off_law(const World& world, InteractionId id) const;
    [[nodiscard]] std::string check_lines(const World& world);
    [[nodiscard]] std::string check_turns(const World& world);

    std::vector<BodyId> bodies_, moving_;
    std::vector<InteractionId> interactions_;
    std::vector<InputId> inputs_;
    std::vector<Role> role_;                ///< By interaction.
    std::vector<bool> driven_;              ///< By interaction: an input changes it.
    std::vector<Pose> pose_, pose_before_;  ///< Where the step began, and the one before …
    std::vector<Pose> now_, arrived_;       ///< … and where that one led, before edits.
    std::vector<Twist> twist_;              ///< Before the step.
    std::vector<Vec3> force_, torque_;      ///< Of sources in the step, by body.
    std::vector<Vec3> force_before_, torque_before_;
    std::vector<Vec3> other_, other_torque_;  ///< Of springs and drag in the step, by body …
    std::vector<Vec3> other_before_, other_torque_before_;  ///< … and in the one before.
    std::vector<Vec3> impulse_, turn_impulse_;    ///< Impulses of add_impulse() in the step.
    double gravity_ = 0.0, gravity_after_ = 0.0;  ///< Like potential_.
    double other_work_ = 0.0;  ///< Of springs and drag, and what edits gave but work_ [J].
    double moving_energy_ = 0.0, moved_ = 0.0;  ///< Kinetic and gravity, and exchanged by them [J].
    double peak_ = 0.0;                         ///< Largest kinetic energy of the last seconds [J].
    double line_work_ =
        0.0;  ///< Absolute work of elastic lines on their ends, in the last seconds [J].
    double mean_moving_ = 0.0, most_ = 0.0;  ///< Of these less all work [J].
    std::int64_t impacts_ = 0;
    bool loss_ends_ = false;      ///< Things have come or gone: lost energy is not counted on.
    bool impact_before_ = false;  ///< In the step before.
    double potential_ = 0.0, kinetic_ = 0.0;  ///< Where the step began; before.
    double potential_after_ = 0.0;            ///< Where the last one ended.
    double energy_ = 0.0, swing_ = 0.0;       ///< Before [J].
    double work_ = 0.0, exchanged_ = 0.0;     ///< [J].
    double mean_ = 0.0, least_ = 0.0;         ///< Of energy less work [J].
    LastingFaults lasting_;
    double excused_ = 0.0;                ///< What joints stood open by at the start.
    std::array<double, 2> off_before_{};  ///< Of the worst elements of the two steps before.
    std::int64_t steps_ = 0;
    StateFigures result_;
};

}  // namespace hawser::verify
