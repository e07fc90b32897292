// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file judge.h
/// Whether what steps come to can be: each state is judged in the step after it, by figures that
/// this one has at hand. The limits and their reasons are in docs/limits.md.
///
/// Energy. Created is what kinetic, gravity and elastic energy together gained beyond the work of
/// forces and drives, friction and contacts: half-way between poses, where velocities live, and at
/// the poses, with the mean of the velocities before and after; and half-way with springs that hold
/// what their force says, as one that the step does not resolve is left longer or shorter than it
/// pulls by the turning of its direction. Each comes and goes where motion is fast; the smallest
/// rise is taken. What drag and rows took may hide more: unexplained is
/// the gain with that added, counted by rows linearised once a step, and so judged less closely.
/// All of these are sums over the steps, so that a look every few steps misses nothing. What rows
/// take is an explanation as long as it is more than nothing: joints do no work, and two that
/// contradict each other put in energy as if they took less than nothing. A further sum therefore
/// adds what rows gave beyond what they had taken within about a second, which may be held in an
/// overlap or in an element that comes taut. Judged is how far each rises above its lowest value,
/// and the unexplained falls below its highest, over what was exchanged: kinetic energy and half
/// the changes of all that is in the sums. Both forget within kMemory. A result is doubtful by
/// what three looks running have in common, as energy of a moment comes and goes where something
/// whips round within two steps; a step is refused by means over kMean.
///
/// Limits. A rise in one place and a loss in another at the same time are not told apart.

#include <hawser/limits.h>
#include <hawser/stats.h>

#include "assembly/view.h"

#include <array>
#include <cstdint>
#include <vector>

namespace hawser::stepper {

struct StepContext;

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
enum Work : std::uint8_t { kForces, kDrives, kDrag, kFriction, kContacts, kRows, kWorks };
using Works = std::array<double, kWorks>;

/// Part of the state of a world.
struct JudgeState {
    /// See JudgePart, at the last look [J].
    double kinetic = 0.0, potential = 0.0, elastic = 0.0, by_length = 0.0, by_force = 0.0;
    Works work{};              ///< At the last look.
    ByAccount<double> mean{};  ///< Over kMean [J].
    ByAccount<Tide> now_tide{}, mean_tide{};
    double posed = 0.0;                  ///< Rise of kAtPoses, at the last look [J].
    double held = 0.0, given = 0.0;      ///< By rows: what they may give back, and gave beyond [J].
    double exchanged = 0.0;              ///< By bodies and springs, and by what drives them [J].
    double counted = 0.0;                ///< The same with what rows took and gave [J].
    double age = 0.0;                    ///< Since the sums began [s].
    double closed = 0.0;                 ///< Higher by closing poses, in the last step [J].
    double closed_elastic = 0.0;         ///< held_by_closing() in the last step [J].
    double unsolved = 0.0;               ///< For so long [s].
    std::array<double, 2> risen{};       ///< Created energy at the last two looks [J].
    std::array<double, 2> stretched{};   ///< Off the cable law at the last two looks, newest first.
    double open_start = 0.0;             ///< What still excuses joints that started open.
    std::int64_t step = 0;               ///< Of the last look.
    std::int64_t begun = 0;              ///< 0: the next look is the first one.
    std::array<std::uint8_t, 8> told{};  ///< By judge: it has been said, and holds on.
};

/// What a chunk of bodies or interactions adds.
struct JudgePart {
    double kinetic = 0.0, potential = 0.0, elastic = 0.0;
    double at_pose = 0.0;    ///< All three at the poses, between the velocities before and after.
    double by_length = 0.0;  ///< Elastic energy, of lines by their true lengths half-way.
    double by_force = 0.0;   ///< Elastic energy by the force of the last step, ½ f² ε.
    double open = 0.0, stretch = 0.0, turn = 0.0, twist = 0.0;
    std::int32_t open_row = -1, stretch_id = -1, turn_body = -1, twist_id = -1;
};

struct JudgeData {
    JudgeState state;
    std::vector<double> allowed;        ///< By row: 1 / what it may be open by, 0: anything.
    std::vector<std::int32_t> elastic;  ///< Interactions with rows that hold energy.
    std::vector<std::uint8_t> line;     ///< Of those: 1, a spring or wire between two points.
    std::vector<std::int32_t> lines;    ///< Wire elements.
    std::vector<JudgePart> part;        ///< One a chunk.
    double nothing = 0.0;               ///< See limit::kNothingHigher [J].
    std::int32_t every = 1;             ///< Steps from look to look.
    Verdict verdict;
};

/// When velocities are those of the poses, or of half a step before them.
enum class At { pose, half_step };
/// Energies and extremes of the state, whose rows have been evaluated; they do not depend on
/// threads.
[[nodiscard]] JudgePart look(StepContext& ctx, At when) noexcept;

/// How far a sum is above its least value, and below its highest [J].
struct Swing {
    double rise = 0.0, fall = 0.0;
};
/// Energy that came or went without reason: at this moment, and in the mean.
struct Unexplained {
    ByAccount<Swing> now{}, mean{};
    double posed = 0.0;  ///< What JudgeState::posed was before [J].
};
/// The sums begin: energy at the start.
void begin_energy(const JudgePart& p, const Works& works, JudgeState& state) noexcept;
/// `state` goes on to this look. @param time  Since the last one [s].
[[nodiscard]] Unexplained follow_energy(const JudgePart& p, const Works& works, double time,
                                        JudgeState& state) noexcept;

/// Violations of the rows of springs at the poses as they are, into `gaps`, by row.
void read_spring_gaps(StepContext& ctx, double* gaps) noexcept;
/// How much more springs hold half a step before the poses, reckoned back by the velocities, since
/// poses have moved by all of what they were closed by instead of half [J].
/// @param before  Of read_spring_gaps() before the poses were closed.
[[nodiscard]] double held_by_closing(StepContext& ctx, const double* before) noexcept;

/// Arrays for the interactions there are. @throws std::bad_alloc.
void prepare_judge(StepContext& ctx);
/// Energy at the start, from velocities as given.
void begin_judge(StepContext& ctx) noexcept;
/// Judge the state before the step being taken, whose rows have been evaluated.
[[nodiscard]] Status judge(StepContext& ctx) noexcept;
/// The verdict with the present state.
[[nodiscard]] Verdict verdict(StepContext& ctx) noexcept;

}  // namespace hawser::stepper
