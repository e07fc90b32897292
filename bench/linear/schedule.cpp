// SPDX-License-Identifier: Apache-2.0
#include "linear/schedule.h"

#include "index.h"
#include "linear/sweeps.h"
#include "linear/timing.h"
#include "runtime/tasks.h"
#include "runtime/trace.h"

#include <algorithm>
#include <chrono>

namespace hawser::bench {
namespace {

/// Runs on one thread the tasks of several threads.
class SimulatedExecutor final : public base::Executor {
  public:
    SimulatedExecutor(runtime::Pool& pool, int threads) : pool_(pool), threads_(threads) {}
    void run(int count, Task task, void* context) noexcept override {
        pool_.run(count, task, context);
    }
    void announce(const base::TaskOrder& order) noexcept override { pool_.announce(order); }
    void begin_node(int node, int thread) noexcept override { pool_.begin_node(node, thread); }
    [[nodiscard]] int threads() const noexcept override { return threads_; }

  private:
    runtime::Pool& pool_;
    int threads_;
};

constexpr int kMarks = 5;
constexpr const char* kPhase[kMarks - 1] = {"condense", "factor", "backward", "refine"};

/// Start of each phase of one solution, and end of the last one [s].
struct Marks {
    double at[kMarks] = {};
    bool disturbed = false;
    [[nodiscard]] double solve() const noexcept { return at[3] - at[1]; }
    [[nodiscard]] double whole() const noexcept { return at[4] - at[0]; }
};

class Work {
  public:
    Work(const ProblemSource& source, bool condensed)
        : problem_(source.system()), condensed_(condensed), solver_(make_ours(Order::library)) {
        base::SerialExecutor serial;
        vectors_.resize(problem_.system);
        solver_->analyse(problem_.input(condensed), serial);
        // Memory for the second thread; serial executors use the first.
        SimulatedExecutor two(one_thread_, 2);
        solver_->analyse(problem_.input(condensed), two);
    }

    /// Run one solution after another one that is not counted: threads are awake, but a run with
    /// another number of threads left the values in other caches.
    Marks run(base::Executor& executor, runtime::Pool& pool) {
        pool.resume();
        (void)solve(executor);
        double before[2], after[2];
        processor(pool, before);
        Marks m = solve(executor);
        processor(pool, after);
        pool.pause();
        // Switching a thread takes at least microseconds; reading the clocks about one.
        for (int t = 0; t < pool.threads(); ++t)
            if (m.whole() - (after[t] - before[t]) > 0.01 * m.whole() + 3e-6) m.disturbed = true;
        return m;
    }

    [[nodiscard]] runtime::Pool& one() noexcept { return one_thread_; }
    [[nodiscard]] runtime::Pool& two() noexcept { return two_threads_; }
    [[nodiscard]] runtime::Trace& trace() noexcept { return trace_; }

  private:
    static void processor(runtime::Pool& pool, double* seconds) {
        for (int t = 0; t < pool.threads(); ++t) seconds[t] = pool.cpu_seconds(t);
    }

    Marks solve(base::Executor& team) {
        const Input in = problem_.input(condensed_);
        std::vector<double>& inverse = problem_.inverse;
        Marks m;
        m.at[0] = trace_.now();
        invert_sigma(*in.system, *in.form, inverse, team);
        fold_right_side(*in.system, *in.form, inverse, vectors_, team);
        solver_->refresh(in, team);
        m.at[1] = trace_.now();
        solver_->factor_and_begin(vectors_.folded, team);
        m.at[2] = trace_.now();
        solver_->finish(vectors_.folded, team);
        m.at[3] = trace_.now();
        unfold_solution(*in.system, *in.form, inverse, vectors_, team);
        fold_residual(*in.system, *in.form, vectors_, team);
        solver_->solve(vectors_.folded, team);
        add_correction(*in.system, *in.form, inverse, vectors_, team);
        m.at[4] = trace_.now();
        return m;
    }

    Problem problem_;
    bool condensed_;
    std::unique_ptr<Solver> solver_;
    SweepVectors vectors_;
    runtime::Pool one_thread_{1}, two_threads_{2};
    runtime::Trace trace_{1, 1 << 16};
};

/// Combine several runs of a program into one with median times: another program that occupies the
/// processor lengthens a task in only one of them.
ProgramTimes median_times(const std::vector<ProgramTimes>& runs) {
    ProgramTimes p = runs.front();
    std::vector<double> v;
    auto middle = [&](auto&& of) {
        v.clear();
        for (const ProgramTimes& r : runs) v.push_back(of(r));
        return median(v);
    };
    for (std::size_t k = 0; k < p.loops.size(); ++k) {
        p.loops[k].before = middle([&](const ProgramTimes& r) { return r.loops[k].before; });
        for (std::size_t i = 0; i < p.loops[k].task.size(); ++i)
            p.loops[k].task[i] = middle([&](const ProgramTimes& r) { return r.loops[k].task[i]; });
    }
    p.after = middle([](const ProgramTimes& r) { return r.after; });
    return p;
}

/// Runs of one part of the work.
struct Stretch {
    std::vector<double> one, two;
    std::vector<ProgramTimes> program[std::size(kScheduleThreads)];

