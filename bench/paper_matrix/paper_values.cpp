// SPDX-License-Identifier: Apache-2.0
// Values of the system: inertia, Jacobians, compliance.
#include "paper_matrix/dice.h"

#include "index.h"
#include "paper_matrix/paper_matrix.h"

#include <Eigen/Dense>

#include <algorithm>
#include <string>

namespace hawser::bench {
namespace {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

constexpr double kStep = 1.0 / 60.0;  ///< [s]

/// Compute Σ of a position row with damping time `steps` steps: 4 ε Υ / h² (SPOOK).
double sigma(double compliance, double steps) {
    return 4.0 * compliance / (kStep * kStep) / (1.0 + 4.0 * steps);
}
const double kRigidSigma = sigma(1e-12, 2.0);

Mat3 cross(const Vec3& v) {
    Mat3 m;
    m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return m;
}

/// Compute the inertia about the origin of a body whose centre of mass is at c. Symmetric to the
/// last bit.
Eigen::Matrix<double, 6, 6> spatial(double mass, const Vec3& size, const Vec3& c) {
    Eigen::Matrix<double, 6, 6> m;
    const Vec3 s = size.cwiseAbs2();
    const Mat3 moment = mass / 3.0 * Vec3(s.y() + s.z(), s.x() + s.z(), s.x() + s.y()).asDiagonal();
    m.topLeftCorner<3, 3>() = mass * Mat3::Identity();
    m.topRightCorner<3, 3>() = -mass * cross(c);
    m.bottomLeftCorner<3, 3>() = mass * cross(c);
    m.bottomRightCorner<3, 3>() = moment - mass * cross(c) * cross(c);
    const Eigen::Matrix<double, 6, 6> transposed = m.transpose();
    return 0.5 * (m + transposed);
}

/// Return two unit vectors perpendicular to u and to each other.
std::array<Vec3, 2> across(const Vec3& u) {
    const Vec3 helper = std::abs(u.x()) < 0.7 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    const Vec3 p = u.cross(helper).normalized();
    return {p, u.cross(p)};
}

template <class M>
std::vector<double> by_rows(const M& m) {
    std::vector<double> v;
    for (int i = 0; i < m.rows(); ++i)
        for (int j = 0; j < m.cols(); ++j) v.push_back(m(i, j));
    return v;
}

std::array<double, 3> plain(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
Vec3 vec(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

}  // namespace

std::vector<double> PaperScene::point_rows(int body, const std::vector<Vec>& directions,
                                           const Vec& point, double factor) const {
    const Vec3 arm = vec(point) - vec(place_[at(body)]);
    std::vector<double> rows;
    for (const Vec& direction : directions) {
        const Vec3 d = factor * vec(direction), turn = arm.cross(d);
        for (int k = 0; k < 3; ++k) rows.push_back(d[k]);
        for (int k = 0; dof(body) == 6 && k < 3; ++k) rows.push_back(turn[k]);
    }
    return rows;
}

void PaperScene::emit_body(SystemBuilder& builder, int body) const {
    Dice dice(options_.seed + 31 + 7919 * static_cast<std::uint64_t>(body));
    const int local = body % per_copy();
    if (wide(body)) {
        const bool hull = local < 3, rig = local == 2;
        const double mass = rig ? 2e7 : hull ? 4e6 : dice.uniform(2e3, 5e4);
        const Vec3 size = rig    ? Vec3(35, 35, 10)
                          : hull ? Vec3(40, 9, 4)
                                 : Vec3(dice.uniform(1, 3), 1.5, dice.uniform(1, 6));
        const Vec3 centre(dice.uniform(-0.5, 0.5), dice.uniform(-0.3, 0.3), dice.uniform(-1, 0.5));
        builder.add_body(6, by_rows(spatial(mass, size, centre)));
        return;
    }
    // A wire of 25 kg/m in water: the added mass acts only across it.
    const double mass = 25.0 * length_[at(body)], added = 5.0 * length_[at(body)];
    const Vec3 u = vec(along_[at(body)]);
    const Mat3 normal = Mat3::Identity() - u * u.transpose();
    const Mat3 linear = mass * Mat3::Identity() + added * normal;
    if (options_.form == CableForm::lumped) {
        builder.add_body(3, by_rows(linear));
        return;
    }
    Eigen::Matrix<double, 6, 6> m = Eigen::Matrix<double, 6, 6>::Zero();
    m.topLeftCorner<3, 3>() = linear;
    const double l = length_[at(body)], radius = 0.038;
    m.bottomRightCorner<3, 3>() =
        mass * (l * l / 12.0 * normal + 0.5 * radius * radius * (u * u.transpose()));
    builder.add_body(6, by_rows(m));
}

void PaperScene::emit_joint(SystemBuilder& builder, const Joint& j) const {
    const Vec3 axis = vec(j.axis);
    const auto [p, q] = across(axis);
    const std::vector<Vec> frame{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const std::vector<Vec> sideways{plain(p), plain(q)};
    auto pair = [&](int node, auto&& rows) {
        for (int k = 0; k < 2; ++k)
            if (const int b = j.body[at(k)]; b >= 0)
                builder.add_block(node, b, rows(b, k ? -1 : 1));
    };
    auto turn_rows = [&](const std::vector<Vec>& axes, double factor, std::vector<double>& rows) {
        for (const Vec& a : axes)
            for (int k = 0; k < 6; ++k) rows.push_back(k < 3 ? 0.0 : factor * a[at(k - 3)]);
    };
    switch (j.kind) {
        case Kind::hinge:
        case Kind::lock: {
            const bool lock = j.kind == Kind::lock;
            const std::vector<double> s(lock ? 6 : 5, kRigidSigma);
            pair(builder.add_rows(s), [&](int b, double f) {
                std::vector<double> rows = point_rows(b, frame, j.point, f);
                turn_rows(lock ? frame : sideways, f, rows);
                return rows;
            });
            break;
        }
        case Kind::motor: {  // on the velocity, 1e-6 rad/s per N m
            const std::vector<double> s{1e-6 / kStep};
            pair(builder.add_rows(s), [&](int, double f) {
                std::vector<double> rows;
                turn_rows({j.axis}, f, rows);
                return rows;
            });
            break;
        }
        case Kind::end:
        case Kind::link: {
            const bool ball = j.kind == Kind::end || options_.form == CableForm::rigid;
            const double stretch = sigma(4.0 / 2.33e8, 0.5);  // l / EA, wire of 76 mm
            const std::vector<double> s =
                ball ? std::vector<double>(3, kRigidSigma) : std::vector<double>{stretch};
            pair(builder.add_rows(s), [&](int b, double f) {
                return point_rows(b, ball ? frame : std::vector<Vec>{j.axis}, j.point, f);
            });
            break;
        }
        case Kind::bend: {  // second difference of three points over l; EI 5 kN m²
            const std::vector<double> s(2, sigma(4.0 / 5e3, 2.0));
            const int node = builder.add_rows(s);
            for (int k = 0; k < 3; ++k) {
                const int b = j.body[at(k)];
                const Vec point = wide(b) ? j.point : place_[at(b)];
                builder.add_block(node, b, point_rows(b, sideways, point, (k == 1 ? -2 : 1) / 4.0));
            }
            break;
        }
    }
}

void PaperScene::emit_contact(SystemBuilder& builder, const Contact& c, int index) const {
    Dice dice(options_.seed + 53 + 104729 * static_cast<std::uint64_t>(c.first) +
              15485863 * static_cast<std::uint64_t>(index));
    const Vec3 n =
        Vec3(dice.uniform(-0.4, 0.4), dice.uniform(-0.4, 0.4), dice.uniform(0.6, 1.0)).normalized();
    const auto [p, q] = across(n);
    const std::vector<Vec> directions{plain(n), plain(p), plain(q)};
    const double reach = wide(c.first) ? 1.5 : 0.038;
    Vec3 point = vec(place_[at(c.first)]) - reach * n;
    if (wide(c.first)) point += Vec3(dice.uniform(-1, 1), dice.uniform(-1, 1), 0.0);
    const std::vector<double> s{sigma(1e-9, 2.0), sigma(1.5e-9, 2.0), sigma(1.5e-9, 2.0)};
    const int node = builder.add_rows(s);
    builder.add_block(node, c.first, point_rows(c.first, directions, plain(point), 1.0));
    if (c.second < 0) return;
    // Two cables are 76 mm apart at a contact, for any drawn positions; a hull keeps its position.
    const Vec3 far = wide(c.second) ? point : Vec3(vec(place_[at(c.second)]) + reach * n);
    builder.add_block(node, c.second, point_rows(c.second, directions, plain(far), -1.0));
}

BlockSystem PaperScene::system() const {
    SystemBuilder builder;
    for (int b = 0; b < bodies(); ++b) emit_body(builder, b);
    int joint = 0, contact = 0;
    for (const int end : joint_end_) {
        for (; joint < end; ++joint) emit_joint(builder, joints_[at(joint)]);
        for (int i = 0; i < contacts_per_copy(); ++i, ++contact)
            emit_contact(builder, contacts_[at(contact)], contact);
    }
    const std::string name = options_.form == CableForm::rigid ? "paper rigid" : "paper lumped";
    return builder.finish(options_.scale == 1 ? name : name + " x" + std::to_string(options_.scale),
                          options_.seed);
}

}  // namespace hawser::bench
