// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file summary.h
/// Collects the figures of a run step by step and writes them as JSON (docs/cli.md).

#include "record/scene_info.h"
#include "report/degradations.h"
#include "report/samples.h"
#include "report/verdict_text.h"
#include "report/wires.h"
#include "verify/certificate.h"
#include "verify/coupling.h"

#include <hawser/hawser.h>
#include <hawser/observer.h>
#include <hawser/sea_accuracy.h>

#include <array>
#include <span>
#include <string>
#include <vector>

namespace hawser::report {

/// Number of steps whose times are not counted, because caches, branch predictors and clocks are
/// cold.
inline constexpr std::int64_t kWarmUpSteps = 60;
/// Number of listed events: of lines that become slack or taut, and of all others.
inline constexpr std::size_t kListedEvents = 100;
/// ListedEvent::kind of operations of the scene's timeline.
inline constexpr const char* kTimelineEvent = "timeline";

struct Spread {
    double median = 0.0, p90 = 0.0, p95 = 0.0, p99 = 0.0, max = 0.0;
};

/// The solve for contacts, over the steps in which there were any.
struct FrictionFigures {
    std::int64_t steps = 0;              ///< With contacts, or with a residual.
    Spread natural_map, factorisations;  ///< See StepStats::natural_map, factor_work.
    std::int32_t flips_left = 0;         ///< Largest of a step.
    /// Steps with a residual above WorldDef::contact_tolerance, or with undecided rows and
    /// contacts.
    std::int64_t uncertified_steps = 0;
    std::int64_t cut_steps = 0;  ///< Steps ended by a budget.
    Spread cut_residual;         ///< Natural map of these steps.
};

struct CableFigures {
    std::string name;
    double min = 0.0, mean = 0.0, max = 0.0;  ///< Over elements and steps [N].
    double breaking_load = 0.0;               ///< [N]; 0 = not given.
};

struct BodyFigures {
    std::string name;
    double displacement = 0.0;  ///< Largest distance from the first pose [m].
    double tilt = 0.0;          ///< Largest angle between its z axis then and at first [deg].
    double rotation = 0.0;      ///< Largest angle of rotation from the first pose [deg].
};

struct ListedEvent {
    double time = 0.0;
    std::string kind, where;
    double value = 0.0;
    std::string note{};  ///< Addition to the value in texts; see record::describe_breaking().
};

/// Events of one kind over the run.
struct EventFigures {
    EventKind kind = EventKind::warning;
    std::int64_t count = 0;
    ListedEvent first, worst;  ///< Position in words.
    const char* unit = "";     ///< Unit of the values.
    bool vessels = false;      ///< True if events of kind saturation include actuators of vessels.
    /// True if the first or worst event (render, join, detach) is that of an anchor.
    bool anchors = false;
};

struct Summary {
    std::string scene, scene_path;
    std::uint64_t scene_hash = 0;
    std::string outcome = "finished";  ///< "finished", "interrupted" or "failed".
    StepStats last{};                  ///< Statistics of the last step.
    VerdictText verdict;               ///< Result for all states.
    double start_time = 0.0;           ///< [s]
    std::int64_t steps = 0;            ///< In this run.
    std::int64_t timed_steps = 0;      ///< Steps counted in the times below.
    double step = 0.0;                 ///< Time step [s].
    Form form = Form::automatic;
    double contacts_median = 0.0, contacts_max = 0.0;  ///< Contact points of a step.
    double asleep_median = 0.0, asleep_max = 0.0;      ///< Bodies of a step.
    FrictionFigures friction;
    Spread interactions, equations;  ///< Per step, with contact points and their rows.
    /// step_cpu_ms: CPU time of the stepping thread, if add_step_cpu() was called.
    Spread step_ms, solver_ms, solver_cpu_ms, step_cpu_ms;
    Spread factorisations;                       ///< Per timed step.
    double budget_ms = 0.0, budget_mflop = 0.0;  ///< 0: none.
    Degradations degradations;
    verify::Verification verified;     ///< With --verify; no steps without.
    std::string objection;             ///< Objection of --verify to the last step; empty: none.
    verify::CouplingFigures coupling;  ///< Figures of a split; no steps otherwise.
    int parts = 0;                     ///< WorldDef::parts if coupling is not exact, else 0.
    int regroup_every = 0;             ///< WorldDef::regroup_every [steps].
    double within_budget = 1.0;        ///< Fraction of timed steps with solver_cpu_ms ≤.
    std::array<double, kStageCount> stage_ms{};  ///< Medians.
    std::int64_t analyses = 0;                   ///< Steps of this run, of all, with one.
    double analyse_ms_max = 0.0;                 ///< Longest of these.
    double momentum_residual_max = 0.0, momentum_residual_median = 0.0;
    double constraint_residual_max = 0.0, constraint_residual_median = 0.0;
    double violation_max = 0.0;  ///< [m]
    std::string violation_where = "-";
    double violation_time = 0.0;      ///< [s]
    double stretch_error_max = 0.0;   ///< Relative.
    double stretch_error_time = 0.0;  ///< [s]
    /// Largest fraction of the steps of limit::kMemory with failed iterations of rigid joints.
    double incomplete = 0.0;
    double incomplete_time = 0.0;  ///< [s]
    Energy energy_start, energy_end;
    SeaAccuracy sea;            ///< Accuracy of the last step.
    double energy_scale = 0.0;  ///< Scale of the drift [J].
    Spread energy_step_drift;   ///< |Drift| of a single step [J].
    /// Events in the order of occurrence, with all operations of the timeline as `timeline`.
    std::vector<ListedEvent> events;
    std::vector<EventFigures> happened;  ///< Kinds that occurred, the most important first.
    std::vector<std::string> warnings;   ///< Warnings of the start, in words.
    std::vector<CableFigures> cables;
    std::vector<WireFigures> wires;
    std::vector<BrokenWire> broken_wires;  ///< The first ones, in order.
    std::vector<BodyFigures> bodies;
    std::uint64_t state_hash = 0;
    int threads = 1;
    double wall_seconds = 0.0;
    std::array<double, 3> load_start{}, load_end{};
    std::size_t world_memory = 0;     ///< Memory of state and solver [bytes].
    std::int64_t missed_frames = -1;  ///< With --realtime; −1 without.
    double lateness_max = 0.0;        ///< With --realtime [s].

