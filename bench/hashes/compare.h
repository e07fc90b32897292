// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file compare.h
/// Step one scene with several numbers of threads, and continue from saved states: the state hash
/// must be equal after every step. Timelines are executed. A world whose objects changed is saved
/// with its structure (hawser/structure.h).

#include <hawser/def.h>
#include <hawser/stats.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace hawser::bench {

struct HashOptions {
    std::vector<int> threads{1, 2, 4, 8};  ///< The first one is the reference of the others.
    int steps = 1000;
    int restores = 0;                ///< Number of states saved at random steps, in addition to the
                                     ///< middle.
    std::vector<std::string> set{};  ///< Changes to the scene, see scene::Options::set.
};

/// First step after which a run had another hash, or 0.
struct HashRun {
    int threads = 1;
    int restored_from = 0;  ///< Number of threads of the world that saved its initial state; 0: the
                            ///< start.
    std::int64_t steps_to_saved = 0;  ///< Number of steps before this state.
    std::int64_t first_difference = 0;
};

struct HashComparison {
    std::string scene;
    std::int64_t steps = 0;           ///< Steps of each run from the start.
    std::int64_t steps_to_saved = 0;  ///< Steps after which states were saved.
    Status status = Status::ok;       ///< Status of the last step of the first run.
    std::uint64_t hash = 0;           ///< After the last step of the first run.
    std::int32_t contacts_max = 0;    ///< Contact points in a step.
    std::int32_t sliding_max = 0;     ///< Contact points with friction at its limit.
    std::int64_t sliding_steps = 0;   ///< Number of steps with sliding contacts.
    std::int64_t edited_steps = 0;    ///< Number of steps with additions or removals of bodies or
                                      ///< interactions.
    std::vector<HashRun> runs;        ///< All except the first run.

    [[nodiscard]] bool equal() const noexcept;
};

/// Compare runs of a scene:
/// - with every number of threads from the start;
/// - from the state in the middle of each of these, with the next number of threads (after the last
///   one the first);
/// - from states of the first run at random steps, some just before an edit, with numbers of
///   threads in turn, each to the end or for kRestoredSteps.
/// @throws scene::SceneError; DefError.
[[nodiscard]] HashComparison compare_hashes(const std::string& file, const HashOptions& options);

/// Return the scene files of a folder in which contacts are possible, or a joint has friction, a
/// range or a motor, by name.
[[nodiscard]] std::vector<std::string> nonsmooth_scenes(const std::string& folder);

}  // namespace hawser::bench
