// SPDX-License-Identifier: Apache-2.0
// hawser-bench sea: cost of waves, hulls and their memory by instruction set, and of a step of
// bench/scenes/frozen/anchor_sea.json.
#include <hawser/scene.h>
#include <hawser/sea.h>

#include "base/isa.h"
#include "base/memory.h"
#include "commands.h"
#include "fraction_of.h"
#include "marine/hull_kernels.h"
#include "marine/hull_sums.h"
#include "marine/memory_sums.h"
#include "marine/spectra.h"
#include "marine/wave_sums.h"
#include "verdict.h"

#include <fmt/core.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>
#include <string>
#include <vector>

namespace hawser::bench {
namespace {

constexpr const char* kSeaFooter =
    R"(CPU time of the calling thread, medians: of 41 rounds for kernels, of the steps after the first 60 for
the scene. Bars: clipping 20 ns a triangle, each by itself (beside the kernels what a step takes for one);
waves 3.5 ns a component and point (AVX-512), 5.5 (AVX2); memory of 60 s, six motions, 10 us a step;
bench/scenes/frozen/anchor_sea.json prestep 1.3 ms on one thread and 0.8 on two (wall time), step 2 ms on one. Exit
code 1 where one is missed.)";

double sea_cpu() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// Return the median CPU time of a call, of rounds of `repeat` calls [s].
template <class Call>
double time_of(int repeat, Call&& call) {
    std::vector<double> rounds;
    for (int r = 0; r < 41; ++r) {
        const double start = sea_cpu();
        for (int i = 0; i < repeat; ++i) call(i);
        rounds.push_back((sea_cpu() - start) / repeat);
    }
    return fraction_of(rounds, 0.5);
}

struct Set {
    base::Isa isa;
    const marine::WaveKernels* waves;
    const marine::MemoryKernels* memory;
    const marine::HullKernels* hulls;
    double bar;  ///< Bar of waves [ns]; 0: none.
};

std::vector<Set> sets() {
    std::vector<Set> all{
        {base::Isa::sse2, &sse2::kWaveKernels, &sse2::kMemoryKernels, &sse2::kHullKernels, 0.0}};
#if !defined(HAWSER_NO_AVX2)
    if (base::isa() >= base::Isa::avx2)
        all.push_back({base::Isa::avx2, &avx2::kWaveKernels, &avx2::kMemoryKernels,
                       &avx2::kHullKernels, 5.5});
#endif
#if !defined(HAWSER_NO_AVX512)
    if (base::isa() >= base::Isa::avx512)
        all.push_back({base::Isa::avx512, &avx512::kWaveKernels, &avx512::kMemoryKernels,
                       &avx512::kHullKernels, 3.5});
#endif
    return all;
}

/// Measure [ns] per component and point, kWavePoints at a time, down to 5 m: elevation, velocity,
/// acceleration, pressure.
double waves_ns(const marine::WaveKernels& by) {
    SeaDef def{.depth = 150.0};
    def.waves.push_back({.kind = WaveKind::jonswap,
                         .height = 3.0,
                         .period = 9.0,
                         .spreading = 10.0,
                         .components = 400});
    const Sea sea(def);
    const auto table = marine::wave_table(sea.components(), def.depth);
    const SeaMoment now = sea.at(100.0);
    constexpr int kPoints = marine::kWavePoints;
    alignas(64) static double circle[2 * kMaxWaveComponents * kPoints];
    double kept = 0.0;
    const double seconds = time_of(200 / kPoints, [&](int i) {
        double x[kPoints], y[kPoints], z[kPoints], surface[kPoints];
        for (int p = 0; p < kPoints; ++p) {
            x[p] = 0.3 * (kPoints * i + p);
            y[p] = -0.1 * (kPoints * i + p);
            z[p] = -0.05 * ((kPoints * i + p) % 100);
        }
        marine::WaveSums sums[kPoints];
        by.many.surface(table.data(), 400, now.phase.data(), x, y, circle, surface);
        by.many.sums(table.data(), 400, circle, z, sums);
        kept += surface[0] + sums[0].p;
    });
    if (!std::isfinite(kept)) fmt::print("not finite\n");
    return 1e9 * seconds / (400.0 * kPoints);
}

/// Measure [us] per step: 60 s at 60 Hz, all 21 pairs of six motions.
double memory_us(const marine::MemoryKernels& by) {
    constexpr std::int64_t kSamples = 3599;
    base::Array<double> k(21 * marine::memory_padded(kSamples), 1e-3),
        v(6 * marine::memory_stride(kSamples), 0.5);
    std::vector<int> pairs;
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j <= i; ++j) pairs.insert(pairs.end(), {i, j});
    double out[6] = {};
    const double seconds = time_of(40, [&](int i) {
        by.sums(k.data(), v.data(), kSamples, 89 * i % kSamples, pairs.data(), 21, out);
    });
    if (!std::isfinite(out[0])) fmt::print("not finite\n");
    return 1e6 * seconds;
}

