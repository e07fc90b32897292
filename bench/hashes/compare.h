// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file compare.h
/// One scene stepped by several numbers of threads, and gone on with from saved states: the state
/// hash has to be the same after every step. Timelines are done; of a world whose pieces came and
/// went a state is saved with its structure (hawser/structure.h).

#include <hawser/def.h>
#include <hawser/stats.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace hawser::bench {

struct HashOptions {
    std::vector<int> threads{1, 2, 4, 8};  ///< The first one is what the others are compared with.
    int steps = 1000;
    int restores = 0;                ///< States saved at random steps, besides that half way.
    std::vector<std::string> set{};  ///< Changes to the scene, see scene::Options::set.
};

/// The first step after which a run had another hash, or 0.
struct HashRun {
    int threads = 1;
    int restored_from = 0;  ///< Threads of the world whose state it went on from; 0: the start.
    std::int64_t saved_after = 0;  ///< Steps of that state.
    std::int64_t first_difference = 0;
};

struct HashComparison {
    std::string scene;
    std::int64_t steps = 0;          ///< Taken by each run from the start.
    std::int64_t saved_after = 0;    ///< Steps after which states were saved.
    Status status = Status::ok;      ///< Of the last step of the first run.
    std::uint64_t hash = 0;          ///< After the last step of the first run.
    std::int32_t contacts_max = 0;   ///< Contact points in a step.
    std::int32_t sliding_max = 0;    ///< Of those, with friction at its limit.
    std::int64_t sliding_steps = 0;  ///< Steps with some that slide.
    std::int64_t edited_steps = 0;   ///< Before or in which bodies or interactions came or went.
    std::vector<HashRun> runs;       ///< All but the first run.

    [[nodiscard]] bool equal() const noexcept;
};

/// Every number of threads from the start; then, from the state that the run with each number of
/// threads saved half way, a world with the next number of threads, the last one's with the first;
/// then from states of the first run at random steps, some of them just before an edit, by numbers
/// of threads in turn, each to the end or for kRestoredSteps.
/// @throws scene::SceneError; DefError.
[[nodiscard]] HashComparison compare_hashes(const std::string& file, const HashOptions& options);

/// Scene files of a folder in which something can touch, or a joint has friction, a range or a
/// motor, by name.
[[nodiscard]] std::vector<std::string> nonsmooth_scenes(const std::string& folder);

}  // namespace hawser::bench
