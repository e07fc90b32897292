// SPDX-License-Identifier: Apache-2.0 Compare non-dimensional values of vessels with those of
// published ships.
#include <hawser/sea.h>
#include <hawser/vessel.h>
#include <hawser/world.h>

#include "base/number.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace hawser {
namespace {

/// Collect the sentences of a report.
class Unusual {
  public:
    void range(const std::string& what, double value, double least, double most) {
        if (value >= least && value <= most) return;
        list.push_back(what + " is " + number(value) + "; published ships have " + number(least) +
                       " to " + number(most));
    }
    std::vector<std::string> list;
};

double length_of(const VesselDef& def) {
    for (const double length : {def.polynomial.length, def.cross_flow.length, def.mmg.length,
                                def.son_nomoto.length, def.wind.length})
        if (length > 0.0) return length;
    return 0.0;
}

double term_coefficient(const HullPolynomial& p, HullAxis axis, const char* of) {
    double sum = 0.0;
    for (const HullTerm& t : p.terms)
        if (t.axis == axis && t.of == of) sum += t.value;
    return sum;
}

void check_lengths(const VesselDef& def, double length, Unusual& out) {
    const auto compare = [&](const char* field, double other) {
        if (other > 0.0 && std::abs(other / length - 1.0) > 0.1)
            out.list.push_back(std::string(field) + " is " + number(other) + " m beside " +
                               number(length) + " m: coefficients of another scale?");
    };
    compare("mmg/length", def.mmg.length);
    compare("son_nomoto/length", def.son_nomoto.length);
    compare("cross_flow/length", def.cross_flow.length);
}

/// Check that the weight is carried once only.
void check_weight(const World& world, const VesselDef& def, Unusual& out) {
    const SeaDef* sea = find_sea(world);
    const bool afloat =
        sea != nullptr && std::any_of(sea->hulls.begin(), sea->hulls.end(),
                                      [&](const WaterHull& h) { return h.body == def.body; });
    const bool heavy = world.body_def(def.body).gravity && world.settings().gravity.z() != 0.0;
    if (heavy && !afloat)
        out.list.push_back(
            "the body has weight, and no hull in the sea carries it; make it "
            "weightless (gravity false) or give it a hull in the sea");
    if (afloat && !def.restoring.isZero(0.0))
        out.list.push_back(
            "\"restoring\" adds to the restoring force of a hull in the sea; give one of them");
}

}  // namespace

std::vector<std::string> unusual_values(const World& world, const VesselDef& def) {
    Unusual out;
    if (!world.alive(def.body)) return out.list;
    check_weight(world, def, out);
    const double length = length_of(def);
    const double mass = world.body_def(def.body).mass;
    if (!(length > 0.0) || !(mass > 0.0)) return out.list;
    check_lengths(def, length, out);
    const double cube = def.density * length * length * length;
    out.range("mass over density length^3", mass / cube, 5e-4, 0.05);
    const Matrix6& a = def.added_mass;
    if (!a.isZero(0.0)) {
        out.range("added mass of surge over mass", a(0, 0) / mass, 0.005, 0.35);
        out.range("added mass of sway over mass", a(1, 1) / mass, 0.15, 3.0);
        out.range("added inertia of yaw over mass length^2", a(5, 5) / (mass * length * length),
                  0.005, 0.2);
    }
    const HullPolynomial& p = def.polynomial;
    if (!p.terms.empty() && p.scale == HullScale::speed) {
        // Refer to L d, for any reference area of the source.
        const double draught = def.draught > 0.0 ? def.draught : 0.05 * length;
        const double share = p.area / (length * draught);
        out.range("Y' of v on L d", -share * term_coefficient(p, HullAxis::y, "v"), 0.08, 1.0);
        out.range("N' of v on L d", -share * term_coefficient(p, HullAxis::n, "v"), 0.0, 0.4);
        out.range("N' of r on L d", -share * term_coefficient(p, HullAxis::n, "r"), 0.005, 0.2);
    }
    for (const double d : {def.mmg.diameter, def.son_nomoto.diameter})
        if (d > 0.0) out.range("propeller diameter over length", d / length, 0.01, 0.08);
    for (const double area : {def.mmg.rudder_area, def.son_nomoto.rudder_area})
        if (area > 0.0)
            out.range("rudder area over length^2", area / (length * length), 2e-4, 5e-3);
    if (def.cross_flow.length > 0.0)
        out.range("beam over draught", def.cross_flow.beam / def.cross_flow.draught, 1.5, 9.0);
    if (def.wind.ship != WindShip::none)
        out.range("lateral area in the wind over length^2",
                  def.wind.lateral_area / (def.wind.length * def.wind.length), 0.01, 0.4);
    for (const PropulsorDef& q : def.propulsors) {
        if (!(q.propeller.diameter > 0.0)) {
            out.range(q.name + ": thrust over weight", q.thrust / (9.81 * mass), 1e-4, 0.2);
            continue;
        }
        const bool b = q.propeller.series == PropellerSeries::wageningen_b;
        out.range(q.name + ": pitch ratio", q.propeller.pitch, 0.5, b ? 1.4 : 1.6);
        if (b) out.range(q.name + ": blade area ratio", q.propeller.area, 0.30, 1.05);
        if (b) out.range(q.name + ": blades", q.propeller.blades, 2.0, 7.0);
        out.range(q.name + ": diameter over length", q.propeller.diameter / length, 0.005, 0.1);
    }
    for (const RudderDef& r : def.rudders)
        out.range(r.name + ": area over length^2", r.area / (length * length), 2e-4, 1e-2);
    return out.list;
}

}  // namespace hawser
