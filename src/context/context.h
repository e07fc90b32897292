// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file context.h
/// Data that a step reads and writes, in three parts: Model, State and Work. The data headers
/// included here declare them. Headers of functions include this one.

#include <hawser/def.h>
#include <hawser/stats.h>

#include "assembly/loads.h"
#include "assembly/system.h"
#include "budget/budget.h"
#include "budget/coarsening.h"
#include "budget/cut_levels.h"
#include "budget/deadline.h"
#include "collide/collider.h"
#include "context/actors.h"
#include "context/completion_data.h"
#include "context/cuts_data.h"
#include "context/edit_list.h"
#include "context/events.h"
#include "context/impact_data.h"
#include "context/ledger.h"
#include "context/monitor_data.h"
#include "context/newton_data.h"
#include "context/regroup_data.h"
#include "context/sleep_data.h"
#include "context/undo_data.h"
#include "context/wires_data.h"
#include "graph/bridges.h"
#include "model/bodies.h"
#include "model/interactions.h"
#include "nonsmooth/anderson.h"
#include "nonsmooth/box.h"
#include "nonsmooth/gmres.h"
#include "nonsmooth/resistance.h"
#include "runtime/stopwatch.h"
#include "runtime/tasks.h"
#include "runtime/trace.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace hawser::context {

/// Model of a step, constant between two preparations of the system. Exception: bodies,
/// interactions, wires, cuts and groups contain parts of the state in their own arrays.
struct Model {
    WorldDef def;
    model::Bodies bodies;
    model::Interactions interactions;
    collide::Collider collider;
    assembly::System system;
    Cuts cuts;
    Regroup regroup;
    Wires wires;
    Completion completion;
    double contact_floor = 0.0;   ///< Impulse of a contact or line that does not count [N s].
    double scalar_floor = 0.0;    ///< The same of rows on scalar bodies, slides next to no mass.
    double residual_floor = 0.0;  ///< Denominator floor of the momentum residual.
};

/// State of a step in addition to Model. It has the data that a snapshot stores, a copy transfers
/// and a hash covers (src/world/saved_state.h). It also has results of the last step for readers
/// and for the next step.
struct State {
    double time = 0.0;
    std::int64_t step = 0;
    bool started = false;  ///< True if the staggered start has been made.
    /// Number of coming steps that refine before they measure. More than eight: the last step
    /// measured first and required refinement (solve.cpp).
    int refine_unasked = 0;
    Ledger ledger;
    assembly::LoadStore loads;
    MonitorData monitor;
    EventLog events;
    collide::ContactSet contacts;         ///< Contacts of the current or last step.
    base::Array<double> contact_impulse;  ///< 3 a contact: on side 1, world frame [N s]; or empty.
    base::Array<std::uint8_t> contact_sliding;  ///< 1 a contact: friction at its limit; or empty.
    /// Positions and rotations at the last analysis, which chose forms and floors by them.
    base::Array<double> analysed_x, analysed_r;
    Changed changed = Changed::all;
    Edits edits;
    PendingRepair repair = PendingRepair::nothing;  ///< Before the system may be used.
    Degradation imposed;                            ///< On the next step.
};

/// Stage whose time is counted, see timer.h.
struct StageClock {
    int current_stage = -1;  ///< −1: none.
    std::chrono::steady_clock::time_point stage_since{};
};

/// State that a solve overwrites, see remember.h; and poses to be restored (energy.cpp).
struct Before {
    bool remembered = false;            ///< True in a step after remember().
    std::vector<double> active;         ///< Statuses of bounded interactions, also for events.
    std::vector<double> lambda;         ///< Multipliers.
    std::vector<std::uint8_t> repeats;  ///< Interactions::repeats.
    int refine_unasked = 0;             ///< State::refine_unasked.
    std::vector<double> carriers;       ///< Poses of kinematic bodies, for the energy.
};

