// SPDX-License-Identifier: Apache-2.0
// Wires of nodes at steps that resolve neither their transverse nor their axial vibration. `Ratio`
// is h √(T/ρ)/l. It is the number of elements that a transverse wave passes in a step. Without
// geometric stiffness, one is the limit of a step.
#include "validate/robust.h"
#include "validate/tools.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hawser::validate {
namespace {

constexpr double kNoReference = std::numeric_limits<double>::quiet_NaN();

constexpr int kElements = 60;  ///< Number of elements of 1 m.
constexpr double kPull = 1e6;  ///< Tension [N].

/// A wire along x, fixed at one end, under the tension T of a force on a small mass at its other
/// end. It has a third of the drag that stops the bounce of a wire with EA/T 200. Its nodes are off
/// the line by up to `bend`. It straightens; after a large bend it becomes slack and taut again.
struct ZigZag {
    double ratio, bend, stiffness, damping, step;  ///< Stiffness: EA/T.
    [[nodiscard]] double density() const { return kPull * step * step / (ratio * ratio); }
};

/// Numbers in [−1, 1), the same on every machine.
class Noise {
  public:
    double next() {
        state_ = state_ * 6364136223846793005u + 1442695040888963407u;
        return static_cast<double>(state_ >> 11) * 0x1p-52 - 1.0;
    }

