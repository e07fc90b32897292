// SPDX-License-Identifier: Apache-2.0
#include "draw/timeline.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>

namespace hawser::draw {

namespace {

const TraceSpan& find_step(const TraceView& trace, std::int64_t step) {
    for (const TraceSpan& s : trace.spans)
        if (s.kind == SpanKind::step && s.step == step) return s;
    throw std::out_of_range(fmt::format("the trace does not hold step {}", step));
}

/// Nested spans of the calling thread, converted to segments of the innermost span. In a loop the
/// calling thread waits outside its own tasks.
class Caller {
  public:
    Caller(Timeline& out, const TraceSpan& step)
        : out_(out), origin_(step.begin), now_(step.begin) {}

    void add(const TraceSpan& span) {
        close(span.begin);
        advance(span.begin);
        open_spans_.push_back(span);
    }
    /// End all spans that end before or at `until`.
    void close(double until) {
        while (!open_spans_.empty() && open_spans_.back().end <= until) {
            advance(open_spans_.back().end);
            open_spans_.pop_back();
        }
    }

  private:
    void advance(double to) {
        if (to <= now_) return;
        if (!open_spans_.empty()) {
            const TraceSpan& top = open_spans_.back();
            if (top.kind != SpanKind::loop || out_.threads == 1)
                out_.segments.push_back({now_ - origin_, to - origin_, 0, work_of(top.stage),
                                         top.kind == SpanKind::task});
        }
        now_ = to;
    }

