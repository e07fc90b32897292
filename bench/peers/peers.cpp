// SPDX-License-Identifier: Apache-2.0
#include "peers.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

namespace hawser::bench {
namespace {

constexpr std::size_t kWarmUp = 60;  ///< Number of frames left out of the statistics of time.

/// Return sorted times after the warm-up; all of them if the run ended before twice that.
std::vector<double> settled_times(const std::vector<double>& ms) {
    std::vector<double> t(ms.begin() + (ms.size() >= 2 * kWarmUp ? kWarmUp : 0), ms.end());
    std::sort(t.begin(), t.end());
    return t;
}

double percentile(const std::vector<double>& sorted, double p) {
    if (sorted.empty()) return 0.0;
    const double i = p * static_cast<double>(sorted.size() - 1);
    return sorted[static_cast<std::size_t>(std::lround(i))];
}

/// Return layout number `choice` of the scene, counted from 1; 0: the fastest one for the engine.
/// Bullet's cost is the length of the trees between closures (the first layout), Simbody's the
/// number of closures (the last of those with the fewest). Unused if neither is built in.
[[maybe_unused]] const TreeLayout& layout(const Scene& scene, std::size_t choice,
                                          bool few_closures) {
    const std::vector<TreeLayout>& all = scene.layouts;
    if (choice > 0) return all[std::min(choice, all.size()) - 1];
    std::size_t best = 0;
    for (std::size_t i = 1; few_closures && i < all.size(); ++i)
        if (all[i].closures.size() <= all[best].closures.size()) best = i;
    return all[best];
}

std::vector<Engine> engines_with_layout(std::size_t choice) {
    std::vector<Engine> all;
    all.push_back({"hawser", "ours, h = 1/60 s without substeps", true,
                   [](const Scene& s, int n) { return make_ours(s, n); }});
#if HAWSER_HAVE_ODE
    all.push_back({"ode-step", "ODE dWorldStep (direct, dense)", false,
                   [](const Scene& s, int n) { return make_ode(s, n, false); }});
    all.push_back({"ode-quick", "ODE dWorldQuickStep (iterative)", false,
                   [](const Scene& s, int n) { return make_ode(s, n, true); }});
#endif
#if HAWSER_HAVE_BULLET
    all.push_back({"bullet-impulse", "Bullet float64, sequential impulse", false,
                   [](const Scene& s, int n) { return make_bullet_impulse(s, n); }});
    all.push_back({"bullet-featherstone", "Bullet float64, Featherstone and Dantzig", false,
                   [choice](const Scene& s, int n) {
                       return make_bullet_featherstone(s, n, layout(s, choice, false));
                   }});
#endif
#if HAWSER_HAVE_SIMBODY
    all.push_back({"simbody", "Simbody, reduced coordinates; joints only", false,
                   [choice](const Scene& s, int n) {
                       return s.touching ? nullptr : make_simbody(s, n, layout(s, choice, true));
                   }});
#endif
    (void)choice;
    return all;
}

}  // namespace

std::vector<Engine> engines() { return engines_with_layout(0); }

Engine engine_by_name(const std::string& name) {
    const std::size_t cut = name.find('@');
    std::size_t choice = 0;
    if (cut != std::string::npos)
        choice = static_cast<std::size_t>(std::max(0, std::atoi(name.c_str() + cut + 1)));
    std::string known;
    for (Engine& e : engines_with_layout(choice)) {
        if (e.name == name.substr(0, cut)) {
            e.name = name;
            return e;
        }
        known += (known.empty() ? "" : ", ") + e.name;
    }
    throw std::invalid_argument("unknown engine '" + name + "': expected one of " + known);
}

Trial::Trial(const Engine& engine, const Scene& scene, const Reference& reference, int substeps,
             double duration)
    : scene_(scene),
      reference_(reference),
      engine_(engine.name),
      runner_(engine.make(scene, substeps)),
      meter_(scene, reference, runner_ && runner_->staggered()),
      now_(scene.bodies.size()),
      loads_(scene.bodies.size()),
      total_(static_cast<int>(std::lround(duration / kFrame))) {
    if (!runner_) throw std::invalid_argument("this program was built without " + engine.name);
    runner_->read(now_);
    frame_ms_.reserve(static_cast<std::size_t>(total_));
}

bool Trial::frame() {
    if (is_over()) return false;
    const double h = kFrame / runner_->substeps();
    Spent time;
    for (int i = 0; i < runner_->substeps(); ++i) {
        before_ = now_;
        external_loads(scene_, now_, loads_);
        const Spent now = runner_->substep(loads_);
        time.wall += now.wall;
        time.cpu += now.cpu;
        runner_->read(now_);
        const bool own = runner_->tow_force(tow_);
        meter_.substep(before_, loads_, now_, h, own ? &tow_ : nullptr);
    }
    frame_ms_.push_back(1e3 * time.wall);
    frame_cpu_ms_.push_back(1e3 * time.cpu);
    if (const int n = runner_->contacts(); n >= 0) contacts_.push_back(n);
    ++frames_;
    meter_.frame(before_, now_, frames_ * kFrame);
    return !is_over();
}

bool Trial::holds(std::string* why) const {
    const std::string reason = meter_.reason_unusable(total_);
    if (why) *why = reason;
    return reason.empty();
}

PeerResult Trial::result() const {
    PeerResult r;
    r.engine = engine_;
    r.scene = scene_.name;
    r.settings = runner_->settings();
    r.substeps = runner_->substeps();
    r.simulated = frames_ * kFrame;
    r.holds = holds(&r.reason_unusable);
    if (r.holds && frames_ < total_) {
        r.holds = false;
        r.reason_unusable = "not finished";
    }
    r.measures = meter_.measures();
    if (!scene_.towed.empty() && !scene_.tension && reference_.tension.empty())
        r.unchecked = "tension";
    if (scene_.block >= 0 && reference_.block.empty()) r.unchecked = "path of the block";
    const std::vector<double> sorted = settled_times(frame_ms_);
    r.ms_per_frame = percentile(sorted, 0.5);
    r.ms_p99 = percentile(sorted, 0.99);
    r.cpu_ms = percentile(settled_times(frame_cpu_ms_), 0.5);
    r.frame_ms = frame_ms_;
    r.contacts = contacts_;
    r.tension_times = meter_.tension_times();
    r.tensions = meter_.tensions();
    return r;
}

PeerResult run_peer(const Engine& engine, const Scene& scene, int substeps,
                    const Reference& reference, const SearchOptions& options, bool early_out) {
    const double duration = options.duration > 0.0 ? options.duration : scene.duration;
    Trial trial(engine, scene, reference, substeps, duration);
    const auto start = std::chrono::steady_clock::now();
    bool in_time = true;
    while (trial.frame() && in_time && !(early_out && !trial.holds())) {
        const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
        in_time = wall.count() < options.budget;
    }
    PeerResult r = trial.result();
    if (!in_time && r.reason_unusable == "not finished") r.reason_unusable = "too slow to finish";
    return r;
}

PeerResult smallest_that_holds(const Engine& engine, const Scene& scene, const Reference& reference,
                               const SearchOptions& options,
                               const std::function<void(const PeerResult&)>& tell) {
    PeerResult last;
    for (const int n : {1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 16, 20, 24, 32, 40, 48, 64, 96, 128, 256}) {
        if (n > options.max_substeps && n > 1) break;
        last = run_peer(engine, scene, n, reference, options, true);
        if (tell) tell(last);
        // A run that took too long with n substeps takes longer with more.
        if (last.holds || last.reason_unusable == "too slow to finish" || engine.ours) break;
    }
    return last;
}

void run_in_turns(std::vector<std::unique_ptr<Trial>>& trials, int block) {
    for (bool any = true; any;) {
        any = false;
        for (auto& t : trials)
            for (int i = 0; i < block && t->frame(); ++i) any = true;
    }
}

}  // namespace hawser::bench