  private:
    std::uint64_t state_ = 1;
};

struct Wire {
    World world;
    std::vector<InteractionId> elements;
    std::vector<BodyId> nodes;
};

/// Build a wire. @param bend  ≥ 0: a zigzag with a free end under tension. Negative: a taut wire
/// with both ends fixed.
Wire straight_wire(double step, double density, double stiffness, double damping, double bend) {
    const bool taut = bend < 0.0;
    WorldDef def;
    def.step = step;
    def.gravity = Vec3::Zero();
    // For bends of 0.3 l the case requires bounded motion only, not a good verdict of the monitors.
    if (bend > 0.2) def.on_diverged = OnDiverged::warn;
    def.staggered_start = taut;  // otherwise the energy at the start is that of half a step before
    Wire out{World(def), {}, {}};
    Noise noise;
    const double stretched = 1.0 + 1.0 / stiffness;
    for (int i = 0; i <= kElements; ++i) {
        const bool inner = i > 0 && i < kElements;
        BodyDef node;
        node.name = fmt::format("n{}", i);
        const bool free_end = i == 0 && !taut;
        node.kind = inner || free_end ? BodyKind::lump : BodyKind::fixed;
        node.position = Vec3(i * stretched, 0, 0);
        if (inner && !taut) {
            const double y = noise.next(), z = noise.next();
            node.position += bend * Vec3(0, y, z);
        }
        node.mass = density;
        if (free_end) {
            // A third of the wire goes with it.
            const double moving = (1.0 + kElements / 3.0) * density;
            node.force = Vec3(-kPull, 0, 0);
            node.linear_damping =
                Vec3::Constant(0.6 * std::sqrt(200.0 * kPull / kElements * moving));
        }
        out.nodes.push_back(out.world.add_body(node));
    }
    const double whole = stiffness * kPull;  // EA
    for (int i = 0; i < kElements; ++i) {
        InteractionDef element;
        element.kind = InteractionKind::Stretch;
        element.body = {out.nodes[static_cast<std::size_t>(i)],
                        out.nodes[static_cast<std::size_t>(i) + 1], BodyId{}};
        const double chord =
            (out.world.pose(element.body[1]).position - out.world.pose(element.body[0]).position)
                .norm();
        element.set("length", chord / stretched).set("EA", whole);
        if (!std::isnan(damping)) element.damping_time[0] = damping * std::sqrt(density / whole);
        out.elements.push_back(out.world.add_interaction(element));
    }
    return out;
}

/// Results of a zigzag wire.
struct Outcome {
    double created = 0.0;         ///< Energy without a source, relative to the exchanged energy.
    double ripple = 0.0;          ///< Deviation of the tension, rms, of T.
    double most = 0.0;            ///< Largest tension, of T.
    double factorisations = 0.0;  ///< Mean number of factorisations in a step.
};

Outcome run_zigzag(const ZigZag& z) {
    Wire w = straight_wire(z.step, z.density(), z.stiffness, z.damping, z.bend);
    const long calm = std::max(std::lround(2.0 / z.step), 10L);
    const long steps = std::max(std::lround(5.0 / z.step), 2 * calm);
    Outcome out;
    w.world.prepare();
    const double start = w.world.energy().mechanical();
    double exchanged = start, created = 0.0, sum = 0.0, squares = 0.0;
    for (long k = 0; k < steps; ++k) {
        advance(w.world, 1);
        out.factorisations += w.world.stats().factorisations;
        const Energy e = w.world.energy();
        exchanged = std::max({exchanged, std::abs(e.applied), e.dissipated});
        created = std::max(created, e.mechanical() - start - e.applied + e.dissipated);
        const double tension = w.world.force(w.elements.front())[0] / -kPull;
        out.most = std::max(out.most, tension);
        if (k < calm) continue;
        sum += tension;
        squares += tension * tension;
    }
    const double count = static_cast<double>(steps - calm), mean = sum / count;
    out.ripple = std::sqrt(std::max(0.0, squares / count - mean * mean));
    out.created = created / exchanged;
    out.factorisations /= static_cast<double>(steps);
    return out;
}

std::string damping_text(double d) { return std::isnan(d) ? "absent" : fmt::format("{:g}", d); }

/// Worst value of some runs, and its run.
struct Worst {
    double value = 0.0;
    std::string whose;
    void take(double v, const ZigZag& z) {
        if (v <= value || std::isnan(value)) return;  // a NaN is stored and stays
        value = v;
        whose = fmt::format("EA/T {:g}, axial damping {}, step {:.3g} s", z.stiffness,
                            damping_text(z.damping), z.step);
    }
    [[nodiscard]] std::string reason(const char* why) const {
        return whose.empty() ? why : fmt::format("{}; here {}", why, whose);
    }
};

/// Run the wires with a given ratio of stiffnesses and a given bend, and report them.
void run_zigzag_wires(Report& report, double ratio, double bend) {
    Worst created, calm, lively, most;
    double few = 0.0, many = 0.0;
    int runs = 0, stiff_runs = 0;
    for (const double stiffness : {200.0, 5000.0})
        for (const double damping : {kNoReference, 0.0, 0.1, 1.0})
            for (const double step : {1.0 / 240, 1.0 / 60, 0.2, 0.5}) {
                const ZigZag z{ratio, bend, stiffness, damping, step};
                const Outcome o = run_zigzag(z);
                created.take(o.created, z);
                most.take(o.most, z);
                // Below half a step a damping time is that of half a step (docs/theory/wires.md).
                const bool hardly =
                    damping * std::sqrt(z.density() / (stiffness * kPull)) < 0.5 * step;
                (bend >= 0.1 && hardly ? lively : calm).take(o.ripple, z);
                const bool is_stiff = bend >= 0.1 && ratio == 2.0 && stiffness > 1000.0;
                (is_stiff ? many : few) += o.factorisations;
                ++(is_stiff ? stiff_runs : runs);
            }
    const std::string name = fmt::format("ratio {:g}, bend {:g} l: ", ratio, bend);
    if (bend > 0.1) {
        report.compare(name + "largest tension / T", {0.0}, {most.value}, 100.0,
                       most.reason("bounded"), 1.0);
        return;
    }
    report.compare(name + "energy from nothing", {0.0}, {created.value}, 1e-3,
                   created.reason("of what was exchanged"), 1.0);
    if (ratio >= 2.0) {
        report.compare(name + "ripple of the tension", {0.0}, {calm.value}, 1e-2,
                       calm.reason("rms of T after 2 s or 10 steps"), 1.0);
        if (bend >= 0.1)
            report.compare(
                name + "the same, hardly damped", {0.0}, {lively.value}, 5e-2,
                lively.reason("rms of T after 2 s or 10 steps, axial damping below half a step's"),
                1.0);
    }
    report.compare(name + "factorisations a step", {1.0}, {few / runs}, bend < 0.05 ? 0.1 : 2.0,
                   "mean", 1.0);
    if (stiff_runs > 0)
        report.compare(name + "the same, EA/T 5000", {1.0}, {many / stiff_runs}, 9.0, "mean", 1.0);
}

/// First vibration mode of a taut wire between fixed ends.
struct Sway {
    double period = 0.0;          ///< Mean of the first 19 [s].
    double amplitude_left = 0.0;  ///< Amplitude after them, relative to the first.
};

Sway sway(double steps_a_period) {
    constexpr double kDensity = 10.0, kStiffness = 200.0;
    const double length = kElements * (1.0 + 1.0 / kStiffness);
    const double expected = 2.0 * length / std::sqrt(kPull / kDensity);
    const double step = expected / steps_a_period;
    Wire w = straight_wire(step, kDensity, kStiffness, kNoReference, -1.0);
    for (int i = 1; i < kElements; ++i) {
        const BodyId node = w.nodes[static_cast<std::size_t>(i)];
        Pose pose = w.world.pose(node);
        pose.position.y() = 0.05 * std::sin(kPi * i / kElements);
        w.world.set_pose(node, pose);
    }
    const BodyId middle = w.nodes[kElements / 2];
    std::vector<double> y{0.05};
    for (long k = 0; k < std::lround(20.5 * steps_a_period); ++k) {
        advance(w.world, 1);
        y.push_back(w.world.pose(middle).position.y());
    }
    const std::vector<double> zeros = upward_zeros(y, step);
    Sway out;
    out.period = (zeros.at(19) - zeros.at(0)) / 19.0;
    // Largest within the last whole period, by parabolas through three samples.
    const auto from = y.size() - static_cast<std::size_t>(std::lround(steps_a_period)) - 1;
    for (std::size_t k = from; k + 1 < y.size(); ++k) {
        if (y[k] < y[k - 1] || y[k] < y[k + 1]) continue;
        const double bow = y[k - 1] - 2.0 * y[k] + y[k + 1], tilt = 0.5 * (y[k + 1] - y[k - 1]);
        out.amplitude_left = std::max(out.amplitude_left, (y[k] - 0.5 * tilt * tilt / bow) / 0.05);
    }
    return out;
}

/// Run a scene to its end. Report the tension of the last element and the position of the cable's
/// free end.
void settle(Report& report, const std::string& scene, double step, const std::string& damping,
            double tension, double place) {
    std::vector<std::string> set;
    if (!damping.empty()) set.push_back("line_types.w.axial_damping=" + damping);
    scene::Scene s = open_scene(scene, step, set);
    const std::vector<InteractionId>& elements = s.cables.at(0).stretch;
    const long steps = std::lround(s.duration / step);
    double sum = 0.0, most = 0.0;
    long count = 0;
    for (long k = 0; k < steps; ++k) {
        advance(s.world, 1);
        const double now = hawser::validate::tension(s.world, elements.back());
        most = std::max(most, now);
        if (k * step < 0.7 * s.duration) continue;
        sum += now;
        ++count;
    }
    const std::string name = fmt::format("step {:.3g} s, axial damping {}: ", step,
                                         damping.empty() ? "absent" : damping);
    report.compare(name + "tension [N]", {tension}, {sum / static_cast<double>(count)}, 1e-2,
                   fmt::format("mean of the last third; peak {:.0f} kN", 1e-3 * most));
    if (place > 0.0)
        report.compare(name + "tug at [m]", {place},
                       {s.world.pose(body(s.world, "tug")).position.x()}, 0.1,
                       "it still rises and falls a little", 1.0);
}

}  // namespace

