// SPDX-License-Identifier: Apache-2.0
// Wires whose resolution follows tension, curvature and contact. Checked: effects of edits on a
// wire at rest, whether they end, regions of short elements, and random wires.
#include "validate/tools.h"
#include "validate/wires.h"

#include <hawser/catenary.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace hawser::validate {
namespace {

constexpr double kCableMass = 23.0, kCableEA = 2.33e8;  // kg/m, N

/// Numbers between two, the same on every machine.
class Draw {
  public:
    double between(double a, double b) {
        state_ = state_ * 6364136223846793005u + 1442695040888963407u;
        return a + (b - a) * static_cast<double>(state_ >> 11) * 0x1p-53;
    }

  private:
    std::uint64_t state_ = 11;
};

double signal(const World& w, const char* name) {
    return w.system_signal(std::string("nodes.") + name);
}
double edit_count(const World& w) { return signal(w, "inserted") + signal(w, "removed"); }

/// A wire at rest over 190 m with a rise of 50 m, of a tension at its upper end, whose ends may
/// move. Drag has waves die out within some seconds.
struct Spanned {
    World w{WorldDef{.step = 1.0 / 60.0}};
    WireId wire;
    BodyId upper;
    double length = 0.0;

    Spanned(double pull, double element, const ResolutionDef& resolution) {
        CatenaryDef shape;
        shape.to = Vec3(190, 0, 50);
        const int n = std::max(3, static_cast<int>(std::lround(200.0 / element)));
        double low = 150.0, high = 400.0;  // m; the longer, the less it pulls
        Catenary c;
        for (int i = 0; i < 60; ++i) {
            length = 0.5 * (low + high);
            shape.sections = {
                {.length = length, .weight = kCableMass * kGravity, .EA = kCableEA, .elements = n}};
            c = catenary(shape);
            (c.tension.back() < pull ? high : low) = length;
        }
        WireDef def;
        def.name = "wire";
        def.from = w.add_body({.name = "from", .kind = BodyKind::fixed});
        def.to = upper =
            w.add_body({.name = "to", .kind = BodyKind::kinematic, .position = shape.to});
        def.elements = n;
        def.length = length;
        def.EA = kCableEA;
        def.mass_per_length = kCableMass;
        def.drag = 20.0;
        def.consistent_mass = true;
        def.path.assign(c.nodes.begin() + 1, c.nodes.end() - 1);
        wire = w.wires().add(def);
        ResolutionDef of = resolution;
        of.name = "nodes";
        of.wire = wire;
        w.add(of);
    }
    /// Return the force on the upper end: the tension of the last element and half of its weight
    /// [N].
    [[nodiscard]] double pull() const {
        const InteractionDef& d = w.interaction_def(w.wires().elements(wire).back());
        const Vec3 along = w.pose(d.body[1]).position - w.pose(d.body[0]).position;
        const Vec3 down(0.0, 0.0, 0.5 * kGravity * d.get("mass"));
        return (tension(w, w.wires().elements(wire).back()) * along.normalized() + down).norm();
    }
};

/// Check that a wire at rest adapts its elements, with a small change of tension in each edit, and
/// then does not change them again.
void check_at_rest(Report& report, double pull, double element) {
    Spanned s(pull, element, {.min_length = 2.5, .max_length = 20.0});
    const double allowed = std::max(0.003 * pull, 50.0);
    advance(s.w, 1);
    double worst = 0.0, before = s.pull(), edits = 0.0;
    for (int i = 0; i < 60 * 90; ++i) {
        const double last = s.pull();
        advance(s.w, 1);
        if (edit_count(s.w) != edits) before = last;
        edits = edit_count(s.w);
        if (edits > 0.0) worst = std::max(worst, std::abs(s.pull() - before));
    }
    const std::string what = fmt::format("{:.0f} kN, from {} m", pull / 1e3, element);
    report.compare(fmt::format("change of tension by edits, {} [N]", what), {0.0}, {worst}, 1.0,
                   fmt::format("max(0.3 %, 50 N); {:.0f} came, {:.0f} went",
                               signal(s.w, "inserted"), signal(s.w, "removed")),
                   allowed);
    advance(s.w, 60 * 60);
    report.compare(fmt::format("edits in a minute of rest, {}", what), {0.0},
                   {edit_count(s.w) - edits}, 0.0,
                   fmt::format("none; {:.0f} nodes, {:.3g} to {:.3g} m", signal(s.w, "nodes"),
                               signal(s.w, "shortest"), signal(s.w, "longest")),
                   1.0);
    report.compare(fmt::format("material, {} [m]", what), {s.length}, {signal(s.w, "material")},
                   1e-12, "an account");
}

/// A soft wire without weight over a fixed roller, both ends of which move along their tangents.
struct Dragged {
    static constexpr double kRadius = 1.5, kWire = 0.04, kReach = 40.0;  // m
    World w{WorldDef{.step = 1.0 / 60.0, .gravity = Vec3::Zero()}};
    WireId wire;
    BodyId end[2];
    Vec3 along[2];  ///< Directions towards the roller.

