// SPDX-License-Identifier: Apache-2.0
#include "coupling_simulated.h"

#include "linear/timing.h"

#include <vector>

namespace hawser::bench::split {
namespace {

/// Sum the time of the calling thread in each stage, outside loops and inner stages, over all
/// steps.
std::array<double, kStageCount> serial_by_stage(const TraceView& trace) {
    std::array<double, kStageCount> seconds{};
    struct Open {
        double end, rest;
        int stage;
    };
    std::vector<Open> open;
    const auto close = [&] {
        const Open last = open.back();
        open.pop_back();
        if (last.stage >= 0) seconds[static_cast<std::size_t>(last.stage)] += last.rest;
    };
    // Sorted by start, longer ones first: an open span encloses the next one or has ended.
    for (const TraceSpan& s : trace.spans) {
        if (s.kind == SpanKind::task) continue;
        while (!open.empty() && open.back().end <= s.begin) close();
        if (!open.empty()) open.back().rest -= s.seconds();
        open.push_back({s.end, s.seconds(), s.kind == SpanKind::stage ? s.stage : -1});
    }
    while (!open.empty()) close();
    return seconds;
}

}  // namespace

SimulatedStep simulate_steps(const World& world, const PoolCosts& costs) {
    const TraceView trace = world.solver().trace();
    SimulatedStep result;
    std::array<std::vector<double>, kSimulatedThreads.size()> ms;
    std::vector<double> serial;
    double work = 0.0;
    for (const TraceSpan& s : trace.spans) {
        if (s.kind != SpanKind::step) continue;
        const ProgramTimes p = program_of(trace, s.begin, s.end);
        work += p.work();
        serial.push_back(p.serial() / p.work());
        for (std::size_t k = 0; k < kSimulatedThreads.size(); ++k)
            ms[k].push_back(1e3 * simulate(p, kSimulatedThreads[k], costs).seconds);
    }
    if (serial.empty()) return result;
    result.steps = static_cast<std::int64_t>(serial.size());
    result.serial = median(serial);
    for (std::size_t k = 0; k < ms.size(); ++k) result.ms[k] = median(ms[k]);
    result.serial_of = serial_by_stage(trace);
    for (double& share : result.serial_of) share /= work;
    return result;
}

}  // namespace hawser::bench::split
