// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file undo_data.h
/// Copies of the last good state (undo.h).

#include "assembly/system.h"
#include "base/memory.h"
#include "collide/contacts.h"
#include "collide/match.h"
#include "context/cuts_data.h"
#include "context/edit_list.h"
#include "context/ledger.h"
#include "context/monitor_data.h"
#include "context/wires_data.h"
#include "model/bodies.h"
#include "model/interactions.h"

#include <array>
#include <cstdint>
#include <vector>

namespace hawser::context {

/// Pending work before the system may be used.
enum class PendingRepair : std::uint8_t {
    nothing,
    rebuild,  ///< Analyse as before, at the poses of that analysis.
    follow,   ///< Analyse with the bodies awake now, at the poses of the last analysis.
    /// Bodies, interactions and shapes were put back (model_undo.h): prepare, then as rebuild …
    all,
    all_follow,  ///< … or as follow.
};

/// Copies of the last good state, as far as it has changed or is about to.
struct Undo {
    /// Extent of changes besides velocities and impulses.
    enum class Depth : std::uint8_t {
        system,  ///< Links, cuts in force, groups, sleep: changes of the stages graph to analyse.
        model,   ///< Also ghost bodies and duplicated rows of cuts.
        all,     ///< Also results of a step, for another state.
    };

    /// Counters of a step.
    struct Scalars {
        std::int64_t step;
        double time;
        Ledger ledger;
        double system_work, water, added;
        int refine_unasked;
        bool started;
        std::array<std::int64_t, kEventKindCount> event_count;
        MonitorState monitor;
    };
    /// True if the system has been saved since the last complete step or preparation.
    [[nodiscard]] bool holds() const noexcept { return depth >= 0; }

    bool moved = false;   ///< True if velocities and impulses are saved.
    bool posed = false;   ///< True if poses are saved.
    bool linked = false;  ///< So are the steps in which links were used last.
    int depth = -1;       ///< −1: the system is unchanged.

    // Motion.
    base::Array<double> v, spin_change, lambda, active;
    base::Array<std::uint8_t> repeats, coarse;
    std::vector<double> energy_allowance;
    std::vector<std::int32_t> flag_steps, recoil;
    base::Array<double> x, q, r;  ///< Poses, in worlds with shapes.
    Scalars scalars{};
    std::vector<std::int64_t> link_used;

    // System.
    PendingRepair repair = PendingRepair::nothing;
    Changed changed = Changed::nothing;
    assembly::System::Kept system;
    base::Array<double> analysed_x, analysed_r;
    base::Array<std::uint8_t> asleep;
    base::Array<std::int32_t> quiet;
    std::int32_t asleep_count = 0;
    std::vector<assembly::Contacts::Link> links;
    std::vector<Cut> cuts;
    std::uint64_t asked = 0;
    int interfaces = 0;
    std::vector<std::int32_t> group;
    std::vector<Coupling> coupling;
    graph::Partition parts;
    Wires wires;  ///< Saved before they are searched again.
    std::int64_t made = 0, seen = -1;
    bool stale = true, grouped = false;
    std::int32_t grouped_interactions = 0;

    // Model.
    model::Bodies bodies;
    model::Interactions interactions;
    Cuts all_cuts;

    // All.
    base::Array<collide::KeptContact> kept;
    std::size_t kept_awake = 0;
    base::Array<assembly::ContactMemory> memory;
    base::Array<assembly::ResistanceMemory> resistances;
    collide::ContactSet contacts;
    base::Array<double> contact_impulse;
    base::Array<std::uint8_t> contact_sliding;
    std::int32_t contact_count = 0;
};

}  // namespace hawser::context
