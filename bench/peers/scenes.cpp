// SPDX-License-Identifier: Apache-2.0
#include "scenes.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace hawser::bench {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kShipMass = 4e6;                           // [kg]
constexpr double kShipHeave = 80.0 * 18.0 * 1025.0 * 9.81;  // water plane 80 x 18 m [N/m]

Body box(double mass, const Vec3& half, const Vec3& at) {
    Body b;
    b.mass = mass;
    const Vec3 s = half.cwiseProduct(half);
    b.inertia = mass / 3.0 * Vec3(s.y() + s.z(), s.x() + s.z(), s.x() + s.y());
    b.start.x = at;
    return b;
}

/// Yaw and pitch that turn the body x axis into `d`.
Quat along_x(const Vec3& d) {
    const Quat yaw(Eigen::AngleAxisd(std::atan2(d.y(), d.x()), Vec3::UnitZ()));
    const double down = std::atan2(-d.z(), std::hypot(d.x(), d.y()));
    return yaw * Quat(Eigen::AngleAxisd(down, Vec3::UnitY()));
}

/// Solid cylinder from `p` to `q`, its body x axis along the cylinder.
Body link(double mass, double radius, const Vec3& p, const Vec3& q) {
    Body b;
    b.mass = mass;
    const double l2 = (q - p).squaredNorm(), r2 = radius * radius;
    const double across = mass * (3.0 * r2 + l2) / 12.0;
    b.inertia = Vec3(mass * r2 / 2.0, across, across);
    b.start.x = 0.5 * (p + q);
    b.start.q = along_x(q - p);
    return b;
}

Vec3 in_frame(const Scene& s, int body, const Vec3& at) {
    if (body == kWorld) return at;
    const BodyState& st = s.bodies[static_cast<std::size_t>(body)].start;
    return st.q.conjugate() * (at - st.x);
}

void join(Scene& s, int a, int b, const Vec3& at) {
    s.joints.push_back({a, b, at, in_frame(s, a, at), in_frame(s, b, at)});
}

int add(Scene& s, const Body& b) {
    s.bodies.push_back(b);
    return static_cast<int>(s.bodies.size()) - 1;
}

/// Links between consecutive `nodes`, with ball joints to `from`, between links and to `to`.
/// Returns the index of the first joint; the last one is that plus the number of links.
int chain(Scene& s, int from, int to, const std::vector<Vec3>& nodes, double mass, double radius,
          double drag = 0.0) {
    const int first = static_cast<int>(s.joints.size());
    int previous = from;
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
        Body l = link(mass, radius, nodes[i], nodes[i + 1]);
        l.drag = drag;
        const int now = add(s, l);
        join(s, previous, now, nodes[i]);
        previous = now;
    }
    join(s, previous, to, nodes.back());
    return first;
}

void float_hull(Scene& s, int body, double heave_k) {
    Body& b = s.bodies[static_cast<std::size_t>(body)];
    b.afloat = true;
    s.floating.push_back(
        {body, heave_k, 0.4 * std::sqrt(heave_k * b.mass), 100.0 * b.mass, 0.4 * 100.0 * b.mass});
}

/// Nodes of `n` rigid links of length `l` hanging between two points at rest.
///
/// Balance of moments makes link i point along (H, V + w (i + 1/2)), w the weight of a link: the
/// exact equilibrium of rigid links, within 3e-7 l of the smooth catenary of the same length.
/// Newton on H and V so that the links end at `q`; started from the estimate of Jonkman 2007.
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

}  // namespace

Scene heavy_hook() {
    Scene s;
    s.name = "heavy_hook";
    s.code = "S1";
    s.duration = 10.0;
    const int n = 100;
    const double angle = 20.0 * kPi / 180.0;
    const Vec3 dir(std::sin(angle), 0.0, -std::cos(angle));
    std::vector<Vec3> nodes;
    for (int i = 0; i <= n; ++i) nodes.push_back(i * dir);
    // The block is body 100, after the links; joined half its size below the last node.
    Body block = box(50e3, Vec3::Ones(), (n + 1.0) * dir);
    block.start.q = along_x(dir);
    int previous = kWorld;
    for (int i = 0; i < n; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const int now = add(s, link(10.0, 0.05, nodes[k], nodes[k + 1]));
        join(s, previous, now, nodes[k]);
        previous = now;
    }
    s.block = add(s, block);
    join(s, previous, s.block, nodes.back());
    s.layouts = {{"tree", {}}};
    s.energy_scale = 0.0;  // potential energy from the start to hanging straight down
    for (const Body& b : s.bodies)
        s.energy_scale += b.mass * s.gravity * b.start.x.norm() * (1.0 - std::cos(angle));
    return s;
}

