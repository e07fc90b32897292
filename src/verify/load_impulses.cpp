// SPDX-License-Identifier: Apache-2.0
#include "verify/load_impulses.h"

#include "base/dense.h"
#include "verify/step_velocity.h"

#include <cmath>
#include <span>

namespace hawser::verify {

namespace {

using Matrix = base::MatUpTo6;
using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 6, 1>;

Matrix full_matrix(std::span<const double> triangle, int n) {
    Matrix m(n, n);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j <= i; ++j) {
            const int place = i * (i + 1) / 2 + j;
            m(i, j) = m(j, i) = triangle[static_cast<std::size_t>(place)];
        }
    return m;
}

Vector motion(const Twist& t, int n) {
    Vector v(n);
    for (int k = 0; k < n; ++k) v[k] = k < 3 ? t.linear[k] : t.angular[k - 3];
    return v;
}

Matrix mass_matrix(const BodyDef& def, const Pose& pose, int n) {
    Matrix m = Matrix::Identity(n, n) * def.mass;
    if (n < 6) return m;
    const Mat3 r = pose.orientation.toRotationMatrix();
    m.block<3, 3>(3, 3) = r * def.inertia * r.transpose();
    return m;
}

// Return θ, the weight of the velocity after the step in the damping of a load
// (docs/theory/loads.md).
double late_fraction_of_load(double z) {
    if (z < 1e-2) return 0.5 + z / 12.0 - z * z * z / 720.0;
    return -1.0 / std::expm1(-z) - 1.0 / z;
}

}  // namespace

std::vector<LoadImpulse> load_impulses(const World& world, const std::vector<Pose>& pose,
                                       const std::vector<Twist>& before) {
    std::vector<LoadImpulse> out;
    const double h = world.settings().step;
    for (const LoadView& load : world.loads()) {
        const auto b = static_cast<std::size_t>(load.body.index);
        const int n = static_cast<int>(load.force.size());
        const Matrix a = full_matrix(load.mass, n), d = full_matrix(load.damping, n),
                     k = full_matrix(load.stiffness, n);
        const Matrix whole = mass_matrix(world.body_def(load.body), pose[b], n) + a;
        const Matrix fast = h * d + 0.25 * h * h * k;
        const double late =
            d.isZero(0.0) ? 0.5 : late_fraction_of_load(base::solve_cholesky(whole, fast).trace());
        const Vector v = motion(before[b], n),
                     u = motion(step_velocity(world, load.body, pose[b]), n);
        const Matrix resistance = a + 0.25 * h * h * k + h * late * d;
        Vector p = -(a + 0.25 * h * h * k) * (u - v) - h * (d * (late * u + (1.0 - late) * v));
        for (int i = 0; i < n; ++i) p[i] += h * load.force[static_cast<std::size_t>(i)];
        LoadImpulse one;
        one.body = load.body;
        one.resistance = resistance.cwiseAbs().maxCoeff();
        for (int i = 0; i < n; ++i) (i < 3 ? one.linear[i] : one.angular[i - 3]) = p[i];
        out.push_back(one);
    }
    return out;
}

}  // namespace hawser::verify
