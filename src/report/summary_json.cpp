// SPDX-License-Identifier: Apache-2.0
#include "record/host.h"
#include "report/summary.h"
#include "report/wires_json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace hawser::report {

namespace {

using Json = nlohmann::ordered_json;

const char* form_name(Form form) {
    switch (form) {
        case Form::saddle:
            return "saddle";
        case Form::condensed:
            return "condensed";
        case Form::automatic:
            break;
    }
    return "auto";
}

Json spread_json(const Spread& s) {
    return {{"median", s.median}, {"p95", s.p95}, {"p99", s.p99}, {"max", s.max}};
}

Json friction_json(const FrictionFigures& f) {
    const Spread &map = f.natural_map, &work = f.factorisations;
    return {{"steps", f.steps},
            {"natural_map", {{"p50", map.median}, {"p95", map.p95}, {"max", map.max}}},
            {"factorisations", {{"median", work.median}, {"p90", work.p90}, {"max", work.max}}},
            {"flips_left", f.flips_left},
            {"uncertified_steps", f.uncertified_steps}};
}

Json budget_json(const Summary& s) {
    const FrictionFigures& f = s.friction;
    const auto limit = [](double value) { return value > 0.0 ? Json(value) : Json(); };
    return {{"ms", limit(s.budget_ms)},
            {"mflop", limit(s.budget_mflop)},
            {"cut_steps", f.cut_steps},
            {"residual", {{"p50", f.cut_residual.median}, {"max", f.cut_residual.max}}},
            {"within", s.budget_ms > 0.0 ? Json(s.within_budget) : Json()}};
}

Json degraded_span_json(const DegradedSpan& d) {
    if (d.steps == 0) return {{"steps", 0}};
    return {{"steps", d.steps},
            {"first_step", d.first},
            {"last_step", d.last},
            {"time", {{"start", d.begin}, {"end", d.end}}},
            {"iterations", d.iterations > 0 ? Json(d.iterations) : Json()},
            {"wires", d.wires},
            {"interfaces", d.interfaces},
            {"momentum_defect_max", d.momentum_defect},
            {"cut_defect_max", d.cut_defect},
            {"foreseen_ms", d.foreseen > 0.0 ? Json(1e3 * d.foreseen) : Json()},
            {"residual_max", d.residual},
            {"cause", to_string(d.cause)}};
}

Json degradations_json(const Summary& s) {
    const Degradations& d = s.degradations;
    Json causes = Json::object(), list = Json::array();
    for (int k = 1; k < kDegradedByCount; ++k)
        causes[to_string(static_cast<DegradedBy>(k))] = d.by_cause[static_cast<std::size_t>(k)];
    for (const DegradedSpan& span : d.list) list.push_back(degraded_span_json(span));
    return {{"steps", d.all.steps},
            {"causes", causes},
            {"wires", degraded_span_json(d.wires)},
            {"friction", degraded_span_json(d.friction)},
            {"coupling", degraded_span_json(d.coupling)},
            {"spans", d.spans},
            {"list", list}};
}

Json coupling_json(const Summary& s) {
    const verify::CouplingFigures& c = s.coupling;
    return {{"coupling", verify::to_string(c.coupling)},
            {"predictor", verify::to_string(c.predictor)},
            {"cuts", c.cuts},
            {"islands", s.last.islands},
            {"steps", c.steps},
            {"interface_residual_max", c.residual_max},
            {"momentum_defect", {{"rms", c.defect_rms}, {"max", c.defect_max}}},
            {"jerk_max", {{"split", c.jerk_max}, {"exact", c.jerk_exact_max}}},
            {"jerk_difference_max", c.jerk_difference_max},
            {"tension_error", {{"rms", c.tension_error_rms}, {"max", c.tension_error_max}}},
            {"spectral_radius", c.spectral_radius}};
}

Json energy(const Energy& e) {
    return {{"mechanical", e.mechanical()},
            {"kinetic", e.kinetic},
            {"added", e.added},
            {"gravity", e.gravity},
            {"elastic", e.elastic}};
}

/// Return the error of the wave kinematics in single precision; null if no wave was summed in
/// single precision.
Json sea_figures(const SeaAccuracy& sea) {
    if (sea.points == 0) return {};
    return {{"significant_velocity", sea.significant},
            {"error", sea.error},
            {"tolerance", sea.tolerance},
            {"points", sea.points}};
}

Json energy_balance(const Summary& s) {
    const double drift = s.energy_drift();
    return {{"start", energy(s.energy_start)},
            {"end", energy(s.energy_end)},
            {"applied", s.energy_end.applied - s.energy_start.applied},
            {"driven", s.energy_end.driven - s.energy_start.driven},
            {"edited", s.energy_end.edited - s.energy_start.edited},
            {"dissipated", s.energy_end.dissipated - s.energy_start.dissipated},
            {"friction", s.energy_end.friction - s.energy_start.friction},
            {"contact", s.energy_end.contact - s.energy_start.contact},
            {"damped", s.energy_end.damped - s.energy_start.damped},
            {"system", s.energy_end.system - s.energy_start.system},
            {"water", s.energy_end.water - s.energy_start.water},
            {"drift", drift},
            {"step_drift",
             {{"median", s.energy_step_drift.median},
              {"p95", s.energy_step_drift.p95},
              {"max", s.energy_step_drift.max}}},
            {"scale", s.energy_scale},
            {"drift_relative", s.energy_scale > 0.0 ? Json(drift / s.energy_scale) : Json()}};
}

Json cables_json(const Summary& s) {
    Json out = Json::object();
    for (const CableFigures& c : s.cables)
        out[c.name] = {{"min", c.min},
                       {"mean", c.mean},
                       {"max", c.max},
                       {"breaking_load", c.breaking_load > 0.0 ? Json(c.breaking_load) : Json()},
                       {"fraction_of_breaking_load",
                        c.breaking_load > 0.0 ? Json(c.max / c.breaking_load) : Json()}};
    return out;
}

Json bodies_json(const Summary& s) {
    Json out = Json::object();
    for (const BodyFigures& b : s.bodies)
        out[b.name] = {{"displacement_max", b.displacement},
                       {"tilt_max_deg", b.tilt},
                       {"rotation_max_deg", b.rotation}};
    return out;
}

Json verdict_json(const VerdictText& text) {
    const auto number = [](double x) { return std::isfinite(x) ? Json(x) : Json(); };
    Json margins = Json::object();
    for (std::size_t k = 0; k < kJudgeCount; ++k) {
        const Finding& f = text.verdict.worst[k];
        margins[to_string(static_cast<Judge>(k))] = {{"value", number(f.value)},
                                                     {"of_doubtful", number(f.doubtful)},
                                                     {"of_wrong", number(f.wrong)},
                                                     {"time", f.time},
                                                     {"where", text.where[k]}};
    }
    return {
        {"grade", to_string(text.verdict.grade)}, {"said", text.description}, {"margins", margins}};
}

Json event_counts(const Summary& s) {
    Json out = Json::object();
    for (int k = 0; k < kEventKindCount; ++k)
        out[to_string(static_cast<EventKind>(k))] = s.last.event_count[static_cast<std::size_t>(k)];
    return out;
}

Json event_extremes(const Summary& s) {
    Json out = Json::object();
    const auto one = [](const ListedEvent& e) {
        return Json{{"time", e.time}, {"where", e.where}, {"value", e.value}};
    };
    for (const EventFigures& e : s.happened)
        out[to_string(e.kind)] = {
            {"count", e.count}, {"unit", e.unit}, {"first", one(e.first)}, {"worst", one(e.worst)}};
    return out;
}

Json event_list(const Summary& s) {
    Json out = Json::array();
    for (const ListedEvent& e : s.events)
        out.push_back({{"time", e.time}, {"kind", e.kind}, {"where", e.where}, {"value", e.value}});
    return out;
}

Json sizes_json(const Summary& s) {
    const StepStats& last = s.last;
    return {{"bodies", last.bodies},
            {"interactions", last.interactions},
            {"equations", last.equations},
            {"interactions_with_contacts",
             {{"median", s.interactions.median}, {"max", s.interactions.max}}},
            {"equations_with_contacts", {{"median", s.equations.median}, {"max", s.equations.max}}},
            {"islands", last.islands},
            {"asleep", {{"median", s.asleep_median}, {"max", s.asleep_max}}},
            {"contacts", {{"median", s.contacts_median}, {"max", s.contacts_max}}},
            {"nnz", {{"matrix", last.matrix_nnz}, {"factor", last.factor_nnz}}},
            {"flops", last.factor_flops}};
}

Json times_json(const Summary& s) {
    Json stages = Json::object();
    for (int k = 0; k < kStageCount; ++k)
        stages[to_string(static_cast<Stage>(k))] = s.stage_ms[static_cast<std::size_t>(k)];
    return {{"timed_steps", s.timed_steps},
            {"step_ms", spread_json(s.step_ms)},
            {"solver_ms", spread_json(s.solver_ms)},
            {"solver_cpu_ms", spread_json(s.solver_cpu_ms)},
            {"step_cpu_ms", spread_json(s.step_cpu_ms)},
            {"factorisations", spread_json(s.factorisations)},
            {"stage_ms", stages},
            {"analyses",
             {{"steps", s.analyses},
              {"ms_max", s.analyse_ms_max},
              {"plans", s.last.plans},
              {"repairs", s.last.repairs},
              {"columns_repaired", s.last.columns_repaired}}}};
}

Json machine_json(const Summary& s) {
    return {{"threads", s.threads},
            {"instruction_set", instruction_set()},
            {"processor", record::processor_model()},
            {"processors", record::processor_count()},
            {"load_average", {{"start", s.load_start}, {"end", s.load_end}}},
            {"version", version()},
            {"peak_memory_bytes", record::peak_memory()},
            {"world_memory_bytes", s.world_memory}};
}

}  // namespace

