// SPDX-License-Identifier: Apache-2.0
#include "figure_timelines.h"

#include <fmt/format.h>

#include <stdexcept>

namespace hawser::cli {
namespace {

using nlohmann::ordered_json;

constexpr int kTracedSteps = 61;  // the one of median duration is shown
constexpr std::size_t kMaxTraceSpans = std::size_t{1}
                                       << 17;  // capacity of each thread, enough for all steps

/// Step to a time, then trace some steps.
TraceView trace_steps(World& world, double at) {
    const auto step = [&] {
        if (const Status status = world.step(); status != Status::ok)
            throw std::runtime_error(
                fmt::format("the step at {:.4g} s failed: {}", world.time(), to_string(status)));
    };
    while (world.time() < at - 0.5 * world.settings().step) step();
    world.solver().start_trace(kMaxTraceSpans);
    for (int k = 0; k < kTracedSteps; ++k) step();
    return world.solver().trace();
}

draw::Timeline typical_timeline(const TraceView& trace) {
    return draw::timeline_of(trace, draw::typical_step(trace));
}

std::string threads_note(int threads) {
    return threads == 1 ? "one thread" : fmt::format("{} threads", threads);
}

}  // namespace

std::vector<draw::NamedTimeline> run_timelines(SceneOptions options, const TimelineRun& run) {
    const PoolCosts costs = measure_pool_costs();
    std::vector<draw::NamedTimeline> out;
    const auto traced = [&](int threads) {
        options.threads = threads;
        scene::Scene scene = options.load();
        return trace_steps(scene.world, run.at);
    };
    const auto add = [&](const std::string& what, const TraceView& one) {
        out.push_back({fmt::format("{}, measured on {}", what, threads_note(run.threads)),
                       typical_timeline(traced(run.threads)),
                       {}});
        out.push_back({fmt::format("{}, SIMULATED on {}", what, threads_note(run.simulated)),
                       draw::simulated_timeline(one, draw::typical_step(one), run.simulated, costs),
                       {}});
    };
    const TraceView serial = traced(1);
    out.push_back({"Serial, measured on one thread", typical_timeline(serial), {}});
    const SceneOptions exact = options;
    const std::string split = fmt::format("Split: kinematic, clique first, {} parts", run.parts);
    try {
        options.set.insert(options.set.end(),
                           {"settings.coupling=kinematic", "settings.predictor=clique",
                            fmt::format("settings.parts={}", run.parts)});
        add(split, traced(1));
    } catch (const std::exception& e) {  // the scene cannot be split; show the exact timelines only
        out.push_back({split, {}, fmt::format("not run: {}", e.what())});
    }
    options = exact;
    add("Exact, parallel", serial);
    return out;
}

Panel timeline_panel(const std::string& name, const std::string& title,
                     const std::vector<draw::NamedTimeline>& timelines) {
    ordered_json list = ordered_json::array();
    for (const draw::NamedTimeline& t : timelines) {
        if (!t.note.empty()) {
            list.push_back({{"name", t.name}, {"missing", t.note}});
            continue;
        }
        const draw::TimelineFigures f = draw::figures_of(t.timeline);
        ordered_json work, segments = ordered_json::array();
        for (int w = 0; w < draw::kWorkCount; ++w)
            work[to_string(static_cast<draw::Work>(w))] =
                1e3 * f.seconds[static_cast<std::size_t>(w)];
        for (const draw::Segment& s : t.timeline.segments)
            segments.push_back({s.thread, 1e3 * s.begin, 1e3 * s.end, to_string(s.work), s.task});
        list.push_back({{"name", t.name},
                        {"threads", t.timeline.threads},
                        {"simulated", t.timeline.simulated},
                        {"step", t.timeline.step},
                        {"ms", 1e3 * t.timeline.seconds},
                        {"busy", f.busy},
                        {"balance", f.balance},
                        {"linear_algebra", f.linear_algebra},
                        {"work_ms", std::move(work)},
                        {"segment_columns", {"thread", "begin_ms", "end_ms", "work", "task"}},
                        {"segments", std::move(segments)}});
    }
    ordered_json data;
    data["timelines"] = std::move(list);
    return {name,
            draw::draw_timelines(
                timelines, title,
                {"a step of median length of each run; high boxes: tasks that any thread may take, "
                 "low ones: code of the calling thread alone"}),
            std::move(data)};
}

}  // namespace hawser::cli
