// SPDX-License-Identifier: Apache-2.0
#include "paper_matrix/structures.h"

#include "paper_matrix/dice.h"

#include <hawser/math.h>

#include <Eigen/Dense>

#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace hawser::bench {
namespace {

using Vec3 = Eigen::Vector3d;

// Kinematic rows at 60 Hz: 4 ε Υ / h² with ε = 1e-12 m/N, Υ = 1/9. Strings: l / EA = 1e-6 m/N.
constexpr double kRigid = 1.6e-9, kString = 1.6e-3;
constexpr double kHalf = 0.5;  ///< half the length of a link [m]

/// Add a rigid body of the given mass and semi-axes, rotated so that its first axis is `u`.
int add_rigid(SystemBuilder& builder, double mass, const Vec3& size, const Vec3& u) {
    const Vec3 s = size.cwiseAbs2();
    const Eigen::Matrix3d turn = turn_between(Vec3::UnitX(), u).toRotationMatrix();
    const Eigen::Matrix3d moment =
        turn * (mass / 5.0 * Vec3(s.y() + s.z(), s.x() + s.z(), s.x() + s.y())).asDiagonal() *
        turn.transpose();
    std::array<double, 36> block{};
    for (std::size_t i = 0; i < 3; ++i) {
        block[7 * i] = mass;
        for (std::size_t j = 0; j < 3; ++j)
            block[6 * (i + 3) + j + 3] = 0.5 * (moment(static_cast<int>(i), static_cast<int>(j)) +
                                                moment(static_cast<int>(j), static_cast<int>(i)));
    }
    return builder.add_body(6, block);
}

/// A side of a ball joint: body −1 is the ground; arms from the centres.
struct Side {
    int body;
    Vec3 arm;
};
void add_ball(SystemBuilder& builder, const Side& a, const Side& b) {
    const std::array<double, 3> sigma{kRigid, kRigid, kRigid};
    const int node = builder.add_rows(sigma);
    double factor = 1.0;
    for (const Side& side : {a, b}) {
        if (side.body >= 0) {
            std::array<double, 18> rows{};
            double* row = rows.data();
            for (int i = 0; i < 3; ++i, row += 6) {
                const Vec3 direction = factor * Vec3::Unit(i), turn = side.arm.cross(direction);
                for (int k = 0; k < 3; ++k) {
                    row[k] = direction[k];
                    row[3 + k] = turn[k];
                }
            }
            builder.add_block(node, side.body, rows);
        }
        factor = -1.0;
    }
}

/// Add a chain that starts at `start` and ends at `stop`, if that is a body. Joints are added with
/// it, so that bodies are numbered along it. The direction of each link varies slightly. @return
/// the last link.
int add_chain(SystemBuilder& builder, Dice& dice, const Side& start, int links) {
    Side last = start;
    for (int i = 0; i < links; ++i) {
        const Vec3 u = Vec3(dice.uniform(-0.2, 0.2), dice.uniform(-0.2, 0.2), -1.0).normalized();
        const int body = add_rigid(builder, 10.0, {kHalf, 0.05, 0.05}, u);
        add_ball(builder, last, {body, -kHalf * u});
        last = {body, kHalf * u};
    }
    return last.body;
}

}  // namespace

BlockSystem chain(int links) {
    SystemBuilder builder;
    Dice dice(11);
    add_chain(builder, dice, {-1, {}}, links);
    return builder.finish("chain", 11);
}

BlockSystem tree_of_chains(int levels, int links) {
    SystemBuilder builder;
    Dice dice(12);
    std::vector<int> tip{add_chain(builder, dice, {-1, {}}, links)};
    const int chains = (1 << levels) - 1;
    for (int c = 1; c < chains; ++c) {
        const int parent = tip[static_cast<std::size_t>((c - 1) / 2)];
        tip.push_back(add_chain(builder, dice, {parent, {0.0, 0.0, -kHalf}}, links));
    }
    return builder.finish("tree of chains", 12);
}