    /// Return energy_drift(from, to) [J].
    [[nodiscard]] double energy_drift() const noexcept;
};

/// Return the change of mechanical energy that applied and driven work, drag and contacts do not
/// explain [J].
[[nodiscard]] double energy_drift(const Energy& from, const Energy& to) noexcept;

/// Watches a run. Costs O(elements) a step.
class SummaryCollector : public Observer {
  public:
    SummaryCollector(const record::SceneInfo& scene, const World& world);
    /// Record a step and its events. Call after each step.
    void after_step(const World& world, std::span<const Event> events) override;
    /// Add the CPU time Session::step_cpu_seconds() of the step that after_step() recorded last.
    void add_step_cpu(double seconds);
    /// Add an operation of the timeline, in words. Call before after_step() of its step.
    /// @param time  Time at which it was due [s].
    void add_operation(double time, std::string what);
    /// Return the summary of the steps until now.
    [[nodiscard]] Summary result(const World& world) const;

  private:
    void watch_cables(const World& world);
    void watch_bodies(const World& world);
    void watch_energy(const World& world);
    void watch_contacts(const World& world);
    void watch_joints(const World& world);

    const record::SceneInfo& scene_;
    Summary summary_;
    WireWatch wires_;
    std::int64_t completion_failures_ = 0;  ///< StepStats of the last step.
    double incomplete_ = 0.0;               ///< See Summary::incomplete.
    std::vector<Pose> first_pose_;
    std::vector<BodyId> bodies_;
    /// Sums for the mean of a cable.
    struct Tensions {
        WireId wire{};  ///< Invalid for a chain of links.
        double sum = 0.0;
        std::int64_t count = 0;
    };
    std::vector<Tensions> tensions_;
    Samples step_, solver_, solver_cpu_, step_cpu_, factorisations_, momentum_, constraint_,
        contacts_, asleep_;
    Samples map_, work_, cut_, step_drift_, interactions_, equations_;
    std::int64_t within_budget_ = 0;
    std::array<std::size_t, 2> listed_{};  ///< Events of lines slack or taut; of all others.
    std::array<Samples, kStageCount> stage_{};
    double kinetic_max_ = 0.0, potential_low_ = 0.0, potential_high_ = 0.0;
};

[[nodiscard]] std::string to_json(const Summary& summary);

/// Figures of a report: those for users, or also those of the solver (option --verbose).
enum class Detail : std::uint8_t { user, solver };

/// Return a page of text for the end of a run: figures for users first, the solver last.
[[nodiscard]] std::string to_text(const Summary& summary, Detail detail);

/// Return the lines about --verify; "" without a verified step.
[[nodiscard]] std::string to_text(const verify::Verification& verified, Detail detail);

/// Return the first and worst event of each kind in the world (event_figures.cpp).
[[nodiscard]] std::vector<EventFigures> event_figures(const World& world);
/// Return the lines of a report about the events.
[[nodiscard]] std::string event_lines(const Summary& summary);

}  // namespace hawser::report
