// SPDX-License-Identifier: Apache-2.0
#include "report/summary.h"

#include "record/event_input.h"
#include "record/host.h"
#include "record/series.h"

#include <hawser/limits.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>

namespace hawser::report {

namespace {

std::string event_location(const World& world, const Event& event) {
    std::string input = record::input_label(world, event);
    return input.empty() ? record::position_label(world, event.interaction, event.body) : input;
}

constexpr double kMilliseconds = 1e3;

Spread spread(const Samples& samples) {
    return {samples.median(), samples.quantile(0.90), samples.quantile(0.95),
            samples.quantile(0.99), samples.max()};
}

}  // namespace

double energy_drift(const Energy& from, const Energy& to) noexcept {
    const auto gained = [](const Energy& e) {
        return e.mechanical() - e.applied - e.driven - e.edited - e.system + e.dissipated +
               e.friction + e.contact + e.damped;
    };
    return gained(to) - gained(from);
}

double Summary::energy_drift() const noexcept {
    return report::energy_drift(energy_start, energy_end);
}

SummaryCollector::SummaryCollector(const record::SceneInfo& scene, const World& world)
    : scene_(scene), wires_(world), bodies_(record::watched_bodies(scene, world)) {
    summary_.scene = scene.name;
    summary_.scene_path = scene.path;
    summary_.scene_hash = scene.hash;
    summary_.start_time = world.time();
    summary_.step = world.settings().step;
    summary_.form = world.settings().form;
    if (world.settings().coupling != Coupling::exact) summary_.parts = world.settings().parts;
    summary_.regroup_every = world.settings().regroup_every;
    summary_.threads = world.settings().threads;
    summary_.budget_ms = kMilliseconds * world.settings().budget;
    summary_.budget_mflop = 1e-6 * world.settings().budget_work;
    summary_.load_start = record::load_average();
    for (const record::CableInfo& cable : scene.cables) {
        summary_.cables.push_back({cable.name, HUGE_VAL, 0.0, -HUGE_VAL, cable.breaking_load});
        tensions_.push_back({world.wires().find(cable.name)});
    }
    for (const BodyId body : bodies_) {
        summary_.bodies.push_back({.name = record::body_label(world, body)});
        first_pose_.push_back(world.pose(body));
    }
    completion_failures_ = world.stats().completion_failures;
}

void SummaryCollector::after_step(const World& world, std::span<const Event> events) {
    const StepStats& stats = world.stats();
    ++summary_.steps;
    momentum_.add(stats.momentum_residual);
    constraint_.add(stats.constraint_residual);
    if (stats.violation_max > summary_.violation_max) {
        summary_.violation_max = stats.violation_max;
        summary_.violation_where = record::interaction_label(world, stats.violation_worst);
        summary_.violation_time = stats.time;
    }
    if (stats.stretch_error_max > summary_.stretch_error_max) {
        summary_.stretch_error_max = stats.stretch_error_max;
        summary_.stretch_error_time = stats.time;
    }
    if (const double analyse = stats.stage_seconds[static_cast<std::size_t>(Stage::analyse)];
        analyse > 0.0) {
        ++summary_.analyses;
        summary_.analyse_ms_max = std::max(summary_.analyse_ms_max, kMilliseconds * analyse);
    }
    if (summary_.steps > kWarmUpSteps) {
        step_.add(kMilliseconds * stats.step_seconds);
        solver_.add(kMilliseconds * stats.solver_seconds);
        solver_cpu_.add(kMilliseconds * stats.solver_cpu_seconds);
        factorisations_.add(stats.factorisations);
        within_budget_ += stats.solver_cpu_seconds <= world.settings().budget ? 1 : 0;
        for (std::size_t s = 0; s < stage_.size(); ++s)
            stage_[s].add(kMilliseconds * stats.stage_seconds[s]);
    }
    for (const Event& event : events) {
        const bool line = event.kind == EventKind::slack || event.kind == EventKind::taut;
        if (listed_[line ? 0 : 1]++ < kListedEvents)
            summary_.events.push_back(
                {event.time, to_string(event.kind), event_location(world, event), event.value});
    }
    summary_.degradations.after_step(stats);
    watch_joints(world);
    watch_contacts(world);
    watch_cables(world);
    wires_.after_step(world, events);
    watch_bodies(world);
    watch_energy(world);
}

void SummaryCollector::add_operation(double time, std::string what) {
    ListedEvent done{time, kTimelineEvent, std::move(what), 0.0};
    // Insert it before the events of the step that followed.
    auto at = summary_.events.end();
    while (at != summary_.events.begin() && std::prev(at)->time > time) --at;
    summary_.events.insert(at, std::move(done));
}

/// Update the fraction of recent steps with failed iterations of rigid joints.
void SummaryCollector::watch_joints(const World& world) {
    const StepStats& stats = world.stats();
    const bool failed = stats.completion_failures > completion_failures_;
    completion_failures_ = stats.completion_failures;
    const double fresh = std::min(1.0, world.settings().step / limit::kMemory);
    incomplete_ += fresh * ((failed ? 1.0 : 0.0) - incomplete_);
    if (incomplete_ <= summary_.incomplete) return;
    summary_.incomplete = incomplete_;
    summary_.incomplete_time = stats.time;
}

void SummaryCollector::watch_contacts(const World& world) {
    const StepStats& stats = world.stats();
    contacts_.add(stats.contacts);
    asleep_.add(stats.asleep);
    interactions_.add(stats.interactions + stats.contacts);
    equations_.add(stats.equations + 3.0 * stats.contacts);
    if (stats.contacts == 0 && stats.natural_map == 0.0 && stats.flips_left == 0) return;
    FrictionFigures& f = summary_.friction;
    ++f.steps;
    map_.add(stats.natural_map);
    work_.add(stats.factor_work);
    f.flips_left = std::max(f.flips_left, stats.flips_left);
    const bool solved =
        stats.natural_map <= world.settings().contact_tolerance && stats.flips_left == 0;
    f.uncertified_steps += solved ? 0 : 1;
    f.cut_steps += stats.cut ? 1 : 0;
    if (stats.cut) cut_.add(stats.natural_map);
}

void SummaryCollector::watch_cables(const World& world) {
    for (std::size_t c = 0; c < scene_.cables.size(); ++c) {
        CableFigures& figures = summary_.cables[c];
        Tensions& all = tensions_[c];
        // Elements of a wire are added and removed with its nodes; links of a chain belong to no
        // wire.
        std::span<const InteractionId> elements = scene_.cables[c].elements;
        if (world.alive(all.wire)) elements = world.wires().elements(all.wire);
        for (const InteractionId element : elements) {
            if (!world.alive(element)) continue;
            const double tension = record::element_tension(world, element);
            figures.min = std::min(figures.min, tension);
            figures.max = std::max(figures.max, tension);
            all.sum += tension;
            ++all.count;
        }
    }
}

void SummaryCollector::watch_bodies(const World& world) {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const Pose pose = world.pose(bodies_[i]);
        const Pose& first = first_pose_[i];
        BodyFigures& figures = summary_.bodies[i];
        figures.displacement =
            std::max(figures.displacement, (pose.position - first.position).norm());
        const Vec3 z0 = first.orientation * Vec3::UnitZ(), z = pose.orientation * Vec3::UnitZ();
        figures.tilt =
            std::max(figures.tilt, record::kDegrees * std::atan2(z0.cross(z).norm(), z0.dot(z)));
        figures.rotation =
            std::max(figures.rotation,
                     record::kDegrees * first.orientation.angularDistance(pose.orientation));
    }
}

