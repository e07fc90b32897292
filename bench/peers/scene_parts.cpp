// SPDX-License-Identifier: Apache-2.0
#include "scene_parts.h"

#include <cmath>

namespace hawser::bench {

Body box(double mass, const Vec3& half, const Vec3& at) {
    Body b;
    b.mass = mass;
    const Vec3 s = half.cwiseProduct(half);
    b.inertia = mass / 3.0 * Vec3(s.y() + s.z(), s.x() + s.z(), s.x() + s.y());
    b.start.x = at;
    return b;
}

Quat along_x(const Vec3& d) {
    const Quat yaw(Eigen::AngleAxisd(std::atan2(d.y(), d.x()), Vec3::UnitZ()));
    const double down = std::atan2(-d.z(), std::hypot(d.x(), d.y()));
    return yaw * Quat(Eigen::AngleAxisd(down, Vec3::UnitY()));
}

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

namespace {

Vec3 in_frame(const Scene& s, int body, const Vec3& at) {
    if (body == kWorld) return at;
    const BodyState& st = s.bodies[static_cast<std::size_t>(body)].start;
    return st.q.conjugate() * (at - st.x);
}

}  // namespace

void join(Scene& s, int a, int b, const Vec3& at) {
    s.joints.push_back({a, b, at, in_frame(s, a, at), in_frame(s, b, at)});
}

int add(Scene& s, const Body& b) {
    s.bodies.push_back(b);
    return static_cast<int>(s.bodies.size()) - 1;
}

int chain(Scene& s, int from, int to, const std::vector<Vec3>& nodes, double mass, double radius,
          double drag) {
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

}  // namespace hawser::bench
