// SPDX-License-Identifier: Apache-2.0
// Cables of nodes: a catenary, frequencies, momentum.
#include "base/dense.h"
#include "validate/cases.h"
#include "validate/tools.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hawser::validate {
namespace {

/// Small transverse vibration of a line of nodes. Frequencies and shapes solve K u = ω² M u with
/// the masses and lengths of the scene and the given tensions.
struct LineModes {
    Eigen::VectorXd omega;   ///< Ascending [rad/s].
    Eigen::MatrixXd shape;   ///< One column for each mode, largest entry 1, over the moving nodes.
    Eigen::VectorXd weight;  ///< Masses [kg].
    std::vector<BodyId> nodes;
};

LineModes line_modes(const World& world, const scene::Cable& cable,
                     const std::vector<double>& pull) {
    LineModes m;
    std::vector<std::size_t> moving;
    for (std::size_t i = 0; i < cable.nodes.size(); ++i) {
        if (world.body_def(cable.nodes[i]).kind == BodyKind::lump) moving.push_back(i);
    }
    const auto n = static_cast<Eigen::Index>(moving.size());
    // Diagonals of the stiffness: each node is coupled to its two neighbours.
    Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(n);
    Eigen::VectorXd off_diagonal = Eigen::VectorXd::Zero(std::max<Eigen::Index>(n - 1, 0));
    m.weight.resize(n);
    for (Eigen::Index a = 0; a < n; ++a) {
        const std::size_t i = moving[static_cast<std::size_t>(a)];
        m.nodes.push_back(cable.nodes[i]);
        m.weight[a] = world.body_def(cable.nodes[i]).mass;
        for (const std::size_t e : {i - 1, i}) {  // element e joins nodes e and e + 1
            if (e >= pull.size()) continue;
            const Vec3 d =
                world.pose(cable.nodes[e + 1]).position - world.pose(cable.nodes[e]).position;
            diagonal[a] += pull[e] / d.norm();
            if (e == i && a + 1 < n) {
                off_diagonal[a] = -pull[e] / d.norm();
            }
        }
    }
    // M^(-1/2) K M^(-1/2) has the same frequencies, its vectors are M^(1/2) u.
    const Eigen::VectorXd root = m.weight.cwiseSqrt();
    for (Eigen::Index a = 0; a < n; ++a) diagonal[a] /= m.weight[a];
    for (Eigen::Index a = 0; a + 1 < n; ++a) off_diagonal[a] /= root[a] * root[a + 1];
    const auto eigen = base::tridiagonal_eigen(diagonal, off_diagonal);
    m.omega = eigen.values.cwiseSqrt();
    m.shape = eigen.vectors;
    for (Eigen::Index j = 0; j < n; ++j) {
        for (Eigen::Index a = 0; a < n; ++a) m.shape(a, j) /= root[a];
        m.shape.col(j) /= m.shape.col(j).cwiseAbs().maxCoeff();
    }
    return m;
}

/// Return the frequency of a mode [Hz] from the zeros of its modal coordinate. The initial
/// amplitude is small compared with the elements.
double measured_frequency(scene::Scene& s, const LineModes& m, Eigen::Index mode,
                          const Vec3& direction) {
    constexpr double kAmplitude =
        1e-5;  // Amplitude [m]: slopes of 1e-5, frequency shift of order 1e-10
    for (std::size_t i = 0; i < m.nodes.size(); ++i) {
        Pose pose = s.world.pose(m.nodes[i]);
        pose.position += kAmplitude * m.shape(static_cast<Eigen::Index>(i), mode) * direction;
        s.world.set_pose(m.nodes[i], pose);
    }
    const auto coordinate = [&] {
        double q = 0.0;
        for (std::size_t i = 0; i < m.nodes.size(); ++i) {
            const auto a = static_cast<Eigen::Index>(i);
            q += m.weight[a] * m.shape(a, mode) * direction.dot(s.world.pose(m.nodes[i]).position);
        }
        return q;
    };
    std::vector<double> q{coordinate()};
    const double duration = 3.2 * 2.0 * kPi / m.omega[mode];
    while (s.world.time() < duration) {
        advance(s.world, 1);
        q.push_back(coordinate());
    }
    const std::vector<double> zeros = upward_zeros(q, s.world.settings().step);
    if (zeros.size() < 2) throw std::runtime_error("the line does not swing");
    return static_cast<double>(zeros.size() - 1) / (zeros.back() - zeros.front());
}

}  // namespace

