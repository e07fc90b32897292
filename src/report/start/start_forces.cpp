// SPDX-License-Identifier: Apache-2.0
#include "report/start/start_forces.h"

#include "base/body_dof.h"
#include "report/start/joint_rows.h"

#include <hawser/factor.h>
#include <hawser/inspect.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace hawser::report::start {

namespace {

std::size_t index_of(std::int32_t i) { return static_cast<std::size_t>(i); }

/// Diagonal value that removes the force of a row, for a line that would push.
constexpr double kSlackDiagonal = 1e30;

/// Fraction of G M⁻¹ Gᵀ that regularises redundant rigid rows.
constexpr double kRegularisation = 1e-9;

/// Solves M a + Gᵀ y = f, G a − (ε/h²) y = −g/h². y is the pull of each row after a step from rest.
class Statics {
  public:
    explicit Statics(const World& world) : world_(world), h_(world.settings().step) {
        node_of_body_.assign(index_of(world.body_count()), -1);
        for (const BodyId id : world.bodies()) {
            const int size = base::dof_of(world.body_def(id).kind);
            if (size == 0) continue;
            node_of_body_[index_of(id.index)] = static_cast<std::int32_t>(pattern_.size.size());
            bodies_.push_back(id);
            pattern_.size.push_back(static_cast<std::int8_t>(size));
            pattern_.sign.push_back(1);
        }
        for (std::int32_t i = 0; i < count(); ++i) {
            const KindInfo& kind = kind_info(world.interaction_def(id_of(i)).kind);
            pattern_.size.push_back(static_cast<std::int8_t>(kind.rows));
            pattern_.sign.push_back(-1);
            for (std::size_t b = 0; b < index_of(kind.bodies); ++b)
                if (const std::int32_t body = this->node(i, b); body >= 0)
                    pattern_.edges.push_back({static_cast<std::int32_t>(bodies_.size()) + i, body});
        }
    }

    bool solve() {
        factor_.analyse(pattern_);
        values_.assign(index_of64(factor_.value_count()), 0.0);
        rhs_.assign(index_of64(factor_.info().scalars), 0.0);
        for (std::size_t n = 0; n < bodies_.size(); ++n) write_body(n);
        std::int32_t edge = 0;
        for (std::int32_t i = 0; i < count(); ++i) edge = write_rows(i, edge);
        constexpr int kReleaseIterations = 4;  // Iterations in which lines that push are released.
        for (int round = 0; round < kReleaseIterations; ++round) {
            if (factor_.factor(values_) != Status::ok) return false;
            x_ = rhs_;
            if (factor_.solve(x_) != Status::ok) return false;
            if (!release_lines()) break;
        }
        return true;
    }

    [[nodiscard]] double push(std::int32_t i) const {
        const std::string_view units = kind_info(world_.interaction_def(id_of(i)).kind).row_units;
        const std::size_t begin = row_begin(i);
        double sum = 0.0;
        for (std::size_t r = 0; r < units.size() && units[r] == 'm'; ++r)
            sum += x_[begin + r] * x_[begin + r];
        return std::sqrt(sum);
    }

  private:
    // Return the number of interactions. The functions below refer to an interaction by its index
    // among these.
    [[nodiscard]] std::int32_t count() const {
        return static_cast<std::int32_t>(world_.interactions().size());
    }
    [[nodiscard]] InteractionId id_of(std::int32_t i) const {
        return world_.interactions()[index_of(i)];
    }
    static std::size_t index_of64(std::int64_t i) { return static_cast<std::size_t>(i); }
    [[nodiscard]] std::int32_t row_node(std::int32_t i) const {
        return static_cast<std::int32_t>(bodies_.size()) + i;
    }
    [[nodiscard]] std::size_t row_begin(std::int32_t i) const {
        return index_of64(factor_.scalar_begin(row_node(i)));
    }
    [[nodiscard]] std::int32_t node(std::int32_t i, std::size_t b) const {
        return node_of_body_[index_of(world_.interaction_def(id_of(i)).body[b].index)];
    }