Scene tow_zigzag() {
    Scene s;
    s.name = "tow_zigzag";
    s.code = "S2p";
    s.gravity = 0.0;
    s.duration = 20.0;
    const int n = 200;
    const double l = 2.0, mass = 50.0, thrust = 500e3;
    s.sine = 0.05;
    std::vector<Vec3> nodes{Vec3::Zero()};
    double y0 = 0.0;
    for (int i = 1; i <= n; ++i) {
        const double zigzag = i == n ? 0.0 : (i % 2 == 1 ? -1e-3 : 1e-3);
        const double y = i == n ? 0.0 : s.sine * std::sin(kPi * i / n) + zigzag;
        const double dx = std::sqrt(l * l - (y - y0) * (y - y0));
        nodes.push_back(nodes.back() + Vec3(dx, y - y0, 0.0));
        y0 = y;
    }
    const Vec3 half(40.0, 9.0, 4.0);
    const int ship2 = add(s, box(kShipMass, half, nodes.front() - 40.0 * Vec3::UnitX()));
    const int ship1 = add(s, box(kShipMass, half, nodes.back() + 40.0 * Vec3::UnitX()));
    s.cable_first = static_cast<int>(s.bodies.size());
    s.cable_links = n;
    chain(s, ship2, ship1, nodes, mass, 0.04);
    s.thrusts.push_back({ship1, thrust * Vec3::UnitX()});
    float_hull(s, ship1, kShipHeave);
    float_hull(s, ship2, kShipHeave);
    s.towed = {ship2};
    const double all = 2.0 * kShipMass + n * mass;
    s.tension = thrust * kShipMass / all;
    s.sine_omega = kPi / (n * l) * std::sqrt(0.5 * thrust / (mass / l));
    s.layouts = {{"tree", {}}, {"ship 1 closed", {static_cast<int>(s.joints.size()) - 1}}};
    // Work of the thrust over the run: F x with x = F t^2 / (2 m).
    s.energy_scale = thrust * thrust * s.duration * s.duration / (2.0 * all);
    return s;
}

Scene mooring() {
    Scene s;
    s.name = "mooring";
    s.code = "S3";
    s.duration = 20.0;
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
                const int first = chain(s, kWorld, rig, hanging_nodes(anchor, fairlead, n, l, w),
                                        mass, radius, drag);
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
    // Potential energy that the lines give up while the hulls settle, from a converged run: what
    // S1 is measured by, too. The largest kinetic energy is 2.8e4 J.
    s.energy_scale = 2.1e5;
    return s;
}

Scene scene_by_name(const std::string& name) {
    for (Scene (*make)() : {heavy_hook, tow_zigzag, mooring}) {
        Scene s = make();
        if (s.name == name || s.code == name) return s;
    }
    throw std::invalid_argument("unknown scene '" + name +
                                "': expected heavy_hook, tow_zigzag or mooring");
}

void external_loads(const Scene& scene, const std::vector<BodyState>& states,
                    std::vector<Load>& loads) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        loads[i].force = -scene.bodies[i].drag * states[i].v;
        loads[i].torque.setZero();
    }
    for (const Thrust& t : scene.thrusts) loads[static_cast<std::size_t>(t.body)].force += t.force;
    for (const Floating& f : scene.floating) {
        const auto i = static_cast<std::size_t>(f.body);
        const BodyState& st = states[i];
        loads[i].force.z() -= f.heave_k * (st.x.z() - scene.bodies[i].start.x.z());
        loads[i].force.z() -= f.heave_c * st.v.z();
        const Vec3 up = st.q * Vec3::UnitZ();
        loads[i].torque += f.tilt_k * up.cross(Vec3::UnitZ());
        loads[i].torque -= f.tilt_c * Vec3(st.w.x(), st.w.y(), 0.0);
    }
}

}  // namespace hawser::bench