/// A hull partly cut by the surface.
struct CutHull {
    HullMesh mesh = box_hull({40, 9, 6}, 40, 9, 6);
    std::vector<marine::HullCorner> corners;
    CutHull() {
        for (const Vec3& x : mesh.vertices) {
            const double depth = 0.8 * std::sin(0.05 * x.x()) - x.z();
            corners.push_back({x, depth, 1e4 * std::max(depth, 0.0)});
        }
    }
};

/// Measure [ns] per triangle, clipped one by one.
double clipping_ns() {
    const auto [mesh, corners] = CutHull();
    const auto at = [&](std::int32_t i) -> const marine::HullCorner& {
        return corners[static_cast<std::size_t>(i)];
    };
    double kept = 0.0;
    const double seconds = time_of(20, [&](int) {
        marine::HullSums sums;
        for (const auto& t : mesh.triangles) sums.add_triangle(at(t[0]), at(t[1]), at(t[2]));
        kept += sums.volume;
    });
    if (!std::isfinite(kept)) fmt::print("not finite\n");
    return 1e9 * seconds / static_cast<double>(mesh.triangles.size());
}

/// Measure [ns] per triangle like in a step: wet ones in batches, cut ones one by one.
double hull_ns(const marine::HullKernels& by) {
    const CutHull hull;
    const auto& triangles = hull.mesh.triangles;
    const auto at = [&](std::int32_t i) -> const marine::HullCorner& {
        return hull.corners[static_cast<std::size_t>(i)];
    };
    const auto count = static_cast<int>(triangles.size());
    double kept = 0.0;
    const double seconds = time_of(20, [&](int) {
        for (int first = 0; first < count; first += marine::kHullBlock) {
            double sums[marine::kHullSums];
            int cut[marine::kHullBlock];
            const auto* const from = &triangles[static_cast<std::size_t>(first)];
            const int cuts = by.wet(hull.corners.front().x.data(), from->data(),
                                    std::min(marine::kHullBlock, count - first), cut, sums);
            marine::HullSums rest;
            for (int i = 0; i < cuts; ++i)
                rest.add_triangle(at(from[cut[i]][0]), at(from[cut[i]][1]), at(from[cut[i]][2]));
            kept += sums[marine::kVolume] + rest.volume;
        }
    });
    if (!std::isfinite(kept)) fmt::print("not finite\n");
    return 1e9 * seconds / count;
}

struct SceneFigures {
    int threads = 1;
    double prestep = 0.0, step = 0.0, cpu = 0.0, cpu95 = 0.0, cpu99 = 0.0;  ///< [ms].
    double factorisations = 0.0;
};

