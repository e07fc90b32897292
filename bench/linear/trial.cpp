// SPDX-License-Identifier: Apache-2.0
#include "linear/trial.h"

#include "linear/sweeps.h"
#include "linear/timing.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <map>
#include <stdexcept>

namespace hawser::bench {
namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point from) {
    return std::chrono::duration<double>(Clock::now() - from).count();
}

/// Times of successive phases.
class Watch {
  public:
    explicit Watch(bool processor) : processor_(processor), last_(now()) {}
    double lap() {
        const double t = now(), passed = t - last_;
        last_ = t;
        return passed;
    }

  private:
    [[nodiscard]] double now() const {
        return processor_ ? thread_seconds() : since(Clock::time_point{});
    }
    bool processor_;
    double last_;
};

bool is_selected(const Variant& v, const TrialOptions& o) {
    const bool ours = v.library.starts_with("hawser");
    if (o.quick_choice && (v.order != (ours ? Order::library : Order::amd_blocks))) return false;
    if (o.libraries.empty()) return true;
    return std::any_of(o.libraries.begin(), o.libraries.end(), [&](const std::string& name) {
        return v.library.find(name) != std::string::npos;
    });
}

Result describe(Candidate& c) {
    Result r;
    r.library = c.variant().library;
    r.form = c.variant().form();
    r.order = name_of(c.variant().order);
    if (c.variant().order == Order::library && r.library == "KLU") r.order = "COLAMD";
    if (c.variant().order == Order::amd_blocks && r.library.starts_with("hawser"))
        r.order = "minimum degree";
    r.threads = c.threads();
    return r;
}

/// Samples of one candidate, and their evaluation.
struct Samples {
    std::vector<double> analyse, own_order_analysis, refresh, factor, solve, refine, total;
    void add(const Phases& p) {
        refresh.push_back(p.refresh);
        factor.push_back(p.factor);
        solve.push_back(p.solve);
        refine.push_back(p.refine);
        total.push_back(p.total());
    }
    void finish(Result& r) const {
        r.analyse = median(analyse);
        if (!own_order_analysis.empty()) r.own_order_analysis = median(own_order_analysis);
        r.phases = {median(refresh), median(factor), median(solve), median(refine)};
        r.total = median(total);
        r.totals = total;
    }
};

/// Run one turn. Uncounted solutions come first: the first of all touches its memory for the first
/// time, and a short one finds caches and branch prediction with data of another solver. They also
/// wake the threads, which stay awake for the turn, like in a time step. @param others  Another
/// solver had the turn before.
void run_turn(Candidate& c, Samples& s, bool others) {
    constexpr double kShort = 0.02, kOthers = 0.03;  // [s]
    const bool first_of_all = s.total.empty();
    const Phases p = c.work();
    const bool is_short = p.total() < kShort;
    // Threads of another library's BLAS wait actively for work before they sleep.
    for (double passed = p.total(); others && is_short && passed < kOthers;)
        passed += c.work().total();
    if (!first_of_all && !is_short) s.add(p);
    if (first_of_all || is_short)
        for (int k = 0; k < (is_short ? 3 : 1); ++k) s.add(c.work());
    c.sleep();
}

void complete(Candidate& c, const Problem& problem, Result& r) {
    r.factor_nnz = c.solver().factor_nnz();
    r.flops = c.solver().flops();
    r.bytes = c.solver().bytes();
    if (problem.reference) r.error = relative_error(problem.system, c.x(), problem.reference->x);
}

/// Try one variant alone. A failure is also a result.
Result try_variant(Problem& problem, const Variant& variant, int threads) {
    Result r;
    try {
        Candidate c(problem, variant, threads);
        r = describe(c);
        Samples s;
        s.analyse.push_back(c.analyse());
        for (int turn = 0; turn < 2; ++turn) run_turn(c, s, turn == 0);
        // Short ones are disturbed more, and there is time for more of them.
        constexpr double kShort = 0.005;  // [s]
        const bool is_short = *std::min_element(s.total.begin(), s.total.end()) < kShort;
        for (int turn = 0; is_short && turn < 8; ++turn) run_turn(c, s, false);
        s.finish(r);
        // Variants are compared by their best sample, which other programs disturb least.
        r.total = *std::min_element(s.total.begin(), s.total.end());
        complete(c, problem, r);
    } catch (const std::exception& e) {
        r.library = variant.library;
        r.form = variant.form();
        r.order = name_of(variant.order);
        r.threads = threads;
        r.failure = e.what();
        r.total = std::numeric_limits<double>::infinity();
    }
    return r;
}

