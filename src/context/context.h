// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file context.h
/// Everything that a step reads and writes. What its parts are is told by the headers of data that
/// it includes; what is done with them by those of functions, which include this one.

#include <hawser/def.h>
#include <hawser/stats.h>

#include "assembly/system.h"
#include "collide/collider.h"
#include "context/actors.h"
#include "context/budget.h"
#include "context/completion_data.h"
#include "context/cut_levels.h"
#include "context/cuts_data.h"
#include "context/deadline.h"
#include "context/edit_list.h"
#include "context/events.h"
#include "context/judge_data.h"
#include "context/loads.h"
#include "context/newton_data.h"
#include "context/regroup_data.h"
#include "context/sleep_data.h"
#include "context/undo_data.h"
#include "context/wires_data.h"
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
#include <vector>

namespace hawser::stepper {

struct StepContext {
    explicit StepContext(const WorldDef& d) : def(d), pool(d.threads) {
        collider.margin = d.contact_margin;
        collider.most_contacts = d.max_contacts;
        collider.most_bytes = system.most_bytes = d.max_memory;
        // They couple bodies beside the rows, which a sweep over rows does not see.
        if (d.nonsmooth == Nonsmooth::pgs) def.geometric_stiffness = def.rotation_damping = 0.0;
    }

    WorldDef def;
    model::Bodies bodies;
    model::Interactions interactions;
    assembly::System system;
    collide::Collider collider;
    collide::ContactSet contacts;         ///< Of the step being taken, or of the last one.
    base::Array<double> contact_impulse;  ///< 3 a contact: on side 1, world frame [N s]; or empty.
    base::Array<double> contact_speed;    ///< u where the step began, as in Newton::x.
    base::Array<std::uint8_t> contact_sliding;  ///< 1 a contact: friction at its limit; or empty.
    runtime::Pool pool;
    runtime::PoolStopwatch pool_stopwatch{pool};
    runtime::Stopwatch* stopwatch = &pool_stopwatch;  ///< Of the solver; tests put their own.
    std::unique_ptr<runtime::Trace> trace;            ///< What threads do; none: not written down.
    Completion completion;
    std::vector<assembly::Turning> turnings;  ///< Scratch of completion: one a strip or group.
    std::vector<double> closing;              ///< Scratch of closing: gaps of rows, a solution.
    Cuts cuts;
    Regroup regroup;
    Budget budget;
    Deadline deadline;
    CutLevels cut_levels;
    JudgeData judge;
    Edits edits;
    std::vector<std::uint8_t> edits_stay;  ///< Scratch: by contact of the last step.
    LoadStore loads;
    Actors* actors = nullptr;  ///< Systems of the world, if it has some.
    Undo undo;
    Mend mend = Mend::nothing;  ///< Before the system may be used.
    Laps laps;                  ///< Of the step being taken, where a budget asks for time.
    Degradation imposed;        ///< On the next step.
    int refine_unasked = 0;  ///< So many steps to come refine before they measure, see solve.cpp.
    int refine_unasked_before = 0;  ///< refine_unasked, kept for a step that fails.
    EventLog events;
    StepStats stats;

    double time = 0.0;
    std::int64_t step = 0;
    int stage_now = -1;  ///< Whose time is counted, see timer.h; −1: no one's.
    std::chrono::steady_clock::time_point stage_since{};
    bool factor_whole = false;  ///< Never in part: for tests, to compare bits.
    bool remembered = false;    ///< In this step, see remember().
    bool rhs_ready = false;  ///< The solver's vector holds the right-hand side of the first solve.
    bool topology_changed = true;             ///< Bodies or interactions were added.
    bool started = false;                     ///< The staggered start has been made.
    double work = 0.0, drag = 0.0;            ///< Since the start [J].
    double drive = 0.0;                       ///< Since the start [J], see Energy::driven.
    double friction = 0.0, contact = 0.0;     ///< Since the start [J], see Energy.
    double damped = 0.0;                      ///< Since the start [J], see Energy.
    double step_work = 0.0, step_drag = 0.0;  ///< Of the step being taken [J].
    std::int64_t step_flops = 0;              ///< Of all factorisations of the step.
    Newton newton;                            ///< Of a world in which something may touch.
    std::vector<std::int32_t> columns;        ///< Scratch: nodes, one a block of contacts.
    std::vector<double> partial;              ///< Scratch of merged_over().
    Sleep sleep;
    Wires wires;
    double contact_floor = 0.0;          ///< Impulse of a contact that does not count [N s].
    double residual_floor = 0.0;         ///< Denominator floor of the momentum residual.
    std::vector<assembly::Norms> norms;  ///< One a strip or group, merged in order.
    std::vector<double> losses;          ///< One a strip, of row_losses().
    bool losses_known = false;           ///< They are those of λ and v₊ as they stand.
    std::vector<double> active_before;   ///< Of bounded interactions, for events.
    /// Positions and rotations at the last analysis, which chose forms and floors by them.
    base::Array<double> analysed_x, analysed_r;
    std::vector<double> carriers_before;       ///< Poses of kinematic bodies, for the energy.
    std::vector<double> lambda_before;         ///< Multipliers, for a step that fails.
    std::vector<std::uint8_t> repeats_before;  ///< Interactions::repeats, for a step that fails.

    /// Chunks of bodies or interactions: coarse tasks of fixed size.
    static constexpr std::int32_t kChunk = 128;
    [[nodiscard]] static int chunks(std::int32_t count) noexcept {
        return (count + kChunk - 1) / kChunk;
    }
};

}  // namespace hawser::stepper
