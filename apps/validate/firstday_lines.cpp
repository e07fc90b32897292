// SPDX-License-Identifier: Apache-2.0
// Lines in still water: tensions of the start against closed forms, and against the first second.
#include "validate/firstday.h"
#include "validate/tools.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace hawser::validate {
namespace {

constexpr double kSteps[] = {1.0 / 60.0, 1.0 / 240.0};
constexpr double kWater = 1025.0;

/// Return a scene of a floating box with two cables to the bottom, along an axis turned by
/// `degrees`. The cables are chains of 126.5 kg/m and 0.01604 m2.
std::string mooring(double degrees) {
    const double c = std::cos(degrees * kPi / 180.0), s = std::sin(degrees * kPi / 180.0);
    std::string cables;
    for (const double side : {1.0, -1.0})
        cables += fmt::format(
            R"({}{{"name": "{}", "line_type": "c", "length": 400, "elements": 80, "shape": "hanging",
            "seabed": {{"height": -60, "friction": 0.6}}, "from": {{"body": "box", "point": [0, 0, -2]}},
            "to": {{"at": [{}, {}, -59.95]}}, "contact": {{"radius": 0.05, "material": "mud"}}}})",
            side > 0.0 ? "" : ", ", side > 0.0 ? "e" : "w", side * 360.0 * c, side * 360.0 * s);
    return fmt::format(
        R"({{"version": 1, "name": "first_chains",
        "line_types": {{"c": {{"mass_per_length": 126.5, "EA": 5.83e8, "diameter": 0.076,
          "cd_normal": 2.6, "cd_tangential": 1.4, "displaced_area": 0.01604}}}},
        "materials": {{"mud": {{"friction": 0.6}}}},
        "sea": {{"depth": 60, "hulls": [{{"body": "box", "mesh": {{"box": [20, 6, 4], "pieces": [6, 4, 2]}},
          "added_mass": [1e5, 5e5, 1e6, 5e6, 2e7, 2e7], "damping": [5e4, 2e5, 5e5, 5e6, 2e7, 2e7]}}]}},
        "bodies": [{{"name": "bed", "kind": "fixed", "position": [0, 0, -60],
          "shapes": [{{"kind": "plane", "material": "mud"}}]}},
          {{"name": "box", "position": [0, 0, 1], "mass": 1476000, "box": [20, 6, 4]}}],
        "cables": [{}]}})",
        cables);
}

/// Smallest and largest tension of an element over a second, over that of its stretch at the start.
struct FirstSecond {
    double start = 0.0, low = 0.0, high = 0.0;
    double rise = 0.0;  ///< Rise of the element at the start, over its length.
};

FirstSecond first_second(scene::Scene& scene, std::size_t cable, bool last) {
    World& w = scene.world;
    const WireId wire = w.wires().find(scene.cables[cable].name);
    const InteractionId id =
        last ? w.wires().elements(wire).back() : w.wires().elements(wire).front();
    const RowsView rows = w.solver().rows(id);
    FirstSecond out;
    const auto nodes = w.wires().nodes(wire);
    const std::size_t n = last ? nodes.size() - 2 : 0;
    const Vec3 chord = w.pose(nodes[n + 1]).position - w.pose(nodes[n]).position;
    out.rise = chord.z() / chord.norm();
    out.start = out.low = out.high = rows.violation[0] / rows.compliance[0];
    for (long i = steps_to(w, 1.0); i > 0; --i) {
        advance(w, 1);
        out.low = std::min(out.low, tension(w, id));
        out.high = std::max(out.high, tension(w, id));
    }
    return out;
}

struct Line {
    const char* name;
    std::string line_type, ends;
    double length = 0.0;
    int elements = 0;
};

scene::Scene line_scene(const Line& line, double step, const char* shape = "hanging") {
    scene::Options options;
    options.step = step;
    return scene::load_text(
        fmt::format(R"({{"version": 1, "name": "first_line", "sea": {{"depth": 400}},
            "cables": [{{"name": "line", "line_type": {}, "length": {}, "elements": {},
            "shape": "{}", {}}}]}})",
                    line.line_type, line.length, line.elements, shape, line.ends),
        "first_line", options);
}

