// SPDX-License-Identifier: Apache-2.0
#include "coupling_chains.h"

#include "verify/coupling.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace hawser::bench::split {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kStep = 1.0 / 60;

/// Make point masses along x, 10 m apart, joined by rods of stiffness k and damping time n h; those
/// from `border` on are another group.
World chain(const std::vector<double>& mass, double k, double n, std::size_t border,
            Coupling coupling, Predictor predictor) {
    WorldDef def;
    def.step = kStep;
    def.gravity = Vec3::Zero();
    def.staggered_start = false;
    def.geometric_stiffness = 0.0;
    def.coupling = coupling;
    def.predictor = predictor;
    World world(def);
    for (std::size_t i = 0; i < mass.size(); ++i) {
        BodyDef body;
        body.kind = BodyKind::lump;
        body.position = {10.0 * static_cast<double>(i), 0, 0};
        body.mass = mass[i];
        body.group = i < border ? "a" : "b";
        world.add_body(body);
    }
    for (std::int32_t i = 0; i + 1 < static_cast<std::int32_t>(mass.size()); ++i) {
        InteractionDef d;
        d.kind = InteractionKind::Distance;
        d.body = {BodyId{i}, BodyId{i + 1}};
        d.compliance[0] = 1.0 / k;
        d.damping_time[0] = n * kStep;
        world.add_interaction(d.set("length", 10.0));
    }
    world.prepare();
    return world;
}

/// Compute A (1 + Υ(2 − R)): at most 2 if stable (docs/theory/splits.md).
double criterion(double m1, double m2, double k, double n) {
    const double z = k * kStep * kStep * (1.0 / m1 + 1.0 / m2) * (n + 0.25);
    const double late = -1.0 / std::expm1(-z) - 1.0 / z;
    const double upsilon = 1.0 / (1.0 + 4.0 * n * late), recall = 1.0 - 4.0 * n * (1.0 - late);
    const double sigma = 4.0 * upsilon / (k * kStep * kStep);
    return (1.0 / (1.0 + m1 * sigma) + 1.0 / (1.0 + m2 * sigma)) * (1.0 + upsilon * (2.0 - recall));
}

/// Find the largest k for which `stable(k)`, to 0.1 %.
template <class F>
double largest(F&& stable) {
    double low = 1.0, high = 1e12;
    while (high / low > 1.001) {
        const double k = std::sqrt(low * high);
        (stable(k) ? low : high) = k;
    }
    return std::sqrt(low * high);
}

/// True if the stretch of the one rod grows in 2,000 steps. Growth vanishes at the boundary, where
/// the spectral radius does not resolve 1 %.
bool stretch_grows(World& world) {
    Twist kick;
    kick.linear = {1e-3, 0, 0};
    world.set_velocity(BodyId{0}, kick);
    auto most = [&](int steps) {
        double g = 0.0;
        for (int i = 0; i < steps; ++i) {
            if (world.step() != Status::ok) return HUGE_VAL;
            g = std::max(g, std::fabs(world.violation(InteractionId{0})[0]));
            if (!(g < 1.0)) return HUGE_VAL;
        }
        return g;
    };
    const double early = most(200);
    (void)most(1600);
    const double late = most(200);
    return late == HUGE_VAL || late > 1.5 * early;
}

/// Return the growth per step after a kick of 1 nm/s. The chain at rest is linear for it, so that
/// this is the spectral radius, including multipliers of the last step. Measured until it is 1e8
/// times as large, or for 2,000 steps, over which a neutral motion changes by less than a
/// thousandth per step.
double growth(World& world) {
    const int bodies = world.body_count();
    std::vector<double> v(static_cast<std::size_t>(bodies), 0.0);
    for (std::int32_t b = 0; b < bodies; ++b) {
        Twist kick;
        kick.linear = {1e-9 * std::sin(1.0 + 2.3 * b), 0, 0};
        world.set_velocity(BodyId{b}, kick);
    }
    auto change = [&](int steps) {
        double most = 0.0;
        for (int i = 0; i < steps; ++i) {
            if (world.step() != Status::ok) return HUGE_VAL;
            for (std::int32_t b = 0; b < bodies; ++b) {
                const double now = world.velocity(BodyId{b}).linear[0];
                double& before = v[static_cast<std::size_t>(b)];
                most = std::max(most, std::fabs(now - before));
                before = now;
            }
        }
        return most;
    };
    constexpr int kWindow = 4;
    (void)change(kWindow);
    const double first = change(kWindow);
    double last = first;
    int steps = 0;
    do {
        last = change(kWindow);
        steps += kWindow;
    } while (steps < 2000 && last < 0.1 && last > 1e-14);
    return std::pow(last / first, 1.0 / steps);
}

}  // namespace