    Timeline& out_;
    double origin_, now_;
    std::vector<TraceSpan> open_spans_;
};

}  // namespace

const char* to_string(Work work) noexcept {
    constexpr const char* kNames[kWorkCount] = {
        "collide", "analysis", "assembly", "linear algebra", "nonsmooth", "integrate", "other"};
    return kNames[static_cast<std::size_t>(work)];
}

Work work_of(std::int8_t stage) noexcept {
    if (stage < 0) return Work::other;
    switch (static_cast<Stage>(stage)) {
        case Stage::collide:
            return Work::collide;
        case Stage::graph:
        case Stage::analyse:
            return Work::analysis;
        case Stage::assemble:
            return Work::assembly;
        case Stage::factor:
            return Work::linear_algebra;
        case Stage::nonsmooth:
            return Work::nonsmooth;
        case Stage::integrate:
            return Work::integrate;
        case Stage::prestep:
            break;
    }
    return Work::other;
}

Timeline timeline_of(const TraceView& trace, std::int64_t step) {
    const TraceSpan whole = find_step(trace, step);
    Timeline t;
    t.seconds = whole.seconds();
    t.threads = trace.threads;
    t.step = step;
    Caller caller(t, whole);
    for (const TraceSpan& s : trace.spans) {
        if (s.begin < whole.begin || s.end > whole.end) continue;
        if (s.thread == 0)
            caller.add(s);
        else
            t.segments.push_back(
                {s.begin - whole.begin, s.end - whole.begin, s.thread, work_of(s.stage), true});
    }
    caller.close(whole.end);
    return t;
}

std::int64_t typical_step(const TraceView& trace) {
    std::vector<std::pair<double, std::int64_t>> steps;
    for (const TraceSpan& s : trace.spans)
        if (s.kind == SpanKind::step) steps.emplace_back(s.seconds(), s.step);
    if (steps.empty()) throw std::out_of_range("the trace holds no whole step");
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    return middle->second;
}

Timeline simulated_timeline(const TraceView& trace, std::int64_t step, int threads,
                            const PoolCosts& costs) {
    const TraceSpan whole = find_step(trace, step);
    const ProgramTimes program = program_of(trace, whole.begin, whole.end);
    std::vector<TraceSpan> spans;
    Timeline t;
    t.seconds = simulate(program, threads, costs, &spans).seconds;
    t.threads = threads;
    t.step = step;
    t.simulated = true;
    double now = 0.0;
    for (const TraceSpan& s : spans) {
        const Work work = work_of(s.stage);
        if (s.kind == SpanKind::loop) {
            if (s.begin > now) t.segments.push_back({now, s.begin, 0, work, false});
            now = s.end;
        } else if (s.end > s.begin) {
            t.segments.push_back({s.begin, s.end, s.thread, work, true});
        }
    }
    if (t.seconds > now) t.segments.push_back({now, t.seconds, 0, Work::other, false});
    return t;
}

TimelineFigures figures_of(const Timeline& timeline) {
    TimelineFigures f;
    std::vector<double> thread(static_cast<std::size_t>(timeline.threads), 0.0);
    double work = 0.0;
    for (const Segment& s : timeline.segments) {
        const double seconds = s.end - s.begin;
        f.seconds[static_cast<std::size_t>(s.work)] += seconds;
        thread[static_cast<std::size_t>(s.thread)] += seconds;
        work += seconds;
    }
    if (work <= 0.0 || timeline.seconds <= 0.0) return f;
    f.busy = work / (timeline.threads * timeline.seconds);
    f.balance = work / timeline.threads / *std::max_element(thread.begin(), thread.end());
    f.linear_algebra = f.seconds[static_cast<std::size_t>(Work::linear_algebra)] / work;
    return f;
}

std::string describe(const Timeline& timeline) {
    const TimelineFigures f = figures_of(timeline);
    return fmt::format(
        "step {}: {:.4g} ms on {} {}thread{}, linear algebra {:.1f} % of the work, load balance "
        "{:.1f} %, idle {:.1f} %",
        timeline.step, 1e3 * timeline.seconds, timeline.threads,
        timeline.simulated ? "simulated " : "", timeline.threads == 1 ? "" : "s",
        100.0 * f.linear_algebra, 100.0 * f.balance, 100.0 * (1.0 - f.busy));
}

std::string to_trace_events(const TraceView& trace, const std::string& scene) {
    std::string escaped;
    for (const char c : scene) {
        if (c == '"' || c == '\\') escaped += '\\';
        escaped += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
    fmt::memory_buffer out;
    auto to = std::back_inserter(out);
    fmt::format_to(to,
                   "{{\"displayTimeUnit\":\"ms\",\"otherData\":{{\"scene\":\"{}\",\"steps\":{},"
                   "\"steps_lost\":{}}},\n\"traceEvents\":[\n",
                   escaped, trace.steps, trace.steps_lost);
    for (int t = 0; t < trace.threads; ++t)
        fmt::format_to(to,
                       "{{\"name\":\"thread_name\",\"ph\":\"M\",\"pid\":1,\"tid\":{},\"args\":"
                       "{{\"name\":\"thread {}\"}}}}{}\n",
                       t, t, t + 1 < trace.threads || !trace.spans.empty() ? "," : "");
    for (std::size_t i = 0; i < trace.spans.size(); ++i) {
        const TraceSpan& s = trace.spans[i];
        const char* const name = s.kind == SpanKind::step || s.stage < 0
                                     ? "step"
                                     : hawser::to_string(static_cast<Stage>(s.stage));
        fmt::format_to(to,
                       "{{\"name\":\"{}\",\"cat\":\"{}\",\"ph\":\"X\",\"ts\":{:.3f},\"dur\":{:.3f},"
                       "\"pid\":1,\"tid\":{},\"args\":{{\"step\":{}",
                       name, hawser::to_string(s.kind), 1e6 * s.begin, 1e6 * s.seconds(), s.thread,
                       s.step);
        if (s.kind == SpanKind::task)
            fmt::format_to(to, ",\"loop\":{},\"task\":{}", s.loop, s.task);
        if (s.kind == SpanKind::loop)
            fmt::format_to(to, ",\"loop\":{},\"tasks\":{}", s.loop, s.task);
        fmt::format_to(to, "}}}}{}\n", i + 1 < trace.spans.size() ? "," : "");
    }
    fmt::format_to(to, "]}}\n");
    return fmt::to_string(out);
}

}  // namespace hawser::draw