/// Return the tension at the higher end of an elastic catenary of weight w, horizontal distance x,
/// rise z and length L. The horizontal tension H is found by bisection; the vertical tension V
/// follows from the rise for each H.
double catenary_top(double w, double EA, double x, double z, double length) {
    const auto at = [&](double h, double v, double& dx, double& dz) {
        // V at the upper end; s from there down.
        const double low = v - w * length;
        const double t0 = std::hypot(h, v), t1 = std::hypot(h, low);
        dx = h / w * (std::asinh(v / h) - std::asinh(low / h)) + h * length / EA;
        dz = (t0 - t1) / w + (v * v - low * low) / (2.0 * EA * w);
    };
    const auto v_of = [&](double h) {
        double a = -1e9, b = 1e9;
        for (int i = 0; i < 200; ++i) {
            const double v = 0.5 * (a + b);
            double dx, dz;
            at(h, v, dx, dz);
            (dz < z ? a : b) = v;
        }
        return 0.5 * (a + b);
    };
    double a = 1e-3, b = 1e9;
    for (int i = 0; i < 200; ++i) {
        const double h = std::sqrt(a * b);
        double dx, dz;
        at(h, v_of(h), dx, dz);
        (dx < x ? a : b) = h;
    }
    return std::hypot(a, v_of(a));
}

}  // namespace

void case_first_chains(Report& report) {
    for (const double step : kSteps)
        for (const double degrees : {0.0, 90.0, 37.0}) {
            scene::Options options;
            options.step = step;
            scene::Scene scene = scene::load_text(mooring(degrees), "first_chains", options);
            const FirstSecond e = first_second(scene, 0, false);
            report.compare(
                fmt::format("chain at {:.0f} degrees, step 1/{:.0f}: tension over that of "
                            "the start in a second",
                            degrees, 1.0 / step),
                {1.0, 1.0}, {e.low / e.start, e.high / e.start}, 2e-2,
                "2 %: the hull rises by the weight of the chain", 1.0);
        }
}

void case_first_lines(Report& report) {
    const double polyester = 52.0 * kGravity - kWater * kGravity * 0.25 * kPi * 0.217 * 0.217;
    const Line submerged{
        "polyester, wholly under water",
        R"({"mass_per_length": 52, "EA": 333.9e6, "diameter": 0.217, "cd_normal": 1.6})",
        R"("from": {"at": [0, 0, -372.192]}, "to": {"at": [1360, 0, -18]})", 1400.0, 70};
    const std::string chain =
        R"({"mass_per_length": 50.4, "EA": 2.3e8, "diameter": 0.048, "cd_normal": 2.6, "displaced_area": 0.0064})";
    const Line pierces{"chain that comes out of the water", chain,
                       R"("from": {"at": [0, 0, 20]}, "to": {"at": [20, 0, -40]})", 80.0, 60};
    const Line stiff{
        "pipe with EI, half in the water",
        R"({"mass_per_length": 50.4, "EA": 2.3e8, "EI": 1e5, "diameter": 0.2, "cd_normal": 1.2})",
        R"("from": {"at": [0, 0, 10]}, "to": {"at": [60, 0, -40]})", 90.0, 60};
    const Line floats{"rope that floats",
                      R"({"mass_per_length": 4, "EA": 2.3e7, "diameter": 0.09, "cd_normal": 1.2})",
                      R"("from": {"at": [0, 0, 5]}, "to": {"at": [60, 0, -20]})", 90.0, 60};
    const double top = catenary_top(polyester, 333.9e6, 1360.0, 372.192 - 18.0, 1400.0);
    for (const double step : kSteps) {
        for (const Line& line : {submerged, pierces, stiff, floats})
            for (const char* shape : {"hanging", "catenary"}) {
                scene::Scene scene = line_scene(line, step, shape);
                const FirstSecond e = first_second(scene, 0, true);
                report.compare(fmt::format("{}, \"{}\", step 1/{:.0f}: tension over that of the "
                                           "start in a second",
                                           line.name, shape, 1.0 / step),
                               {1.0, 1.0}, {e.low / e.start, e.high / e.start}, 1e-2,
                               "1 %: it starts at rest", 1.0);
                if (line.name == submerged.name)
                    report.compare(
                        fmt::format("{}, \"{}\": tension at its upper end [N]", line.name, shape),
                        {top},
                        {std::hypot(e.start * std::sqrt(1.0 - e.rise * e.rise),
                                    e.start * e.rise + 0.5 * polyester * 20.0)},
                        1e-4, "elastic catenary, elements of 20 m");
            }
    }
}

}  // namespace hawser::validate