void case_catenary(Report& report) {
    constexpr double kSpan = 80.0, kLength = 100.0;
    // Closed form without stretch: 2 a sinh(span / 2a) = length.
    double a = 30.0;
    for (int i = 0; i < 50; ++i) {
        const double u = 0.5 * kSpan / a;
        a -= (2.0 * a * std::sinh(u) - kLength) / (2.0 * std::sinh(u) - kSpan / a * std::cosh(u));
    }
    const double sag = a * (std::cosh(0.5 * kSpan / a) - 1.0);

    scene::Scene s = open_scene("catenary", 1.0 / 60.0);
    advance(s.world, steps_to(s.world, s.duration));
    const scene::Cable& rope = s.cables.at(0);
    const std::size_t half = rope.nodes.size() / 2;
    const auto pull = [&](std::size_t e) -> Vec3 {  // of element e on its first node [N]
        const Vec3 d =
            s.world.pose(rope.nodes[e + 1]).position - s.world.pose(rope.nodes[e]).position;
        return tension(s.world, rope.stretch[e]) * d.normalized();
    };
    const double element = s.world.body_def(rope.nodes[1]).mass * kGravity;  // weight of one [N]
    const double per_metre = element * static_cast<double>(rope.stretch.size()) / kLength;
    // The lumped cable leaves half an element's weight at its fixed end.
    const double end = (pull(0) + Vec3{0, 0, -0.5 * element}).norm();
    const char* reason = "100 elements: inscribed polygon; strain 6e-5";
    report.compare("horizontal pull / weight per metre [m]", {a}, {pull(half).x() / per_metre},
                   1e-3, reason);
    report.compare("sag [m]", {sag}, {-s.world.pose(rope.nodes[half]).position.z()}, 1e-3, reason);
    report.compare("end tension / weight per metre [m]", {a + sag}, {end / per_metre}, 1e-3,
                   reason);
    double fastest = 0.0;
    for (const BodyId node : rope.nodes) {
        fastest = std::max(fastest, s.world.velocity(node).linear.norm());
    }
    report.compare("speed left after settling [m/s]", {0.0}, {fastest}, 1e-6,
                   "absolute: the shape is at rest", 1.0);
}

void case_hanging_chain(Report& report) {
    constexpr double kLength = 10.0;
    constexpr double kBesselZeros[] = {2.404826, 5.520078, 8.653728};  // zeros of J0
    for (int mode = 0; mode < 3; ++mode) {
        double exact = 0.0;
        const auto run = [&](double step) -> Result {
            scene::Scene s = open_scene("hanging_chain", step);
            std::vector<double> pull(s.cables.at(0).stretch.size());
            double weight = 0.0;  // of the nodes below an element
            for (std::size_t e = pull.size(); e-- > 0;) {
                weight += kGravity * s.world.body_def(s.cables[0].nodes[e + 1]).mass;
                pull[e] = weight;
            }
            const LineModes m = line_modes(s.world, s.cables[0], pull);
            exact = m.omega[mode] / (2.0 * kPi);
            return {{measured_frequency(s, m, mode, Vec3{1, 0, 0})}};
        };
        run(1.0 / 60.0);  // for the lumped reference
        report.converge({{fmt::format("frequency {} of 20 lumps [Hz]", mode + 1),
                          {exact},
                          0.0,
                          1e-3,
                          1.9,
                          "relative, against the lumped form"}},
                        run, kTo960);
        if (mode == 0) {  // the higher modes of 20 nodes are 1 % and 4 % below the continuum
            const double continuum = kBesselZeros[0] / (4.0 * kPi) * std::sqrt(kGravity / kLength);
            report.compare("frequency 1 of the continuum [Hz]", {continuum},
                           report.checks().back().ours, 1e-3,
                           "20 lumps are 0.08 % below the continuum");
        }
    }
}

void case_taut_string(Report& report) {
    for (int mode = 0; mode < 3; ++mode) {
        scene::Scene first = open_scene("taut_string", 1.0 / 240.0);
        const scene::Cable& cable = first.cables.at(0);
        const auto n = static_cast<double>(cable.stretch.size());
        const double span = first.world.pose(cable.nodes.back()).position.x();
        const double pull = cable.EA * (span / cable.length - 1.0);
        const double mass = first.world.body_def(cable.nodes[1]).mass;
        // ω_j = 2 √(T/(m l)) sin(j π / 2N)
        const double exact =
            std::sqrt(pull / (mass * span / n)) * std::sin((mode + 1) * kPi / (2.0 * n)) / kPi;
        report.converge(
            {{fmt::format("frequency {} of 20 elements [Hz]", mode + 1),
              {exact},
              0.0,
              1e-3,
              1.9,
              "relative, against the lumped form"}},
            [&](double step) -> Result {
                scene::Scene s = open_scene("taut_string", step);
                const LineModes m = line_modes(
                    s.world, s.cables[0], std::vector<double>(s.cables[0].stretch.size(), pull));
                return {{measured_frequency(s, m, mode, Vec3{0, 1, 0})}};
            },
            kTo960);
    }
}

}  // namespace hawser::validate