/// Compare two variants of one solver in turns, as a single sample of either may be disturbed.
/// @return true if the second is faster.
bool second_is_better(Problem& problem, const Variant& a, const Variant& b, int threads) {
    Candidate first(problem, a, threads), second(problem, b, threads);
    (void)first.analyse();
    (void)second.analyse();
    Samples of_first, of_second;
    constexpr int kTurns = 9;
    for (int turn = 0; turn < kTurns; ++turn) {
        run_turn(first, of_first, true);
        run_turn(second, of_second, true);
    }
    return median(of_second.total) < median(of_first.total);
}

/// Time Hawser twice: one candidate repairs, the other analyses the same systems. They start in
/// turns, as the first of the two has less data in the caches.
void time_updates(Problem& problem, std::vector<std::unique_ptr<Candidate>>& candidates,
                  std::vector<Result>& results, const ProblemSource& source,
                  const TrialOptions& options) {
    if (!source.paper) return;  // only this scene has contacts to edit
    constexpr int kSteps = 4;
    std::vector<std::unique_ptr<Candidate>> from_scratch(candidates.size());
    for (std::size_t k = 0; k < candidates.size(); ++k) {
        const Candidate& c = *candidates[k];
        if (c.variant().library != "hawser") continue;
        from_scratch[k] = std::make_unique<Candidate>(problem, c.variant(), c.threads());
        from_scratch[k]->analyse();
    }
    PaperScene scene(*source.paper);
    int step = 0;
    for (const int count : options.edits) {
        std::vector<std::vector<double>> times(candidates.size()), whole(candidates.size());
        for (int k = 0; k < kSteps + (step == 0 ? 1 : 0); ++k, ++step) {
            const std::vector<int> changed = scene.change_contacts(count, step);
            std::vector<int> nodes;
            for (const int i : changed) nodes.push_back(scene.contact_node(i));
            const Problem edited(scene.system());
            for (std::size_t c = 0; c < candidates.size(); ++c) {
                const Input input = edited.input(candidates[c]->variant().condensed);
                auto analyse = [&](bool now) {
                    if (now && from_scratch[c]) whole[c].push_back(from_scratch[c]->analyse(input));
                };
                analyse(step % 2 != 0);
                times[c].push_back(candidates[c]->update(input, nodes));
                analyse(step % 2 == 0);
                if (step > 0) continue;  // arrays grow once
                times[c].clear();
                whole[c].clear();
            }
        }
        for (std::size_t c = 0; c < candidates.size(); ++c)
            results[c].update.push_back(
                {count, median(times[c]), whole[c].empty() ? -1.0 : median(whole[c])});
    }
}

}  // namespace

base::Executor& Candidate::serial() noexcept {
    static base::SerialExecutor executor;
    return executor;
}

Candidate::Candidate(Problem& problem, const Variant& variant, int threads)
    : problem_(&problem),
      variant_(variant),
      threads_(threads),
      solver_(variant.make(variant.order)) {
    if (threads > 1) pool_ = std::make_unique<runtime::Pool>(threads);
    own_ = pool_ && variant.library == "hawser" ? pool_.get() : &serial();
    vectors_.resize(problem.system);
}

Candidate::~Candidate() = default;

void Candidate::wake() {
    if (pool_) pool_->resume();
}
void Candidate::sleep() {
    if (pool_) pool_->pause();
}
/// Put the threads of the pool to sleep: a spinning pool would occupy a core of a library with its
/// own threads.
void Candidate::sleep_pool() {
    if (pool_ && own_ != pool_.get()) pool_->pause();
}

double Candidate::analyse(const Input& input) {
    set_library_threads(threads_);
    if (own_ == pool_.get()) wake();  // as within a time step
    Watch watch(processor_time());
    solver_->analyse(input, executor());
    const double time = watch.lap();
    sleep();
    return time;
}