    [[nodiscard]] ScheduleTimes times(const PoolCosts& costs) const {
        ScheduleTimes t;
        t.one = median(one);
        t.two = median(two);
        t.one_best = *std::min_element(one.begin(), one.end());
        t.two_best = *std::min_element(two.begin(), two.end());
        for (std::size_t k = 0; k < std::size(kScheduleThreads); ++k) {
            const ProgramTimes p = median_times(program[k]);
            t.predicted.push_back(simulate(p, kScheduleThreads[k], costs).seconds);
            t.speed_up.push_back(p.work() / t.predicted.back());
            t.serial = p.serial();
            t.critical = p.critical();
        }
        return t;
    }
};

/// Describe the loops of one phase with the code before them, and the code after the last one.
void describe_loops(const ProgramTimes& p, const char* phase, const PoolCosts& costs,
                    std::vector<ScheduleLoop>& loops) {
    const Simulated eight = simulate(p, 8, costs);
    for (std::size_t i = 0; i < p.loops.size(); ++i) {
        const LoopTimes& l = p.loops[i];
        ScheduleLoop s{phase, static_cast<int>(l.task.size()), l.before};
        for (const double t : l.task) s.sum += t;
        s.path = l.critical();
        s.eight = eight.loop[i];
        loops.push_back(s);
    }
    loops.push_back({phase, 0, p.after});
}

}  // namespace

ScheduleReport measure_schedule(const ProblemSource& source, bool condensed, int rounds,
                                const PoolCosts& costs) {
    Work work(source, condensed);
    ScheduleReport report;
    report.name = source.name;
    report.form = condensed ? "condensed" : "saddle";
    Stretch solve, whole;
    std::vector<ProgramTimes> phase[kMarks - 1], phase_two[kMarks - 1];
    std::vector<double> one[kMarks - 1], two[kMarks - 1];
    TraceView spans;
    auto counted = [&](base::Executor& executor, runtime::Pool& pool) {
        Marks m;
        const auto begin = std::chrono::steady_clock::now();
        while (std::chrono::steady_clock::now() - begin < std::chrono::milliseconds(100)) {
            m = work.run(executor, pool);
            ++report.samples;
            if (!m.disturbed) break;
            ++report.disturbed;
        }
        return m;
    };
    std::size_t disturbed_two = 0;
    for (int round = 0; round < rounds; ++round) {
        const Marks a = counted(work.one(), work.one()), b = counted(work.two(), work.two());
        solve.one.push_back(a.solve());
        whole.one.push_back(a.whole());
        solve.two.push_back(b.solve());
        whole.two.push_back(b.whole());
        for (int i = 0; i + 1 < kMarks; ++i) {
            one[i].push_back(a.at[i + 1] - a.at[i]);
            two[i].push_back(b.at[i + 1] - b.at[i]);
        }
        disturbed_two += b.disturbed ? 1U : 0U;
        for (std::size_t k = 0; k < std::size(kScheduleThreads); ++k) {
            SimulatedExecutor team(work.one(), kScheduleThreads[k]);
            work.one().record(&work.trace());
            const Marks m = counted(team, work.one());
            work.one().record(nullptr);
            work.trace().copy(m.at[0], spans);
            solve.program[k].push_back(program_of(spans, m.at[1], m.at[3]));
            whole.program[k].push_back(program_of(spans, m.at[0], m.at[4]));
            for (auto* of : {kScheduleThreads[k] == 8 ? phase : nullptr,
                             kScheduleThreads[k] == 2 ? phase_two : nullptr})
                for (int i = 0; of != nullptr && i + 1 < kMarks; ++i)
                    of[i].push_back(program_of(spans, m.at[i], m.at[i + 1]));
        }
    }
    report.quiet = 2 * disturbed_two < solve.two.size();
    report.solve = solve.times(costs);
    report.whole = whole.times(costs);
    for (int i = 0; i + 1 < kMarks; ++i) {
        report.phases.push_back({kPhase[i], median(one[i]), median(two[i]),
                                 simulate(median_times(phase_two[i]), 2, costs).seconds});
        describe_loops(median_times(phase[i]), kPhase[i], costs, report.loops);
    }
    return report;
}

}  // namespace hawser::bench
