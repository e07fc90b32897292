// SPDX-License-Identifier: Apache-2.0
// Wires that start in equilibrium and stay at rest, against the elastic catenary (H. M. Irvine,
// Cable Structures, 1981). With touchdown: J. Jonkman, 2007.
#include "validate/tools.h"
#include "validate/wires.h"

#include <hawser/catenary.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace hawser::validate {
namespace {

/// Return the root of an increasing function, by bisection in the logarithm.
double increasing_root(double low, double high, const std::function<double(double)>& f) {
    for (int i = 0; i < 200; ++i) {
        const double middle = std::sqrt(low * high);
        (f(middle) < 0.0 ? low : high) = middle;
    }
    return std::sqrt(low * high);
}

/// A wire and its closed form.
struct Line {
    double span, rise, length, weight, EA, friction = 0.0;

    /// Return the span for an anchor on the bottom. The length LB = L − V/w lies on the bottom.
    [[nodiscard]] double reach(double h, double v) const {
        const double w = weight, laid = length - v / w;
        double stretch = h * length / EA;
        if (friction > 0.0) {
            // On the bottom the tension decreases by μ w per metre from the touchdown, over the
            // length `held`.
            const double held = std::min(laid, h / (friction * w));
            stretch -= h * (laid - held) / EA + friction * w * held * held / (2.0 * EA);
        }
        return laid + h / w * std::asinh(v / h) + stretch;
    }
    [[nodiscard]] double height(double h, double v) const {
        return h / weight * (std::sqrt(1.0 + v * v / (h * h)) - 1.0) + v * v / (2.0 * EA * weight);
    }
    [[nodiscard]] double lift(double h) const {
        return increasing_root(1e-9, 1e12, [&](double v) { return height(h, v) - rise; });
    }
    [[nodiscard]] double laid_pull() const {
        return increasing_root(1.0, 1e9, [&](double h) { return reach(h, lift(h)) - span; });
    }
    /// Return H for ends of equal height [N].
    [[nodiscard]] double hung_pull() const {
        return increasing_root(1.0, 1e12, [&](double h) {
            return h * length / EA + 2.0 * h / weight * std::asinh(weight * length / (2.0 * h)) -
                   span;
        });
    }
    [[nodiscard]] double sag(double h) const {
        const double half = 0.5 * weight * length;
        return height(h, half);
    }
};

/// A wire of a world at its catenary's position; ends are fixed.
struct Started {
    World world;
    WireId wire{};
    Catenary start;

    [[nodiscard]] Vec3 place(std::size_t node) const {
        return world.pose(world.wires().nodes(wire)[node]).position;
    }
    /// Return the force of element e on its first node [N].
    [[nodiscard]] Vec3 pull(std::size_t e) const {
        return tension(world, world.wires().elements(wire)[e]) *
               (place(e + 1) - place(e)).normalized();
    }
    /// Return the largest distance of a node from its start [m].
    [[nodiscard]] double largest_shift() const {
        double most = 0.0;
        for (std::size_t i = 0; i < start.nodes.size(); ++i)
            most = std::max(most, (place(i) - start.nodes[i]).norm());
        return most;
    }
};

WorldDef world_def_60hz() {
    WorldDef def;
    def.step = 1.0 / 60.0;
    return def;
}

Started start_shape(const CatenaryDef& shape, double radius = 0.0, double friction = 0.0) {
    Started out{World(world_def_60hz()), {}, catenary(shape)};
    const auto fixed = [&](const char* name, const Vec3& at) {
        return out.world.add_body({.name = name, .kind = BodyKind::fixed, .position = at});
    };
    const CatenarySection& part = shape.sections[0];
    WireDef def;
    def.name = "wire";
    def.from = fixed("from", shape.from);
    def.to = fixed("to", shape.to);
    def.elements = part.elements;
    def.length = part.length;
    def.EA = part.EA;
    def.mass_per_length = part.weight / kGravity;
    def.path.assign(out.start.nodes.begin() + 1, out.start.nodes.end() - 1);
    if (radius > 0.0) {
        MaterialDef mud;
        mud.name = "mud";
        mud.friction = friction;
        // At the start the bristles of friction are undeformed. To hold μ w l they deform by this
        // force over their stiffness, which changes the first elements at an anchor. A stiff
        // bristle avoids this.
        mud.stiffness = 1e9;
        mud.tangential = 1.0;
        def.radius = radius;
        def.material = out.world.add_material(mud);
        const Vec3 at(0, 0, shape.seabed->height - radius);
        ShapeDef plane;
        plane.kind = ShapeKind::plane;
        plane.body = out.world.add_body({.name = "bed", .kind = BodyKind::fixed, .position = at});
        plane.material = def.material;
        out.world.add_shape(plane);
    }
    out.wire = out.world.wires().add(def);
    return out;
}

}  // namespace