void case_zigzag_wires(Report& report) {
    for (const double ratio : {0.5, 2.0, 8.0, 50.0})
        for (const double bend : {1e-3, 1e-2, 0.1, 0.3}) run_zigzag_wires(report, ratio, bend);
}

void case_long_wire(Report& report) {
    // An elastic catenary that is level at the tug: L (1 + H/EA) − (w L)² L/6H².
    constexpr double kPull = 280e3, kLength = 300.0, kWeight = 9.5 * kGravity * kLength;
    const double rest =
        kLength * (1.0 + kPull / 1.1e8) - kWeight * kWeight * kLength / (6.0 * kPull * kPull);
    for (const double step : {1.0 / 240, 1.0 / 60, 0.05, 0.1, 0.15, 0.3, 0.5})
        for (const char* damping : {"", "0.02", "0.1", "1"})
            settle(report, "tug_on_long_wire", step, damping, kPull, rest);
}

void case_wires_come_taut(Report& report) {
    for (const double step : {1.0 / 240, 1.0 / 60})
        for (const char* damping : {"", "0", "0.5"}) {
            settle(report, "taut_wire_short_elements", step, damping, 1e6, 0.0);
            settle(report, "taut_wire_damped", step, damping, 5e5, 0.0);
        }
}

void case_wire_sway(Report& report) {
    const Sway exact = sway(960.0);
    for (const double steps : {120.0, 30.0}) {
        const Sway ours = sway(steps);
        const bool fine = steps > 100.0;
        report.compare(fmt::format("period at {:g} steps a period [s]", steps), {exact.period},
                       {ours.period}, fine ? 1e-3 : 1e-2, "against 960 steps a period");
        report.compare(fmt::format("amplitude after 19 periods, {:g} steps", steps),
                       {exact.amplitude_left}, {ours.amplitude_left}, fine ? 5e-3 : 6e-2,
                       "of that with 960 steps a period");
    }
}

}  // namespace hawser::validate
