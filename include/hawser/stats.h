// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file stats.h
/// What a step reports: status, times, residuals, energy, events.

#include <hawser/def.h>
#include <hawser/id.h>

#include <array>
#include <cstdint>

namespace hawser {

/// Outcome of a step. Anything but `ok` leaves the state of the previous step in place; the
/// next call tries the same step again.
enum class Status : std::uint8_t {
    ok,
    wrong_pivot,    ///< A pivot had the wrong sign or was not finite: the model is singular.
    not_finite,     ///< The solution or an input was not finite.
    out_of_memory,  ///< Capacity could not grow.
    cancelled,      ///< World::cancel() ended it.
    over_bound,     ///< It would exceed a bound of WorldDef: StepStats::bound_met says which.
    /// The state that the last steps came to is nothing that the model can do: World::verdict()
    /// says what. Where WorldDef::on_diverged is stop.
    diverged,
    /// A system set what is not finite, or a load that is not positive semi-definite:
    /// World::bad_load() names system and body.
    bad_load,
    in_use,  ///< Another thread uses the world, or the step called itself: see UseError.
    /// A system asked for an addition or removal that the world refuses (Edits): World::bad_load()
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
    line_break,  ///< A stretch element exceeded its breaking load and parted. value: tension [N].
    slack,       ///< A tension-only element went slack. value: 0.
    taut,        ///< A slack element came under load. value: tension [N].
    saturation,  ///< A motor's force reached an end of its range; once each time.
                 ///< value: force [N or N m].
    range,       ///< A joint reached the end of its range. value: how far beyond [m or rad].
    input_clamped,  ///< An input was outside its range. value: the value asked for.
    warning,        ///< Residual above its limit. value: the residual.
    // What a judge found to be doubtful, or worse; each once until it is well again. value:
    // Finding::value.
    energy_created,  ///< Judge::energy.
    joint_open,      ///< Judge::violation.
    cable_law,       ///< Judge::cable.
    uncertified,     ///< Judge::certificate.
    fast,            ///< Judge::speed.
    // Of winches (winch.h), of the body that is the drum.
    layer,       ///< The wire leaves or lies on another layer. value: its number, 1 the innermost.
    brake_slip,  ///< A brake began to slip; once each time. value: its torque [N m].
    release,     ///< An emergency release took effect, or a pelican hook opened (wire.h, of the
                 ///< hook). value: tension then [N].
    weak_link,   ///< The wire's fastening on the drum parted. value: its force [N].
    drum_empty,  ///< All wire is off the drum. value: tension then [N].
    // Of wires that are cut and joined (wire.h).
    cut,     ///< A wire was cut. value: tension there [N].
    join,    ///< Ends were joined, or an end attached. value: how far apart they were [m].
    detach,  ///< An end was let go. value: tension there [N].
    // Of winches again.
    chain_jump,  ///< Chain jumped by a pocket of its gypsy. value: what it was pulled with [N].
    no_node,     ///< A winch could not put a node on its wire, for want of room; once until it
                 ///< can. value: length of the element at the drum [m].
    /// A wire would be finer than its limit of nodes lets it (resolution.h); once each time, of a
    /// node of the element that stays too long. value: its nodes.
    node_limit,
    render,  ///< A winch in mode render gave way; once each time. value: tension then [N].
    // Of cranes (crane.h), of the body that is the hook.
    alarm,      ///< Its load came to a higher step of alarm. value: load over rated load [1].
    alarm_end,  ///< It came to a lower step of alarm. value: load over rated load [1].
    // Of shark jaws and chain stoppers (stopper.h), and of hooks (hook.h).
    overload,  ///< One opened above its rated load, of its joint or load. value: the load [N].
    missed,    ///< One has nothing in reach, of its body. value: how far the nearest is [m].
    /// The end of a wire reached the fairlead of its drum, or the place that it runs through, and
    /// stops there; once until it runs back. Of the drum or the slide. value: tension [N].
    hauled_in,
    // Of guides without an upper roller (guide.h), of the element there.
    lift_off,  ///< The wire left its guide. value: tension then [N].
    lay_on,    ///< The wire came back onto its guide. value: tension then [N].
    /// Iterations of rigid joints failed, so that the step linearised the joints once; once until
    /// limit::kMemory has passed without one. value: StepStats::completion_failures.
    incomplete,
    // Control of a vessel (vessel_control.h), on its body.
    mode_refused,      ///< A mode of control was refused. value: the mode.
    position_lost,     ///< An offset exceeded its alarm; once each time. value: distance [m].
    failure_critical,  ///< The worst single failure would lose the position; once each time.
                       ///< value: shortfall over the force needed [1].
};
inline constexpr int kEventKindCount = 35;
[[nodiscard]] const char* to_string(EventKind kind) noexcept;

struct Event {
    double time = 0.0;  ///< End of the step in which it happened [s].
    EventKind kind = EventKind::warning;
    InteractionId interaction{};  ///< Where; invalid for what concerns the whole world.
    double value = 0.0;           ///< See EventKind.
    /// Of input_clamped: which one; of a system, which has no id, index −2 less its place in
    /// World::system_signals().
    InputId input{};
    BodyId body{};  ///< Where, if that is a body.
};

/// What stays of the events of a kind, however many there were.
struct EventExtremes {
    std::int64_t count = 0;  ///< Since the world was made; a restored state has none of before.
    Event first, worst;      ///< Worst: with the largest |value|, the first of equals.
};

/// What a step is judged by (docs/limits.md).
enum class Judge : std::uint8_t {
    energy,       ///< Mechanical energy that nothing accounts for.
    violation,    ///< Rigid joints that stand open.
    cable,        ///< Elements whose tension is not that of their length.
    certificate,  ///< Equations and laws of contact that are not solved.
    speed,        ///< Turns of more than a step can follow.
};
inline constexpr int kJudgeCount = 5;
[[nodiscard]] const char* to_string(Judge judge) noexcept;
/// What to do about it, in a sentence.
[[nodiscard]] const char* remedy(Judge judge) noexcept;

/// The worst that a judge has found.
struct Finding {
    /// energy: [J]; violation: [m] or [rad]; cable: |l − l₀(1 + T/EA)|/l₀ [1]; certificate:
    /// relative residual [1]; speed: angle of a step [rad].
    double value = 0.0;
    double doubtful = 0.0;        ///< Over the limit beyond which a result is doubtful [1].
    double wrong = 0.0;           ///< Over the limit beyond which it is wrong [1]; 0: it has none.
    double time = 0.0;            ///< Of the state [s].
    InteractionId interaction{};  ///< Where, if that is an interaction, …
    BodyId body{};                ///< … or a body.
};

enum class Grade : std::uint8_t { good, doubtful, wrong };
[[nodiscard]] const char* to_string(Grade grade) noexcept;

/// What a world vouches for: see docs/limits.md.
struct Verdict {
    Grade grade = Grade::good;    ///< Worst since the start; speed alone makes nothing doubtful.
    Judge judge = Judge::energy;  ///< Who says so; where good, who is nearest to its limit.
    std::array<Finding, kJudgeCount> worst{};  ///< Of each judge, since the start.
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
    /// Work done since the start by motors (negative where they brake), by lengths and targets
    /// that inputs change, by winches, and by bodies with a prescribed velocity.
    double driven = 0.0;
    double dissipated =
        0.0;  ///< Energy taken since the start by body damping (drag), and by damping of systems.
    /// Energy taken since the start by contacts: by tangential impulses, those of friction in
    /// joints and slides included, and by normal ones (impact, damping). What their springs hold at
    /// the moment is part of it.
    double friction = 0.0, contact = 0.0;
    /// Energy taken since the start by rows: by their damping, where lines come taut or part, where
    /// limits are met, and by corrections of rigid rows.
    double damped = 0.0;
    /// ½ vᵀA v of the added mass that systems load bodies with (hawser/system.h), at the last step.
    double added = 0.0;
    /// Work done since the start by loads of systems but for their damping, which counts as
    /// dissipated; changes of their added mass included.
    double system = 0.0;
    /// Work done since the start by water on all bodies: by all that the sea loads them with
    /// (hawser/sea.h), its damping and added mass included, so that what water takes is negative.
    /// A part of `system`, `dissipated` and the change of `added`. 0 where a recording is repeated,
    /// whose loads have no names.
    double water = 0.0;
    /// Energy that edits of the world brought in since the start, negative where they took it away:
    /// bodies and interactions that come and go, masses that change, nodes of wires that come and
    /// go at drums, guides and posts or by refinement, cuts and joins.
    double edited = 0.0;
    [[nodiscard]] double mechanical() const noexcept { return kinetic + added + gravity + elastic; }
};

/// What a step left out to keep to a limit of its cost; by default nothing. Enough to repeat the
/// step bit for bit without a clock (docs/methods.md, 11).
struct Degradation {
    /// Newton iterations after which solves for contacts ended, of all that the step took; 0: when
    /// they were solved.
    std::int32_t iterations = 0;
    /// They end with the factorisation at hand, and lines that ask to switch do so after the step.
    bool hasty = false;
    /// Interfaces, a bit each, whose cuts of Coupling::deadline were compliant. An interface is a
    /// pair of groups; pairs count in the order of their groups, those beyond 63 as one.
    std::uint64_t cuts = 0;
    /// Level by which wires were coarser (resolution.h): lengths of elements times 1.5 to its
    /// power.
    std::int32_t wires = 0;
    /// Whether the step was solved less than whole.
    [[nodiscard]] bool of_solve() const noexcept { return iterations > 0 || cuts != 0; }
    [[nodiscard]] bool any() const noexcept { return of_solve() || wires > 0; }
    friend bool operator==(const Degradation&, const Degradation&) = default;
};

/// What had a step leave something out.
enum class DegradedBy : std::uint8_t {
    nothing,
    prediction,  ///< More would not have fitted, by what was known before the step.
    clock,       ///< By the time that the step had used.
    work,        ///< By the flops that it had used.
    order,       ///< World::degrade_next_step().
};
inline constexpr int kDegradedByCount = 5;
[[nodiscard]] const char* to_string(DegradedBy cause) noexcept;

/// Figures of the last step.
struct StepStats {
    Status status = Status::ok;
    BoundMet bound_met;     ///< Of Status::over_bound.
    std::int64_t step = 0;  ///< Steps taken so far.
    double time = 0.0;      ///< End of the step [s].

