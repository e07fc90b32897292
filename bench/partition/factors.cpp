// SPDX-License-Identifier: Apache-2.0
#include "partition/factors.h"

#include "factor/ordering.h"
#include "graph/partition.h"
#include "index.h"
#include "partition/foreign.h"
#include "partition/measure.h"

#include <hawser/factor.h>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

namespace hawser::bench {
namespace {

/// A factorisation and a solution of a diagonal matrix: times depend on the pattern alone.
struct OrderedFactor {
    std::string name;
    BlockFactor factor;
    std::vector<double> values, x, seconds;

    OrderedFactor(std::string what, const BlockPattern& p, const std::vector<std::int32_t>& order,
                  int threads)
        : name(std::move(what)), factor(FactorOptions{.threads = threads}) {
        factor.analyse(p, order);
        values.assign(at(factor.value_count()), 0.0);
        for (std::size_t v = 0; v < p.size.size(); ++v)
            for (int i = 0; i < p.size[v]; ++i)
                values[at(factor.value_begin(static_cast<std::int32_t>(v))) +
                       at(i * (p.size[v] + 1))] = 1.0;
        x.assign(at(factor.info().scalars), 1.0);
    }
    void run(int times) {
        for (int i = 0; i < times; ++i) {
            const auto from = std::chrono::steady_clock::now();
            if (factor.factor(values) != Status::ok || factor.solve(x) != Status::ok)
                throw std::runtime_error("a unit matrix has no factor");
            seconds.push_back(
                std::chrono::duration<double>(std::chrono::steady_clock::now() - from).count());
        }
    }
    /// Return the first decile of the samples: disturbances only lengthen them [s].
    [[nodiscard]] double best() const {
        std::vector<double> v = seconds;
        const auto k = static_cast<std::ptrdiff_t>(v.size() / 10);
        std::nth_element(v.begin(), v.begin() + k, v.end());
        return v[static_cast<std::size_t>(k)];
    }
};

/// Compute Hawser's order, balanced by exact flops: the most even of five iterations.
std::vector<std::int32_t> our_order(const PartCase& c, int parts, const FactorCounts& amd) {
    graph::Partitioner p;
    graph::Partition out;
    std::vector<std::int64_t> exact;
    std::vector<std::int32_t> best;
    double least = 0.0;
    for (int k = 0; k < 5; ++k) {
        p.read(c.graph(exact));
        p.separate({parts}, out);
        const std::vector<std::int32_t> order = order_parts(c.pattern, out.part);
        const PartRow row = measure_parts("", c, out.part, parts, amd);
        exact = inside_costs(c.pattern, out.part, row.counts.node);
        if (best.empty() || (k > 0 && row.imbalance < least)) {
            best = order;
            least = row.imbalance;
        }
    }
    return best;
}

}  // namespace

std::vector<FactorTimes> compare_factors(const PartCase& c, int parts, int turns) {
    BlockPattern p;
    p.size = c.pattern.size;
    p.sign = c.pattern.sign;
    for (std::int32_t v = 0; v < c.pattern.nodes(); ++v)
        for (const std::int32_t u : c.pattern.neighbours(v))
            if (u < v) p.edges.push_back({v, u});
    ForeignGraph g(c.pattern);
    std::vector<std::int32_t> part = metis_parts(g, g.weight, parts);
    if (part.empty()) return {};
    cover_cuts(c.pattern, part);
    const std::vector<std::int32_t> theirs = order_parts(c.pattern, part),
                                    amd = factor::order_nodes(c.pattern),
                                    ours = our_order(c, parts, count_factor(c.pattern, amd));
    std::vector<FactorTimes> out;
    fmt::print("{}: factorisation and solution, separators of {} parts last [us]\n", c.name, parts);
    for (const int threads : {1, 2}) {
        OrderedFactor a("ours", p, ours, threads), b("METIS", p, theirs, threads),
            none("AMD", p, amd, threads);
        for (int k = 0; k < turns; ++k)
            for (OrderedFactor* f : {&a, &b, &none}) f->run(20);
        fmt::print(
            "  {} thread(s): ours {:>7.1f}, METIS {:>7.1f}: ours takes {:.2f} of it; AMD "
            "{:>7.1f}\n",
            threads, 1e6 * a.best(), 1e6 * b.best(), a.best() / b.best(), 1e6 * none.best());
        out.push_back({threads, a.best(), b.best(), none.best()});
    }
    return out;
}

nlohmann::json factor_json(const std::vector<FactorTimes>& times) {
    nlohmann::json out = nlohmann::json::object();
    for (const FactorTimes& t : times)
        out[std::to_string(t.threads)] = {{"ours_seconds", t.ours},
                                          {"metis_seconds", t.metis},
                                          {"amd_seconds", t.amd},
                                          {"ours_over_metis", t.ours / t.metis}};
    return out;
}

}  // namespace hawser::bench
