// SPDX-License-Identifier: Apache-2.0
#include "record/host.h"
#include "record/units.h"
#include "report/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace hawser::report {

namespace {

using Out = std::back_insert_iterator<std::string>;

void print_simulated(Out out, const Summary& s) {
    const double time = s.last.time - s.start_time;
    fmt::format_to(out, "  simulated    {:.6g} s in {} steps of {:.6g} ms", time, s.steps,
                   1e3 * s.step);
    if (s.wall_seconds > 0.0)
        fmt::format_to(out, ", {:.3g} s of wall time: {:.3g} x real time", s.wall_seconds,
                       time / s.wall_seconds);
    fmt::format_to(out, "\n");
}

/// Print times of the solver and of the stages of a step.
void print_solver_times(Out out, const Summary& s) {
    if (s.timed_steps > 0) {
        fmt::format_to(out,
                       "  wall, cpu    step p50/p95/p99 {:.4g}/{:.4g}/{:.4g} ms, solver's slowest "
                       "thread {:.4g}/{:.4g}/{:.4g} ms of CPU time\n",
                       s.step_ms.median, s.step_ms.p95, s.step_ms.p99, s.solver_cpu_ms.median,
                       s.solver_cpu_ms.p95, s.solver_cpu_ms.p99);
        if (s.step_cpu_ms.max > 0.0)
            fmt::format_to(out,
                           "  stepping CPU p50/p95/p99 {:.4g}/{:.4g}/{:.4g} ms of the thread that "
                           "steps, factorisations {:.3g}/{:.3g}/{:.3g}\n",
                           s.step_cpu_ms.median, s.step_cpu_ms.p95, s.step_cpu_ms.p99,
                           s.factorisations.median, s.factorisations.p95, s.factorisations.p99);
        fmt::format_to(out, "  stages [ms] ");
        for (std::size_t k = 0; k < s.stage_ms.size(); ++k)
            if (s.stage_ms[k] > 1e-3 * s.step_ms.median)
                fmt::format_to(out, " {} {:.3g}", to_string(static_cast<Stage>(k)), s.stage_ms[k]);
        fmt::format_to(out, "\n");
    }
    if (s.last.plans + s.last.repairs > 1)
        fmt::format_to(out,
                       "  analyses     {} planned, {} repaired with {} block columns; in {} steps, "
                       "at most {:.3g} ms\n",
                       s.last.plans, s.last.repairs, s.last.columns_repaired, s.analyses,
                       s.analyse_ms_max);
}

void print_times(Out out, const Summary& s, Detail detail) {
    if (s.timed_steps > 0) {
        fmt::format_to(out, "  step         median {:.4g} ms, p99 {:.4g} ms, max {:.4g} ms  (",
                       s.step_ms.median, s.step_ms.p99, s.step_ms.max);
        if (detail == Detail::solver) fmt::format_to(out, "solver {:.4g} ms; ", s.solver_ms.median);
        fmt::format_to(out, "first {} steps left out)\n", kWarmUpSteps);
    } else {
        fmt::format_to(out, "  step         not timed: the run has no more than {} steps\n",
                       kWarmUpSteps);
    }
    if (detail == Detail::solver) print_solver_times(out, s);
    if (s.missed_frames >= 0)
        fmt::format_to(out, "  real time    {} of {} frames late, at most {:.3g} ms\n",
                       s.missed_frames, s.steps, 1e3 * s.lateness_max);
}

void print_friction(Out out, const Summary& s, Detail detail) {
    const FrictionFigures& f = s.friction;
    const std::string lost =
        fmt::format("lost by friction {}, by contact {}",
                    record::with_unit(s.energy_end.friction - s.energy_start.friction, "J"),
                    record::with_unit(s.energy_end.contact - s.energy_start.contact, "J"));
    fmt::format_to(out, "  contacts     {:.0f} points in the median step, at most {:.0f}\n",
                   s.contacts_median, s.contacts_max);
    if (detail == Detail::solver) {
        fmt::format_to(out, "               with them {:.0f} interactions, {:.0f} equations\n",
                       s.interactions.median, s.equations.median);
        fmt::format_to(out,
                       "  friction     natural map p50 {:.2e}, p95 {:.2e}, max {:.2e}; {} of {} "
                       "steps uncertified\n",
                       f.natural_map.median, f.natural_map.p95, f.natural_map.max,
                       f.uncertified_steps, f.steps);
        fmt::format_to(out,
                       "               factorisations a step median {:.3g}, p90 {:.3g}, max "
                       "{:.3g}; {}\n",
                       f.factorisations.median, f.factorisations.p90, f.factorisations.max, lost);
    } else {
        fmt::format_to(out, "  friction     {}", lost);
        if (f.uncertified_steps > 0)
            fmt::format_to(out, "; not solved to contact_tolerance in {} of {} steps",
                           f.uncertified_steps, f.steps);
        fmt::format_to(out, "\n");
    }
    if (s.budget_ms <= 0.0 && s.budget_mflop <= 0.0) return;
    fmt::format_to(out, "  budget      ");
    if (s.budget_ms > 0.0)
        fmt::format_to(out, " {:.4g} ms: kept in {:.4g} % of steps;", s.budget_ms,
                       100.0 * s.within_budget);
    if (s.budget_mflop > 0.0) fmt::format_to(out, " {:.4g} Mflop;", s.budget_mflop);
    fmt::format_to(out, " cut {} steps", f.cut_steps);
    if (detail == Detail::solver)
        fmt::format_to(out, ", residual p50 {:.2e}, max {:.2e}", f.cut_residual.median,
                       f.cut_residual.max);
    fmt::format_to(out, "\n");
}

void print_degradations(Out out, const Summary& s, Detail detail) {
    const Degradations& d = s.degradations;
    if (d.all.steps == 0) return;
    const auto by = [&](DegradedBy cause) { return d.by_cause[static_cast<std::size_t>(cause)]; };
    fmt::format_to(out,
                   "  degraded     {} of {} steps, {} times, {:.6g} s to {:.6g} s: wires {}, "
                   "friction {}, coupling {}; by prediction {}, clock {}, work {}",
                   d.all.steps, s.steps, d.spans, d.all.begin, d.all.end, d.wires.steps,
                   d.friction.steps, d.coupling.steps, by(DegradedBy::prediction),
                   by(DegradedBy::clock), by(DegradedBy::work));
    if (d.all.foreseen > 0.0)
        fmt::format_to(out, "; another iteration would have ended by {:.4g} ms",
                       1e3 * d.all.foreseen);
    if (detail == Detail::solver && d.coupling.steps > 0)
        fmt::format_to(out,
                       "; momentum defect of compliant cuts at most {:.2e} of h g m, of one {:.3g} "
                       "N s",
                       d.coupling.momentum_defect, d.coupling.cut_defect);
    fmt::format_to(out, "\n");
}

void print_coupling(Out out, const Summary& s) {
    const verify::CouplingFigures& c = s.coupling;
    fmt::format_to(out,
                   "  split        {}, predictor {}: {} cuts, {} islands; interface residual "
                   "{:.2e}, spectral radius {:.4f}\n",
                   verify::to_string(c.coupling), verify::to_string(c.predictor), c.cuts,
                   s.last.islands, c.residual_max, c.spectral_radius);
    fmt::format_to(out, "               momentum defect rms {:.2e}, max {:.2e} of h g m\n",
                   c.defect_rms, c.defect_max);
    fmt::format_to(out,
                   "               against an exact step from the same state: tension at cuts off "
                   "by {:.3g} % rms, {:.3g} % at most\n",
                   100.0 * c.tension_error_rms, 100.0 * c.tension_error_max);
    fmt::format_to(
        out, "               jerk at most {:.3g} m/s³, exact {:.3g} m/s³, difference {:.3g}\n",
        c.jerk_max, c.jerk_exact_max, c.jerk_difference_max);
}

void print_quality(Out out, const Summary& s, Detail detail) {
    fmt::format_to(out, "  margins      of the limits at which a step fails: {}\n",
                   margins(s.verdict));
    if (detail == Detail::solver)
        fmt::format_to(out, "  residuals    momentum {:.2e} (median {:.2e}), constraint {:.2e}\n",
                       s.momentum_residual_max, s.momentum_residual_median,
                       s.constraint_residual_max);
    fmt::format_to(out, "  violation    {} at {} ({:.4g} s)\n",
                   record::with_unit(s.violation_max, "m"), s.violation_where, s.violation_time);
    if (s.contacts_max > 0.0) print_friction(out, s, detail);
    print_degradations(out, s, detail);
    if (detail == Detail::solver && s.coupling.steps > 0) print_coupling(out, s);
    if (detail == Detail::solver && s.parts > 0)
        fmt::format_to(out,
                       "  groups       {} parts, checked every {} steps: regrouped {} times, {} "
                       "bodies moved\n",
                       s.parts, s.regroup_every, s.last.regroupings, s.last.regrouped_bodies);
    if (s.asleep_max > 0.0)
        fmt::format_to(out, "  asleep       {:.0f} bodies in the median step, at most {:.0f}\n",
                       s.asleep_median, s.asleep_max);
    out = fmt::format_to(out, "{}", to_text(s.verified, detail));
    if (s.sea.points > 0)
        fmt::format_to(out,
                       "  sea          velocities at {} points off by {:.1e} of the significant "
                       "{:.4g} m/s in the last step (at most {:.0e})\n",
                       s.sea.points, s.sea.error, s.sea.significant, s.sea.tolerance);
    if (s.stretch_error_max > 0.0)
        fmt::format_to(out, "  cable law    |l − l0 (1 + T/EA)| at most {:.2e} l0 ({:.4g} s)\n",
                       s.stretch_error_max, s.stretch_error_time);
    const double drift = s.energy_drift();
    fmt::format_to(out,
                   "  energy       {} changed by {}: applied {}, driven {}, lost by drag {}, "
                   "by damping {}, other {}",
                   record::with_unit(s.energy_start.mechanical(), "J"),
                   record::with_unit(s.energy_end.mechanical() - s.energy_start.mechanical(), "J"),
                   record::with_unit(s.energy_end.applied - s.energy_start.applied, "J"),
                   record::with_unit(s.energy_end.driven - s.energy_start.driven, "J"),
                   record::with_unit(s.energy_end.dissipated - s.energy_start.dissipated, "J"),
                   record::with_unit(s.energy_end.damped - s.energy_start.damped, "J"),
                   record::with_unit(drift, "J"));
    if (s.energy_end.edited != s.energy_start.edited)
        fmt::format_to(out, "; from edits of wires {}",
                       record::with_unit(s.energy_end.edited - s.energy_start.edited, "J"));
    if (s.energy_end.added != 0.0 || s.energy_end.system != 0.0)
        fmt::format_to(out, "; work of systems {}, energy of added mass {}",
                       record::with_unit(s.energy_end.system - s.energy_start.system, "J"),
                       record::with_unit(s.energy_end.added, "J"));
    if (s.energy_end.water != s.energy_start.water)
        fmt::format_to(out, "; work of water {}",
                       record::with_unit(s.energy_end.water - s.energy_start.water, "J"));
    // At rest no energy is exchanged, so a fraction of it is meaningless.
    if (s.energy_scale > 1e-6 * std::abs(s.energy_start.mechanical()))
        fmt::format_to(out, " ({:.2g} % of the exchanged energy)", 100.0 * drift / s.energy_scale);
    fmt::format_to(out, "\n");
}

void print_cables(Out out, const Summary& s) {
    // Pieces of cables that were cut have lines of their own: that of the cable is of all of them.
    std::vector<CableFigures> all = s.cables;
    for (const WireFigures& w : s.wires)
        if (w.is_cut_piece)
            all.push_back(
                {w.name, w.tension.least, w.tension.mean, w.tension.greatest, w.breaking_load});
    if (all.empty()) return;
    constexpr std::size_t kShown = 20;
    std::size_t width = 5;
    for (const CableFigures& c : all) width = std::max(width, c.name.size());
    fmt::format_to(out, "\n  {:<{}}  {:>10}  {:>10}  {:>10}  {:>10}\n", "cable", width, "min",
                   "mean", "max", "of break");
    for (std::size_t i = 0; i < std::min(kShown, all.size()); ++i) {
        const CableFigures& c = all[i];
        fmt::format_to(
            out, "  {:<{}}  {:>10}  {:>10}  {:>10}  {:>10}\n", c.name, width,
            record::with_unit(c.min, "N"), record::with_unit(c.mean, "N"),
            record::with_unit(c.max, "N"),
            c.breaking_load > 0.0 ? fmt::format("{:.3g} %", 100.0 * c.max / c.breaking_load) : "-");
    }
    if (all.size() > kShown)
        fmt::format_to(out, "  … and {} more (see --summary)\n", all.size() - kShown);
}

void print_bodies(Out out, const Summary& s) {
    if (s.bodies.empty()) return;
    constexpr std::size_t kShown = 12;
    std::size_t width = 5;
    for (const BodyFigures& b : s.bodies) width = std::max(width, b.name.size());
    fmt::format_to(out, "\n  {:<{}}  {:>14}  {:>10}  {:>10}\n", "body", width, "moved at most",
                   "tilt", "rotation");
    for (std::size_t i = 0; i < std::min(kShown, s.bodies.size()); ++i)
        fmt::format_to(out, "  {:<{}}  {:>14}  {:>6.3g} deg  {:>6.3g} deg\n", s.bodies[i].name,
                       width, record::with_unit(s.bodies[i].displacement, "m"), s.bodies[i].tilt,
                       s.bodies[i].rotation);
    if (s.bodies.size() > kShown)
        fmt::format_to(out, "  … and {} more (see --summary)\n", s.bodies.size() - kShown);
}

}  // namespace

