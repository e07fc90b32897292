// SPDX-License-Identifier: Apache-2.0
// Waves along a wire that breaks, and transverse waves across a change of element length.
// References: the closed forms of the elastic bar and of the taut string (d'Alembert).
#include "validate/tools.h"
#include "validate/wires.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <vector>

namespace hawser::validate {
namespace {

constexpr double kPerMetre = 23.0, kStiffness = 2.33e8, kPull = 1e6;  // kg/m, N, N

/// Add nodes and elements in a line between fixed ends, at the tension kPull.
WireId add_taut(World& w, const std::vector<double>& x, const std::vector<BodyDef>& lumps,
                const std::function<void(std::size_t, InteractionDef&)>& finish) {
    const double strain = 1.0 + kPull / kStiffness;
    std::vector<BodyId> nodes;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const bool end = i == 0 || i + 1 == x.size();
        BodyDef b = lumps.empty() ? BodyDef{.position = Vec3(x[i], 0, 0)} : lumps[i];
        b.kind = end ? BodyKind::fixed : BodyKind::lump;
        if (!end) b.mass = 0.5 * kPerMetre / strain * (x[i + 1] - x[i - 1]);
        nodes.push_back(w.add_body(b));
    }
    std::vector<InteractionId> elements;
    for (std::size_t i = 0; i + 1 < x.size(); ++i) {
        InteractionDef d;
        d.kind = InteractionKind::Stretch;
        d.body = {nodes[i], nodes[i + 1]};
        d.set("length", (x[i + 1] - x[i]) / strain).set("EA", kStiffness);
        finish(i, d);
        elements.push_back(w.add_interaction(d));
    }
    return w.wires().adopt("wire", elements);
}

/// A wire, without gravity, that is to part between its node `left` and the next.
struct Pieces {
    double element;  ///< Length of an element [m].
    int left, right;
    double axial_damping;  ///< As in WireDef.
    bool consistent, breaks_by_load;
};

World broken_wire_world(const Pieces& p, double step, WireId& wire) {
    World w({.step = step, .gravity = Vec3::Zero()});
    std::vector<double> x;
    for (int i = 0; i <= p.left + p.right + 1; ++i)
        x.push_back(i * p.element * (1.0 + kPull / kStiffness));
    const auto weak = static_cast<std::size_t>(p.left);
    wire = add_taut(w, x, {}, [&](std::size_t i, InteractionDef& d) {
        if (p.consistent) d.set("mass", kPerMetre * p.element);
        if (!std::isnan(p.axial_damping))
            d.damping_time[0] = p.axial_damping * p.element * std::sqrt(kPerMetre / kStiffness);
        if (p.breaks_by_load && i == weak) d.set("breaking_load", 0.99 * kPull);
    });
    const InteractionId element = w.wires().elements(wire)[weak];
    advance(w, p.breaks_by_load ? 1 : 12);
    if (!p.breaks_by_load) w.wires().part(element);
    if (w.intact(element)) throw std::runtime_error("the weak element has not parted");
    return w;
}

/// Return the mean recoil speed of the last node of each piece, until the axial wave reaches the
/// other end of the piece [m/s].
std::array<double, 2> recoil_speeds(const Pieces& p, double step) {
    WireId wire;
    World w = broken_wire_world(p, step, wire);
    const double c = std::sqrt(kStiffness / kPerMetre), begin = w.time();
    std::array<double, 2> mean{};
    BodyId node[2];
    double x0[2], x[2];
    for (const std::size_t side : {0U, 1U}) {
        node[side] = w.wires().nodes(wire)[static_cast<std::size_t>(p.left) + side];
        x[side] = x0[side] = w.pose(node[side]).position.x();
    }
    while (mean[0] == 0.0 || mean[1] == 0.0) {
        const double earlier = w.time() - begin;
        advance(w, 1);
        const double t = w.time() - begin;
        for (const std::size_t side : {0U, 1U}) {
            const double before = x[side];
            x[side] = w.pose(node[side]).position.x();
            // The last node is half an element from the break. The wave passes it after l/2c and
            // reaches the other end after L/c, L = (count + 1/2) l.
            const double way = (side == 0 ? p.left : p.right) * p.element;
            const double until = (way + 0.5 * p.element) / c;
            if (mean[side] != 0.0 || t < until) continue;
            const double share = (until - earlier) / (t - earlier);
            mean[side] = std::abs(before + (x[side] - before) * share - x0[side]) / (way / c);
        }
    }
    return mean;
}

/// Return the value farther from the reference.
double farther_from(double a, double b, double reference) {
    return std::abs(a - reference) > std::abs(b - reference) ? a : b;
}

constexpr double kRecoilSteps[2] = {1.0 / 60.0, 1.0 / 240.0};
constexpr double kRecoilLimit[2] = {0.04, 0.015};

void check_parting(Report& report, double piece, std::size_t s, double limit, const char* reason) {
    const double speed = kPull / std::sqrt(kStiffness * kPerMetre);
    for (const double element : {1.0, 2.0, 5.0, 10.0, 20.0}) {
        double worst = speed;
        const int n = static_cast<int>(std::lround(piece / element));
        for (const double damping : {0.0, 0.1, 0.5, 1.0, 2.0, 10.0, kDefault})
            for (const bool consistent : {false, true})
                for (const bool breaks_by_load : {false, true}) {
                    const auto [left, right] = recoil_speeds(
                        {element, n, n, damping, consistent, breaks_by_load}, kRecoilSteps[s]);
                    worst = farther_from(farther_from(left, right, speed), worst, speed);
                }
        report.compare(fmt::format("recoil, {} m in elements of {} m, 1/{:.0f} s [m/s]", piece,
                                   element, 1.0 / kRecoilSteps[s]),
                       {speed}, {worst}, limit, reason);
    }
}

void check_random_parting(Report& report, std::size_t s) {
    constexpr int kRandomPulses = 60;
    const double speed = kPull / std::sqrt(kStiffness * kPerMetre);
    double worst = speed;
    Chance chance(4);
    for (int i = 0; i < kRandomPulses; ++i) {
        const double element = chance.between(1.0, 20.0);
        const auto count = [&] {
            return static_cast<int>(std::lround(chance.between(200.0, 800.0) / element));
        };
        const int left = count(), right = count();
        const double damping = std::exp(chance.between(-5.0, 3.0));
        const bool consistent = chance.next() < 0.5, breaks_by_load = chance.next() < 0.5;
        const auto [a, b] = recoil_speeds(
            {element, left, right, damping, consistent, breaks_by_load}, kRecoilSteps[s]);
        worst = farther_from(farther_from(a, b, speed), worst, speed);
    }
    report.compare(fmt::format("recoil, {} random wires, 1/{:.0f} s [m/s]", kRandomPulses,
                               1.0 / kRecoilSteps[s]),
                   {speed}, {worst}, kRecoilLimit[s],
                   "pieces of 200 to 800 m, elements of 1 to 20 m");
}

// --- A pulse across -------------------------------------------------------------------------

constexpr double kPulse = 120.0, kHeight = 0.05;     // m
constexpr double kStart = 300.0, kJunction = 600.0;  // m
constexpr double kFirst = 420.0, kSecond = 1320.0;   // m
constexpr double kEnd = 1800.0, kFine = 5.0, kCoarse = 10.0;

struct Passing {
    double crest = 0.0, middle = 0.0;  ///< Times at which its crest and its first moment pass [s].
};

/// Compute the times at which a pulse passes a node, from the displacement of the node, sampled
/// every step from time h on.
Passing passing(const std::vector<double>& z, double step, double half_width) {
    const auto most = static_cast<std::size_t>(std::max_element(z.begin(), z.end()) - z.begin());
    const double a = z[most - 1], b = z[most], d = z[most + 1];
    Passing out;
    out.crest = step * (static_cast<double>(most) + 1.0 + 0.5 * (a - d) / (a - 2.0 * b + d));
    double sum = 0.0, moment = 0.0;
    for (std::size_t i = 0; i < z.size(); ++i) {
        const double t = step * (static_cast<double>(i) + 1.0);
        if (std::abs(t - out.crest) > half_width) continue;
        sum += z[i];
        moment += z[i] * t;
    }
    out.middle = moment / sum;
    return out;
}

/// A taut wire of elements of 5 m, then of 10 m, along which a pulse runs.
struct Pulsed {
    World w;
    WireId wire{};
    double speed;  ///< √(T/ρ) of the stretched wire [m/s].
    /// Build the wire. @param edited  True: create all elements with 5 m, then remove nodes.
    Pulsed(double step, bool edited)
        : w({.step = step, .gravity = Vec3::Zero()}),
          speed(std::sqrt(kPull * (1.0 + kPull / kStiffness) / kPerMetre)) {
        std::vector<double> x;
        for (double at = 0.0; at < kEnd + 1.0;
             at += at < kJunction - 1.0 || edited ? kFine : kCoarse)
            x.push_back(at);
        std::vector<BodyDef> lumps;
        for (const double at : x) {
            const double off = at - kStart, k = 2.0 * kPi / kPulse;
            const bool in = std::abs(off) < 0.5 * kPulse;
            const double z = in ? 0.5 * kHeight * (1.0 + std::cos(k * off)) : 0.0;
            BodyDef b{.position = Vec3(at, 0, z)};
            if (in) b.velocity = Vec3(0, 0, speed * 0.5 * kHeight * k * std::sin(k * off));
            lumps.push_back(b);
        }
        wire = add_taut(w, x, lumps, [&](std::size_t, InteractionDef& d) {
            d.set("mass", kPerMetre * d.get("length"));
        });
        if (!edited) return;
        const auto first = static_cast<std::size_t>(std::lround(kJunction / kFine));
        const std::vector<BodyId> nodes(w.wires().nodes(wire).begin(), w.wires().nodes(wire).end());
        for (std::size_t i = first + 1; i + 1 < nodes.size(); i += 2)
            if (!w.wires().remove_node(nodes[i], kPi)) throw std::runtime_error("a node stayed");
    }
    [[nodiscard]] BodyId at(double x) const {
        for (const BodyId node : w.wires().nodes(wire))
            if (std::abs(w.pose(node).position.x() - x) < 0.1) return node;
        throw std::runtime_error("no node there");
    }
    /// Return the largest displacement within half a pulse of x, before the junction [m].
    [[nodiscard]] double largest_displacement(double x) const {
        double most = 0.0;
        for (const BodyId node : w.wires().nodes(wire)) {
            const Vec3 p = w.pose(node).position;
            if (std::abs(p.x() - x) < 0.5 * kPulse && p.x() < kJunction - 20.0)
                most = std::max(most, std::abs(p.z()));
        }
        return most;
    }
};

void check_pulse(Report& report, double step, bool edited) {
    Pulsed p(step, edited);
    const BodyId first = p.at(kFirst), second = p.at(kSecond);
    std::vector<double> z[2];
    double back = 0.0;
    const long steps = std::lround((kSecond - kStart + kPulse) / p.speed / step);
    for (long i = 0; i < steps; ++i) {
        advance(p.w, 1);
        z[0].push_back(p.w.pose(first).position.z());
        z[1].push_back(p.w.pose(second).position.z());
        // Measure while the reflection is separate from the pulse and from the pulse that the start
        // sent the other way.
        const double crest = kStart + p.speed * p.w.time();
        if (crest > kJunction + 70.0 && crest < kJunction + 170.0)
            back = std::max(back, p.largest_displacement(2.0 * kJunction - crest));
    }
    const double half = 0.6 * kPulse / p.speed;
    const Passing a = passing(z[0], step, half), b = passing(z[1], step, half);
    const double way = kSecond - kFirst;
    const auto what = [&](const char* text) {
        return fmt::format("{}, 1/{:.0f} s{}", text, 1.0 / step, edited ? ", edited" : "");
    };
    report.compare(what("reflected, of the height"), {0.0}, {back / kHeight}, 0.005,
                   "from elements of 5 m into 10 m", 1.0);
    report.compare(what("arrival over 900 m [s]"), {way / p.speed}, {b.middle - a.middle}, 0.01,
                   "first moment of the pulse");
    report.compare(what("arrival of the crest [s]"), {way / p.speed}, {b.crest - a.crest},
                   step > 0.01 ? 0.01 : 0.015, "twelve elements a pulse: their waves disperse");
}

}  // namespace

void case_wire_parting(Report& report) {
    const char* all = "the worst of 7 dampings, both masses, both halves";
    for (const std::size_t s : {0U, 1U}) {
        for (const double piece : {200.0, 500.0})
            check_parting(report, piece, s, kRecoilLimit[s], all);
        check_random_parting(report, s);
    }
    check_parting(report, 100.0, 0, 0.12,
                  "L/c is 1.9 steps: the far end holds on too short a time");
}

void case_wire_pulse(Report& report) {
    for (const double step : {1.0 / 60.0, 1.0 / 240.0})
        for (const bool edited : {false, true}) check_pulse(report, step, edited);
}

}  // namespace hawser::validate
