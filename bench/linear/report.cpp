// SPDX-License-Identifier: Apache-2.0
#include "linear/report.h"

#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <map>

namespace hawser::bench {
namespace {

using nlohmann::json;

/// Return the result of Hawser with an equal number of threads, or null.
const Result* ours(const std::vector<Result>& results, int threads) {
    for (const Result& r : results)
        if (r.library == "hawser" && r.threads == threads) return &r;
    return nullptr;
}

std::string gflops(const Result& r) {
    return r.flops > 0.0 && r.phases.factor > 0.0
               ? fmt::format("{:.2f}", 1e-9 * r.flops / r.phases.factor)
               : "-";
}

std::string update_ms(const Result& r, int count) {
    for (const UpdateTime& u : r.update)
        if (u.changed == count) return fmt::format("{:.3f}", 1e3 * u.time);
    return "-";
}

double best_sample(const Result& r) {
    return r.totals.empty() ? r.total : *std::min_element(r.totals.begin(), r.totals.end());
}

json result_json(const Result& r) {
    json updates = json::array();
    for (const UpdateTime& u : r.update)
        updates.push_back(
            {{"contacts_changed", u.changed},
             {"ms", 1e3 * u.time},
             {"analysed_anew_ms",
              u.analysis_from_scratch < 0.0 ? json() : json(1e3 * u.analysis_from_scratch)}});
    json samples = json::array();
    for (const double t : r.totals) samples.push_back(1e3 * t);
    if (!r.failure.empty())
        return {{"solver", r.library},
                {"form", r.form},
                {"order", r.order},
                {"threads", r.threads},
                {"failure", r.failure}};
    return {
        {"solver", r.library},
        {"form", r.form},
        {"order", r.order},
        {"threads", r.threads},
        {"analyse_ms", 1e3 * r.analyse},
        {"own_analyse_ms", r.own_order_analysis < 0.0 ? json() : json(1e3 * r.own_order_analysis)},
        {"update", updates},
        {"refresh_ms", 1e3 * r.phases.refresh},
        {"factor_ms", 1e3 * r.phases.factor},
        {"solve_ms", 1e3 * r.phases.solve},
        {"refine_ms", 1e3 * r.phases.refine},
        {"total_ms", 1e3 * r.total},
        {"samples_ms", samples},
        {"factor_nnz", r.factor_nnz},
        {"flops", r.flops},
        {"bytes", r.bytes},
        {"error", r.error}};
}

void print_memory(const ProblemReport& report) {
    for (const Result& r : report.best) {
        if (r.library != "hawser" || r.threads != 1) continue;
        // The panels are written with the values and with L, and each of the two solutions reads L
        // twice.
        const double l = 8.0 * r.factor_nnz;
        fmt::print(
            "  hawser: {:.0f} B/body; {:.1f} ns/body; L {:.2f} MB; factor writes L at "
            "{:.2f} GB/s, solve reads it at {:.2f} GB/s\n",
            r.bytes / report.bodies, 1e9 * r.total / report.bodies, 1e-6 * l,
            1e-9 * l / r.phases.factor, 1e-9 * 2.0 * l / r.phases.solve);
        for (const UpdateTime& u : r.update)
            fmt::print(
                "  hawser: {} contacts changed: update {:.3f} ms, an analysis in turns with it "
                "{:.3f} ms: {:.2f} times\n",
                u.changed, 1e3 * u.time, 1e3 * u.analysis_from_scratch,
                u.analysis_from_scratch / u.time);
    }
}

}  // namespace

void print_report(const ProblemReport& report) {
    fmt::print(
        "\n{}: {} bodies, {} scalars, nnz of the lower triangle {:.0f} saddle, {:.0f} "
        "condensed\n",
        report.name, report.bodies, report.scalars, report.nnz_saddle, report.nnz_condensed);
    fmt::print("{:<20} {:<9} {:<15} {:>1} {:>9} {:>9} {:>9} {:>9} {:>9} {:>6} {:>8} {:>8}\n",
               "solver", "form", "order", "t", "refresh", "factor", "solve", "refine", "total ms",
               "ratio", "GFLOP/s", "error");
    for (const Result& r : report.best) {
        if (!r.failure.empty()) continue;
        const Result* base = ours(report.best, r.threads);
        const std::string ratio =
            base == nullptr ? "-" : fmt::format("{:.2f}", r.total / base->total);
        fmt::print(
            "{:<20} {:<9} {:<15} {:>1} {:>9.4f} {:>9.4f} {:>9.4f} {:>9.4f} {:>9.4f} {:>6} "
            "{:>8} {:>8}\n",
            r.library, r.form, r.order, r.threads, 1e3 * r.phases.refresh, 1e3 * r.phases.factor,
            1e3 * r.phases.solve, 1e3 * r.phases.refine, 1e3 * r.total, ratio, gflops(r),
            report.reference_correction < 0.0 ? "-" : fmt::format("{:.1e}", r.error));
    }
    // "own": the library alone, on the scalar matrix and with its own order.
    fmt::print("{:<20} {:>1} {:>10} {:>6} {:>10} {:>6} {:>10} {:>10} {:>10} {:>12} {:>10}\n", "",
               "t", "analyse ms", "ratio", "own ms", "ratio", "update 10", "update 50",
               "update 200", "nnz(L)", "Mflop");
    for (const Result& r : report.best) {
        if (!r.failure.empty()) continue;
        const Result* base = ours(report.best, r.threads);
        auto ratio = [&](double time) {
            return base == nullptr || time < 0.0 ? "-"
                                                 : fmt::format("{:.2f}", time / base->analyse);
        };
        fmt::print(
            "{:<20} {:>1} {:>10.3f} {:>6} {:>10} {:>6} {:>10} {:>10} {:>10} {:>12.0f} {:>10}\n",
            r.library, r.threads, 1e3 * r.analyse, ratio(r.analyse),
            r.own_order_analysis < 0.0 ? "-" : fmt::format("{:.3f}", 1e3 * r.own_order_analysis),
            ratio(r.own_order_analysis), update_ms(r, 10), update_ms(r, 50), update_ms(r, 200),
            r.factor_nnz, r.flops > 0.0 ? fmt::format("{:.2f}", 1e-6 * r.flops) : "-");
    }
    print_memory(report);
    for (const Result& r : report.tried)
        if (!r.failure.empty())
            fmt::print("  failed: {}, {}, {}, {} thread(s): {}\n", r.library, r.form, r.order,
                       r.threads, r.failure);
    std::fflush(stdout);
}

void print_thread_gain(const std::vector<ProblemReport>& reports) {
    fmt::print(
        "\nGain of threads: T(1) / T(t); refactor + solve of medians, all of medians, all of the\n"
        "best samples (which other programs disturb least)\n");
    fmt::print("{:<20} {:>9} {:<20} {:>2} {:>10} {:>10} {:>13} {:>7} {:>7}\n", "matrix", "scalars",
               "solver", "t", "T(1) ms", "T(t) ms", "factor+solve", "all", "best");
    std::map<std::string, std::vector<std::pair<int, bool>>> gains;
    for (const ProblemReport& p : reports)
        for (const Result& one : p.best)
            for (const Result& many : p.best) {
                if (one.threads != 1 || many.threads == 1 || one.library != many.library ||
                    !one.failure.empty() || !many.failure.empty())
                    continue;
                const double gain = best_sample(one) / best_sample(many);
                fmt::print(
                    "{:<20} {:>9} {:<20} {:>2} {:>10.3f} {:>10.3f} {:>13.2f} {:>7.2f} "
                    "{:>7.2f}\n",
                    p.name, p.scalars, one.library, many.threads, 1e3 * one.total, 1e3 * many.total,
                    (one.phases.factor + one.phases.solve) /
                        (many.phases.factor + many.phases.solve),
                    one.total / many.total, gain);
                gains[one.library].emplace_back(p.scalars, gain > 1.1);
            }
    // Find the smallest matrix from which on every larger one gains 10 % or more.
    for (auto& [library, list] : gains) {
        std::sort(list.begin(), list.end());
        auto from = list.end();
        while (from != list.begin() && std::prev(from)->second) --from;
        if (from == list.end())
            fmt::print("  {} does not gain 10 % on the largest matrix here\n", library);
        else
            fmt::print("  {} gains 10 % or more from {} scalars on\n", library, from->first);
    }
}

nlohmann::json to_json(const ProblemReport& report) {
    json best = json::array(), tried = json::array();
    for (const Result& r : report.best) {
        best.push_back(result_json(r));
        const Result* base = ours(report.best, r.threads);
        if (base == nullptr || !r.failure.empty()) continue;
        best.back()["analyse_ratio"] = r.analyse / base->analyse;
        if (r.own_order_analysis >= 0.0)
            best.back()["own_analyse_ratio"] = r.own_order_analysis / base->analyse;
    }
    for (const Result& r : report.tried) tried.push_back(result_json(r));
    return {{"name", report.name},
            {"bodies", report.bodies},
            {"scalars", report.scalars},
            {"scale", report.scale},
            {"nnz_saddle", report.nnz_saddle},
            {"nnz_condensed", report.nnz_condensed},
            {"reference_correction", report.reference_correction},
            {"best", best},
            {"tried", tried}};
}

}  // namespace hawser::bench