BlockSystem net(int side) {
    SystemBuilder builder;
    Dice dice(13);
    for (int i = 0; i < side * side; ++i) {
        std::array<double, 9> block{};
        for (std::size_t k = 0; k < 3; ++k) block[4 * k] = dice.uniform(0.1, 0.2);
        builder.add_body(3, block);
    }
    auto tie = [&](int a, int b, Vec3 u) {
        u += Vec3(dice.uniform(-0.1, 0.1), dice.uniform(-0.1, 0.1), dice.uniform(-0.3, 0.3));
        u.normalize();
        const std::array<double, 1> sigma{kString};
        const int node = builder.add_rows(sigma);
        const std::array<double, 3> g{u.x(), u.y(), u.z()}, minus{-u.x(), -u.y(), -u.z()};
        builder.add_block(node, a, g);
        builder.add_block(node, b, minus);
    };
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j) {
            if (j + 1 < side) tie(i * side + j, i * side + j + 1, Vec3::UnitX());
            if (i + 1 < side) tie(i * side + j, (i + 1) * side + j, Vec3::UnitY());
        }
    return builder.finish("net", 13);
}

BlockSystem solid(int side) {
    using Mat3 = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
    struct Bar {
        int a, b;
        Mat3 stiffness;
    };
    Dice dice(15);
    std::vector<Bar> bars;
    std::vector<Mat3> diagonal;
    for (int i = 0; i < side * side * side; ++i)
        diagonal.emplace_back(dice.uniform(0.1, 0.2) * Mat3::Identity());
    const Eigen::Vector3i steps[] = {{0, 0, 1}, {0, 1, 0}, {1, 0, 0},
                                     {0, 1, 1}, {1, 0, 1}, {1, 1, 0}};
    auto knot = [&](const Eigen::Vector3i& at) { return (at.x() * side + at.y()) * side + at.z(); };
    auto join = [&](const Eigen::Vector3i& from, const Eigen::Vector3i& step) {
        const Eigen::Vector3i to = from + step;
        if (to.maxCoeff() >= side) return;
        const Vec3 u = step.cast<double>().normalized();
        const Mat3 k = dice.uniform(0.5, 1.0) * (u * u.transpose() + 0.1 * Mat3::Identity());
        bars.push_back({knot(from), knot(to), k});
        diagonal[static_cast<std::size_t>(knot(from))] += k;
        diagonal[static_cast<std::size_t>(knot(to))] += k;
    };
    for (int x = 0; x < side; ++x)
        for (int y = 0; y < side; ++y)
            for (int z = 0; z < side; ++z)
                for (const Eigen::Vector3i& step : steps) join({x, y, z}, step);
    SystemBuilder builder;
    for (const Mat3& block : diagonal) builder.add_body(3, {block.data(), 9});
    for (const Bar& bar : bars) {
        const Mat3 minus = -bar.stiffness;
        builder.add_block(bar.b, bar.a, {minus.data(), 9});
    }
    return builder.finish("solid", 15);
}

BlockSystem moored_floats(int links, int chains, int floats) {
    if (floats < 1 || chains < floats || links < chains)
        throw std::invalid_argument("moored_floats: too few chains or links");
    SystemBuilder builder;
    Dice dice(14);
    std::vector<int> hub;
    for (int f = 0; f < floats; ++f)
        hub.push_back(add_rigid(builder, 1e7, {40.0, 20.0, 5.0}, Vec3::UnitX()));
    for (int c = 0; c < chains; ++c) {
        const int count = links / chains + (c < links % chains ? 1 : 0);
        const auto from = static_cast<std::size_t>(c % floats);
        const Vec3 arm(dice.uniform(-40, 40), dice.uniform(-20, 20), -5.0);
        const int last = add_chain(builder, dice, {hub[from], arm}, count);
        const bool bridge = c + 1 < floats;
        const Side stop = bridge ? Side{hub[from + 1], -arm} : Side{-1, {}};
        add_ball(builder, {last, {0.0, 0.0, -kHalf}}, stop);
    }
    return builder.finish("moored floats", 14);
}

}  // namespace hawser::bench
