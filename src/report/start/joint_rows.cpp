// SPDX-License-Identifier: Apache-2.0
#include "report/start/joint_rows.h"

#include <hawser/row_constants.h>

#include "base/body_dof.h"
#include "base/dense.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hawser::report::start {

namespace {

/// Compliance below this fraction of a row's mobility over a step has no effect.
constexpr double kMinComplianceRatio = 1e-4;

std::size_t index(std::int32_t i) { return static_cast<std::size_t>(i); }

/// True if a range has a width. A range without width is a joint.
bool is_open_range(const InteractionDef& def) {
    return kind_info(def.kind).is(kRangeKind) && def.get("max") - def.get("min") > 1e-9;
}

/// Return G M⁻¹ Gᵀ of one row, with the masses of the bodies [1/kg or 1/(kg m²)].
double mobility(const World& world, const InteractionDef& def, const RowsView& view,
                std::size_t row) {
    double sum = 0.0;
    for (std::size_t b = 0; b < index(view.bodies); ++b) {
        const BodyDef& body = world.body_def(def.body[b]);
        const auto& jac = view.jacobian[b][row];
        const Vec3 push(jac[0], jac[1], jac[2]), turn(jac[3], jac[4], jac[5]);
        if (body.kind == BodyKind::rigid) {
            const Vec3 local = world.pose(def.body[b]).orientation.conjugate() * turn;
            sum +=
                push.squaredNorm() / body.mass + local.dot(base::solve_ldlt(body.inertia, local));
        } else if (body.kind == BodyKind::lump) {
            sum += push.squaredNorm() / body.mass;
        } else if (body.kind == BodyKind::scalar) {
            sum += jac[0] * jac[0] / body.mass;
        }
    }
    return sum;
}

double row_arm(const InteractionDef& def, const RowsView& view) {
    double arm = 0.0;
    for (std::size_t b = 0; b < index(view.bodies); ++b) arm = std::max(arm, def.point[b].norm());
    return arm;
}

}  // namespace

JointRows::JointRows(const World& world) {
    const double h = world.settings().step;
    for (const InteractionId id : world.interactions()) {
        const InteractionDef& def = world.interaction_def(id);
        if (kind_info(def.kind).is(kElastic) || kind_info(def.kind).is(kFrictionKind) ||
            is_open_range(def))
            continue;
        const RowsView view = world.solver().rows(id);
        Joint joint{.id = id, .row_begin = static_cast<std::int32_t>(rows_)};
        for (std::size_t r = 0; r < index(view.rows); ++r) {
            const double felt = kMinComplianceRatio * mobility(world, def, view, r);
            const double soft = view.velocity[r] ? velocity_row_sigma(view.compliance[r], h)
                                                 : row_sigma(view.compliance[r], 1.0, h);
            if (!(felt > 0.0) || soft > felt) continue;
            joint.row[index(joint.rows++)] = static_cast<std::int8_t>(r);
            joint.motor |= view.velocity[r];
        }
        if (joint.rows == 0) continue;
        joint.size = row_arm(def, view);
        rows_ += index(joint.rows);
        joints_.push_back(joint);
    }
    find_bodies(world);
    build_pattern();
}

