// SPDX-License-Identifier: Apache-2.0
#include <hawser/catenary.h>

#include "wire/chain.h"
#include "wire/hang.h"
#include "wire/lie.h"
#include "wire/rest.h"
#include "wire/touch.h"
#include "wire/wet.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hawser {
namespace wire {
namespace {

/// Fraction of the wire's length below which lengths count as rounding.
constexpr double kLengthRounding = 1e-12;

/// The vertical plane through both ends.
struct Frame {
    Vec3 along, side, up;
    double x = 0.0, z = 0.0;  ///< Last end relative to the first [m].
    double bottom = 0.0;      ///< Height of the seabed above the first end [m].
    double water = 0.0;       ///< Height of still water above the first end [m].

    Frame(const CatenaryDef& def, double length) : up(-def.down.normalized()) {
        const Vec3 d = def.to - def.from;
        z = d.dot(up);
        const Vec3 flat = d - z * up;
        x = flat.norm();
        if (x > kLengthRounding * (length + std::abs(z))) {
            along = flat / x;
        } else {
            x = 0.0;
            Vec3 axis = Vec3::UnitX();
            if (std::abs(up.x()) > 0.9) axis = Vec3::UnitY();
            along = (axis - axis.dot(up) * up).normalized();
        }
        side = up.cross(along);
        if (def.seabed) bottom = def.seabed->height - def.from.dot(up);
        if (def.water) water = *def.water - def.from.dot(up);
    }
};

/// Return the least height of the inner nodes, and of the last node if it is free [m].
double lowest(const Plane& shape, bool free) {
    double z = 0.0, least = std::numeric_limits<double>::infinity();
    for (std::size_t e = 0; e + (free ? 0 : 1) < shape.chord.size(); ++e) {
        z += shape.chord[e].z();
        least = std::min(least, z);
    }
    return least;
}

struct SolvedShape {
    Plane shape;
    bool below = false;  ///< true if an end lies under the seabed
    bool dips = false;   ///< true if another node lies under it because no better shape was found
};

SolvedShape solve(const CatenaryDef& def, const Chain& chain, const Frame& f) {
    SolvedShape out;
    out.shape = def.free ? hang_down(chain) : hang_between(chain, f.x, f.z);
    if (!def.seabed) return out;
    const double size = chain.total_length() + std::abs(f.z) + std::abs(f.bottom);
    const double first = -f.bottom, last = f.z - f.bottom;
    // An end may lie below the bottom by half the length of its element, so that the element is not
    // steep.
    constexpr double kMaxSunkFraction = 0.5, kCoordinateRounding = 1e-9;
    out.below =
        first < -std::max(kMaxSunkFraction * chain.length.front(), kCoordinateRounding * size) ||
        (!def.free &&
         last < -std::max(kMaxSunkFraction * chain.length.back(), kCoordinateRounding * size));
    if (def.free && first < -kCoordinateRounding * size) out.below = true;
    if (out.below || lowest(out.shape, def.free) >= f.bottom - kLengthRounding * size) return out;
    auto lies = def.free ? rest_with_free_end(chain, std::max(0.0, first))
                         : rest_between(chain, f.x, first, last, def.seabed->friction);
    if (!lies && !def.free && first < 0.0) lies = touch_once(chain, f.x, -first, last);
    if (!lies && !def.free && last < 0.0) {
        lies = touch_once(reversed(chain), f.x, -last, first);
        if (lies) *lies = reversed(*lies);
    }
    if (lies)
        out.shape = std::move(*lies);
    else
        out.dips = lowest(out.shape, def.free) < f.bottom - kCoordinateRounding * size;
    return out;
}

/// Compute node positions from chords. Distribute the closing error at the last end evenly over all
/// elements.
void compute_node_positions(const CatenaryDef& def, const Chain& chain, const Frame& f,
                            const Plane& shape, Catenary& out) {
    const std::size_t n = chain.elements();
    out.nodes.resize(n + 1);
    out.nodes[0] = def.from;
    Vec3 at = Vec3::Zero();
    std::vector<Vec3> sum{at};
    for (const Vec3& d : shape.chord) sum.push_back(at += d);
    const Vec3 open = def.free ? Vec3::Zero().eval() : Vec3(Vec3(f.x, 0.0, f.z) - at);
    for (std::size_t i = 1; i <= n; ++i) {
        Vec3 p = sum[i] + chain.s[i] / chain.total_length() * open;
        if (i >= shape.laid_first && i <= shape.laid_last) p.z() = f.bottom;
        out.nodes[i] = def.from + p.x() * f.along + p.y() * f.side + p.z() * f.up;
    }
    if (!def.free) out.nodes[n] = def.to;
}

/// Return the tension of an element from the positions of its ends [N].
Vec3 tension_between_nodes(const Chain& chain, const std::vector<Vec3>& nodes, std::size_t e) {
    const Vec3 d = nodes[e + 1] - nodes[e];
    const double length = d.norm(), stretch = length - chain.length[e];
    return stretch > 0.0 ? Vec3(stretch / chain.compliance[e] / length * d) : Vec3::Zero().eval();
}

/// Return the largest difference from equilibrium at a free node [N].
double residual(const CatenaryDef& def, const Chain& chain, const Frame& f, const Plane& shape,
                const std::vector<Vec3>& nodes) {
    const std::size_t n = chain.elements();
    double most = 0.0;
    const std::vector<Vec3> bent = bending_forces(chain, nodes);
    for (std::size_t i = 1; i < n + (def.free ? 1 : 0); ++i) {
        Vec3 force = bent[i] - tension_between_nodes(chain, nodes, i - 1);
        if (i < n) force += tension_between_nodes(chain, nodes, i);
        const double weight = i < n ? chain.weight[i] : chain.half_last;
        double up = force.dot(f.up);
        Vec3 level = force - up * f.up;
        up -= weight;
        const double above = (nodes[i] - def.from).dot(f.up) - f.bottom;
        const bool lies = def.seabed && above <= 1e-12 * chain.total_length();
        if (lies || (i >= shape.laid_first && i <= shape.laid_last)) {
            const double carried = std::max(0.0, -up),
                         held = def.seabed ? def.seabed->friction * carried : 0.0;
            up = std::max(0.0, up);
            level *= std::max(0.0, 1.0 - held / std::max(level.norm(), 1e-300));
        }
        most = std::max(most, std::hypot(up, level.norm()));
    }
    return most;
}

/// Return the allowed residual: the tolerance plus the rounding of positions [N].
double allowed(const CatenaryDef& def, const Chain& chain, const Catenary& shape) {
    double weight = std::abs(chain.half_last), stiffest = 0.0, far = 0.0;
    for (const double w : chain.weight) weight = std::max(weight, std::abs(w));
    for (const double c : chain.compliance) stiffest = std::max(stiffest, 1.0 / c);
    for (const Vec3& p : shape.nodes) far = std::max(far, p.cwiseAbs().maxCoeff());
    far = std::max(far, chain.total_length());
    if (!(weight > 0.0)) weight = shape.largest();
    return def.tolerance * weight + 16.0 * std::numeric_limits<double>::epsilon() * far * stiffest;
}

/// Repeat the solution with node weights from the wetted fractions of half elements in the last
/// shape.
/// @return true if converged; the wet part of a floating wire may alternate.
bool update_wet_weights(const CatenaryDef& def, Chain& chain, const Frame& f, SolvedShape& solved) {
    constexpr int kIterations = 60;
    for (int k = 0; k < kIterations; ++k) {
        double heaviest = 0.0;
        for (std::size_t e = 0; e < chain.elements(); ++e)
            heaviest = std::max({heaviest, std::abs(chain.heavy[e]), chain.buoyancy[e]});
        const double change = weigh_nodes(chain, wet_halves(chain, solved.shape, f.water));
        if (change <= 1e-12 * heaviest) return true;
        solved = solve(def, chain, f);
    }
    return false;
}

/// Return the straight line between the ends, the first shape from which the wet part of the wire
/// is estimated.
Plane straight(const CatenaryDef& def, const Chain& chain, const Frame& f) {
    Plane out;
    for (const double l : chain.length)
        out.chord.push_back(def.free ? Vec3(0.0, 0.0, -l)
                                     : Vec3(l / chain.total_length() * Vec3(f.x, 0.0, f.z)));
    return out;
}

/// Return true if slack elements between two held ends leave the shape undetermined.
bool stays_slack(const CatenaryDef& def, const Plane& shape) { return !def.free && shape.slack; }

}  // namespace
}  // namespace wire

