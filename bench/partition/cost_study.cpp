// SPDX-License-Identifier: Apache-2.0
#include "partition/cost_study.h"

#include "draw/axes.h"
#include "draw/drawing.h"
#include "draw/svg.h"
#include "factor/ordering.h"
#include "graph/cost.h"
#include "graph/neighbours.h"
#include "index.h"
#include "linear/problem.h"
#include "paper_matrix/structures.h"
#include "partition/cases.h"
#include "partition/measure.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <span>

namespace hawser::bench {
namespace {

constexpr std::size_t kPredictors = 4;
constexpr std::array<const char*, kPredictors> kNames{"c of the paper", "c in flops", "exact flops",
                                                      "METIS vertex weights"};

struct Sample {
    std::string name;
    int bodies = 0;
    std::array<double, kPredictors> cost{};
    double seconds = 0.0, cost_seconds = 0.0, amd_seconds = 0.0;
};

Sample sample(const PartCase& c) {
    Sample s;
    s.name = c.name;
    s.bodies = c.bodies();
    graph::Neighbours neighbours;
    graph::Cost cost;
    const graph::Hypergraph g = c.graph();
    neighbours.build(g);
    s.cost_seconds = median_seconds([&] { cost.build(g, neighbours); }, 5);
    std::vector<std::int32_t> order;
    FactorCounts counts;
    s.amd_seconds = median_seconds([&] { order = factor::order_nodes(c.pattern); }, 5);
    counts = count_factor(c.pattern, order);
    s.cost[0] =
        static_cast<double>(std::accumulate(cost.paper.begin(), cost.paper.end(), std::int64_t{0}));
    s.cost[1] =
        static_cast<double>(std::accumulate(cost.node.begin(), cost.node.end(), std::int64_t{0}));
    s.cost[2] = static_cast<double>(counts.flops);
    s.cost[3] = std::accumulate(c.size.begin(), c.size.end(), 0.0);
    s.seconds = factor_seconds(c.pattern, order, 11);
    return s;
}

std::vector<PartCase> all_islands() {
    std::vector<PartCase> cases;
    const auto take = [&](const PartCase& all, std::size_t most) {
        for (PartCase& c : islands_of(all))
            if (c.bodies() >= 8 && most-- > 0) cases.push_back(std::move(c));
    };
    for (const char* file : {"anchor_lines", "anchor_contact", "mooring", "mooring_seabed",
                             "heavy_hook", "tow_zigzag", "hanging_chain", "wall_648", "arch"}) {
        const std::string path = std::string("scenes/") + file + ".json";
        if (!std::filesystem::exists(path)) continue;
        PartCase c = make_case(scene_system(path, 1));
        c.name = file;
        take(c, 4);
    }
    for (int elements = 30; elements <= 94; elements += 4)
        for (const bool rigid : {false, true})
            take(paper_case(rigid, 1, elements, static_cast<std::uint64_t>(elements)), 1);
    for (int side = 4; side <= 30; side += 1) take(make_case(net(side)), 1);
    for (int k = 1; k <= 40; ++k) {
        take(star_case(1 + k % 11, 10 + 6 * k, static_cast<std::uint64_t>(k)), 1);
        take(random_case(10 + k * k / 3, static_cast<std::uint64_t>(k)), 1);
        take(make_case(chain(8 + 20 * k)), 1);
    }
    for (int levels = 2; levels <= 6; ++levels)
        for (const int links : {5, 10, 20, 40}) take(make_case(tree_of_chains(levels, links)), 1);
    return cases;
}

/// Return ranks; equal values get their mean rank.
std::vector<double> ranks(const std::vector<double>& v) {
    std::vector<std::size_t> order(v.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return v[a] < v[b]; });
    std::vector<double> rank(v.size());
    for (std::size_t i = 0; i < v.size();) {
        std::size_t j = i;
        while (j < v.size() && v[order[j]] == v[order[i]]) ++j;
        for (std::size_t k = i; k < j; ++k) rank[order[k]] = 0.5 * static_cast<double>(i + j - 1);
        i = j;
    }
    return rank;
}

double correlation(const std::vector<double>& x, const std::vector<double>& y) {
    const auto n = static_cast<double>(x.size());
    const double mx = std::accumulate(x.begin(), x.end(), 0.0) / n;
    const double my = std::accumulate(y.begin(), y.end(), 0.0) / n;
    double xy = 0.0, xx = 0.0, yy = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        xy += (x[i] - mx) * (y[i] - my);
        xx += (x[i] - mx) * (x[i] - mx);
        yy += (y[i] - my) * (y[i] - my);
    }
    return xy / std::sqrt(xx * yy);
}

/// Time = factor · cost: factor by the geometric mean, and the typical and the largest ratio to it.
struct Fit {
    double rank = 0.0, factor = 0.0, typical = 0.0, worst = 0.0;
};