    void write_body(std::size_t n) {
        const BodyDef& def = world_.body_def(bodies_[n]);
        const Pose pose = world_.pose(bodies_[n]);
        const Twist v = world_.velocity(bodies_[n]);
        const auto node = static_cast<std::int32_t>(n);
        const auto size = static_cast<std::size_t>(pattern_.size[n]);
        double* const own = &values_[index_of64(factor_.value_begin(node))];
        double* const f = &rhs_[index_of64(factor_.scalar_begin(node))];
        for (std::size_t i = 0; i < std::min<std::size_t>(size, 3); ++i)
            own[i * size + i] = def.mass;
        const Mat3 turn =
            def.kind == BodyKind::rigid ? pose.orientation.toRotationMatrix() : Mat3::Identity();
        Vec3 force =
            def.force - turn * def.linear_damping.cwiseProduct(turn.transpose() * v.linear);
        if (def.gravity) force += def.mass * world_.settings().gravity;
        for (std::size_t i = 0; i < std::min<std::size_t>(size, 3); ++i)
            f[i] = force[static_cast<int>(i)];
        if (size < 6) return;
        const Mat3 inertia = turn * def.inertia * turn.transpose();
        const Vec3 torque = def.torque - v.angular.cross(inertia * v.angular) -
                            turn * def.angular_damping.cwiseProduct(turn.transpose() * v.angular);
        for (std::size_t i = 0; i < 3; ++i) {
            f[3 + i] = torque[static_cast<int>(i)];
            for (std::size_t j = 0; j < 3; ++j)
                own[(3 + i) * 6 + 3 + j] = inertia(static_cast<int>(i), static_cast<int>(j));
        }
    }

    /// Write the diagonal of G M⁻¹ Gᵀ for the rows of interaction i. For each column the largest
    /// mass or moment of inertia is used.
    std::int32_t write_rows(std::int32_t i, std::int32_t edge) {
        const RowsView view = world_.solver().rows(id_of(i));
        const InteractionDef& def = world_.interaction_def(id_of(i));
        const auto rows = index_of(view.rows);
        double* const own = &values_[index_of64(factor_.value_begin(row_node(i)))];
        double mobile[kMaxInteractionRows] = {};
        const auto nodes = static_cast<std::int32_t>(pattern_.size.size());
        for (std::size_t b = 0; b < index_of(view.bodies); ++b) {
            const std::int32_t body = node(i, b);
            if (body < 0) continue;
            const auto size = static_cast<std::size_t>(pattern_.size[index_of(body)]);
            double* const block = &values_[index_of64(factor_.value_begin(nodes + edge++))];
            const double* const inertia = &values_[index_of64(factor_.value_begin(body))];
            for (std::size_t r = 0; r < rows; ++r)
                for (std::size_t c = 0; c < size; ++c) {
                    const double j = view.jacobian[b][r][c];
                    block[r * size + c] = j;
                    mobile[r] += j * j / inertia[c * size + c];
                }
        }
        const bool elastic = kind_info(def.kind).is(kElastic);
        const bool idle = kind_info(def.kind).is(kRangeKind);
        for (std::size_t r = 0; r < rows; ++r) {
            const double soft =
                view.velocity[r] ? view.compliance[r] / h_ : view.compliance[r] / (h_ * h_);
            double s = std::max(soft, kRegularisation * mobile[r]);
            if (idle || !(mobile[r] > 0.0)) s = kSlackDiagonal;
            own[r * rows + r] = -s;
            if (elastic) rhs_[row_begin(i) + r] = -view.violation[r] / (h_ * h_);
        }
        if (is_one_sided(def) && view.violation[0] < -1e-6 * def.get("length")) release(i);
        return edge;
    }

    static bool is_one_sided(const InteractionDef& def) {
        return kind_info(def.kind).is(kWireElement) && def.get("tension_only") != 0.0;
    }

    void release(std::int32_t i) {
        values_[index_of64(factor_.value_begin(row_node(i)))] = -kSlackDiagonal;
        rhs_[row_begin(i)] = 0.0;
    }

    bool release_lines() {
        bool any = false;
        for (std::int32_t i = 0; i < count(); ++i) {
            // The pull y is −λ: a line in tension has y > 0.
            if (!is_one_sided(world_.interaction_def(id_of(i))) || x_[row_begin(i)] >= 0.0)
                continue;
            release(i);
            any = true;
        }
        return any;
    }

    const World& world_;
    double h_;
    std::vector<std::int32_t> node_of_body_;
    std::vector<BodyId> bodies_;
    BlockPattern pattern_;
    BlockFactor factor_;
    std::vector<double> values_, rhs_, x_;
};

}  // namespace

StartForces::StartForces(const World& world) {
    push_.assign(index_of(world.interaction_count()), 0.0);
    is_known_ = world.interactions().empty();
    if (is_known_) return;
    Statics statics(world);
    is_known_ = statics.solve();
    std::int32_t number = 0;
    for (const InteractionId id : world.interactions())
        if (is_known_) push_[index_of(id.index)] = statics.push(number++);
}

double StartForces::push(InteractionId id) const { return push_[index_of(id.index)]; }

}  // namespace hawser::report::start
