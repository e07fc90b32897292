// SPDX-License-Identifier: Apache-2.0
#include <hawser/scene.h>

#include "hashes/compare.h"

#include <algorithm>
#include <filesystem>
#include <span>

namespace hawser::bench {
namespace {

scene::Scene load_for_hashes(const std::string& file, const HashOptions& options, int threads) {
    scene::Options o;
    o.threads = threads;
    o.set = options.set;
    return scene::load_file(file, o);
}

/// Whether a joint has friction, a range, or a motor whose force may be limited.
bool has_bounds(const World& world) {
    for (int i = 0; i < world.interaction_count(); ++i) {
        const std::string kind = kind_info(world.interaction_def(InteractionId{i}).kind).name;
        if (kind.ends_with("_friction") || kind.ends_with("_range") || kind.ends_with("_motor"))
            return true;
    }
    return false;
}

/// What a step that failed counts as: its state is that of the step before.
constexpr std::uint64_t kFailed = 0;

std::uint64_t step_and_hash(World& world) {
    return world.step() == Status::ok ? world.state_hash() : kFailed;
}

/// The first run: hashes of all steps, and what there was to be seen.
std::vector<std::uint64_t> run_first(scene::Scene& s, const HashOptions& options, int middle,
                                     HashComparison& out, std::vector<std::byte>& saved) {
    std::vector<std::uint64_t> hashes;
    for (int i = 0; i < options.steps; ++i) {
        if (i == middle) saved = s.world.save();
        hashes.push_back(step_and_hash(s.world));
        std::int32_t sliding = 0;
        for (const ContactView& c : s.world.contacts()) sliding += c.sliding ? 1 : 0;
        out.contacts_max = std::max(out.contacts_max, s.world.stats().contacts);
        out.sliding_max = std::max(out.sliding_max, sliding);
        out.sliding_steps += sliding > 0 ? 1 : 0;
    }
    out.status = s.world.stats().status;
    return hashes;
}

/// Step on and compare. `at`: steps taken so far. Saves after `middle` steps.
std::int64_t first_difference(World& world, std::span<const std::uint64_t> hashes, int at,
                              int middle, std::vector<std::byte>* saved) {
    for (auto i = static_cast<std::size_t>(at); i < hashes.size(); ++i) {
        if (saved != nullptr && static_cast<int>(i) == middle) *saved = world.save();
        if (step_and_hash(world) != hashes[i]) return static_cast<std::int64_t>(i) + 1;
    }
    return 0;
}

}  // namespace

bool HashComparison::equal() const noexcept {
    return std::all_of(runs.begin(), runs.end(),
                       [](const HashRun& r) { return r.first_difference == 0; });
}

HashComparison compare_hashes(const std::string& file, const HashOptions& options) {
    HashComparison out;
    out.scene = std::filesystem::path(file).stem().string();
    out.steps = options.steps;
    const int middle = options.steps / 2;
    out.saved_after = middle;
    const std::vector<int>& threads = options.threads;
    std::vector<std::vector<std::byte>> saved(threads.size());
    scene::Scene first = load_for_hashes(file, options, threads.at(0));
    const auto hashes = run_first(first, options, middle, out, saved[0]);
    out.hash = hashes.empty() ? first.world.state_hash() : hashes.back();
    for (std::size_t k = 1; k < threads.size(); ++k) {
        scene::Scene s = load_for_hashes(file, options, threads[k]);
        const auto differs = first_difference(s.world, hashes, 0, middle, &saved[k]);
        out.runs.push_back({threads[k], 0, differs});
    }
    for (std::size_t k = 0; k < threads.size(); ++k) {
        if (saved[k].empty()) continue;  // it differed before
        const int other = threads[(k + 1) % threads.size()];
        scene::Scene s = load_for_hashes(file, options, other);
        s.world.restore(saved[k]);
        const auto differs = first_difference(s.world, hashes, middle, middle, nullptr);
        out.runs.push_back({other, threads[k], differs});
    }
    return out;
}

std::vector<std::string> nonsmooth_scenes(const std::string& folder) {
    std::vector<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        // A state or a part has a name of two words: "anchor_lines.settled.json".
        if (!name.ends_with(".json") || name.find('.') + 5 != name.size()) continue;
        const World world = scene::load_file(entry.path()).world;
        if (world.shape_count() > 0 || has_bounds(world)) found.push_back(entry.path().string());
    }
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace hawser::bench
