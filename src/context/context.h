// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file context.h
/// Everything that a step reads and writes, in three parts: Model, State and Work. What they are
/// made of is told by the headers of data that this one includes; what is done with them by those
/// of functions, which include this one.

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

namespace hawser::stepper {

/// What a step is taken of: constant from one preparation of the system to the next, but for what
/// bodies, interactions, wires, cuts and groups carry of the state in arrays of their own.
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

/// What a step goes on from beside Model: what a snapshot holds, a copy takes and a hash is of
/// (src/world/saved_state.h), and what the last step left for readers and for the next one.
struct State {
    double time = 0.0;
    std::int64_t step = 0;
    bool started = false;  ///< The staggered start has been made.
    /// So many steps to come refine before they measure; more than eight: the last one was measured
    /// first and asked for it (solve.cpp).
    int refine_unasked = 0;
    Ledger ledger;
    LoadStore loads;
    JudgeData judge;
    EventLog events;
    collide::ContactSet contacts;         ///< Of the step being taken, or of the last one.
    base::Array<double> contact_impulse;  ///< 3 a contact: on side 1, world frame [N s]; or empty.
    base::Array<std::uint8_t> contact_sliding;  ///< 1 a contact: friction at its limit; or empty.
    /// Positions and rotations at the last analysis, which chose forms and floors by them.
    base::Array<double> analysed_x, analysed_r;
    Changed changed = Changed::all;
    Edits edits;
    Mend mend = Mend::nothing;  ///< Before the system may be used.
    Degradation imposed;        ///< On the next step.
};

/// Whose time is counted, see timer.h.
struct StageClock {
    int stage_now = -1;  ///< −1: no one's.
    std::chrono::steady_clock::time_point stage_since{};
};

/// What a solve overwrites of the state, see remember.h; and poses that come back (energy.cpp).
struct Before {
    bool remembered = false;            ///< In this step.
    std::vector<double> active;         ///< Of bounded interactions, for events as well.
    std::vector<double> lambda;         ///< Multipliers.
    std::vector<std::uint8_t> repeats;  ///< Interactions::repeats.
    int refine_unasked = 0;             ///< State::refine_unasked.
    std::vector<double> carriers;       ///< Poses of kinematic bodies, for the energy.
};

/// Stages assemble and factor.
struct SolveWork {
    bool rhs_ready = false;  ///< The solver's vector holds the right-hand side of the first solve.
    bool factor_whole = false;                ///< Never in part: for tests, to compare bits.
    std::vector<assembly::Norms> norms;       ///< One a strip or group, merged in order.
    std::vector<double> losses;               ///< One a strip, of row_losses().
    bool losses_known = false;                ///< They are those of λ and v₊ as they stand.
    double step_work = 0.0, step_drag = 0.0;  ///< Of the step being taken [J].
    std::int64_t step_flops = 0;              ///< Of all factorisations of the step.
    std::vector<std::int32_t> columns;        ///< Nodes of blocks that contacts and rows change.
    std::vector<double> partial;              ///< Of merged_over().
    std::vector<double> factored_active;      ///< By bounded row: `active` when last factored.
};

/// Joints completed and closed.
struct JointWork {
    std::vector<assembly::Turning> turnings;  ///< One a strip or group.
    std::vector<double> closing;              ///< Gaps of rows, a solution.
    std::vector<double> taken;                ///< By row: self-stress, see solve/self_stress.h.
    std::vector<std::pair<std::int32_t, std::int32_t>> edges;  ///< Bodies of each rigid joint.
    graph::LoopFinder loops;
};

/// What a step leaves out to end in time: src/budget.
struct LimitWork {
    Budget budget;
    Deadline deadline;
    CutLevels cut_levels;
    Coarsening coarsening;
    Laps laps;                  ///< Of the step being taken, where a budget asks for time.
    std::int64_t analyses = 0;  ///< StepStats::plans and repairs when the solver began.
    bool knew_levels = false;   ///< Levels of cuts had been looked for by then.
};

/// Scratch and statistics, by stage. What is learned of times is no part of the state either.
struct Work {
    StepStats stats;
    StageClock clock;
    Before before;
    Undo undo;
    Sleep sleep;
    SolveWork solve;
    Newton newton;                      ///< Of a world in which something may touch.
    base::Array<double> contact_speed;  ///< u where the step began, as in Newton::x.
    JointWork joints;
    WireWork wires;
    LimitWork limits;
    std::vector<std::uint8_t> edits_stay;  ///< By contact of the last step.
    /// Of spans on wheels, before bodies moved (Interactions::wheel_angles()).
    std::vector<std::array<double, 2>> wheel_angles;
};

struct StepContext {
    explicit StepContext(const WorldDef& d) : pool(d.threads) {
        model.def = d;
        model.collider.margin = d.contact_margin;
        model.collider.most_contacts = d.max_contacts;
        model.collider.most_bytes = model.system.most_bytes = d.max_memory;
        // They couple bodies beside the rows, which a sweep over rows does not see.
        if (d.nonsmooth == Nonsmooth::pgs)
            model.def.geometric_stiffness = model.def.rotation_damping = 0.0;
        model.system.consistent_mass = d.nonsmooth != Nonsmooth::pgs;
    }

    Model model;
    State state;
    Work work;

    runtime::Pool pool;
    runtime::PoolStopwatch pool_stopwatch{pool};
    runtime::Stopwatch* stopwatch = &pool_stopwatch;  ///< Of the solver; tests put their own.
    std::unique_ptr<runtime::Trace> trace;            ///< What threads do; none: not written down.
    Actors* actors = nullptr;                         ///< Systems of the world, if it has some.

    /// Chunks of bodies or interactions: coarse tasks of fixed size.
    static constexpr std::int32_t kChunk = 128;
    [[nodiscard]] static int chunks(std::int32_t count) noexcept {
        return (count + kChunk - 1) / kChunk;
    }
};

}  // namespace hawser::stepper
