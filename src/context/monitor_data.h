// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file monitor_data.h
/// Memory and samples of the monitors (monitor/monitor.h).

#include <hawser/limits.h>
#include <hawser/stats.h>

#include <array>
#include <cstdint>
#include <vector>

namespace hawser::context {

/// A sum with its decaying extrema.
struct DecayingExtremes {
    double least = 0.0, most = 0.0;
};

/// Balances of unexplained energy, by the terms that are counted.
enum Account : std::uint8_t {
    kUnexplained,  ///< Mechanical energy, all works, and the losses of drag and rows.
    /// Like kUnexplained, with the energy that rows returned beyond their earlier losses.
    kWithGiven,
    kBetween,  ///< Created energy at the midpoint between poses, of lines by their true lengths.
    kAtPoses,  ///< Created energy at the poses, with the mean of the velocities before and after.
    kByForce,  ///< Like kBetween, with the energy of springs by their force: ½ f² ε.
    kAccounts
};

template <class T>
using ByAccount = std::array<T, kAccounts>;

/// Works since the start [J].
enum WorkBy : std::uint8_t {
    kForces,
    kDrives,
    kDrag,
    kFriction,
    kContacts,
    kRows,
    kGiven,  ///< Energy of edits, see Edited.
    /// Elastic energy of added and removed nodes of wires: not work; counts as created if it lasts.
    kStrained,
    kWorks
};
using Works = std::array<double, kWorks>;

/// Part of the state of a world.
struct MonitorState {
    /// Energies at the last sample, see MonitorPart [J].
    double kinetic = 0.0, potential = 0.0, elastic = 0.0, by_length = 0.0, by_force = 0.0;
    Works work{};              ///< Works at the last sample.
    ByAccount<double> mean{};  ///< Mean over kMean [J].
    ByAccount<DecayingExtremes> now_extremes{}, mean_extremes{};
    double posed = 0.0;  ///< Rise of kAtPoses at the last sample [J].
    /// Energy that rows may return, and energy that they returned beyond it [J].
    double held = 0.0, given = 0.0;
    double exchanged = 0.0;  ///< Energy exchanged by bodies, springs and drives [J].
    double counted = 0.0;    ///< Like `exchanged`, with the exchange of rows [J].
    double age = 0.0;        ///< Time since the sums began [s].
    /// Increase of potential energy by the position projection in the last step [J].
    double closed = 0.0;
    double closed_elastic = 0.0;    ///< held_by_closing() in the last step [J].
    double unsolved = 0.0;          ///< Duration of unsolved equations [s].
    std::array<double, 2> risen{};  ///< Created energy at the last two samples [J].
    /// Deviation from the cable law at the last two samples, newest first.
    std::array<double, 2> stretched{};
    /// Least rise by the lengths of lines, in this interval and in the two before [J].
    std::array<double, 3> lasting_rise{};
    double held_time = 0.0;  ///< Duration of this interval [s].
    /// Elements above their strength, and with more than their length wound in, at the last two
    /// steps.
    std::array<double, 2> overlong{}, wound{};
    std::array<double, 5> beyond{},
        deep{};               ///< See MonitorPart; at the last samples, newest first.
    double open_start = 0.0;  ///< Remaining tolerance for joints that started open.
    std::int64_t step = 0;    ///< Step of the last sample.
    std::int64_t begun = 0;   ///< 0: the next sample is the first one.
    std::array<std::uint8_t, 8> reported{};  ///< By monitor: 1 if reported and still present.
};

/// Contribution of a chunk of bodies or interactions.
struct MonitorPart {
    double kinetic = 0.0, potential = 0.0, elastic = 0.0;
    /// Sum of all three at the poses, with the mean of the velocities before and after.
    double at_pose = 0.0;
    double by_length = 0.0;  ///< Elastic energy, of lines by their true lengths at the midpoint.
    double by_force = 0.0;   ///< Elastic energy by the force of the last step, ½ f² ε.
    double open = 0.0, stretch = 0.0, turn = 0.0, twist = 0.0;
    double beyond = 0.0;  ///< Excess over a range, relative to the suspect limit.
    double deep = 0.0;    ///< Penetration, relative to the thickness of the thinner shape.
    std::int32_t open_row = -1, stretch_id = -1, turn_body = -1, twist_id = -1;
    std::int32_t beyond_row = -1, deep_contact = -1;
};

struct MonitorData {
    MonitorState state;
    std::vector<double> allowed;        ///< By row: 1 / allowed gap, 0: unlimited.
    std::vector<std::int32_t> elastic;  ///< Interactions with rows that store energy.
    /// By entry of `elastic`, 1: a spring or wire between two points.
    std::vector<std::uint8_t> line;
    std::vector<std::int32_t> lines;    ///< Wire elements.
    std::vector<std::int32_t> ranges;   ///< Rows of ranges that are rigid by intention.
    std::vector<double> range_allowed;  ///< By entry of `ranges`: 1 / allowed excess.
    std::vector<MonitorPart> part;      ///< One per chunk.
    double nothing = 0.0;               ///< See limit::kNothingHigher [J].
    std::int32_t every = 1;             ///< Number of steps between samples.
    Verdict verdict;
};

}  // namespace hawser::context