/// Stages assemble and factor.
struct SolveWork {
    bool rhs_ready = false;  ///< The solver's vector holds the right-hand side of the first solve.
    bool factor_whole = false;                ///< Never in part: for tests, to compare bits.
    std::vector<assembly::Norms> norms;       ///< One for each row block or group, merged in order.
    std::vector<double> losses;               ///< One for each row block, of row_losses().
    bool losses_known = false;                ///< True if they belong to the current λ and v₊.
    double step_work = 0.0, step_drag = 0.0;  ///< Work and drag of the current step [J].
    std::int64_t step_flops = 0;              ///< Flops of all factorisations of the step.
    std::vector<std::int32_t> columns;        ///< Nodes of blocks that contacts and rows change.
    std::vector<double> partial;              ///< Scratch of merged_over().
    std::vector<double> factored_active;      ///< By bounded row: `active` when last factored.
};

/// Change of the right-hand sides in an iteration at the end of the step.
struct IterationChange : assembly::Turning {
    /// Largest change of compliant joints, multiplied if it causes a large force [m/s or rad/s].
    double weighted = 0.0;
};

/// Joints completed and closed.
struct JointWork {
    std::vector<IterationChange> changes;  ///< One for each row block or group.
    std::vector<double> closing;           ///< Gaps of rows, a solution.
    std::vector<double> taken;             ///< By row: self-stress, see solve/self_stress.h.
    std::vector<std::pair<std::int32_t, std::int32_t>> edges;  ///< Bodies of each rigid joint.
    graph::LoopFinder loops;
};

/// Data for the limits of a step's cost: src/budget.
struct LimitWork {
    budget::Budget budget;
    budget::Deadline deadline;
    budget::CutLevels cut_levels;
    budget::Coarsening coarsening;
    budget::Laps laps;          ///< Laps of the current step, if a budget needs times.
    std::int64_t analyses = 0;  ///< StepStats::plans and repairs when the solver began.
    bool knew_levels = false;   ///< True if levels of cuts had been searched by then.
};

/// Scratch and statistics, by stage. Learned times are not part of the state.
struct Work {
    StepStats stats;
    StageClock clock;
    Before before;
    Undo undo;
    Sleep sleep;
    SolveWork solve;
    Newton newton;                      ///< Data of worlds with contacts or bounded rows.
    base::Array<double> contact_speed;  ///< u at the start of the step, as in Newton::x.
    ImpactWork impact;
    JointWork joints;
    WireWork wires;
    LimitWork limits;
    std::vector<std::uint8_t> edits_stay;  ///< By contact of the last step.
    /// Angles of spans on wheels before bodies moved (Interactions::wheel_angles()).
    std::vector<std::array<double, 2>> wheel_angles;
};

struct StepContext {
    explicit StepContext(const WorldDef& d) : pool(d.threads) {
        model.def = d;
        model.collider.margin = d.contact_margin;
        model.collider.most_contacts = d.max_contacts;
        model.collider.max_bytes = model.system.max_bytes = d.max_memory;
        // Both couple bodies outside the rows, which a sweep over rows does not treat.
        if (d.nonsmooth == Nonsmooth::pgs)
            model.def.geometric_stiffness = model.def.rotation_damping = 0.0;
        model.system.consistent_mass = d.nonsmooth != Nonsmooth::pgs;
    }

    Model model;
    State state;
    Work work;

    runtime::Pool pool;
    runtime::PoolStopwatch pool_stopwatch{pool};
    /// Stopwatch of the solver; tests set their own.
    runtime::Stopwatch* stopwatch = &pool_stopwatch;
    std::unique_ptr<runtime::Trace> trace;  ///< Activity of threads; null: not recorded.
    Actors* actors = nullptr;               ///< Systems of the world, if it has some.

    /// Chunks of bodies or interactions: coarse tasks of fixed size.
    static constexpr std::int32_t kChunk = 128;
    [[nodiscard]] static int chunks(std::int32_t count) noexcept {
        return (count + kChunk - 1) / kChunk;
    }
};

}  // namespace hawser::context