std::string to_json(const Summary& s) {
    Json out{{"scene", s.scene},
             {"scene_file", s.scene_path},
             {"scene_hash", fmt::format("{:016x}", s.scene_hash)},
             {"outcome", s.outcome},
             {"status", to_string(s.last.status)},
             {"verdict", verdict_json(s.verdict)}};
    out.update(sizes_json(s));
    out.update(Json{{"steps", s.steps},
                    {"step", s.step},
                    {"form", form_name(s.form)},
                    {"time", {{"start", s.start_time}, {"end", s.last.time}}},
                    {"wall_seconds", s.wall_seconds}});
    out.update(times_json(s));
    if (s.budget_ms > 0.0 || s.budget_mflop > 0.0)
        out.update(Json{{"budget", budget_json(s)}, {"degradations", degradations_json(s)}});
    if (s.coupling.steps > 0) out["coupling"] = coupling_json(s);
    if (s.parts > 0)
        out["groups"] = {{"parts", s.parts},
                         {"regroup_every", s.regroup_every},
                         {"regroupings", s.last.regroupings},
                         {"bodies_moved", s.last.regrouped_bodies}};
    out["friction"] = friction_json(s.friction);
    if (const verify::Verification& v = s.verified; v.steps > 0)
        out["verified"] = {{"objection", s.objection},
                           {"verified_steps", v.steps},
                           {"natural_map", v.natural_map},
                           {"largest_disagreement", v.difference},
                           {"momentum", v.momentum},
                           {"bounds", v.bounds},
                           {"sea", v.sea},
                           {"states",
                            {{"created", v.states.created},
                             {"open", v.states.open},
                             {"cable_law", v.states.cable},
                             {"turn", v.states.turn}}},
                           {"covered_bodies", v.covered_bodies},
                           {"moving_bodies", v.moving_bodies}};
    out.update(Json{
        {"residuals",
         {{"momentum", {{"max", s.momentum_residual_max}, {"median", s.momentum_residual_median}}},
          {"constraint",
           {{"max", s.constraint_residual_max}, {"median", s.constraint_residual_median}}}}},
        {"violation_max", s.violation_max},
        {"violation_where", s.violation_where},
        {"violation_time", s.violation_time},
        {"stretch_error_max", s.stretch_error_max},
        {"stretch_error_time", s.stretch_error_time},
        {"sea", sea_figures(s.sea)},
        {"energy", energy_balance(s)},
        {"event_counts", event_counts(s)},
        {"event_extremes", event_extremes(s)},
        {"start_warnings", s.warnings},
        {"events", event_list(s)},
        {"parted", broken_json(s.broken_wires)},
        {"wires", wires_json(s.wires)},
        {"tensions", cables_json(s)},
        {"motions", bodies_json(s)},
        {"growths", s.last.growths},
        {"state_hash", fmt::format("{:016x}", s.state_hash)}});
    if (s.missed_frames >= 0)
        out["realtime"] = {{"missed_frames", s.missed_frames}, {"lateness_max", s.lateness_max}};
    out.update(machine_json(s));
    // Names in scenes are UTF-8 already; replace rather than throw if one is not.
    return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace hawser::report