Fit fit(const std::vector<Sample>& samples, std::size_t predictor) {
    std::vector<double> x, y, off;
    double sum = 0.0;
    for (const Sample& s : samples) {
        x.push_back(s.cost[predictor]);
        y.push_back(s.seconds);
        sum += std::log(s.seconds / s.cost[predictor]);
    }
    Fit f;
    f.rank = correlation(ranks(x), ranks(y));
    f.factor = std::exp(sum / static_cast<double>(samples.size()));
    double squares = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double d = std::log(y[i] / (f.factor * x[i]));
        squares += d * d;
        f.worst = std::max(f.worst, std::abs(d));
    }
    f.typical = std::exp(std::sqrt(squares / static_cast<double>(samples.size())));
    f.worst = std::exp(f.worst);
    return f;
}

void draw(const std::vector<Sample>& samples, const std::vector<Fit>& fits,
          const std::string& file) {
    draw::Drawing d;
    d.width = 1200.0;
    d.height = 1000.0;
    draw::draw_heading(
        d, "Predicted and measured time of a factorisation, one thread",
        fmt::format("{} islands; logarithms to base ten of microseconds", samples.size()));
    for (std::size_t p = 0; p < kPredictors; ++p) {
        draw::Axes axes;
        axes.frame = {90.0 + 570.0 * static_cast<double>(p % 2),
                      110.0 + 450.0 * static_cast<double>(p / 2), 480.0, 350.0};
        axes.x = {-1.0, 6.0};
        axes.y = {0.0, 5.0};
        axes.x_label = "log10 predicted [us]";
        axes.y_label = "log10 measured [us]";
        axes.title = fmt::format("{}: rank {:.3f}, off by {:.2f}x", kNames[p], fits[p].rank,
                                 fits[p].typical);
        axes.draw(d);
        d.line(axes.at(0.0, 0.0), axes.at(5.0, 5.0), draw::kSoft, 1.0, {4.0, 4.0});
        draw::Cells cells;
        cells.fill = draw::curve_color(p);
        for (const Sample& s : samples) {
            const double x = std::log10(1e6 * fits[p].factor * s.cost[p]);
            const double y = std::log10(1e6 * s.seconds);
            if (x < axes.x.low || x > axes.x.high || y < axes.y.low || y > axes.y.high) continue;
            const draw::Point at = axes.at(x, y);
            cells.boxes.push_back({at.x - 2.0, at.y - 2.0, 4.0, 4.0});
        }
        d.add(std::move(cells));
    }
    std::ofstream(file) << draw::to_svg(d);
}

}  // namespace

nlohmann::json cost_study(const std::string& picture) {
    std::vector<Sample> samples;
    for (const PartCase& c : all_islands()) samples.push_back(sample(c));
    fmt::print(
        "{} islands of 8 to {} bodies; time = factor x cost\n", samples.size(),
        std::max_element(samples.begin(), samples.end(), [](const Sample& a, const Sample& b) {
            return a.bodies < b.bodies;
        })->bodies);
    fmt::print("{:<22} {:>9} {:>12} {:>10}\n", "cost", "rank", "typically", "at worst");
    nlohmann::json rows = nlohmann::json::array();
    std::vector<Fit> fits;
    for (std::size_t p = 0; p < kPredictors; ++p) {
        const Fit f = fit(samples, p);
        fits.push_back(f);
        fmt::print("{:<22} {:>9.3f} {:>11.2f}x {:>9.2f}x\n", kNames[p], f.rank, f.typical, f.worst);
        rows.push_back({{"cost", kNames[p]},
                        {"rank", f.rank},
                        {"typically_off", f.typical},
                        {"worst_off", f.worst}});
    }
    double cost = 0.0, amd = 0.0, factor = 0.0;
    for (const Sample& s : samples) {
        cost += s.cost_seconds;
        amd += s.amd_seconds;
        factor += s.seconds;
    }
    fmt::print("all islands: c {:.3g} ms, AMD {:.3g} ms ({:.1f}x), factorisation {:.3g} ms\n",
               1e3 * cost, 1e3 * amd, amd / cost, 1e3 * factor);
    if (!picture.empty()) draw(samples, fits, picture);
    nlohmann::json list = nlohmann::json::array();
    for (const Sample& s : samples)
        list.push_back({{"name", s.name},
                        {"bodies", s.bodies},
                        {"cost", s.cost},
                        {"seconds", s.seconds},
                        {"cost_seconds", s.cost_seconds},
                        {"amd_seconds", s.amd_seconds}});
    return {{"fits", rows}, {"islands", list}, {"cost_seconds", cost}, {"amd_seconds", amd}};
}

}  // namespace hawser::bench
