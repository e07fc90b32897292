// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file stats.h
/// Results of a step: status, times, residuals, energy, events.

#include <hawser/def.h>
#include <hawser/id.h>

#include <array>
#include <cstdint>

namespace hawser {

/// Outcome of a step. For any value other than `ok` the state is that of the previous step. The
/// next call tries the same step again.
enum class Status : std::uint8_t {
    ok,
    wrong_pivot,    ///< A pivot had the wrong sign or was not finite: the model is singular.
    not_finite,     ///< The solution or an input was not finite.
    out_of_memory,  ///< Allocation failed.
    cancelled,      ///< World::cancel() ended it.
    over_bound,     ///< A bound of WorldDef would be exceeded: see StepStats::bound_met.
    /// Reported if recent states are physically impossible (World::verdict()). Only if
    /// WorldDef::on_diverged is stop.
    diverged,
    /// A system set a value that is not finite, or a load that is not positive semi-definite.
    /// World::bad_load() names the system and body.
    bad_load,
    in_use,  ///< Another thread uses the world, or the step called itself: see UseError.
    /// A system requested an addition or removal that the world rejects (Edits). World::bad_load()
    /// names the system and the reason.
    bad_edit,
};
[[nodiscard]] const char* to_string(Status status) noexcept;

/// The stages of a step, in order. One name for code, timer, trace and documentation.
enum class Stage : std::uint8_t {
    prestep,
    collide,
    graph,  ///< Groups that follow the state.
    analyse,
    assemble,
    factor,
    nonsmooth,
    integrate
};
inline constexpr int kStageCount = 8;
[[nodiscard]] const char* to_string(Stage stage) noexcept;

enum class EventKind : std::uint8_t {
    /// The tension of an element exceeded its breaking load and it broke. value: tension [N].
    line_break,
    slack,          ///< A tension-only element went slack. value: 0.
    taut,           ///< A slack element came under load. value: tension [N].
    saturation,     ///< A motor's force reached an end of its range; once each time.
                    ///< value: force [N or N m].
    range,          ///< A joint reached the end of its range. value: how far beyond [m or rad].
    input_clamped,  ///< An input was outside its range. value: the requested value.
    warning,        ///< Residual above its limit. value: the residual.
    // A monitor became suspect or failed; each once until it is good again. value: Finding::value.
    energy_created,  ///< Judge::energy.
    joint_open,      ///< Judge::violation.
    cable_law,       ///< Judge::cable.
    uncertified,     ///< Judge::certificate.
    fast,            ///< Judge::speed.
    // Events of winches (winch.h), for the body of the drum.
    layer,       ///< The wire leaves or reaches another layer. value: its number, 1 the innermost.
    brake_slip,  ///< A brake began to slip; once each time. value: its torque [N m].
    release,     ///< An emergency release took effect, or a pelican hook opened (wire.h, of the
                 ///< hook). value: tension then [N].
    weak_link,   ///< The wire's fastening on the drum broke. value: its force [N].
    drum_empty,  ///< All wire is off the drum. value: tension then [N].
    // Events of wires that are cut and joined (wire.h).
    cut,     ///< A wire was cut. value: tension there [N].
    join,    ///< Ends were joined, or an end attached. value: their distance before [m].
    detach,  ///< An end was released. value: tension there [N].
    // Further events of winches.
    chain_jump,  ///< Chain jumped by a pocket of its gypsy. value: its pull [N].
    no_node,     ///< A new node did not fit on the wire of a winch; once until it does. value:
                 ///< length of the element at the drum [m].
    /// A wire requires more nodes than its limit allows (resolution.h); once each time, for a node
    /// of the element that stays too long. value: its number of nodes.
    node_limit,
    render,  ///< The drum paid out in mode render; once each time. value: tension then [N].
    // Events of cranes (crane.h), for the body of the hook.
    alarm,      ///< The load reached a higher alarm level. value: load over rated load [1].
    alarm_end,  ///< It fell to a lower alarm level. value: load over rated load [1].
    // Events of shark jaws and chain stoppers (stopper.h), and of hooks (hook.h).
    overload,  ///< It opened above its rated load; for its joint or load. value: the load [N].
    missed,    ///< Nothing is within its reach; for its body. value: distance of the nearest [m].
    /// The end of a wire reached the fairlead of its drum, or its turning point, and stops there.
    /// Once until it runs back; for the drum or the slide. value: tension [N].
    hauled_in,
    // Events of guides without an upper roller (guide.h), for the element there.
    lift_off,  ///< The wire left its guide. value: tension then [N].
    lay_on,    ///< The wire returned to its guide. value: tension then [N].
    /// Iterations of rigid joints failed, so the step linearised the joints once. Reported once
    /// until limit::kMemory has passed without a failure. value: StepStats::completion_failures.
    incomplete,
    // Events of vessels (vessel.h), for their body.
    shed,     ///< A bus withheld power from a consumer; once each time. value: power withheld [W].
    failure,  ///< A part failed by its signal; once each time. value: the signal.
    // Events of the control of a vessel (vessel_control.h), for its body.
    mode_refused,      ///< A mode of control was refused. value: the mode.
    position_lost,     ///< An offset exceeded its alarm; once each time. value: distance [m].
    failure_critical,  ///< The worst single failure would lose the position; once each time.
                       ///< value: shortfall over the force needed [1].
};
inline constexpr int kEventKindCount = 37;
[[nodiscard]] const char* to_string(EventKind kind) noexcept;

struct Event {
    double time = 0.0;  ///< End of the step in which it happened [s].
    EventKind kind = EventKind::warning;
    InteractionId interaction{};  ///< Invalid for the whole world.
    double value = 0.0;           ///< See EventKind.
    InputId input{};              ///< Clamped input of the world; invalid for other events.
    BodyId body{};                ///< Body of the event; invalid if none.
    std::int32_t signal = -1;     ///< Clamped signal: index in World::system_signals(); −1: none.
};

/// Count and extremes of all events of a kind.
struct EventExtremes {
    /// Since the world was created; a restored state does not include earlier ones.
    std::int64_t count = 0;
    Event first, worst;  ///< Worst: the largest |value|, the first of equals.
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
[[nodiscard]] const char* to_string(Judge judge) noexcept;
/// Return a recommended action as a sentence.
[[nodiscard]] const char* remedy(Judge judge) noexcept;

/// The worst result of a monitor.
struct Finding {
    /// energy: [J]; violation: [m] or [rad]; cable: |l − l₀(1 + T/EA)|/l₀ [1]; certificate:
    /// relative residual [1]; speed: angle of a step [rad].
    double value = 0.0;
    double doubtful = 0.0;        ///< Value over the limit beyond which a result is suspect [1].
    double wrong = 0.0;           ///< Value over the limit beyond which it fails [1]; 0: no limit.
    double time = 0.0;            ///< Time of the state [s].
    InteractionId interaction{};  ///< Interaction, if any, …
    BodyId body{};                ///< … or a body.
};

enum class Grade : std::uint8_t { good, doubtful, wrong };
[[nodiscard]] const char* to_string(Grade grade) noexcept;

/// Result of the monitors of a world: see docs/limits.md.
struct Verdict {
    Grade grade = Grade::good;  ///< Worst since the start; speed alone makes nothing doubtful.
    /// Monitor with this grade; if good, the one nearest to its limit.
    Judge judge = Judge::energy;
    std::array<Finding, kJudgeCount> worst{};  ///< Worst result of each monitor since the start.
    [[nodiscard]] const Finding& of(Judge j) const noexcept {
        return worst[static_cast<std::size_t>(j)];
    }
};

/// Mechanical energy, evaluated at the half-step position x̄ = (x_k + x_{k−1})/2 with v_k [J].
struct Energy {
    double kinetic = 0.0;
    double gravity = 0.0;  ///< −Σ m g·x̄.
    double elastic = 0.0;  ///< Σ g²/(2ε) over rows with compliance > 1e-11, hydrostatics included.
    double applied = 0.0;  ///< Work done since the start by applied forces and torques.
    /// Work since the start of motors (negative when braking), of lengths and targets that inputs
    /// change, of winches, and of bodies with a prescribed velocity.
    double driven = 0.0;
    double dissipated =
        0.0;  ///< Energy taken since the start by body damping (drag), and by damping of systems.
    /// Energy absorbed since the start by contacts: by tangential impulses (with friction in joints
    /// and slides) and by normal ones (impact, damping). Includes the present energy of their
    /// springs.
    double friction = 0.0, contact = 0.0;
    /// Energy absorbed since the start by rows: by damping, by lines that become taut or break, at
    /// limits, and by corrections of rigid rows.
    double damped = 0.0;
    /// ½ vᵀA v of the added mass of system loads (hawser/system.h), at the last step.
    double added = 0.0;
    /// Work since the start of system loads without their damping, which counts as dissipated.
    /// Includes changes of their added mass.
    double system = 0.0;
    /// Work since the start of water on all bodies: all loads of the sea (hawser/sea.h) with
    /// damping and added mass. Energy absorbed by water is negative. It is a part of `system`,
    /// `dissipated` and the change of `added`. 0 in the replay of a recording of format 2, whose
    /// loads have no sources (docs/recording.md).
    double water = 0.0;
    /// Energy of edits since the start, negative if removed. Edits are: bodies and interactions
    /// added or removed, masses changed, nodes of wires inserted or removed, cuts and joins.
    double edited = 0.0;
    [[nodiscard]] double mechanical() const noexcept { return kinetic + added + gravity + elastic; }
};

/// Work that a step left out to keep a limit of its cost; none by default. It suffices to repeat
/// the step bit for bit without a clock (docs/theory/deadlines.md).
struct Degradation {
    /// Newton iterations after which solves for contacts ended, summed over the step; 0: they were
    /// solved.
    std::int32_t iterations = 0;
    /// True if they end with the current factorisation, and requesting lines switch after the step.
    bool hasty = false;
    /// Interfaces with compliant cuts of Coupling::deadline, one bit each. An interface is a pair
    /// of groups. Pairs count in the order of their groups, those beyond 63 as one.
    std::uint64_t cuts = 0;
    /// Coarsening level of wires (resolution.h): lengths of elements times 1.5 to this power.
    std::int32_t wires = 0;
    /// Return true if the solution of the step is incomplete.
    [[nodiscard]] bool of_solve() const noexcept { return iterations > 0 || cuts != 0; }
    [[nodiscard]] bool any() const noexcept { return of_solve() || wires > 0; }
    friend bool operator==(const Degradation&, const Degradation&) = default;
};

/// Reason for leaving out work.
enum class DegradedBy : std::uint8_t {
    nothing,
    prediction,  ///< Predicted: more work would not have fitted.
    clock,       ///< The elapsed time of the step.
    work,        ///< The flops of the step.
    order,       ///< WorldSolver::degrade_next_step().
};
inline constexpr int kDegradedByCount = 5;
[[nodiscard]] const char* to_string(DegradedBy cause) noexcept;

/// Figures of the last step.
struct StepStats {
    Status status = Status::ok;
    BoundMet bound_met;     ///< For Status::over_bound.
    std::int64_t step = 0;  ///< Number of steps taken.
    double time = 0.0;      ///< End of the step [s].