void JointRows::find_bodies(const World& world) {
    node_of_body_.assign(index(world.body_count()), -1);
    for (const Joint& joint : joints_) {
        const InteractionDef& def = world.interaction_def(joint.id);
        for (std::size_t b = 0; b < index(kind_info(def.kind).bodies); ++b) {
            std::int32_t& node = node_of_body_[index(def.body[b].index)];
            if (base::dof_of(world.body_def(def.body[b]).kind) == 0) continue;
            if (node < 0) {
                node = static_cast<std::int32_t>(bodies_.size());
                bodies_.push_back(def.body[b]);
                length_.push_back(0.0);
            }
            double& length = length_[index(node)];
            length = std::max(length, def.point[b].norm());
        }
    }
    for (std::size_t n = 0; n < bodies_.size(); ++n) {
        pattern_.size.push_back(
            static_cast<std::int8_t>(base::dof_of(world.body_def(bodies_[n]).kind)));
        pattern_.sign.push_back(1);
        if (!(length_[n] > 1e-6))
            length_[n] = 1.0;  // The joint is at the body's centre: any length will do.
    }
    edge_of_slot_.assign(kMaxInteractionBodies * joints_.size(), -1);
    for (std::size_t j = 0; j < joints_.size(); ++j) {
        const InteractionDef& def = world.interaction_def(joints_[j].id);
        pattern_.size.push_back(static_cast<std::int8_t>(joints_[j].rows));
        pattern_.sign.push_back(-1);
        for (std::size_t b = 0; b < index(kind_info(def.kind).bodies); ++b) {
            const std::int32_t node = node_of_body_[index(def.body[b].index)];
            if (node < 0) continue;
            edge_of_slot_[kMaxInteractionBodies * j + b] =
                static_cast<std::int32_t>(pattern_.edges.size());
            pattern_.edges.push_back({static_cast<std::int32_t>(bodies_.size() + j), node});
        }
    }
}

void JointRows::build_pattern() {
    if (rows_ == 0) return;
    factor_.analyse(pattern_);
    values_.assign(static_cast<std::size_t>(factor_.value_count()), 0.0);
    scale_.assign(rows_, 0.0);
    violations_.assign(rows_, 0.0);
    speeds_.assign(rows_, 0.0);
    rates_.assign(rows_, 0.0);
}

void JointRows::write_row(const World& world, const Joint& joint) {
    const auto j = static_cast<std::size_t>(&joint - joints_.data());
    const InteractionDef& def = world.interaction_def(joint.id);
    const RowsView view = world.solver().rows(joint.id);
    const auto nodes = static_cast<std::int32_t>(pattern_.size.size());
    double* const own = &values_[static_cast<std::size_t>(
        factor_.value_begin(static_cast<std::int32_t>(bodies_.size() + j)))];
    for (std::size_t k = 0; k < index(joint.rows); ++k) {
        const auto r = static_cast<std::size_t>(joint.row[k]);
        const std::size_t row = index(joint.row_begin) + k;
        violations_[row] = view.violation[r];
        rates_[row] = view.rate[r];
        speeds_[row] = view.velocity[r] ? view.speed[r] : 0.0;
        double mobile = 0.0;
        for (std::size_t b = 0; b < index(view.bodies); ++b) {
            const auto& jac = view.jacobian[b][r];
            const std::int32_t edge = edge_of_slot_[kMaxInteractionBodies * j + b];
            if (edge < 0) {  // Other bodies cannot change a prescribed velocity: subtract its rate.
                const Twist v = world.velocity(def.body[b]);
                for (std::size_t i = 0; i < 3; ++i)
                    speeds_[row] -= jac[i] * v.linear[static_cast<int>(i)] +
                                    jac[3 + i] * v.angular[static_cast<int>(i)];
                continue;
            }
            const std::int32_t node = pattern_.edges[index(edge)].column;
            const auto size = static_cast<std::size_t>(pattern_.size[index(node)]);
            double* const block =
                &values_[static_cast<std::size_t>(factor_.value_begin(nodes + edge))];
            const double l2 = length_[index(node)] * length_[index(node)];
            for (std::size_t i = 0; i < size; ++i) {
                block[k * size + i] = jac[i];
                mobile += jac[i] * jac[i] / (i < 3 ? 1.0 : l2);
            }
        }
        mobile = std::max(mobile, 1e-300);
        scale_[row] = std::sqrt(mobile);
        for (std::size_t i = 0; i < index(joint.rows); ++i)
            own[k * index(joint.rows) + i] = i == k ? -small_ * mobile : 0.0;
    }
}

