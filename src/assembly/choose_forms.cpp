// SPDX-License-Identifier: Apache-2.0
/// Values that an analysis derives from the present poses: Jacobians, and from them fractions of
/// damping, forms and floors of rows.
#include "assembly/mobility.h"
#include "assembly/system.h"
#include "base/index.h"
#include "model/arms.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace hawser::assembly {

double mobility(const model::Bodies& bodies, const model::Interactions& in, int id, int row) {
    int width = 0;
    for (int b = 0; b < in.bodies[at(id)]; ++b)
        width += bodies.dof(in.body[at(kMaxInteractionBodies * id + b)]);
    double buffer[model::kArmBufferSize];
    const double* jac =
        model::packed_rows(&in.jacobian[at(in.jac_begin[at(id)])], in.arms[at(id)] != 0, buffer) +
        static_cast<std::ptrdiff_t>(row) * width;
    double sum = 0.0;
    for (int b = 0; b < in.bodies[at(id)]; ++b) {
        const std::int32_t body = in.body[at(kMaxInteractionBodies * id + b)];
        const int dof = bodies.dof(body);
        const bool drum = b == 2 && kind_info(in.kinds[at(id)]).is(kWoundUp);
        for (int j = 0; j < dof && j < 3; ++j) {
            const double arm = drum ? in.defined_radius[at(id)] : jac[j];
            sum += arm * arm / bodies.mass[at(body)];
        }
        if (dof == 6) {
            using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
            const Eigen::Map<const RowMajor> r(&bodies.r[at(9 * body)]);
            const Eigen::Map<const RowMajor> inertia(&bodies.inertia[at(9 * body)]);
            const Vec3 local = r.transpose() * Vec3(jac[3], jac[4], jac[5]);
            sum += local.dot(inertia.inverse() * local);
        }
        jac += dof;
    }
    return sum;
}

/// Compute the Jacobians at the present poses, by which the forms of rows are chosen.
void System::evaluate(const model::Bodies& bodies, model::Interactions& interactions,
                      const WorldDef& def) {
    const View v = view(const_cast<model::Bodies&>(bodies), interactions, def);
    for (int s = 0; s < strips.count(); ++s)
        for (const PoolRange& r : strips.pools(s)) {
            const model::Pool& pool = interactions.pool[static_cast<std::size_t>(r.kind)];
            kernels().evaluate(v, r.kind, pool.ids.data(), pool.data.data(), r.begin, r.end);
        }
}

void System::split_damping(const model::Bodies& bodies, model::Interactions& in, double h) const {
    for (int i = 0; i < in.count(); ++i) {
        if (rests(i)) continue;
        // It also decides whether a step completes a compliant joint (model::may_complete()).
        const bool joint = model::may_ever_complete(in, i);
        for (int r = 0; r < in.rows[at(i)]; ++r) {
            const auto row = at(in.row_begin[at(i)] + r);
            if (!(in.row_flags[row] & model::kRowDamper) && !(joint && in.epsilon[row] > 0.0))
                continue;
            in.mobility[row] = mobility(bodies, in, i, r);
            in.split_damping(row, in.rest_length[at(i)] > 0.0, h);
        }
    }
    // Use the mobility of a cut row for all of its bodies.
    for (const Sides& s : sides)
        for (int r = 0; r < in.rows[at(s.first)]; ++r) {
            double whole = 0.0;
            for (std::int32_t id = s.first; id < s.first + s.count; ++id)
                whole += in.mobility[at(in.row_begin[at(id)] + r)];
            for (std::int32_t id = s.first; id < s.first + s.count && whole > 0.0; ++id) {
                const auto row = at(in.row_begin[at(id)] + r);
                in.mobility[row] = whole;
                in.split_damping(row, in.rest_length[at(id)] > 0.0, h);
            }
        }
}

void System::choose_forms(const model::Bodies& bodies, model::Interactions& in,
                          const WorldDef& def) {
    kept_.assign(at(in.count()), 0);
    bounded_mobility.clear();
    // split_damping() computes the mobility of dampers; for sides of cuts it is the total one.
    auto knows = [&](std::size_t row) {
        return (in.row_flags[row] & model::kRowDamper) != 0 && sides.empty();
    };
    for (const std::int32_t id : bounded) {
        const auto row = at(in.row_begin[at(id)]);
        bounded_mobility.push_back(knows(row) ? in.mobility[row] : mobility(bodies, in, id, 0));
    }
    const double h = def.step;
    for (int i = 0; i < in.count(); ++i) {
        if (rests(i)) continue;
        // A line that runs through a guide with nearly no mass is far stiffer than all other rows
        // there.
        bool keep = def.form == Form::saddle || kind_info(in.kinds[at(i)]).is(kRouted);
        for (int r = 0; r < in.rows[at(i)]; ++r) {
            const auto row = at(in.row_begin[at(i)] + r);
            const double w = knows(row) ? in.mobility[row] : mobility(bodies, in, i, r);
            // A rigid row may be redundant (closed loops). A floor keeps the signs of the pivots.
            const double needed =
                in.epsilon[row] == 0.0 ? kRigidFraction * w : in.sigma_without_floor(row, h);
            const double sigma = std::max({needed, in.min_sigma[row], model::kTinySigma});
            in.sigma[row] = sigma;
            // Use the compliance as defined: a restored world with other line lengths must choose
            // the same form as the saved one.
            const double defined = in.defined[row], epsilon = in.epsilon[row];
            double ratio = 1.0;  // default without a division
            if (epsilon > 0.0 && defined != epsilon) ratio = defined / epsilon;
            // Also consider the damping without recoil.
            if (in.row_flags[row] & model::kRowRecoils)
                ratio /= in.recoil_fraction(row, in.rest_length[at(i)] > 0.0, h);
            static_assert(kRigidFraction * kSafeRatio > 1.0);
            if (def.form == Form::automatic && w > kSafeRatio * ratio * sigma) keep = true;
        }
        kept_[at(i)] = keep ? 1 : 0;
        if (in.arms[at(i)] && !keep) in.arms[at(i)] = model::kCompactCondensed;
        for (int r = 0; r < in.rows[at(i)]; ++r) {
            const auto row = at(in.row_begin[at(i)] + r);
            in.inv_sigma[row] = keep ? 0.0 : 1.0 / in.sigma[row];
        }
    }
}

}  // namespace hawser::assembly