    std::array<double, kStageCount> stage_seconds{};  ///< Wall time by stage.
    double step_seconds = 0.0;                        ///< Wall time of all stages.
    double solver_seconds = 0.0;                      ///< Wall time, stages graph to nonsmooth.
    double solver_cpu_seconds = 0.0;  ///< CPU time of the slowest thread, same stages.

    double momentum_residual = 0.0;    ///< ‖M v₊ − a − Gᵀλ‖_{M⁻¹} / max(‖a − M v_k‖_{M⁻¹}, floor).
    double constraint_residual = 0.0;  ///< max |G v₊ + Σ λ − c| over rows [m/s or rad/s].
    double violation_max = 0.0;        ///< Largest |g| of translational constraint rows [m].
    InteractionId violation_worst{};   ///< Row of the largest violation.
    double stretch_error_max = 0.0;    ///< Largest |l − l₀(1 + T/EA)| / l₀ over stretch elements.

    std::int32_t bodies = 0;  ///< Bodies that move.
    std::int32_t asleep = 0;  ///< Sleeping bodies among these.
    std::int32_t interactions = 0;
    std::int32_t equations = 0;  ///< Velocity unknowns + rows of all interactions.
    std::int32_t islands = 0;
    std::int64_t matrix_nnz = 0;      ///< Scalars of the lower triangle of the factored matrix.
    std::int64_t factor_nnz = 0;      ///< Scalars of L, diagonal included.
    std::int64_t factor_flops = 0;    ///< Multiply-adds counted as two, of one factorisation.
    std::int32_t factorisations = 0;  ///< In this step.
    /// Substitutions of the step's solution: of its factorisations, refinements, end-of-step
    /// constraint iterations, and of the filter of joints in loops. Without those of Krylov
    /// iterations.
    std::int32_t substitutions = 0;
    /// Change of a right-hand side that a further constraint iteration would cause [m/s or rad/s].
    double completion_change = 0.0;
    /// End-of-step constraint iterations in this step (docs/theory/joints.md).
    std::int32_t completion_rounds = 0;
    /// Steps since the start with diverging constraint iterations, so that joints were linearised
    /// once.
    std::int64_t completion_failures = 0;
    /// Joints in closed loops whose force is undetermined; the smallest one is shown.
    std::int32_t undetermined = 0;
    /// Partial factorisations among these, after changes of contacts only.
    std::int32_t partial_factorisations = 0;
    /// Repeated solutions of this step with the stiffness of larger joint forces.
    std::int32_t restiffened = 0;
    /// Repeated solutions of this step because a wire would have gained energy.
    std::int32_t wire_repeats = 0;
    std::int32_t contacts = 0;  ///< Contact points, including near ones without touch.
    /// Tension-only rows and contacts whose status still changed at the end of the solve.
    std::int32_t flips_left = 0;
    double natural_map = 0.0;  ///< Largest relative residual of a contact's law (docs/methods.md).
    /// Refinements of the step's last solution, see WorldDef::refinements.
    std::int32_t refinements = 0;
    double factor_work = 0.0;  ///< Flops of the step's factorisations over those of one LDLᵀ.
    std::int64_t impacts = 0;  ///< Steps with an impact stage, since the start.
    /// Impact stages repeated without bounce, because they would have gained energy or failed.
    std::int64_t impact_retries = 0;
    std::int32_t newton_iterations = 0;  ///< Iterations of the solve for contacts.
    bool cut = false;         ///< The budget ended the solve for contacts after newton_iterations.
    Degradation degradation;  ///< Work left out.
    DegradedBy degraded_by = DegradedBy::nothing;
    /// Predicted CPU time of the solver with one more iteration than allowed [s]; 0 if nothing was
    /// left out for lack of time.
    double foreseen_seconds = 0.0;
    /// Interfaces of Degradation::cuts with a cut in force. If other connections join the groups,
    /// the solution stays exact.
    std::uint64_t compliant = 0;
    std::int32_t cuts = 0;    ///< Interactions cut in this step (docs/theory/splits.md).
    double cut_defect = 0.0;  ///< Largest ‖Σ of the impulses on the bodies of a cut‖ [N s].
    /// Largest |G v₊ + Σλ − c| over rows of cuts, v₊ of all their bodies and λ the mean of the
    /// sides [m/s or rad/s].
    double cut_residual = 0.0;
    /// Created linear momentum over h g Σ m. It is Σ over cuts ‖Σ of the impulses on their bodies‖,
    /// which differ by side, plus that of the residuals of all bodies.
    double momentum_defect = 0.0;
    /// Regroupings since the start by groups that follow the state (WorldDef::parts), and bodies
    /// that changed their group.
    std::int64_t regroupings = 0, regrouped_bodies = 0;
    std::int64_t growths = 0;  ///< Capacity growths since the start (0 in a warm step).
    /// Analyses since the start with a new elimination order, and those that repaired the existing
    /// one (a first contact of bodies, additions, sleep, waking).
    std::int64_t plans = 0, repairs = 0;
    std::int64_t columns_repaired = 0;  ///< Block columns that these repairs computed.
    std::array<std::int64_t, kEventKindCount> event_count{};  ///< Since the start, by kind.
};

}  // namespace hawser