// The first step gives the reference, because no half-step position exists before it.
void SummaryCollector::watch_energy(const World& world) {
    const Energy energy = world.energy();
    const double potential = energy.gravity + energy.elastic;
    if (summary_.steps == 1) {
        summary_.energy_start = energy;
        potential_low_ = potential_high_ = potential;
    } else {
        step_drift_.add(std::abs(energy_drift(summary_.energy_end, energy)));
    }
    summary_.energy_end = energy;
    kinetic_max_ = std::max(kinetic_max_, energy.kinetic);
    potential_low_ = std::min(potential_low_, potential);
    potential_high_ = std::max(potential_high_, potential);
}

void SummaryCollector::add_step_cpu(double seconds) {
    if (summary_.steps > kWarmUpSteps) step_cpu_.add(kMilliseconds * seconds);
}

Summary SummaryCollector::result(const World& world) const {
    Summary out = summary_;
    out.last = world.stats();
    out.happened = event_figures(world);
    out.verdict = verdict_in_words(world, world.verdict());
    out.sea = sea_accuracy(world);
    if (out.incomplete > limit::kIncomplete && out.verdict.verdict.grade == Grade::good) {
        out.verdict.verdict.grade = Grade::doubtful;
        out.verdict.verdict.judge = Judge::certificate;
        out.verdict.description = fmt::format(
            "joints were solved approximately in {:.2g} % of the steps of {:.0f} s before {:.6g} "
            "s; use a smaller step (settings.step), or fewer redundant joints",
            100.0 * out.incomplete, limit::kMemory, out.incomplete_time);
    }
    out.timed_steps = step_.count();
    out.step_ms = spread(step_);
    out.solver_ms = spread(solver_);
    out.solver_cpu_ms = spread(solver_cpu_);
    out.step_cpu_ms = spread(step_cpu_);
    out.factorisations = spread(factorisations_);
    for (std::size_t s = 0; s < stage_.size(); ++s) out.stage_ms[s] = stage_[s].median();
    out.momentum_residual_max = momentum_.max();
    out.momentum_residual_median = momentum_.median();
    out.constraint_residual_max = constraint_.max();
    out.constraint_residual_median = constraint_.median();
    out.contacts_median = contacts_.median();
    out.contacts_max = contacts_.max();
    out.asleep_median = asleep_.median();
    out.asleep_max = asleep_.max();
    out.interactions = spread(interactions_);
    out.equations = spread(equations_);
    out.friction.natural_map = spread(map_);
    out.friction.factorisations = spread(work_);
    out.friction.cut_residual = spread(cut_);
    out.energy_step_drift = spread(step_drift_);
    if (out.timed_steps > 0)
        out.within_budget =
            static_cast<double>(within_budget_) / static_cast<double>(out.timed_steps);
    // Potential energy has no natural zero, so the exchanged energy of the run is the scale.
    out.energy_scale = std::max(kinetic_max_, potential_high_ - potential_low_);
    for (std::size_t c = 0; c < out.cables.size(); ++c) {
        if (tensions_[c].count > 0)
            out.cables[c].mean = tensions_[c].sum / static_cast<double>(tensions_[c].count);
        else
            out.cables[c].min = out.cables[c].max = 0.0;
    }
    out.wires = wires_.result(world);
    out.broken_wires = wires_.broken_wires();
    out.state_hash = world.state().hash();
    out.load_end = record::load_average();
    out.world_memory = world.solver().memory_bytes();
    return out;
}

}  // namespace hawser::report