void case_wire_catenary(Report& report) {
    constexpr Line kRope{80.0, 0.0, 100.0, 10.0 * kGravity, 1e6};
    const double h = kRope.hung_pull(), sag = kRope.sag(h);
    for (const auto& [n, limit] : {std::pair(20, 2e-3), {40, 6e-4}, {100, 2e-4}}) {
        CatenaryDef def;
        def.to = {kRope.span, 0, 0};
        def.sections = {{kRope.length, kRope.weight, kRope.EA, n}};
        Started s = start_shape(def);
        advance(s.world, 60);
        const auto middle = static_cast<std::size_t>(n) / 2;
        const auto what = [&](const char* text) { return fmt::format("{}, {} elements", text, n); };
        // The catenary's balance omits half an element at the end: add its weight.
        const Vec3 end = s.pull(0) - Vec3(0, 0, s.start.weight_from);
        report.compare(what("horizontal pull [N]"), {h}, {s.pull(middle).x()}, limit,
                       "relative; elements are chords of the curve");
        report.compare(what("tension at the end [N]"),
                       {std::hypot(h, 0.5 * kRope.weight * kRope.length)}, {end.norm()}, limit,
                       "the same, half an element's weight added");
        report.compare(what("sag [m]"), {sag}, {-s.place(middle).z()}, limit, "the same");
        report.compare(what("moved in 60 steps [m]"), {0.0}, {s.largest_shift()}, 1e-8,
                       "absolute: it starts in balance", 1.0);
    }
}

void case_wire_touchdown(Report& report) {
    constexpr int kElements = 205;
    constexpr double kRadius = 0.1;
    for (const double friction : {0.0, 0.5, 1.5}) {
        const Line chain{400.0, 50.0, 410.0, 3323.25, 1.674e9, friction};
        const double h = chain.laid_pull(), v = chain.lift(h),
                     laid = chain.length - v / chain.weight;
        CatenaryDef def;
        def.from = {0, 0, -chain.rise};
        def.to = {chain.span, 0, 0};
        def.sections = {{chain.length, chain.weight, chain.EA, kElements}};
        def.seabed = FlatSeabed{-chain.rise, friction};
        Started s = start_shape(def, kRadius, friction);
        advance(s.world, 60);
        const Vec3 end = -s.pull(kElements - 1) - Vec3(0, 0, s.start.weight_to);
        std::size_t last = 0;
        while (s.place(last + 1).z() < -chain.rise + 1e-3) ++last;
        const auto what = [&](const char* text) {
            return fmt::format("{}, friction {:g}", text, friction);
        };
        report.compare(what("tension at the top [N]"), {std::hypot(h, v)}, {end.norm()}, 0.01,
                       "relative");
        report.compare(what("tension at the anchor [N]"),
                       {std::max(0.0, h - friction * chain.weight * laid)}, {s.pull(0).norm()},
                       0.01, "of the horizontal pull", h);
        report.compare(what("length that lies [m]"), {laid}, {s.start.s[last]}, 0.01,
                       "relative; elements of 2 m");
        report.compare(what("moved in 60 steps [m]"), {0.0}, {s.largest_shift()}, 0.01,
                       "absolute: the bottom gives way under the chain", 1.0);
    }
}

}  // namespace hawser::validate
