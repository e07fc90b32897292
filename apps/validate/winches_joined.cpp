// SPDX-License-Identifier: Apache-2.0
// Wires that are cut and joined at once against those that were not.
#include "validate/cases.h"
#include "validate/tools.h"
#include "validate/uniform.h"

#include <algorithm>
#include <cmath>

namespace hawser::validate {
namespace {

constexpr int kSpans = 10;

/// A wire between two points, or with a weight at its end, at rest.
struct TautSpan {
    World w{WorldDef{.step = 1.0 / 60.0}};
    WireId wire{};

    explicit TautSpan(const WireDef& of, const Vec3& to, double weight) {
        WireDef def = of;
        def.from = w.add_body({.name = "from", .kind = BodyKind::fixed});
        def.to = weight > 0.0 ? w.add_body({.name = "to",
                                            .kind = BodyKind::lump,
                                            .position = to,
                                            .mass = weight,
                                            .linear_damping = Vec3::Constant(weight)})
                              : w.add_body({.name = "to", .kind = BodyKind::fixed, .position = to});
        wire = w.wires().add(def);
    }
    /// Return the tension in the middle of an element at a material coordinate [m].
    [[nodiscard]] double tension_at(WireId of, double s) const { return w.wires().tension(of, s); }
};

WireDef random_wire(Uniform& random, double length) {
    return {.name = "wire",
            .elements = 24,
            .length = length,
            .EA = random(1e7, 5e8),
            .mass_per_length = random(2.0, 30.0),
            .axial_damping = 2.0,
            .drag = random(5.0, 30.0),
            .consistent_mass = true};
}

}  // namespace

/// Compare the tensions of a span that was cut and spliced at once with those of an uncut one. Do
/// the same for a weight's wire that was cut and shackled.
void report_joined_wires(Report& report) {
    Uniform random(5);
    double spliced = 0.0, shackled = 0.0;
    for (int i = 0; i < kSpans; ++i) {
        const double length = random(60.0, 200.0);
        const bool hangs = i % 2 == 1;
        const WireDef def = random_wire(random, length);
        const double weight = hangs ? random(1e3, 2e4) : 0.0;
        const Vec3 to = hangs ? Vec3(0, 0, -length)
                              : Vec3(length * random(0.7, 0.95), 0, -length * random(0.0, 0.2));
        TautSpan whole(def, to, weight), joined(def, to, weight);
        // Cut a span at a node: a new node would change the discretisation.
        const double element = length / def.elements;
        const double s = hangs ? length * random(0.2, 0.8) : element * random.whole(5, 19);
        advance(whole.w, 60);
        advance(joined.w, 60);
        const WireId second = joined.w.wires().cut(joined.wire, s);
        (void)joined.w.wires().join(joined.wire, 1, second, 0,
                                    {.gear = hangs ? Gear::shackle : Gear::splice, .length = 0.3});
        advance(whole.w, 6'000);
        advance(joined.w, 6'000);
        double& worst = hangs ? shackled : spliced;
        // For a hanging weight compare above the shackle only, because the shackle adds length.
        const double up_to = hangs ? s : length;
        for (double k = 0.5; (k + 0.499) * element < up_to; k += 1.0) {
            const double at = k * element;
            const double expected = whole.tension_at(whole.wire, at);
            worst = std::max(worst, std::abs(joined.tension_at(joined.wire, at) / expected - 1.0));
        }
    }
    report.compare("tension of a wire cut and spliced over that of one uncut, worst", {0.0},
                   {spliced}, 1e-4, "relative; at rest", 1.0);
    report.compare("tension of a wire cut and shackled over that of one uncut, worst", {0.0},
                   {shackled}, 1e-4, "relative; a weight hangs on it", 1.0);
}

}  // namespace hawser::validate