const char* to_string(CatenaryStatus status) noexcept {
    switch (status) {
        case CatenaryStatus::balanced:
            return "balanced";
        case CatenaryStatus::slack:
            return "slack";
        case CatenaryStatus::below_seabed:
            return "below_seabed";
        case CatenaryStatus::unbalanced:
            return "unbalanced";
    }
    return "?";
}

double Catenary::largest() const noexcept {
    double most = 0.0;
    for (const double t : tension) most = std::max(most, t);
    return most;
}

Catenary catenary(const CatenaryDef& def) {
    wire::Chain chain = wire::make_chain(def);
    const wire::Frame frame(def, chain.total_length());
    if (def.water)
        (void)wire::weigh_nodes(
            chain, wire::wet_halves(chain, wire::straight(def, chain, frame), frame.water));
    wire::SolvedShape solved = wire::solve(def, chain, frame);
    const bool even = !def.water || wire::update_wet_weights(def, chain, frame, solved);
    const std::size_t n = chain.elements();
    Catenary out;
    out.s = chain.s;
    wire::compute_node_positions(def, chain, frame, solved.shape, out);
    if (!solved.below && !wire::stays_slack(def, solved.shape) &&
        (!even || (solved.dips && def.water) || wire::resists_bending(chain))) {
        wire::Surroundings around{def.free, {}, {}, 0.0};
        if (def.water) around.water = frame.water;
        if (def.seabed) around.bottom = frame.bottom;
        if (def.seabed && !solved.dips) around.friction = def.seabed->friction;
        wire::Chain wet = chain;
        const double tolerance = 0.3 * wire::allowed(def, chain, out);
        if (auto rest = wire::equilibrium_near(wet, solved.shape, around, tolerance)) {
            chain = std::move(wet);
            solved.shape = std::move(*rest);
            solved.dips = false;
            wire::compute_node_positions(def, chain, frame, solved.shape, out);
        } else {
            std::fill(chain.bend.begin(), chain.bend.end(), 0.0);  // without bending stiffness
        }
    }
    out.pull_from = wire::tension_between_nodes(chain, out.nodes, 0);
    out.pull_to = -wire::tension_between_nodes(chain, out.nodes, n - 1);
    out.weight_from = chain.half_first;
    out.weight_to = def.free ? 0.0 : chain.half_last;
    if (solved.shape.laid_first <= solved.shape.laid_last) {
        out.laid_from = chain.s[solved.shape.laid_first];
        out.laid_to = chain.s[solved.shape.laid_last];
    }
    out.tension = std::move(solved.shape.tension);
    out.residual = wire::residual(def, chain, frame, solved.shape, out.nodes);
    out.allowed = wire::allowed(def, chain, out);
    out.status = !(out.residual <= out.allowed) || solved.dips ? CatenaryStatus::unbalanced
                 : solved.below                                ? CatenaryStatus::below_seabed
                 : solved.shape.slack                          ? CatenaryStatus::slack
                                                               : CatenaryStatus::balanced;
    return out;
}

}  // namespace hawser
