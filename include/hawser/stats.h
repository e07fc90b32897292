// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file stats.h
/// Results of a step: status, events, results of the monitors, energy, times, residuals and counts.

#include <hawser/def.h>
#include <hawser/id.h>

#include <array>
#include <cstdint>

namespace hawser {

/// Outcome of a step. With any value other than `ok` the world keeps the state before the step, and
/// the next call of World::step() tries the same step again.
enum class Status : std::uint8_t {
    ok,             ///< The step is complete.
    wrong_pivot,    ///< A pivot had the wrong sign or was not finite: the model is singular.
    not_finite,     ///< The solution or an input was not finite.
    out_of_memory,  ///< Allocation failed.
    cancelled,      ///< World::cancel() ended the step.
    over_bound,     ///< A limit of WorldDef would be exceeded: see StepStats::bound_met.
    /// A monitor failed: recent states are physically impossible (World::verdict()). Only if
    /// WorldDef::on_diverged is `stop`.
    diverged,
    /// A system set a value that is not finite, or a load that is not positive semi-definite.
    /// World::bad_load() names the system and body.
    bad_load,
    in_use,  ///< Another thread uses the world, or a step was started within a step: see UseError.
    /// A system requested an addition or removal that the world rejects (Edits). World::bad_load()
    /// names the system and the reason.
    bad_edit,
};
/// Return the name of a status, as in its enumerator.
[[nodiscard]] const char* to_string(Status status) noexcept;

/// Stages of a step, in order. Code, timers, traces and documents use these names.
enum class Stage : std::uint8_t {
    prestep,    ///< Systems apply loads, inputs and edits.
    collide,    ///< Collision detection.
    graph,      ///< Update of automatic groups (WorldDef::parts).
    analyse,    ///< Elimination order and addresses, if the structure has changed.
    assemble,   ///< Violations, Jacobians and right-hand sides.
    factor,     ///< Factorisation of the matrix.
    nonsmooth,  ///< Solution, with iterations for contacts, limits and friction.
    integrate   ///< New velocities and poses.
};
inline constexpr int kStageCount = 8;
/// Return the name of a stage, as in its enumerator.
[[nodiscard]] const char* to_string(Stage stage) noexcept;

/// Kind of an event, with the meaning of Event::value. "Once": a new event is sent only after the
/// condition has ended.
enum class EventKind : std::uint8_t {
    /// An element broke, because its tension exceeded its breaking load or by WorldWires::part().
    /// value: tension [N].
    line_break,
    slack,          ///< A tension-only element became slack. value: 0.
    taut,           ///< A slack element became taut. value: tension [N].
    saturation,     ///< The force of a motor reached an end of its range; once. value: force [N or
                    ///< N m].
    range,          ///< A joint reached an end of its range. value: distance beyond it [m or rad].
    input_clamped,  ///< A requested value of an input or signal was outside its range and was
                    ///< clamped.
                    ///< value: requested value.
    warning,        ///< A residual exceeds its limit. value: residual.
    // A monitor became suspect or failed; once. value: Finding::value.
    energy_created,  ///< Monitor Judge::energy.
    joint_open,      ///< Monitor Judge::violation.
    cable_law,       ///< Monitor Judge::cable.
    uncertified,     ///< Monitor Judge::certificate.
    fast,            ///< Monitor Judge::speed.
    // Events of winches (winch.h), for the body of the drum.
    layer,       ///< The wire reached another layer. value: number of the layer, 1 the innermost.
    brake_slip,  ///< A brake began to slip; once. value: torque of the brake [N m].
    release,     ///< An emergency release took effect, or a pelican hook opened (wire.h; for the
                 ///< hook). value: tension [N].
    weak_link,  ///< The fastening of the wire on the drum broke. value: force of the fastening [N].
    drum_empty,  ///< The last wire left the drum. value: tension [N].
    // Events of wires that are cut and joined (wire.h).
    cut,     ///< A wire was cut. value: tension at the cut [N].
    join,    ///< Ends were joined, or an end was attached. value: distance before [m].
    detach,  ///< An end was released. value: tension at the end [N].
    // Further events of winches.
    chain_jump,  ///< The chain jumped by a pocket of its gypsy. value: load of the chain [N].
    no_node,  ///< A node could not be inserted in the wire of a winch; once. value: length of the
              ///< element at the drum [m].
    /// A wire requires more nodes than ResolutionDef::max_nodes; once, for a node of the element
    /// that
    /// remains too long. value: number of nodes.
    node_limit,
    render,  ///< The drum paid out in mode render; once. value: tension [N].
    // Events of cranes (crane.h), for the body of the hook, and of stability gauges (stability.h).
    alarm,      ///< The alarm level rose. value: load over rated load, or utilisation [1].
    alarm_end,  ///< The alarm level fell. value: load over rated load, or utilisation [1].
    // Events of shark jaws and chain stoppers (stopper.h), and of hooks (hook.h).
    overload,  ///< A stopper or hook opened above its rated load; for its joint or load. value:
               ///< load
               ///< [N].
    missed,  ///< No wire or load is within reach of a stopper, chaser or hook; for its body. value:
             ///< distance of the nearest [m].
    /// The end of a wire reached the fairlead of its drum, or a turning point, and stops; once, for
    /// the
    /// drum or the slide. value: tension [N].
    hauled_in,
    // Events of guides without an upper roller (guide.h), for the element at the guide.
    lift_off,  ///< The wire left its guide. value: tension [N].
    lay_on,    ///< The wire returned to its guide. value: tension [N].
    /// The end-of-step constraint iteration of rigid joints failed, and the step linearised the
    /// joints
    /// once instead. Sent again only after limit::kMemory without a failure. value:
    /// StepStats::completion_failures.
    incomplete,
    // Events of vessels (vessel.h), for their body.
    shed,     ///< A power bus withheld power from a consumer; once. value: withheld power [W].
    failure,  ///< A part failed by its signal; once. value: value of the signal.
    // Events of the control of a vessel (vessel_control.h), for its body.
    mode_refused,      ///< A control mode was rejected. value: mode.
    position_lost,     ///< An offset from the ordered position exceeded its alarm; once. value:
                       ///< distance
                       ///< [m].
    failure_critical,  ///< The worst single failure would lose the position; once. value: missing
                       ///< over
                       ///< required force [1].
};
inline constexpr int kEventKindCount = 37;
/// Return the name of a kind, as in its enumerator.
[[nodiscard]] const char* to_string(EventKind kind) noexcept;

/// Incident in a step (world_events.h).
struct Event {
    double time = 0.0;                    ///< End of the step in which it happened [s].
    EventKind kind = EventKind::warning;  ///< Kind of the event.
    InteractionId interaction{};          ///< Interaction of the event; invalid: none.
    double value = 0.0;                   ///< Value, as EventKind states.
    InputId input{};                      ///< Clamped input of the world; invalid: none.
    BodyId body{};                        ///< Body of the event; invalid: none.
    std::int32_t signal = -1;  ///< Clamped signal: index in World::system_signals(); −1: none.
};

/// Count and extremes of all events of a kind, since the world was created.
struct EventExtremes {
    /// Number of events. A restored state does not change it.
    std::int64_t count = 0;
    Event first, worst;  ///< First event, and that of the largest |value| (the first of equals).
};

/// Monitored quantities of states (docs/limits.md).
enum class Judge : std::uint8_t {
    energy,       ///< Unexplained mechanical energy.
    violation,    ///< Open rigid joints.
    cable,        ///< Elements whose tension does not match their length.
    certificate,  ///< Unsolved equations and laws of contact.
    speed,        ///< Rotations too large for a step.
};
inline constexpr int kJudgeCount = 5;
/// Return the name of a monitor, as in its enumerator.
[[nodiscard]] const char* to_string(Judge judge) noexcept;
/// Return the recommended action if a monitor fails, as a sentence.
[[nodiscard]] const char* remedy(Judge judge) noexcept;

/// Worst result of a monitor since the start.
struct Finding {
    /// Measured value. energy: created energy [J]; violation: [m] or [rad]; cable: |l − l₀(1 +
    /// T/EA)|/l₀ [1]; certificate: relative residual [1]; speed: rotation in a step [rad].
    double value = 0.0;
    double doubtful = 0.0;  ///< Measure over its first limit [1]; > 1: suspect.
    double wrong = 0.0;     ///< Measure over its second limit [1]; > 1: failed. 0: no second limit.
    double time = 0.0;      ///< Time of the state [s].
    InteractionId interaction{};  ///< Interaction with this value; invalid: none.
    BodyId body{};                ///< Body with this value; invalid: none.
};

/// Grade of a result: good, suspect (`doubtful`) or failed (`wrong`).
enum class Grade : std::uint8_t { good, doubtful, wrong };
/// Return the name of a grade, as in its enumerator.
[[nodiscard]] const char* to_string(Grade grade) noexcept;

/// Result of the monitors of a world since the start: World::verdict(), docs/limits.md.
struct Verdict {
    Grade grade = Grade::good;  ///< Worst grade of all monitors. The monitor `speed` alone does not
                                ///< make a result suspect.
    /// Monitor with this grade; if good, the one nearest to its limit.
    Judge judge = Judge::energy;
    std::array<Finding, kJudgeCount> worst{};  ///< Worst result of each monitor.
    /// Return the worst result of a monitor.
    [[nodiscard]] const Finding& of(Judge j) const noexcept {
        return worst[static_cast<std::size_t>(j)];
    }
};

/// Energy account of a world [J]. Mechanical energies are those at the midpoint x̄ = (x_k +
/// x_{k−1})/2, where the velocities v_k belong. Works and losses are sums since the start. If the
/// motion is exact, mechanical() = its initial value + applied + driven + system + edited −
/// dissipated − friction − contact − damped.
struct Energy {
    /// Kinetic energy of bodies and elements.
    double kinetic = 0.0;
    double gravity = 0.0;  ///< Potential energy −Σ m g·x̄.
    double elastic = 0.0;  ///< Elastic energy Σ g²/(2ε) over rows with compliance > 1e-11,
                           ///< including hydrostatics.
    double applied = 0.0;  ///< Work of applied forces and torques.
    /// Work of motors (negative when braking), of lengths and targets that inputs change, of
    /// winches, and of bodies with a prescribed velocity.
    double driven = 0.0;
    double dissipated = 0.0;  ///< Energy dissipated by drag of bodies and by damping of systems.
    /// Energy absorbed by contacts: `friction` by tangential impulses, and by friction in joints
    /// and slides; `contact` by normal impulses (impact, damping). Includes the present energy of
    /// their springs.
    double friction = 0.0, contact = 0.0;
    /// Energy absorbed by rows: by damping, by lines that become taut or break, at limits, and by
    /// corrections of rigid rows.
    double damped = 0.0;
    /// Kinetic energy ½ vᵀA v of the added mass of system loads (hawser/system.h), at the last
    /// step.
    double added = 0.0;
    /// Work of system loads without their damping, which counts as dissipated. Includes changes of
    /// their added mass.
    double system = 0.0;
    /// Work of water on all bodies: all loads of the sea (hawser/sea.h) with damping and added
    /// mass. Negative if water absorbs energy. It is a part of `system`, `dissipated` and the
    /// change of `added`. 0 in the replay of a recording of format 2, whose loads have no sources
    /// (docs/recording.md).
    double water = 0.0;
    /// Energy added by edits, negative if removed. Edits are: bodies and interactions added or
    /// removed, masses changed, nodes of wires inserted or removed, cuts and joins.
    double edited = 0.0;
    /// Return the mechanical energy: kinetic + added + gravity + elastic.
    [[nodiscard]] double mechanical() const noexcept { return kinetic + added + gravity + elastic; }
};

/// Work that a step omitted to keep a limit of its cost; none by default. With this record another
/// run reproduces the step bit for bit without a clock (docs/theory/deadlines.md).
struct Degradation {
    /// Number of Newton iterations after which the solves for contacts ended early, summed over the
    /// step; 0: they were solved to the tolerance.
    std::int32_t iterations = 0;
    /// True if the last iteration used the present factorisation, and lines that request a switch
    /// of their status got it only after the step.
    bool hasty = false;
    /// Interfaces whose interactions of Coupling::deadline were cut, one bit each. An interface is
    /// a pair of groups. Bits are in the order of the pairs; all pairs beyond 63 share one bit.
    std::uint64_t cuts = 0;
    /// Coarsening level n of wires (resolution.h): bounds of element lengths are multiplied
    /// by 1.5ⁿ.
    std::int32_t wires = 0;
    /// Return true if the solution of the step is incomplete.
    [[nodiscard]] bool of_solve() const noexcept { return iterations > 0 || cuts != 0; }
    /// Return true if the step omitted any work.
    [[nodiscard]] bool any() const noexcept { return of_solve() || wires > 0; }
    friend bool operator==(const Degradation&, const Degradation&) = default;
};

/// Reason for omitted work.
enum class DegradedBy : std::uint8_t {
    nothing,     ///< No work was omitted.
    prediction,  ///< More work was predicted to exceed WorldDef::budget.
    clock,       ///< The elapsed time reached WorldDef::budget.
    work,        ///< More work would have exceeded WorldDef::budget_work.
    order,       ///< WorldSolver::degrade_next_step() requested it.
};
inline constexpr int kDegradedByCount = 5;
/// Return the name of a reason, as in its enumerator.
[[nodiscard]] const char* to_string(DegradedBy cause) noexcept;

/// Figures of the last step.
struct StepStats {
    Status status = Status::ok;  ///< Outcome of the step.
    BoundMet bound_met;          ///< Exceeded limit, with Status::over_bound.
    std::int64_t step = 0;       ///< Number of completed steps.
    double time = 0.0;           ///< Simulated time at the end of the step [s].

