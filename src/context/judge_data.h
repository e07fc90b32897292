// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file judge_data.h
/// What judges remember, and look at (judge.h).

#include <hawser/limits.h>
#include <hawser/stats.h>

#include <array>
#include <cstdint>
#include <vector>

namespace hawser::stepper {

/// A sum with its extremes, forgetting.
struct Tide {
    double least = 0.0, most = 0.0;
};

/// Energy that nothing accounts for, by what is counted in.
enum Account : std::uint8_t {
    kUnexplained,  ///< Mechanical energy, and all that works, drag and rows took and gave.
    kWithGiven,    ///< The same, with what rows gave beyond what they had taken.
    kBetween,      ///< Created energy half-way between poses, of lines by their true lengths.
    kAtPoses,      ///< Created energy at the poses, between the velocities before and after.
    kByForce,      ///< kBetween, with what springs hold by their force: ½ f² ε.
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
    kGiven,     ///< By edits, see Edited.
    kStrained,  ///< By nodes of wires that come and go: no work, and created where it lasts.
    kWorks
};
using Works = std::array<double, kWorks>;

/// Part of the state of a world.
struct JudgeState {
    /// See JudgePart, at the last look [J].
    double kinetic = 0.0, potential = 0.0, elastic = 0.0, by_length = 0.0, by_force = 0.0;
    Works work{};              ///< At the last look.
    ByAccount<double> mean{};  ///< Over kMean [J].
    ByAccount<Tide> now_tide{}, mean_tide{};
    double posed = 0.0;                 ///< Rise of kAtPoses, at the last look [J].
    double held = 0.0, given = 0.0;     ///< By rows: what they may give back, and gave beyond [J].
    double exchanged = 0.0;             ///< By bodies and springs, and by what drives them [J].
    double counted = 0.0;               ///< The same with what rows took and gave [J].
    double age = 0.0;                   ///< Since the sums began [s].
    double closed = 0.0;                ///< Higher by closing poses, in the last step [J].
    double closed_elastic = 0.0;        ///< held_by_closing() in the last step [J].
    double unsolved = 0.0;              ///< For so long [s].
    std::array<double, 2> risen{};      ///< Created energy at the last two looks [J].
    std::array<double, 2> stretched{};  ///< Off the cable law at the last two looks, newest first.
    /// Least rise by the lengths of lines, in this span of time and in the two before [J].
    std::array<double, 3> held_rise{};
    double held_time = 0.0;  ///< Of this span [s].
    /// Elements beyond their strength, and wound in beyond their length, at the last two steps.
    std::array<double, 2> overlong{}, wound{};
    std::array<double, 5> beyond{}, deep{};  ///< See JudgePart, at the last looks, newest first.
    double open_start = 0.0;                 ///< What still excuses joints that started open.
    std::int64_t step = 0;                   ///< Of the last look.
    std::int64_t begun = 0;                  ///< 0: the next look is the first one.
    std::array<std::uint8_t, 8> told{};      ///< By judge: it has been said, and holds on.
};

/// What a chunk of bodies or interactions adds.
struct JudgePart {
    double kinetic = 0.0, potential = 0.0, elastic = 0.0;
    double at_pose = 0.0;    ///< All three at the poses, between the velocities before and after.
    double by_length = 0.0;  ///< Elastic energy, of lines by their true lengths half-way.
    double by_force = 0.0;   ///< Elastic energy by the force of the last step, ½ f² ε.
    double open = 0.0, stretch = 0.0, turn = 0.0, twist = 0.0;
    double beyond = 0.0;  ///< Outside of a range, over what is doubtful.
    double deep = 0.0;    ///< In each other, over the thickness of the thinner shape.
    std::int32_t open_row = -1, stretch_id = -1, turn_body = -1, twist_id = -1;
    std::int32_t beyond_row = -1, deep_contact = -1;
};

struct JudgeData {
    JudgeState state;
    std::vector<double> allowed;        ///< By row: 1 / what it may be open by, 0: anything.
    std::vector<std::int32_t> elastic;  ///< Interactions with rows that hold energy.
    std::vector<std::uint8_t> line;     ///< Of those: 1, a spring or wire between two points.
    std::vector<std::int32_t> lines;    ///< Wire elements.
    std::vector<std::int32_t> ranges;   ///< Rows of ranges that are meant rigid.
    std::vector<double> range_allowed;  ///< Of those: 1 / what they may be beyond by.
    std::vector<JudgePart> part;        ///< One a chunk.
    double nothing = 0.0;               ///< See limit::kNothingHigher [J].
    std::int32_t every = 1;             ///< Steps from look to look.
    Verdict verdict;
};

}  // namespace hawser::stepper