Json two_body_boundaries(int cases) {
    fmt::print(
        "Two bodies, kinematic, hold: largest stable k h2/m1\n  {:>6} {:>6} {:>6} {:>12} "
        "{:>12} {:>8}\n",
        "m1", "m2", "n", "measured", "theory", "off %");
    Json rows = Json::array();
    for (const auto& [m1, m2, n] :
         {std::array{1.0, 1.0, 0.0}, std::array{1.0, 1.0, 0.5}, std::array{1.0, 1.0, 2.0},
          std::array{1.0, 10.0, 0.0}, std::array{1.0, 10.0, 2.0}, std::array{3.0, 100.0, 0.5}}) {
        if (static_cast<int>(rows.size()) == cases) break;
        const double theory = largest([&](double k) { return criterion(m1, m2, k, n) <= 2.0; });
        const double found = largest([&](double k) {
            World world = chain({m1, m2}, k, n, 1, Coupling::kinematic, Predictor::hold);
            return !stretch_grows(world);
        });
        const double unit = kStep * kStep / m1, off = 100.0 * (found / theory - 1.0);
        fmt::print("  {:>6} {:>6} {:>6} {:>12.5g} {:>12.5g} {:>8.3f}\n", m1, m2, n, found * unit,
                   theory * unit, off);
        rows.push_back({{"m1", m1},
                        {"m2", m2},
                        {"n", n},
                        {"measured", found * unit},
                        {"theory", theory * unit},
                        {"off_percent", off}});
    }
    return rows;
}

Json chain_predictors() {
    struct Case {
        const char* name;
        std::size_t border, heavy;  ///< heavy: index of a body of 1000 m, or none
    };
    constexpr std::size_t kNone = 99;
    const Case cases[] = {
        {"middle", 6, kNone}, {"beside heavy", 6, 6}, {"beside heavy end", 11, 11}};
    fmt::print(
        "\nTwelve bodies: largest spectral radius over k h2/m = 1 … 1e6, and the first "
        "k h2/m above 1.003\n  {:<10} {:<8} {:>5}",
        "coupling", "predictor", "n");
    for (const Case& c : cases) fmt::print(" {:>26}", c.name);
    fmt::print("\n");
    Json rows = Json::array();
    for (const Coupling coupling : {Coupling::exact, Coupling::kinematic, Coupling::compliant})
        for (const Predictor predictor : {Predictor::hold, Predictor::forces, Predictor::clique})
            for (const double n : {0.0, 0.5, 2.0}) {
                if (coupling == Coupling::exact && predictor != Predictor::hold) continue;
                using verify::to_string;
                fmt::print("  {:<10} {:<8} {:>5}", to_string(coupling),
                           coupling == Coupling::exact ? "" : to_string(predictor), n);
                for (const Case& c : cases) {
                    std::vector<double> mass(12, 1.0);
                    if (c.heavy != kNone) mass[c.heavy] = 1000.0;
                    double worst = 0.0, first = 0.0;
                    for (double e = 0.0; e <= 6.0; e += 0.5) {
                        const double scaled = std::pow(10.0, e);
                        World world =
                            chain(mass, scaled / (kStep * kStep), n, c.border, coupling, predictor);
                        const double radius = growth(world);
                        worst = std::max(worst, radius);
                        if (radius > 1.003 && first == 0.0) first = scaled;
                    }
                    fmt::print(" {:>12.4f} {:>13}", worst,
                               first > 0.0 ? fmt::format("from {:.3g}", first) : "stable");
                    rows.push_back({{"coupling", to_string(coupling)},
                                    {"predictor", to_string(predictor)},
                                    {"n", n},
                                    {"cut", c.name},
                                    {"radius", worst},
                                    {"unstable_from", first}});
                }
                fmt::print("\n");
            }
    return rows;
}

}  // namespace hawser::bench::split
