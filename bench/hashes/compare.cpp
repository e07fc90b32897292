// SPDX-License-Identifier: Apache-2.0
#include <hawser/scene.h>

#include "hashes/compare.h"

#include <hawser/structure.h>
#include <hawser/timeline.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <random>
#include <span>
#include <utility>

namespace hawser::bench {
namespace {

scene::Scene load_for_hashes(const std::string& file, const HashOptions& options, int threads) {
    scene::Options o;
    o.threads = threads;
    o.set = options.set;
    return scene::load_file(file, o);
}

/// True if a joint has friction, a range, or a motor with a force limit.
bool has_bounds(const World& world) {
    for (int i = 0; i < world.interaction_count(); ++i) {
        const std::string kind = kind_info(world.interaction_def(InteractionId{i}).kind).name;
        if (kind.ends_with("_friction") || kind.ends_with("_range") || kind.ends_with("_motor"))
            return true;
    }
    return false;
}

/// Hash of a failed step, whose state is that of the step before.
constexpr std::uint64_t kFailed = 0;
/// Steps compared after a state at a random step.
constexpr std::size_t kRestoredSteps = 60;

struct Saved {
    std::vector<std::byte> state;
    std::optional<Structure> made_of;  ///< Structure of a world that differs from the start.
};

/// A scene with its timeline.
class Run {
  public:
    Run(const std::string& file, const HashOptions& options, int threads)
        : scene_(load_for_hashes(file, options, threads)) {
        scene_.world.prepare();
        identity_ = scene_.world.state().identity();
    }
    [[nodiscard]] const World& world() const { return scene_.world; }
    [[nodiscard]] Saved save() const {
        Saved out{scene_.world.state().save(), {}};
        if (scene_.world.state().identity() != identity_)
            out.made_of = scene_.world.state().structure();
        return out;
    }
    void restore(const Saved& from) {
        World& w = scene_.world;
        from.made_of ? w.state().restore(*from.made_of, from.state) : w.state().restore(from.state);
        while (due(w.time() - w.settings().step)) ++next_;
    }
    std::uint64_t step_and_hash() {
        World& w = scene_.world;
        for (; due(w.time()); ++next_) scene::perform(scene_.timeline[next_], w);
        return w.step() == Status::ok ? w.state().hash() : kFailed;
    }

  private:
    [[nodiscard]] bool due(double time) const {
        constexpr double kSlack = 1e-9;
        return next_ < scene_.timeline.size() && scene_.timeline[next_].at <= time + kSlack;
    }
    scene::Scene scene_;
    std::uint64_t identity_ = 0;
    std::size_t next_ = 0;
};

/// Objects of a world, for comparison.
struct Pieces {
    std::vector<BodyId> bodies;
    std::vector<InteractionId> interactions;
    explicit Pieces(const World& w)
        : bodies(w.bodies().begin(), w.bodies().end()),
          interactions(w.interactions().begin(), w.interactions().end()) {}
    friend bool operator==(const Pieces&, const Pieces&) = default;
};

/// Make the first run: hashes of all steps, counts, and states before some steps.
std::vector<std::uint64_t> run_first(Run& run, const HashOptions& options, HashComparison& out,
                                     std::map<int, Saved>& saved) {
    std::vector<std::uint64_t> hashes;
    Pieces pieces(run.world());
    std::int64_t edits_to_save = options.restores / 2;
    for (int i = 0; i < options.steps; ++i) {
        Saved before;
        if (edits_to_save > 0) before = run.save();
        if (const auto at = saved.find(i); at != saved.end())
            at->second = edits_to_save > 0 ? before : run.save();
        hashes.push_back(run.step_and_hash());
        if (Pieces now(run.world()); now != pieces) {
            ++out.edited_steps;
            pieces = std::move(now);
            if (edits_to_save > 0 && saved.emplace(i, std::move(before)).second) --edits_to_save;
        }
        std::int32_t sliding = 0;
        for (const ContactView& c : run.world().contacts()) sliding += c.sliding ? 1 : 0;
        out.contacts_max = std::max(out.contacts_max, run.world().stats().contacts);
        out.sliding_max = std::max(out.sliding_max, sliding);
        out.sliding_steps += sliding > 0 ? 1 : 0;
    }
    out.status = run.world().stats().status;
    return hashes;
}

/// Step on and compare. Saves after `middle` steps. `at`: number of steps made before.
std::int64_t first_difference(Run& run, std::span<const std::uint64_t> hashes, int at, int middle,
                              Saved* saved) {
    for (auto i = static_cast<std::size_t>(at); i < hashes.size(); ++i) {
        if (saved != nullptr && static_cast<int>(i) == middle) *saved = run.save();
        if (run.step_and_hash() != hashes[i]) return static_cast<std::int64_t>(i) + 1;
    }
    return 0;
}

/// Return steps at which states are saved: the middle, and random ones.
std::map<int, Saved> steps_to_save(const HashOptions& options, int middle) {
    std::map<int, Saved> out;
    out[middle];
    std::mt19937 dice(static_cast<std::uint32_t>(options.steps));
    const int random = options.restores - options.restores / 2;
    for (int k = 0; k < random; ++k)
        out[static_cast<int>(dice() % static_cast<std::uint32_t>(options.steps))];
    return out;
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
    out.steps_to_saved = middle;
    const std::vector<int>& threads = options.threads;
    std::vector<Saved> saved(threads.size());
    std::map<int, Saved> states = steps_to_save(options, middle);
    Run first(file, options, threads.at(0));
    const auto hashes = run_first(first, options, out, states);
    saved[0] = std::move(states.at(middle));
    states.erase(middle);
    out.hash = hashes.empty() ? first.world().state().hash() : hashes.back();
    for (std::size_t k = 1; k < threads.size(); ++k) {
        Run run(file, options, threads[k]);
        const auto differs = first_difference(run, hashes, 0, middle, &saved[k]);
        out.runs.push_back({threads[k], 0, 0, differs});
    }
    for (std::size_t k = 0; k < threads.size(); ++k) {
        if (saved[k].state.empty()) continue;  // it differed before
        const int other = threads[(k + 1) % threads.size()];
        Run run(file, options, other);
        run.restore(saved[k]);
        const auto differs = first_difference(run, hashes, middle, middle, nullptr);
        out.runs.push_back({other, threads[k], middle, differs});
    }
    std::size_t next = 0;
    for (const auto& [at, state] : states) {
        const int other = threads[++next % threads.size()];
        Run run(file, options, other);
        run.restore(state);
        const std::size_t end =
            std::min(hashes.size(), static_cast<std::size_t>(at) + kRestoredSteps);
        const auto differs =
            first_difference(run, std::span(hashes).first(end), at, middle, nullptr);
        out.runs.push_back({other, threads[0], at, differs});
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