double Candidate::analyse_own() {
    set_library_threads(threads_);
    if (!solver_->prepare_own(problem_->input(variant_.condensed))) return -1.0;
    Watch watch(processor_time());
    solver_->analyse_own();
    return watch.lap();
}

double Candidate::update(const Input& input, const std::vector<int>& changed) {
    set_library_threads(threads_);
    if (own_ == pool_.get()) wake();
    Watch watch(processor_time());
    solver_->update(input, changed, executor());
    const double time = watch.lap();
    sleep();
    return time;
}

Phases Candidate::work() {
    set_library_threads(threads_);
    const Input in = problem_->input(variant_.condensed);
    std::vector<double>& inverse = problem_->inverse;
    base::Executor& team = executor();
    auto solve = [&] {
        sleep_pool();
        solver_->solve(vectors_.folded, *own_);
        wake();
    };
    Phases p;
    wake();
    Watch watch(processor_time());
    invert_sigma(*in.system, *in.form, inverse, team);
    fold_right_side(*in.system, *in.form, inverse, vectors_, team);
    solver_->refresh(in, team);
    sleep_pool();
    p.refresh = watch.lap();
    solver_->factor_and_begin(vectors_.folded, *own_);
    p.factor = watch.lap();
    solver_->finish(vectors_.folded, *own_);
    wake();
    unfold_solution(*in.system, *in.form, inverse, vectors_, team);
    p.solve = watch.lap();
    fold_residual(*in.system, *in.form, vectors_, team);
    solve();
    add_correction(*in.system, *in.form, inverse, vectors_, team);
    p.refine = watch.lap();
    return p;
}

std::vector<Result> compare(Problem& problem, const ProblemSource& source, int threads,
                            const TrialOptions& options, std::vector<Result>& all) {
    // With more threads, only solvers that use them are tried again.
    using Tried = std::pair<Variant, Result>;
    std::map<std::string, Tried> best, next;
    std::vector<std::string> order;
    for (const Variant& v : all_variants(options.through_public)) {
        if (!is_selected(v, options)) continue;
        const Result r = try_variant(problem, v, threads);
        all.push_back(r);
        const auto it = best.find(v.library);
        if (it == best.end()) {
            order.push_back(v.library);
            best[v.library] = {v, r};
            continue;
        }
        Tried other{v, r};
        if (r.total < it->second.second.total) std::swap(it->second, other);
        const auto second = next.find(v.library);
        if (second == next.end() || other.second.total < second->second.second.total)
            next[v.library] = other;
    }
    // If the two best are close and short, one sample does not decide.
    for (const auto& [name, other] : next) {
        constexpr double kClose = 1.5, kShort = 0.02;  // ratio of times; [s]
        Tried& first = best[name];
        const double least = first.second.total;
        if (options.run_in_turns && least < kShort && other.second.total < kClose * least &&
            second_is_better(problem, first.first, other.first, threads))
            first = other;
    }
    std::vector<Result> results;
    if (!options.run_in_turns) {
        for (const std::string& name : order) results.push_back(best[name].second);
        return results;
    }
    std::vector<std::unique_ptr<Candidate>> candidates;
    std::vector<Samples> samples;
    for (const std::string& name : order) {
        if (!best[name].second.failure.empty()) continue;
        candidates.push_back(std::make_unique<Candidate>(problem, best[name].first, threads));
        samples.emplace_back();
        results.push_back(describe(*candidates.back()));
    }
    for (std::size_t k = 0; k < candidates.size(); ++k)
        for (int i = 0; i < 3; ++i) {
            samples[k].analyse.push_back(candidates[k]->analyse());
            samples[k].own_order_analysis.push_back(candidates[k]->analyse_own());
        }
    for (int round = 0; round < options.rounds; ++round)
        for (std::size_t k = 0; k < candidates.size(); ++k)
            run_turn(*candidates[k], samples[k], candidates.size() > 1 || round == 0);
    for (std::size_t k = 0; k < candidates.size(); ++k) {
        samples[k].finish(results[k]);
        complete(*candidates[k], problem, results[k]);
    }
    if (source.paper && options.updates)
        time_updates(problem, candidates, results, source, options);
    return results;
}

}  // namespace hawser::bench
