// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file compare.h
/// Steps of one scene with several numbers of threads and from saved states. The state hash must be
/// the same after every step. Timelines are executed. If objects were added or removed, a state is
/// saved with its structure (hawser/structure.h).

#include <hawser/def.h>
#include <hawser/stats.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace hawser::bench {

struct HashOptions {
    std::vector<int> threads{1, 2, 4, 8};  ///< The others are compared with the first one.
    int steps = 1000;
    int restores = 0;                ///< States saved at random steps, besides that half way.
    std::vector<std::string> set{};  ///< Changes to the scene, see scene::Options::set.
};

/// The first step after which a run had another hash, or 0.
struct HashRun {
    int threads = 1;
    /// Threads of the world whose state it was restored from; 0: the start.
    int restored_from = 0;
    std::int64_t saved_after = 0;  ///< Steps of that state.
    std::int64_t first_difference = 0;
};

struct HashComparison {
    std::string scene;
    std::int64_t steps = 0;          ///< Steps of each run from the start.
    std::int64_t saved_after = 0;    ///< Steps after which states were saved.
    Status status = Status::ok;      ///< Status of the last step of the first run.
    std::uint64_t hash = 0;          ///< After the last step of the first run.
    std::int32_t contacts_max = 0;   ///< Contact points in a step.
    std::int32_t sliding_max = 0;    ///< Contacts of these with friction at its limit.
    std::int64_t sliding_steps = 0;  ///< Steps with some that slide.
    /// Steps with bodies or interactions added or removed before or in them.
    std::int64_t edited_steps = 0;
    std::vector<HashRun> runs;  ///< All but the first run.

    [[nodiscard]] bool equal() const noexcept;
};

/// Compare three groups of runs. First, each number of threads from the start. Second, each run
/// saves its state half-way, and a world with the next number of threads continues from it, the
/// first number after the last. Third, worlds continue from states of the first run at random
/// steps, some just before an edit. Their numbers of threads alternate, and each runs to the end or
/// for kRestoredSteps.
/// @throws scene::SceneError; DefError.
[[nodiscard]] HashComparison compare_hashes(const std::string& file, const HashOptions& options);

/// Scene files of a folder in which something can touch, or a joint has friction, a range or a
/// motor, by name.
[[nodiscard]] std::vector<std::string> nonsmooth_scenes(const std::string& folder);

}  // namespace hawser::bench
