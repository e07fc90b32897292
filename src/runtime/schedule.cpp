// SPDX-License-Identifier: Apache-2.0
#include <hawser/schedule.h>

#include <algorithm>
#include <numeric>

namespace hawser {
namespace {

double sum(const std::vector<double>& v) noexcept {
    return std::accumulate(v.begin(), v.end(), 0.0);
}

/// Deals out one loop; threads are free from the given times on.
class Dealer {
  public:
    Dealer(const LoopTimes& loop, double deal) : loop_(loop), deal_(deal) {
        if (!loop.parent.empty()) ready_.assign(loop.task.size(), 0.0);
    }

    /// @return end of the last task. `free` is when each thread can take its first task.
    double run(std::vector<double>& free, std::vector<TraceSpan>* spans, const TraceSpan& like) {
        double last = 0.0, ticket = 0.0;
        for (std::size_t i = 0; i < loop_.task.size(); ++i) {
            const auto thread = std::min_element(free.begin(), free.end());
            ticket = std::max(*thread, ticket) + deal_;
            const double begin = ready_.empty() ? ticket : std::max(ticket, ready_[i]);
            const double end = *thread = begin + loop_.task[i];
            if (!ready_.empty() && loop_.parent[i] >= 0) {
                double& ready = ready_[static_cast<std::size_t>(loop_.parent[i])];
                ready = std::max(ready, end);
            }
            last = std::max(last, end);
            if (spans == nullptr) continue;
            TraceSpan s = like;
            s.kind = SpanKind::task;
            s.begin = begin;
            s.end = end;
            s.task = static_cast<std::int32_t>(i);
            s.thread = static_cast<std::int32_t>(thread - free.begin());
            spans->push_back(s);
        }
        return last;
    }

  private:
    const LoopTimes& loop_;
    double deal_;
    std::vector<double> ready_;  ///< When all that a task waits for has ended.
};

/// Longest sum of tasks that wait for each other.
double longest_path(const LoopTimes& loop) {
    std::vector<double> path(loop.task.size(), 0.0);
    double longest = 0.0;
    for (std::size_t i = 0; i < path.size(); ++i) {
        path[i] += loop.task[i];
        longest = std::max(longest, path[i]);
        if (loop.parent.empty() || loop.parent[i] < 0) continue;
        double& up = path[static_cast<std::size_t>(loop.parent[i])];
        up = std::max(up, path[i]);
    }
    return longest;
}

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

double ProgramTimes::critical() const noexcept {
    double total = serial();
    for (const LoopTimes& l : loops) total += longest_path(l);
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
        // The pool does not wake anyone for one task.
        const bool shared = threads > 1 && loop.task.size() > 1;
        free.assign(static_cast<std::size_t>(shared ? threads : 1),
                    std::max(now + costs.start, costs.wake));
        free[0] = now;
        TraceSpan span;
        span.kind = SpanKind::loop;
        span.stage = loop.stage;
        span.begin = now;
        span.loop = static_cast<std::int32_t>(k);
        const double last = Dealer(loop, shared ? costs.deal : 0.0).run(free, spans, span);
        now = std::max(now, last) + (shared ? costs.join : 0.0);
        span.end = now;
        span.task = static_cast<std::int32_t>(loop.task.size());
        result.loop.push_back(span.seconds());
        if (spans != nullptr) spans->push_back(span);
    }
    result.seconds = now + program.after;
    return result;
}

ProgramTimes program_of(std::span<const TraceSpan> spans, double begin, double end) {
    ProgramTimes p;
    double last = begin;
    std::int32_t number = -1;
    for (const TraceSpan& s : spans) {
        if (s.begin < begin || s.end > end) continue;
        if (s.kind == SpanKind::loop) {
            p.loops.push_back({s.begin - last, {}, {}, s.stage});
            p.loops.back().task.assign(static_cast<std::size_t>(s.task), 0.0);
            number = s.loop;
            last = s.end;
        } else if (s.kind == SpanKind::task && s.loop == number) {
            p.loops.back().task[static_cast<std::size_t>(s.task)] = s.seconds();
        }
    }
    p.after = end - last;
    return p;
}

}  // namespace hawser
