// SPDX-License-Identifier: Apache-2.0
#include "base/index.h"

#include <hawser/experimental/schedule.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <queue>
#include <utility>

namespace hawser {
namespace {

double sum(const std::vector<double>& v) noexcept {
    return std::accumulate(v.begin(), v.end(), 0.0);
}

/// Assigns the tasks of one loop to threads, which are free from the given times on.
class Dealer {
  public:
    Dealer(const LoopTimes& loop, double deal, std::vector<double>& free)
        : loop_times_(loop),
          wait_times_(loop.waits),
          dealing_time_(deal),
          thread_free_at_(free),
          tasks_left_(loop.task.size()) {
        if (all_independent()) return;
        blocked_.assign(loop.task.size(), 0);
        for (const std::int32_t v : wait_times_.next) ++blocked_[at(v)];
        for (std::size_t i = 0; i < blocked_.size(); ++i)
            if (blocked_[i] == 0) release(i);
    }

    /// Run all tasks of the loop. @return end of the last task [s].
    double run(std::vector<TraceSpan>* spans, const TraceSpan& like) {
        double last = 0.0, ticket = 0.0;
        for (; tasks_left_ > 0; --tasks_left_) {
            const auto thread = std::min_element(thread_free_at_.begin(), thread_free_at_.end());
            ticket = std::max(*thread, ticket) + dealing_time_;
            double begin = ticket;
            const std::size_t i = begin_task(begin);
            const double end = *thread = begin + loop_times_.task[i];
            if (!all_independent()) running_.emplace(end, i);
            last = std::max(last, end);
            if (spans == nullptr) continue;
            TraceSpan s = like;
            s.kind = SpanKind::task;
            s.begin = begin;
            s.end = end;
            s.task = static_cast<std::int32_t>(i);
            s.thread = static_cast<std::int32_t>(thread - thread_free_at_.begin());
            spans->push_back(s);
        }
        return last;
    }

  private:
    [[nodiscard]] bool all_independent() const { return wait_times_.start.empty(); }
    void release(std::size_t i) { ready_.emplace(wait_times_.rank[i], i); }
    void finish_first() {
        const std::size_t i = running_.top().second;
        running_.pop();
        for (std::int32_t k = wait_times_.start[i]; k < wait_times_.start[i + 1]; ++k)
            if (--blocked_[at(wait_times_.next[at(k)])] == 0) release(at(wait_times_.next[at(k)]));
    }
    /// Return the task that a thread free at `time` begins. Sets `time` to the begin of that task.
    std::size_t begin_task(double& time) {
        if (all_independent()) return loop_times_.task.size() - tasks_left_;
        while (!running_.empty() && (running_.top().first <= time || ready_.empty())) {
            time = std::max(time, running_.top().first);
            finish_first();
        }
        const std::size_t i = ready_.top().second;
        ready_.pop();
        return i;
    }

    template <class Key>
    using Queue = std::priority_queue<std::pair<Key, std::size_t>,
                                      std::vector<std::pair<Key, std::size_t>>, std::greater<>>;
    const LoopTimes& loop_times_;
    const TaskWaits& wait_times_;
    double dealing_time_;
    std::vector<double>& thread_free_at_;
    std::size_t tasks_left_;
    std::vector<std::int32_t> blocked_;  ///< Number of unfinished predecessors, by task.
    Queue<std::int32_t> ready_;          ///< Tasks without unfinished predecessors, by rank.
    Queue<double> running_;              ///< Tasks that have begun, by end.
};

}  // namespace

double ProgramTimes::serial() const noexcept {
    double total = after;
    for (const LoopTimes& l : loops) total += l.before;
    return total;
}

double ProgramTimes::work() const noexcept {
    double total = serial();
    for (const LoopTimes& l : loops) total += sum(l.task);
    return total;
}

double LoopTimes::critical() const {
    // With one thread per task, each task begins as soon as its predecessors end.
    std::vector<double> free(std::max<std::size_t>(task.size(), 1), 0.0);
    return Dealer(*this, 0.0, free).run(nullptr, {});
}

double ProgramTimes::critical() const {
    double total = serial();
    for (const LoopTimes& l : loops) total += l.critical();
    return total;
}

Simulated simulate(const ProgramTimes& program, int threads, const PoolCosts& costs,
                   std::vector<TraceSpan>* spans) {
    Simulated result;
    result.busy = program.work();
    double now = 0.0;
    std::vector<double> free;
    for (std::size_t k = 0; k < program.loops.size(); ++k) {
        const LoopTimes& loop = program.loops[k];
        now += loop.before;
        // The pool wakes no worker for a single task.
        const bool shared = threads > 1 && loop.task.size() > 1;
        free.assign(static_cast<std::size_t>(shared ? threads : 1),
                    std::max(now + costs.start, costs.wake));
        free[0] = now;
        TraceSpan span;
        span.kind = SpanKind::loop;
        span.stage = loop.stage;
        span.begin = now;
        span.loop = static_cast<std::int32_t>(k);
        const double last = Dealer(loop, shared ? costs.deal : 0.0, free).run(spans, span);
        now = std::max(now, last) + (shared ? costs.join : 0.0);
        span.end = now;
        span.task = static_cast<std::int32_t>(loop.task.size());
        result.loop.push_back(span.seconds());
        if (spans != nullptr) spans->push_back(span);
    }
    result.seconds = now + program.after;
    return result;
}

ProgramTimes program_of(const TraceView& trace, double begin, double end) {
    ProgramTimes p;
    double last = begin;
    std::int32_t number = -1;
    for (const TraceSpan& s : trace.spans) {
        if (s.begin < begin || s.end > end) continue;
        if (s.kind == SpanKind::loop) {
            p.loops.push_back({s.begin - last, {}, {}, s.stage});
            LoopTimes& l = p.loops.back();
            l.task.assign(at(s.task), 0.0);
            const auto g =
                std::lower_bound(trace.graph_loop.begin(), trace.graph_loop.end(), s.loop);
            if (g != trace.graph_loop.end() && *g == s.loop) {
                const auto k = static_cast<std::size_t>(g - trace.graph_loop.begin());
                if (trace.graph[k].rank.size() == l.task.size()) l.waits = trace.graph[k];
            }
            number = s.loop;
            last = s.end;
        } else if (s.kind == SpanKind::task && s.loop == number &&
                   at(s.task) < p.loops.back().task.size()) {
            p.loops.back().task[at(s.task)] = s.seconds();
        }
    }
    p.after = end - last;
    return p;
}

}  // namespace hawser