    std::array<double, kStageCount> stage_seconds{};  ///< Wall time by stage.
    double step_seconds = 0.0;                        ///< Wall time of all stages.
    double solver_seconds = 0.0;                      ///< Wall time, stages graph to nonsmooth.
    double solver_cpu_seconds = 0.0;  ///< CPU time of the slowest thread, same stages.

    double momentum_residual = 0.0;    ///< ‖M v₊ − a − Gᵀλ‖_{M⁻¹} / max(‖a − M v_k‖_{M⁻¹}, floor).
    double constraint_residual = 0.0;  ///< max |G v₊ + Σ λ − c| over rows [m/s or rad/s].
    double violation_max = 0.0;        ///< Largest |g| of translational constraint rows [m].
    InteractionId violation_worst{};   ///< Where.
    double stretch_error_max = 0.0;    ///< Largest |l − l₀(1 + T/EA)| / l₀ over stretch elements.

    std::int32_t bodies = 0;  ///< Bodies that move.
    std::int32_t asleep = 0;  ///< Of these, asleep.
    std::int32_t interactions = 0;
    std::int32_t equations = 0;  ///< Velocity unknowns + rows of all interactions.
    std::int32_t islands = 0;
    std::int64_t matrix_nnz = 0;      ///< Scalars of the lower triangle of the factored matrix.
    std::int64_t factor_nnz = 0;      ///< Scalars of L, diagonal included.
    std::int64_t factor_flops = 0;    ///< Multiply-adds counted as two, of one factorisation.
    std::int32_t factorisations = 0;  ///< In this step.
    /// Substitutions of the step's solution: those of its factorisations, refinements, rounds of
    /// completion, and of the filter of joints in loops. Not those of Krylov iterations.
    std::int32_t substitutions = 0;
    /// What another round would have changed in a right-hand side [m/s or rad/s].
    double completion_change = 0.0;
    std::int32_t completion_rounds = 0;  ///< Of rigid joints in this step (docs/methods.md, 2).
    /// Steps since the start whose rounds did not converge, so that joints were linearised once.
    std::int64_t completion_failures = 0;
    /// Joints in closed loops whose force the step leaves undetermined; the smallest one is shown.
    std::int32_t undetermined = 0;
    std::int32_t partial_factorisations = 0;  ///< Of those, of what contacts changed only.
    /// Times that this step was solved again with the stiffness of joints' forces that had grown.
    std::int32_t restiffened = 0;
    /// Times that this step was solved again since a wire would have gained energy.
    std::int32_t wire_repeats = 0;
    std::int32_t contacts = 0;  ///< Contact points, those near without touching included.
    /// Tension-only rows and contacts whose status was still changing when the solve ended.
    std::int32_t flips_left = 0;
    double natural_map = 0.0;  ///< Largest relative residual of a contact's law (docs/methods.md).
    std::int32_t refinements = 0;  ///< Of the step's last solution, see WorldDef::refinements.
    double factor_work = 0.0;      ///< Flops of the step's factorisations over those of one LDLᵀ.
    std::int64_t impacts = 0;      ///< Steps with an impact stage, since the start.
    /// Of those, stages done again without bouncing, since it would have gained energy or failed.
    std::int64_t impact_retries = 0;
    std::int32_t newton_iterations = 0;  ///< Of the solve for contacts.
    bool cut = false;         ///< The budget ended the solve for contacts after newton_iterations.
    Degradation degradation;  ///< What it left out.
    DegradedBy degraded_by = DegradedBy::nothing;
    /// CPU time at which the solver would have ended with one more iteration than it was allowed,
    /// as predicted [s]; 0 where nothing was left out, or not by time.
    double foreseen_seconds = 0.0;
    /// Of Degradation::cuts, the interfaces of which a cut was in force: where something else holds
    /// the groups together, what is asked for stays exact.
    std::uint64_t compliant = 0;
    std::int32_t cuts = 0;    ///< Interactions cut in this step (docs/methods.md, 10).
    double cut_defect = 0.0;  ///< Largest of a cut: ‖Σ of the impulses on its bodies‖ [N s].
    /// max |G v₊ + Σλ − c| over rows of cuts, v₊ of all their bodies and λ the mean of the sides
    /// [m/s or rad/s].
    double cut_residual = 0.0;
    /// Linear momentum out of nothing: Σ over cuts ‖Σ of the impulses on their bodies‖, which
    /// differ by side, and that of the residuals of all bodies; over h g Σ m.
    double momentum_defect = 0.0;
    /// Rounds since the start in which groups that follow the state changed (WorldDef::parts), and
    /// bodies that changed theirs in them.
    std::int64_t regroupings = 0, regrouped_bodies = 0;
    std::int64_t growths = 0;  ///< Times that capacity grew since the start (0 in a warm step).
    /// Analyses since the start that made a new order of elimination, and those that repaired the
    /// one there was (bodies touch for the first time, some are added, fall asleep or wake).
    std::int64_t plans = 0, repairs = 0;
    std::int64_t columns_repaired = 0;  ///< Block columns that these repairs computed.
    std::array<std::int64_t, kEventKindCount> event_count{};  ///< Since the start, by kind.
};

}  // namespace hawser