bool JointRows::update(const World& world) {
    for (std::size_t n = 0; n < bodies_.size(); ++n) {
        const auto size = static_cast<std::size_t>(pattern_.size[n]);
        double* const own =
            &values_[static_cast<std::size_t>(factor_.value_begin(static_cast<std::int32_t>(n)))];
        std::fill(own, own + size * size, 0.0);
        for (std::size_t i = 0; i < size; ++i)
            own[i * size + i] = i < 3 ? 1.0 : length_[n] * length_[n];
    }
    for (const Joint& joint : joints_) write_row(world, joint);
    if (first_scale_.empty()) first_scale_ = scale_;
    return factor_.factor(values_) == Status::ok;
}

std::vector<double> JointRows::solve(std::span<const double> b) {
    std::vector<double> rhs(static_cast<std::size_t>(factor_.info().scalars), 0.0);
    for (std::size_t j = 0; j < joints_.size(); ++j) {
        const auto begin = static_cast<std::size_t>(
            factor_.scalar_begin(static_cast<std::int32_t>(bodies_.size() + j)));
        for (std::size_t k = 0; k < index(joints_[j].rows); ++k)
            rhs[begin + k] = b[index(joints_[j].row_begin) + k];
    }
    std::vector<double> x = rhs;
    if (factor_.solve(x) == Status::ok) (void)factor_.refine(values_, rhs, x);
    return x;
}

std::vector<double> JointRows::out_of_reach(std::span<const double> b) {
    const std::vector<double> x = solve(b);
    std::vector<double> rest(rows_);
    for (std::size_t j = 0; j < joints_.size(); ++j) {
        const auto begin = static_cast<std::size_t>(
            factor_.scalar_begin(static_cast<std::int32_t>(bodies_.size() + j)));
        for (std::size_t k = 0; k < index(joints_[j].rows); ++k) {
            const std::size_t row = index(joints_[j].row_begin) + k;
            rest[row] = -small_ * scale_[row] * scale_[row] * x[begin + k];
        }
    }
    return rest;
}

Eigen::MatrixXd JointRows::repetition_kernel(std::span<const std::int32_t> rows) const {
    // Columns of G D^-1/2, by the index of each body among the bodies of these rows.
    std::vector<std::int32_t> column(bodies_.size(), -1);
    std::int32_t columns = 0;
    const auto nodes = static_cast<std::int32_t>(pattern_.size.size());
    const auto each = [&](auto&& use) {
        std::size_t j = 0;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            while (rows[i] >= joints_[j].row_begin + joints_[j].rows) ++j;
            for (std::size_t b = 0; b < kMaxInteractionBodies; ++b)
                if (const std::int32_t e = edge_of_slot_[kMaxInteractionBodies * j + b]; e >= 0)
                    use(i, rows[i] - joints_[j].row_begin, e, pattern_.edges[index(e)].column);
        }
    };
    each([&](std::size_t, std::int32_t, std::int32_t, std::int32_t node) {
        if (column[index(node)] >= 0) return;
        column[index(node)] = columns;
        columns += pattern_.size[index(node)];
    });
    Eigen::MatrixXd g = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(rows.size()), columns);
    each([&](std::size_t i, std::int32_t k, std::int32_t e, std::int32_t node) {
        const int size = pattern_.size[index(node)];
        const double* block =
            &values_[static_cast<std::size_t>(factor_.value_begin(nodes + e) + k * size)];
        for (int c = 0; c < size; ++c)
            g(static_cast<Eigen::Index>(i), column[index(node)] + c) =
                block[c] / (c < 3 ? 1.0 : length_[index(node)]) / scale_[index(rows[i])];
    });
    const Eigen::MatrixXd gram = g * g.transpose();
    const auto eigen = base::symmetric_eigen(gram);
    constexpr double kEqualEigenvalue =
        1e-10;  // Limit of the squares of singular values: rows equal to 1e-5 count as equal.
    Eigen::Index count = 0;
    while (count < eigen.values.size() && eigen.values[count] < kEqualEigenvalue) ++count;
    return eigen.vectors.leftCols(count);
}

}  // namespace hawser::report::start
