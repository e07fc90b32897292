// SPDX-License-Identifier: Apache-2.0
// A rig on mooring lines between two pulling ships, with lines that hang free or lie on the seabed.
#include "scene_parts.h"

#include <algorithm>
#include <cmath>

namespace hawser::bench {
namespace {

/// Compute nodes of `n` rigid links of length `l` hanging at rest between two points.
///
/// Balance of moments makes link i point along (H, V + w (i + 1/2)), w the weight of a link: the
/// exact equilibrium of rigid links, within 3e-7 l of the smooth catenary of equal length. Newton's
/// method on H and V makes the links end at `q`; it starts from the estimate of Jonkman 2007.
std::vector<Vec3> hanging_nodes(const Vec3& p, const Vec3& q, int n, double l, double w) {
    const Vec3 d = q - p;
    const double x = std::hypot(d.x(), d.y()), z = d.z();
    const Vec3 along(d.x() / x, d.y() / x, 0.0);
    const double total = n * l, rho = w / l;
    const double lambda = std::sqrt(3.0 * ((total * total - z * z) / (x * x) - 1.0));
    double h = rho * x / (2.0 * lambda);
    double v = rho / 2.0 * (z / std::tanh(lambda) - total);
    for (int it = 0; it < 50; ++it) {
        double fx = -x, fz = -z, a = 0.0, b = 0.0, c = 0.0;
        for (int i = 0; i < n; ++i) {
            const double t = (v + w * (i + 0.5)) / h, r = 1.0 / std::sqrt(1.0 + t * t);
            const double r3 = l * r * r * r;
            fx += l * r;
            fz += l * t * r;
            a += r3;
            b += r3 * t;
            c += r3 * t * t;
        }
        // d(fx)/d(t) = -t r3, d(fz)/dt = r3, dt/dh = -t/h, dt/dv = 1/h.
        const Eigen::Matrix2d jac{{c / h, -b / h}, {-b / h, a / h}};
        Eigen::Vector2d step = jac.inverse() * Eigen::Vector2d(fx, fz);
        if (std::abs(step.x()) > 0.5 * h) step *= 0.5 * h / std::abs(step.x());
        h -= step.x();
        v -= step.y();
        if (std::hypot(fx, fz) < 1e-11 * total) break;
    }
    std::vector<Vec3> nodes{p};
    for (int i = 0; i < n; ++i) {
        const double t = (v + w * (i + 0.5)) / h, r = 1.0 / std::sqrt(1.0 + t * t);
        nodes.push_back(nodes.back() + l * (r * along + t * r * Vec3::UnitZ()));
    }
    return nodes;
}

/// Compute nodes of `n` links of length `l` from an anchor. The line lies straight on the floor,
/// its axis at the anchor's height, then hangs as a catenary of a = 100 m up to `q`. Nodes are at
/// equal lengths of arc; chords of the catenary are shorter by up to 0.3 mm.
std::vector<Vec3> nodes_on_seabed(const Vec3& p, const Vec3& q, int n, double l) {
    constexpr double kLying = 186.8, kA = 100.0;  // [m]
    const Vec3 d = q - p;
    const Vec3 along = Vec3(d.x(), d.y(), 0.0).normalized();
    std::vector<Vec3> nodes{p};
    for (int i = 1; i < n; ++i) {
        const double hanging = std::max(0.0, l * i - kLying);
        const double x = std::min(l * i, kLying) + kA * std::asinh(hanging / kA);
        nodes.push_back(p + x * along + (std::hypot(kA, hanging) - kA) * Vec3::UnitZ());
    }
    nodes.push_back(q);
    return nodes;
}

/// Give capsules to the links from body `first` on, so that they touch.
void add_capsules(Scene& s, std::size_t first, double radius, double length) {
    for (std::size_t i = first; i < s.bodies.size(); ++i)
        s.bodies[i].shape = {BodyShape::Kind::capsule, radius, 0.5 * length, Vec3::Zero()};
}

/// Make the site, with mooring lines that hang free or lie on the seabed.
Scene site(bool seabed) {
    Scene s;
    const int n = 90;
    const double l = 4.0, mass = 200.0, radius = 0.1, drag = 20.0, w = mass * s.gravity;
    const Vec3 ship_half(40.0, 9.0, 4.0);
    const int rig = add(s, box(2e7, Vec3(35.0, 35.0, 10.0), Vec3::Zero()));
    s.bodies[0].drag = 2e5;
    float_hull(s, rig, 1.47812e7);
    for (const double side : {1.0, -1.0}) {
        const int ship = add(s, box(kShipMass, ship_half, Vec3(433.155 * side, 0.0, 0.0)));
        s.bodies.back().drag = 1e5;
        float_hull(s, ship, kShipHeave);
        s.thrusts.push_back({ship, Vec3(500e3 * side, 0.0, 0.0)});
        s.towed.push_back(ship);
    }
    TreeLayout one_tree{"one tree", {}}, anchored{"lines on anchors", {}};
    for (const double sx : {1.0, -1.0}) {
        for (const double sy : {1.0, -1.0}) {
            for (const bool wide : {true, false}) {
                const Vec3 anchor(sx * (wide ? 302.109 : 208.462), sy * (wide ? 208.462 : 302.109),
                                  -100.0);
                const Vec3 fairlead(35.0 * sx, 35.0 * sy, 0.0);
                const auto nodes = seabed ? nodes_on_seabed(anchor, fairlead, n, l)
                                          : hanging_nodes(anchor, fairlead, n, l, w);
                const std::size_t body = s.bodies.size();
                const int first = chain(s, kWorld, rig, nodes, mass, radius, drag);
                if (seabed) add_capsules(s, body, radius, l);
                one_tree.closures.push_back(first);
                anchored.closures.push_back(first + n);
            }
        }
    }
    TreeLayout split = anchored;
    split.name = "all lines closed at the rig";
    for (const int i : {0, 1}) {
        const double side = i == 0 ? 1.0 : -1.0;
        const Vec3 fairlead(35.0 * side, 0.0, 0.0), stern(393.155 * side, 0.0, 0.0);
        const int ship = s.towed[static_cast<std::size_t>(i)];
        const int first =
            chain(s, rig, ship, hanging_nodes(fairlead, stern, n, l, w), mass, radius, drag);
        split.closures.push_back(first);
    }
    s.layouts = {split, anchored, one_tree};
    return s;
}

}  // namespace

Scene mooring() {
    Scene s = site(false);
    s.name = "mooring";
    s.code = "S3";
    s.duration = 20.0;
    // Potential energy that the lines lose while the hulls settle, from a converged run; also the
    // scale of S1. The largest kinetic energy is 2.8e4 J.
    s.energy_scale = 2.1e5;
    return s;
}

Scene mooring_seabed() {
    Scene s = site(true);
    s.name = "mooring_seabed";
    s.code = "S3c";
    s.duration = 20.0;
    s.touching = Touching{.floor = -100.1, .friction = 0.5, .stiffness = 1e7};
    s.wanted = {.gap = 1e-5, .tension = 0.005, .ms = 5.0, .contacts = {650, 850}};
    return s;
}

}  // namespace hawser::bench