    Dragged() {
        const double r = kRadius + kWire, slope = 0.4;  // rad
        MaterialDef smooth;
        smooth.name = "smooth";
        smooth.friction = 0.0;
        smooth.stiffness = 1e6;
        const MaterialId material = w.add_material(smooth);
        const BodyId roller = w.add_body({.name = "roller", .kind = BodyKind::fixed});
        ShapeDef round;
        round.kind = ShapeKind::cylinder;
        round.body = roller;
        round.radius = kRadius;
        round.half_length = 2.0;
        round.orientation = Quat(Eigen::AngleAxisd(0.5 * kPi, Vec3::UnitX()));
        round.material = material;
        w.add_shape(round);
        for (const double side : {-1.0, 1.0}) {
            const Vec3 leaves(side * r * std::sin(slope), 0, r * std::cos(slope));
            const std::size_t k = side < 0.0 ? 0 : 1;
            along[k] = Vec3(-side * std::cos(slope), 0, std::sin(slope));
            end[k] = w.add_body({.name = side < 0.0 ? "left" : "right",
                                 .kind = BodyKind::kinematic,
                                 .position = leaves - kReach * along[k]});
        }
        const double path = 2.0 * (kReach + slope * r);
        WireDef def;
        def.name = "wire";
        def.from = end[0];
        def.to = end[1];
        def.elements = 8;  // none of them passes through the roller
        def.EA = 2e6;
        def.length = path / (1.0 + 2e4 / def.EA);
        def.mass_per_length = 5.0;
        def.drag = 20.0;
        def.consistent_mass = true;
        def.radius = kWire;
        def.material = material;
        const double apex = r / std::cos(slope);
        for (int i = 1; i < def.elements; ++i) {
            const double s = (kReach + r * std::tan(slope)) * (2.0 * i / def.elements - 1.0);
            def.path.push_back(Vec3(s * std::cos(slope), 0, apex - std::abs(s) * std::sin(slope)));
        }
        wire = w.wires().add(def);
        w.add(ResolutionDef{.name = "nodes",
                            .wire = wire,
                            .min_length = 0.5,
                            .max_length = 12.0,
                            .contact_length = 1.0,
                            .wave_period = 0.0});
    }
    void move(double speed) {
        for (const std::size_t k : {0U, 1U}) {
            Twist t;
            t.linear = (k == 0 ? speed : -speed) * along[k];
            w.set_velocity(end[k], t);
        }
    }
    /// Return the longest element at the roller and the shortest element far from it [m].
    void lengths(double& longest_near, double& shortest_far) const {
        longest_near = 0.0;
        shortest_far = 1e30;
        for (const InteractionId id : w.wires().elements(wire)) {
            const InteractionDef& d = w.interaction_def(id);
            const Vec3 a = w.pose(d.body[0]).position, b = w.pose(d.body[1]).position;
            const double length = d.get("mass") / 5.0;
            const bool over = a.x() * b.x() <= 0.0;
            if (over) longest_near = std::max(longest_near, length);
            if (std::min(std::abs(a.x()), std::abs(b.x())) > 8.0)
                shortest_far = std::min(shortest_far, length);
        }
    }
};

void check_dragged(Report& report) {
    Dragged d;
    advance(d.w, 60 * 10);
    double near = 0.0, far = 0.0, worst_near = 0.0;
    for (const double speed : {0.5, -0.5}) {
        d.move(speed);
        for (int i = 0; i < 60 * 20; ++i) {
            advance(d.w, 1);
            d.lengths(near, far);
            worst_near = std::max(worst_near, near);
        }
    }
    d.move(0.0);
    const double moved = edit_count(d.w);
    advance(d.w, 60 * 10);
    d.lengths(near, far);
    report.compare("longest element over the roller, dragged at 0.5 m/s [m]", {1.0}, {worst_near},
                   1.0, "at most twice contact_length", 1.0);
    report.compare("longest element over the roller at rest [m]", {0.75}, {near}, 0.25,
                   "within min_length and contact_length", 1.0);
    report.compare(
        "shortest element far from it [m]", {9.0}, {far}, 6.0,
        fmt::format("long again; {:.0f} edits, {:.0f} nodes", moved, signal(d.w, "nodes")), 1.0);
    const double settled = edit_count(d.w);
    advance(d.w, 60 * 60);
    report.compare("edits in a minute of rest, roller", {0.0}, {edit_count(d.w) - settled}, 0.0,
                   "none", 1.0);
}

/// Check wires of random tension, elements and limits with oscillating ends.
void check_random(Report& report) {
    constexpr int kRandomWires = 24;
    Draw draw;
    double edits = 0.0, worst_material = 0.0, worst_grade = 0.0;
    int beyond = 0;
    for (int k = 0; k < kRandomWires; ++k) {
        const double pull = 4e4 * std::pow(25.0, draw.between(0.0, 1.0));
        const double least = draw.between(1.0, 4.0);
        ResolutionDef def{.min_length = least,
                          .max_length = least * draw.between(2.0, 8.0),
                          .sag_error = draw.between(0.01, 0.2),
                          .wave_period = draw.between(0.5, 3.0),
                          .averaging = draw.between(0.2, 5.0),
                          .hysteresis = draw.between(1.05, 2.0),
                          .patience = draw.between(0.1, 3.0),
                          .interval = 1 + static_cast<int>(draw.between(0.0, 8.0))};
        const double element = draw.between(2.0, 30.0);
        Spanned s(pull, element, def);
        const double reach = draw.between(0.1, 1.0), rate = draw.between(0.5, 3.0);
        for (int i = 0; i < 60 * 20; ++i) {
            Twist t;
            t.linear = Vec3(0, reach * rate * std::sin(rate * i / 60.0),
                            0.1 * reach * rate * std::cos(rate * i / 60.0));
            s.w.set_velocity(s.upper, t);
            advance(s.w, 1);
        }
        edits += edit_count(s.w);
        worst_material =
            std::max(worst_material, std::abs(signal(s.w, "material") / s.length - 1.0));
        worst_grade = std::max(worst_grade, static_cast<double>(s.w.verdict().grade));
        const double first = s.length / std::max(3L, std::lround(200.0 / element));
        if (signal(s.w, "shortest") < std::min(first, def.min_length) * (1.0 - 1e-9)) ++beyond;
        if (signal(s.w, "longest") > std::max(def.max_length, 2.0 * least) * (1.0 + 1e-9)) ++beyond;
    }
    const std::string done = fmt::format("{} wires, {:.0f} edits", kRandomWires, edits);
    report.compare("material of random wires, relative", {0.0}, {worst_material}, 1e-12, done, 1.0);
    report.compare("random wires beyond their limits", {0.0}, {static_cast<double>(beyond)}, 0.0,
                   done, 1.0);
    report.compare("worst grade of random wires", {static_cast<double>(Grade::good)}, {worst_grade},
                   0.0, "judged good", 1.0);
}

}  // namespace

void case_wire_resolution(Report& report) {
    for (const double pull : {41e3, 198e3, 999e3})
        for (const double element : {2.5, 5.0, 10.0, 20.0}) check_at_rest(report, pull, element);
    check_dragged(report);
    check_random(report);
}

}  // namespace hawser::validate