    std::array<double, kStageCount> stage_seconds{};  ///< Wall time of each stage [s].
    double step_seconds = 0.0;                        ///< Wall time of all stages [s].
    double solver_seconds = 0.0;      ///< Wall time of the stages graph to nonsmooth [s].
    double solver_cpu_seconds = 0.0;  ///< CPU time of the slowest thread in the same stages [s].

    /// Relative residual of momentum, ‖M v₊ − a − Gᵀλ‖_{M⁻¹} / max(‖a − M v_k‖_{M⁻¹}, floor) [1].
    double momentum_residual = 0.0;
    double constraint_residual = 0.0;  ///< Residual max |G v₊ + Σ λ − c| of rows [m/s or rad/s].
    double violation_max = 0.0;        ///< Largest |g| of translational constraint rows [m].
    InteractionId violation_worst{};   ///< Interaction with the largest violation.
    double stretch_error_max = 0.0;    ///< Largest |l − l₀(1 + T/EA)| / l₀ of stretch elements [1].

    std::int32_t bodies = 0;          ///< Number of bodies with degrees of freedom.
    std::int32_t asleep = 0;          ///< Number of these that sleep.
    std::int32_t interactions = 0;    ///< Number of interactions.
    std::int32_t equations = 0;       ///< Number of velocity unknowns and rows of all interactions.
    std::int32_t islands = 0;         ///< Number of islands.
    std::int64_t matrix_nnz = 0;      ///< Number of scalars of the factored matrix, lower triangle.
    std::int64_t factor_nnz = 0;      ///< Number of scalars of the factor L, diagonal included.
    std::int64_t factor_flops = 0;    ///< Flops of one factorisation; a multiply-add counts as two.
    std::int32_t factorisations = 0;  ///< Number of factorisations in this step.
    /// Number of substitutions in this step, for factorisations, refinements, end-of-step
    /// constraint iterations and the filter of joints in loops. Substitutions of Krylov iterations
    /// do not count.
    std::int32_t substitutions = 0;
    /// Change of the right-hand side that one more constraint iteration would cause [m/s or rad/s].
    double completion_change = 0.0;
    /// Number of end-of-step constraint iterations in this step (docs/theory/joints.md).
    std::int32_t completion_rounds = 0;
    /// Number of steps since the start whose constraint iterations diverged, so that joints were
    /// linearised once.
    std::int64_t completion_failures = 0;
    /// Number of joints in closed loops whose force is undetermined. Their reported force is the
    /// smallest one possible.
    std::int32_t undetermined = 0;
    /// Number of the factorisations that were partial, after changes of contacts only.
    std::int32_t partial_factorisations = 0;
    /// Number of repeated solutions of this step with the geometric stiffness of larger joint
    /// forces.
    std::int32_t restiffened = 0;
    /// Number of repeated solutions of this step because a wire would have gained energy.
    std::int32_t wire_repeats = 0;
    std::int32_t contacts =
        0;  ///< Number of contact points, including those that do not touch yet.
    /// Number of tension-only rows and contacts whose status still changed at the end of the solve.
    std::int32_t flips_left = 0;
    /// Natural map: largest relative residual of a contact law (docs/theory/newton.md) [1].
    double natural_map = 0.0;
    /// Number of refinements of the step's last solution, see WorldDef::refinements.
    std::int32_t refinements = 0;
    double factor_work = 0.0;  ///< Flops of the step's factorisations over those of one LDLᵀ [1].
    std::int64_t impacts = 0;  ///< Number of steps with an impact stage, since the start.
    /// Number of impact stages since the start that were repeated without bounce, because they
    /// would have gained energy or failed.
    std::int64_t impact_retries = 0;
    std::int32_t newton_iterations = 0;  ///< Number of iterations for contacts in this step.
    bool cut = false;                    ///< True if the budget ended the iterations for contacts.
    Degradation degradation;             ///< Omitted work.
    DegradedBy degraded_by = DegradedBy::nothing;  ///< Reason for omitted work.
    /// Predicted CPU time of the solver with one more iteration than allowed [s]; 0 if no work was
    /// omitted for lack of time.
    double foreseen_seconds = 0.0;
    /// Interfaces of Degradation::cuts that have a cut in effect, one bit each. If other
    /// connections join the groups of an interface, its solution is exact.
    std::uint64_t compliant = 0;
    std::int32_t cuts = 0;    ///< Number of cut interactions in this step (docs/theory/splits.md).
    double cut_defect = 0.0;  ///< Largest norm of the sum of the impulses of a cut [N s].
    /// Largest residual |G v₊ + Σλ − c| of rows of cuts, with the velocities v₊ of all their bodies
    /// and the mean λ of both sides [m/s or rad/s].
    double cut_residual = 0.0;
    /// Created linear momentum over h g Σ m [1]. Sum over cuts of the norm of the sum of their
    /// impulses, which differ by side, plus the norm of the momentum residual of all bodies.
    double momentum_defect = 0.0;
    /// Number of updates of automatic groups since the start (WorldDef::parts), and of bodies that
    /// changed their group in them.
    std::int64_t regroupings = 0, regrouped_bodies = 0;
    std::int64_t growths = 0;  ///< Number of capacity growths since the start; constant when warm.
    /// Number of analyses since the start that computed a new elimination order, and of those that
    /// repaired the existing one (first contact of two bodies, additions, sleep, waking).
    std::int64_t plans = 0, repairs = 0;
    std::int64_t columns_repaired = 0;  ///< Number of block columns that these repairs computed.
    /// Number of events of each kind since the start.
    std::array<std::int64_t, kEventKindCount> event_count{};
};

}  // namespace hawser