SceneFigures scene_figures(const std::string& file, int threads, int steps) {
    scene::Options options;
    options.threads = threads;
    scene::Scene scene = scene::load_file(file, options);
    World& w = scene.world;
    std::vector<double> prestep, wall, cpu, work;
    for (int i = 0; i < 60 + steps; ++i) {
        const double start = sea_cpu();
        if (w.step() != Status::ok) throw std::runtime_error(file + ": a step failed");
        if (i < 60) continue;
        cpu.push_back(1e3 * (sea_cpu() - start));
        const StepStats& s = w.stats();
        prestep.push_back(1e3 * s.stage_seconds[static_cast<std::size_t>(Stage::prestep)]);
        wall.push_back(1e3 * s.step_seconds);
        work.push_back(s.factorisations);
    }
    return {threads,
            fraction_of(prestep, 0.5),
            fraction_of(wall, 0.5),
            fraction_of(cpu, 0.5),
            fraction_of(cpu, 0.95),
            fraction_of(cpu, 0.99),
            fraction_of(work, 0.5)};
}

}  // namespace

int sea_command(int argc, char** argv) {
    CLI::App app{"What the sea costs"};
    app.name("hawser-bench sea");
    app.footer(kSeaFooter);
    std::string file = "bench/scenes/frozen/anchor_sea.json", json_file;
    int steps = 1200;
    app.add_option("--scene", file, "Scene with a sea")->check(CLI::ExistingFile);
    app.add_option("--steps", steps, "Steps that are timed")->check(CLI::Range(1, 1'000'000));
    app.add_option("--json", json_file, "Write the results as JSON");
    CLI11_PARSE(app, argc, argv);

    Verdict verdict;
    nlohmann::json kernels = nlohmann::json::object(), scenes = nlohmann::json::array();
    for (const Set& set : sets()) {
        const double waves = waves_ns(*set.waves), memory = memory_us(*set.memory),
                     hull = hull_ns(*set.hulls);
        kernels[base::to_string(set.isa)] = {
            {"wave_ns", waves}, {"memory_us", memory}, {"hull_ns", hull}};
        const std::string name = base::to_string(set.isa);
        const std::string what = fmt::format(
            "{:.2f} ns a component and point, memory of 60 s {:.2f} us a step, hull {:.1f} ns a "
            "triangle",
            waves, memory, hull);
        if (set.bar > 0.0)
            verdict.require("kernels", name, waves <= set.bar && memory <= 10.0, what);
        else
            fmt::print("          {}: {}\n", name, what);
    }
    const double clip = clipping_ns();
    verdict.require("clipping", "", clip <= 20.0,
                    fmt::format("clipping {:.1f} ns a triangle", clip));
    for (const int threads : {1, 2}) {
        const SceneFigures f = scene_figures(file, threads, steps);
        const bool good = f.prestep <= (threads == 1 ? 1.3 : 0.8) && (threads > 1 || f.step <= 2.0);
        verdict.require("scene", fmt::format("{} on {}", file, threads), good,
                        fmt::format("prestep {:.3f} ms, step {:.3f} ms; CPU of the stepping thread "
                                    "p50/p95/p99 {:.3f}/{:.3f}/{:.3f} ms, {:.0f} factorisations",
                                    f.prestep, f.step, f.cpu, f.cpu95, f.cpu99, f.factorisations));
        scenes.push_back({{"threads", threads},
                          {"prestep_ms", f.prestep},
                          {"step_ms", f.step},
                          {"step_cpu_ms", {{"p50", f.cpu}, {"p95", f.cpu95}, {"p99", f.cpu99}}},
                          {"factorisations", f.factorisations}});
    }
    if (!json_file.empty())
        std::ofstream(json_file) << nlohmann::json({{"kernels", kernels},
                                                    {"clipping_ns", clip},
                                                    {"scene", scenes},
                                                    {"bars", verdict.json()}})
                                        .dump(2)
                                 << '\n';
    return verdict.exit_code();
}

}  // namespace hawser::bench
