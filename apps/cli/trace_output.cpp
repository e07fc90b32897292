// SPDX-License-Identifier: Apache-2.0
#include "trace_output.h"

#include "draw/svg.h"
#include "draw/timeline.h"
#include "outputs.h"
#include "record/host.h"

#include <fmt/format.h>

#include <algorithm>

namespace hawser::cli {

namespace {

// Capacity of spans for each thread: a step of a thousand bodies has some hundreds. 12 MB per
// thread.
constexpr std::size_t kTraceSpans = std::size_t{1} << 18;

bool is_picture(const std::string& file) { return file.ends_with(".svg"); }

/// Predict the speed-up with more threads from a run on one thread, as the median over the steps.
std::string predict_more_threads(const TraceView& trace) {
    const PoolCosts costs = measure_pool_costs();
    std::string line = "  simulated   ";
    for (const int threads : {2, 4, 8, 16}) {
        std::vector<double> gain;
        for (const TraceSpan& s : trace.spans) {
            if (s.kind != SpanKind::step) continue;
            const ProgramTimes p = program_of(trace, s.begin, s.end);
            gain.push_back(p.work() / simulate(p, threads, costs).seconds);
        }
        if (gain.empty()) return {};
        const auto middle = gain.begin() + static_cast<std::ptrdiff_t>(gain.size() / 2);
        std::nth_element(gain.begin(), middle, gain.end());
        line += fmt::format(" {} threads x {:.2f}{}", threads, *middle, threads < 16 ? "," : "\n");
    }
    return line;
}

}  // namespace

void TraceOptions::add_to(CLI::App& command) {
    command
        .add_option("--trace", files,
                    "Write a timeline of the threads: FILE.json for chrome://tracing and Perfetto, "
                    "FILE.svg as a picture of one step; may be given twice")
        ->check([](const std::string& file) {
            return file.ends_with(".json") || is_picture(file)
                       ? std::string()
                       : fmt::format("{}: a trace is written as .json or .svg", file);
        });
    command.add_option("--trace-steps", steps, "Number of last steps in FILE.json")
        ->check(CLI::Range(1, 1'000'000))
        ->capture_default_str();
    command
        .add_option("--trace-step", step,
                    "Number of the step in FILE.svg; default: a step of median duration")
        ->check(CLI::Range(std::int64_t{1}, std::int64_t{1} << 40));
}

void TraceOptions::start(World& world) const {
    if (files.empty()) return;
    world.solver().start_trace(kTraceSpans);
}

std::string TraceOptions::finish(const World& world, const std::string& scene) const {
    if (files.empty()) return {};
    const TraceView all = world.solver().trace(), last = world.solver().trace(steps);
    const bool any = all.steps > 0;
    // If the requested step is not in the trace, show the typical one.
    const bool held = std::any_of(all.spans.begin(), all.spans.end(), [&](const TraceSpan& s) {
        return s.kind == SpanKind::step && s.step == step;
    });
    draw::Timeline shown;
    if (any) shown = draw::timeline_of(all, held ? step : draw::typical_step(all));
    for (const std::string& file : files) {
        if (!is_picture(file)) {
            write_output(file, draw::to_trace_events(last, scene), "the trace");
            continue;
        }
        const std::string parameters =
            fmt::format("{}, {}, {}, step {:.6g} ms", scene, record::processor_model(),
                        instruction_set(), 1e3 * world.settings().step);
        write_output(
            file,
            draw::to_svg(draw::plot_timelines(
                {shown},
                fmt::format("What {} thread{} did", shown.threads, shown.threads == 1 ? "" : "s"),
                parameters)),
            "the trace");
    }
    if (!any) return "  timeline     no whole step was traced\n";
    std::string lines = fmt::format("  timeline     {}\n", draw::describe(shown));
    if (step > 0 && !held)
        lines += fmt::format("               step {} is not among the {} that were kept\n", step,
                             all.steps);
    return all.threads == 1 ? lines + predict_more_threads(all) : lines;
}

}  // namespace hawser::cli