std::string to_text(const verify::Verification& v, Detail detail) {
    if (v.steps == 0) return "";
    std::string text =
        detail == Detail::solver
            ? fmt::format(
                  "  verified     {} steps: natural map {:.2e} (differs by {:.2e}), momentum "
                  "of {} of {} bodies {:.2e}, bounds {:.2e}\n",
                  v.steps, v.natural_map, v.difference, v.covered_bodies, v.moving_bodies,
                  v.momentum, v.bounds)
            : fmt::format("  verified     {} steps, {} of {} bodies\n", v.steps, v.covered_bodies,
                          v.moving_bodies);
    text += fmt::format(
        "               of the failure limits: energy {:.2g} %, lost "
        "{:.2g} %, joints {:.2g} %, cable law {:.2g} %, turns {:.2g} %\n",
        100.0 * v.states.created, 100.0 * v.states.lost, 100.0 * v.states.open,
        100.0 * v.states.cable, 100.0 * v.states.turn);
    if (v.states.edited > 0.0)
        text += fmt::format(
            "               stretch from edits of wires {:.2g} % of the failure limit\n",
            100.0 * v.states.edited);
    if (v.sea > 0.0)
        text += fmt::format("               loads of the sea differ by {:.2e}\n", v.sea);
    return text;
}

std::string to_text(const Summary& s, Detail detail) {
    std::string text;
    const Out out = std::back_inserter(text);
    const bool doubtful = s.verdict.verdict.grade != Grade::good;
    fmt::format_to(out, "\n{} ({}), {}\n", s.scene, s.outcome,
                   !s.objection.empty()                      ? "not verified"
                   : doubtful && s.last.status == Status::ok ? to_string(s.verdict.verdict.grade)
                                                             : to_string(s.last.status));
    if (!s.objection.empty())
        fmt::format_to(out, "  not verified the step to {:.6g} s is wrong: {}\n", s.last.time,
                       s.objection);
    if (doubtful)
        fmt::format_to(out, "  {:<11}  {}\n", to_string(s.verdict.verdict.grade),
                       s.verdict.description);
    print_simulated(out, s);
    constexpr std::size_t kMaxWarnings = 5;
    for (std::size_t i = 0; i < std::min(kMaxWarnings, s.warnings.size()); ++i)
        fmt::format_to(out, "  warning      {}\n", s.warnings[i]);
    if (s.warnings.size() > kMaxWarnings)
        fmt::format_to(out, "  warning      and {} more of the start (see --summary)\n",
                       s.warnings.size() - kMaxWarnings);
    print_cables(out, s);
    print_bodies(out, s);
    text += event_lines(s);
    text += wire_lines(s.wires, s.broken_wires);
    fmt::format_to(out, "\n  system       {} bodies, {} interactions", s.last.bodies,
                   s.last.interactions);
    if (detail == Detail::solver)
        fmt::format_to(out,
                       ", {} equations, {} island{}\n  matrix       {} scalars, factor {}, {:.4g} "
                       "Mflop a factorisation",
                       s.last.equations, s.last.islands, s.last.islands == 1 ? "" : "s",
                       s.last.matrix_nnz, s.last.factor_nnz,
                       1e-6 * static_cast<double>(s.last.factor_flops));
    fmt::format_to(out, "\n");
    print_times(out, s, detail);
    print_quality(out, s, detail);
    fmt::format_to(out, "  state hash   {:016x}  (scene {:016x}, {}, {} thread{}, Hawser {})\n",
                   s.state_hash, s.scene_hash, instruction_set(), s.threads,
                   s.threads == 1 ? "" : "s", version());
    fmt::format_to(out, "  machine      {}, {} usable, load {:.2f} -> {:.2f}, peak memory {} MB\n",
                   record::processor_model(), record::processor_count(), s.load_start[0],
                   s.load_end[0], record::peak_memory() / 1000000);
    return text;
}

}  // namespace hawser::report
