// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file dense.h
/// Dense equations of a step, written from the definitions as a reference for the assembly: [M̃ Gᵀ;
/// G −Σ][v₊; −λ] = [a; c].
#define HAWSER_KIND_SETUP
#include "model/kinds/all.h"
#include "support/dense_reference.h"
#include "support/recipe.h"

#include <Eigen/Dense>
#include <algorithm>

#include <cmath>

namespace hawser::test {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

struct DenseStep {
    Matrix mass;       ///< M + h θ D.
    Matrix geometric;  ///< (h²/4) K_g; for lines (a + d) h² K_g (assembly/geo.h).
    Matrix late;       ///< (h²/4) K_g on the velocities before the step. Lines: a h² K_g.
    Matrix ahead;      ///< d h² K_g of lines, on the velocities expected after the step.
    Matrix damping;    ///< (1 + u) h C.
    Matrix before;     ///< (1 − u) h C, on the velocities before the step.
    double fastest;    ///< Largest u.
    Matrix g;          ///< G, all rows of all interactions.
    Vector sigma, c;
    Vector a;  ///< Without the rotation of rigid bodies: the stepper computes the gyroscopic term.
    Vector couple_fixed;  ///< Geometric stiffness times prescribed velocities.
    [[nodiscard]] Matrix tilde() const { return mass + geometric + damping; }
};

inline Mat3 skew(const Vec3& r) {
    Mat3 m;
    m << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
    return m;
}

/// Return the largest positive semi-definite part of a symmetric matrix.
inline Mat3 projected(const Mat3& k) {
    const Spectrum s = spectrum(k);
    Mat3 sum = Mat3::Zero();
    for (int i = 0; i < 3; ++i) {
        const Vec3 axis = s.vectors.col(i);
        sum += std::max(s.values[i], 0.0) * axis * axis.transpose();
    }
    return sum;
}

/// Data from which the terms of one interaction are written.
struct SlotState {
    int dof[kMaxInteractionBodies], at[kMaxInteractionBodies];
    Vec3 arm[kMaxInteractionBodies], lin[kMaxInteractionBodies], ang[kMaxInteractionBodies];
    double g[kMaxInteractionRows], j[kMaxInteractionBodies][kMaxInteractionRows][6];
    generic::Geometry geometry;
    double length;
};

inline SlotState slot_state(const context::StepContext& ctx, int id) {
    const model::Bodies& b = ctx.model.bodies;
    const InteractionDef& def = ctx.model.interactions.def[static_cast<std::size_t>(id)];
    SlotState s{};
    generic::with_kind(def.kind, [&]<class K>() {
        const typename K::Data data = K::make(def);
        generic::BodyRef refs[K::kBodies];
        for (int k = 0; k < K::kBodies; ++k) {
            const auto i = static_cast<std::size_t>(def.body[static_cast<std::size_t>(k)].index);
            const int dof = b.dof(static_cast<int>(i));
            refs[k] = {generic::load3(&b.x[3 * i]), &b.r[9 * i], dof == 6 || dof == 0};
            s.dof[k] = dof;
            s.at[k] = b.dof_begin[i];
            const Vec3 p = def.point[static_cast<std::size_t>(k)];
            const generic::V3 arm = refs[k].arm(p.data());
            s.arm[k] = {arm.x, arm.y, arm.z};
            const double* v =
                dof == 0 ? &b.v_fixed[6 * i] : &b.v[static_cast<std::size_t>(s.at[k])];
            s.lin[k] = dof == 1 ? Vec3::Zero() : Vec3(v[0], v[1], v[2]);
            s.ang[k] = dof == 6 || dof == 0 ? Vec3(v[3], v[4], v[5]) : Vec3::Zero();
        }
        generic::Rows<K::kBodies, K::kRows> rows;
        K::evaluate(data, refs, rows);
        for (int r = 0; r < K::kRows; ++r) {
            s.g[r] = rows.g[r];
            for (int k = 0; k < K::kBodies; ++k)
                for (int i = 0; i < 6; ++i) s.j[k][r][i] = rows.J[k][r][i];
        }
        s.geometry = K::kGeometry;
        const generic::V3 u = refs[K::kBodies > 1 ? 1 : 0].x - refs[0].x;
        s.length = (Vec3(u.x, u.y, u.z) + s.arm[1] - s.arm[0]).norm();
    });
    return s;
}

/// Add K, a 12 × 12 matrix on the twists of slots 0 and 1, to the packed system.
inline void scatter(const SlotState& s, const Matrix& k, Matrix& into, Vector& fixed) {
    for (int p = 0; p < 2; ++p)
        for (int q = 0; q < 2; ++q) {
            const int np = s.dof[p], nq = s.dof[q];
            if (np == 0) continue;
            if (nq > 0) {
                into.block(s.at[p], s.at[q], np, nq) += k.block(6 * p, 6 * q, np, nq);
            } else {
                Vector u(6);
                u << s.lin[q], s.ang[q];
                fixed.segment(s.at[p], np) += k.block(6 * p, 6 * q, np, 6) * u;
            }
        }
}

/// Return |r|/I of a body at the arm r [world frame], with I the mean of its moments across r.
inline double vibration_of(const context::StepContext& ctx, std::size_t body, const Vec3& arm) {
    const Quat q(ctx.model.bodies.q[4 * body], ctx.model.bodies.q[4 * body + 1],
                 ctx.model.bodies.q[4 * body + 2], ctx.model.bodies.q[4 * body + 3]);
    const Eigen::Map<const Mat3> inertia(&ctx.model.bodies.inertia[9 * body]);
    const Mat3 world = q.toRotationMatrix() * inertia * q.toRotationMatrix().transpose();
    const Vec3 n = arm.normalized(), p = n.unitOrthogonal(), t = n.cross(p);
    return arm.norm() / (0.5 * (p.dot(world * p) + t.dot(world * t)));
}
/// Return the larger vibration_of() of both bodies.
inline double vibration_rate(const context::StepContext& ctx, int id, const SlotState& s) {
    double most = 0.0;
    for (std::size_t b = 0; b < 2; ++b) {
        const auto body = static_cast<std::size_t>(
            ctx.model.interactions.def[static_cast<std::size_t>(id)].body[b].index);
        if (s.arm[b].norm() > 0.0) most = std::max(most, vibration_of(ctx, body, s.arm[b]));
    }
    return most;
}

inline void add_geometry(const context::StepContext& ctx, int id, const SlotState& s,
                         DenseStep& out) {
    if (s.geometry == generic::Geometry::none) return;
    const double h = ctx.model.def.step, quarter = 0.25 * h * h * ctx.model.def.geometric_stiffness;
    const auto row =
        static_cast<std::size_t>(ctx.model.interactions.row_begin[static_cast<std::size_t>(id)]);
    const double* lambda = &ctx.model.interactions.lambda[row];
    Matrix k = Matrix::Zero(12, 12), c = Matrix::Zero(12, 12), line = k;
    double late_fraction = 0.25, ahead_fraction = 0.0, resolved = 1.0;
    Vec3 f1;
    double u = 0.0;  // docs/theory/stiffness.md
    if (s.geometry == generic::Geometry::line) {
        const double tension = -lambda[0] / h;
        if (tension <= 0.0) return;
        const Vec3 along(s.j[1][0][0], s.j[1][0][1], s.j[1][0][2]);
        Matrix rel(3, 12);  // velocity of point 0 minus that of point 1
        rel << Mat3::Identity(), -skew(s.arm[0]), -Mat3::Identity(), skew(s.arm[1]);
        line = rel.transpose() *
               (tension / s.length * (Mat3::Identity() - along * along.transpose())) * rel;
        const bool rigid = s.dof[0] == 6 && s.dof[1] == 6;
        double lighter = 0.0;  // 1/m of the lighter end, arms at their longest
        for (std::size_t b = 0; b < 2; ++b) {
            const auto body = static_cast<std::size_t>(
                ctx.model.interactions.def[static_cast<std::size_t>(id)].body[b].index);
            if (s.dof[b] < 3) continue;
            double end = 1.0 / ctx.model.bodies.mass[body];
            if (rigid && s.arm[b].norm() > 0.0)
                end += s.arm[b].norm() * vibration_of(ctx, body, s.arm[b]);
            else if (s.dof[b] == 6)
                end += s.arm[b].squaredNorm() *
                       Mat3(Eigen::Map<const Mat3>(&ctx.model.bodies.inertia[9 * body]).inverse())
                           .trace();
            lighter = std::max(lighter, end);
        }
        const double vibration = 4.0 * quarter * tension / s.length * lighter;
        const double p = vibration > 0.25 && !rigid ? (vibration - 0.25) / (vibration + 0.25) : 0.0;
        late_fraction = 0.25 + 0.25 * p;
        ahead_fraction = -0.1 * p;
        // Skip a resolved line without point masses: it needs no correction.
        const bool lumps = s.dof[0] == 3 || s.dof[1] == 3 || s.dof[0] == 1 || s.dof[1] == 1;
        if (!lumps && vibration < 0.25) resolved = 16.0 * vibration * vibration;
        line *= resolved;
        f1 = -tension * along;
    } else {
        f1 = Vec3(lambda[0], lambda[1], lambda[2]) / h;
        if (s.dof[0] == 6 && s.dof[1] == 6) {
            const double vibration = h * h * f1.norm() * vibration_rate(ctx, id, s);
            if (vibration > 4.0) u = (vibration - 4.0) / (vibration + 4.0);
            out.fastest = std::max(out.fastest, u);
            const double cc = ctx.model.def.rotation_damping * h * f1.norm() *
                              std::min(s.arm[0].norm(), s.arm[1].norm()) *
                              std::min(1.0, 16.0 * vibration * vibration) * (1.0 + 9.0 * u);
            c.block(3, 3, 3, 3) = c.block(9, 9, 3, 3) = cc * Mat3::Identity();
            c.block(3, 9, 3, 3) = c.block(9, 3, 3, 3) = -cc * Mat3::Identity();
        }
    }
    for (int b = 0; b < 2; ++b) {
        if (s.dof[b] != 6) continue;
        const Vec3 f = b == 0 ? Vec3(-f1) : f1, r = s.arm[b];
        k.block(6 * b + 3, 6 * b + 3, 3, 3) +=
            resolved * (1.0 + 0.5 * u) * projected(f.dot(r) * Mat3::Identity() - r * f.transpose());
    }
    const double share = late_fraction + ahead_fraction;
    scatter(s, quarter * k + 4.0 * quarter * share * line, out.geometric, out.couple_fixed);
    Vector none = Vector::Zero(out.couple_fixed.size());
    scatter(s, quarter * k + 4.0 * quarter * late_fraction * line, out.late, none);
    scatter(s, 4.0 * quarter * ahead_fraction * line, out.ahead, none);
    // Joints damp between two rigid bodies only, so nothing couples to a prescribed velocity.
    scatter(s, (1.0 + u) * h * c, out.damping, out.couple_fixed);
    scatter(s, (1.0 - u) * h * c, out.before, out.couple_fixed);
}

/// Compute θ of a damper, docs/theory/step.md.
inline double late(double z) { return z < 1e-3 ? 0.5 + z / 12.0 : -1.0 / std::expm1(-z) - 1.0 / z; }

/// Compute G M⁻¹ Gᵀ of a row.
inline double row_mobility(const context::StepContext& ctx, int id, const SlotState& s, int r) {
    double sum = 0.0;
    for (int b = 0; b < ctx.model.interactions.bodies[static_cast<std::size_t>(id)]; ++b) {
        const auto body =
            static_cast<std::size_t>(ctx.model.interactions.def[static_cast<std::size_t>(id)]
                                         .body[static_cast<std::size_t>(b)]
                                         .index);
        const double* j = s.j[b][r];
        for (int k = 0; k < s.dof[b] && k < 3; ++k)
            sum += j[k] * j[k] / ctx.model.bodies.mass[body];
        if (s.dof[b] < 6) continue;
        const Mat3 rotation =
            Quat(ctx.model.bodies.q[4 * body], ctx.model.bodies.q[4 * body + 1],
                 ctx.model.bodies.q[4 * body + 2], ctx.model.bodies.q[4 * body + 3])
                .toRotationMatrix();
        const Eigen::Map<const Mat3> inertia(&ctx.model.bodies.inertia[9 * body]);
        const Vec3 turn = rotation.transpose() * Vec3(j[3], j[4], j[5]);
        sum += turn.dot(inertia.inverse() * turn);
    }
    return sum;
}

inline void add_bodies(const context::StepContext& ctx, DenseStep& out) {
    const model::Bodies& b = ctx.model.bodies;
    const double h = ctx.model.def.step;
    for (std::int32_t body : b.moving) {
        const auto i = static_cast<std::size_t>(body);
        const int at = b.dof_begin[i], dof = b.dof(body);
        Matrix m = b.mass[i] * Matrix::Identity(dof, dof), d = Matrix::Zero(dof, dof);
        const Mat3 r =
            Quat(b.q[4 * i], b.q[4 * i + 1], b.q[4 * i + 2], b.q[4 * i + 3]).toRotationMatrix();
        auto vec = [&](const base::Array<double>& a, std::size_t k) {
            return Vec3(a[k], a[k + 1], a[k + 2]);
        };
        Matrix past = d;  // drag on the velocity before the step
        const auto share = [&](int k, double mobility) {
            return late(h * b.damping[6 * i + static_cast<std::size_t>(k)] * mobility);
        };
        const auto drag = [&](int from, const Vec3& shares) -> Mat3 {
            return r *
                   shares.cwiseProduct(vec(b.damping, 6 * i + static_cast<std::size_t>(from)))
                       .asDiagonal() *
                   r.transpose();
        };
        const auto late_linear = [&](int k) { return share(k, 1.0 / b.mass[i]); };
        if (dof == 1) {
            d(0, 0) = late_linear(0) * b.damping[6 * i];
            past(0, 0) = b.damping[6 * i] - d(0, 0);
        }
        if (dof >= 3) {
            const Vec3 shares(late_linear(0), late_linear(1), late_linear(2));
            d.block(0, 0, 3, 3) = drag(0, shares);
            past.block(0, 0, 3, 3) = drag(0, Vec3::Ones() - shares);
        }
        if (dof == 6) {
            Mat3 inertia;
            for (std::size_t k = 0; k < 9; ++k)
                inertia(static_cast<int>(k / 3), static_cast<int>(k % 3)) = b.inertia[9 * i + k];
            m.block(3, 3, 3, 3) = r * inertia * r.transpose();
            const Vec3 mobility = Mat3(inertia.inverse()).diagonal();
            d.block(3, 3, 3, 3) =
                drag(3, {share(3, mobility[0]), share(4, mobility[1]), share(5, mobility[2])});
        }
        out.mass.block(at, at, dof, dof) = m + h * d;
        for (int k = 0; k < dof && k < 3; ++k) {
            const auto force = 6 * i + static_cast<std::size_t>(k);
            const double weight = dof > 1 && b.weight[i] ? ctx.model.def.gravity[k] : 0.0;
            out.a[at + k] =
                b.mass[i] *
                    (b.v[static_cast<std::size_t>(at) + static_cast<std::size_t>(k)] + h * weight) +
                h * b.force[force];
        }
        const int moves = std::min(dof, 3);
        const Eigen::Map<const Vector> now(&b.v[static_cast<std::size_t>(at)], moves);
        out.a.segment(at, moves) -= h * past.block(0, 0, moves, moves) * now;
    }
}

/// Write the equations at the present state.
inline DenseStep dense_step(const context::StepContext& ctx) {
    const int n = ctx.model.bodies.dofs, rows = ctx.model.interactions.row_count;
    const double h = ctx.model.def.step;
    const Matrix none = Matrix::Zero(n, n);
    DenseStep out{none,
                  none,
                  none,
                  none,
                  none,
                  none,
                  0.0,
                  Matrix::Zero(rows, n),
                  Vector::Zero(rows),
                  Vector::Zero(rows),
                  Vector::Zero(n),
                  Vector::Zero(n)};
    add_bodies(ctx, out);
    const model::Interactions& in = ctx.model.interactions;
    const Eigen::Map<const Vector> v(ctx.model.bodies.v.data(), n);
    for (int id = 0; id < in.count(); ++id) {
        const auto i = static_cast<std::size_t>(id);
        const SlotState s = slot_state(ctx, id);
        const KindInfo& info = kind_info(in.def[i].kind);
        const bool range = std::string_view(info.name).ends_with("_range");
        // Inactive: a joint inside its range, or a slack line (part of the state). It has no rows,
        // only a diagonal.
        const bool idle = range ? s.g[0] == 0.0 : in.active[i] == 0.0;
        for (int r = 0; r < info.rows; ++r) {
            const int row = in.row_begin[i] + r;
            double e = in.def[i].compliance[static_cast<std::size_t>(r)];
            // Recipes define no compliance for this kind: it is 1/EA of the length paid out by the
            // drum.
            if (in.def[i].kind == InteractionKind::WinchStretch) {
                const auto drum = static_cast<std::size_t>(in.def[i].body[2].index);
                e = (in.def[i].get("length") +
                     in.def[i].get("radius") * ctx.model.bodies.x[3 * drum]) /
                    in.def[i].get("EA");
            }
            const double given = in.def[i].damping_time[static_cast<std::size_t>(r)];
            const double tau = std::isnan(given) ? 2.0 * h : given;
            const bool velocity = info.row_units[r] == 'v';
            // Damper. The scheme's own damping acts only on the velocity after the step. A wire
            // whose transverse vibration is under-resolved has the damping of at least half a step.
            double theta = 1.0, seen = tau;
            // A rigid joint has the damping of at least half a step, a stiff one up to a tenth. The
            // law of a compliant one has a term κ (d₊ − d₋) if its vibration is under-resolved.
            double shift = 0.0;  // κ/h
            using enum InteractionKind;
            const InteractionKind kind = in.def[i].kind;
            const bool joint = kind == Ball || kind == Hinge || kind == Prismatic ||
                               kind == Cylindrical || kind == Universal || kind == Lock;
            if (joint && e == 0.0) seen = std::max(tau, 0.5 * h);
            if (!velocity && (in.row_flags[static_cast<std::size_t>(row)] & model::kRowDamper) &&
                e > 0.0) {
                const double w = row_mobility(ctx, id, s, r), spring = 0.25 * h * h * w / e;
                const bool wire = in.def[i].kind == InteractionKind::Stretch ||
                                  in.def[i].kind == InteractionKind::WinchStretch;
                if (wire) seen = std::max(tau, (late(spring) - 0.5) * h);
                if (joint && spring > 1e4)
                    seen = std::max(tau, 0.1 * h * (spring - 1e4) / (spring + 1e4));
                if (joint && spring > 0.25)
                    shift = std::max(0.0, 0.1 * (spring - 0.25) / (spring + 0.25) - seen / h);
                theta = late(h * seen * w / e + spring);
            }
            const double ups = 1.0 / (1.0 + 4.0 * (seen * theta / h + shift));
            const double recall = 1.0 - 4.0 * (seen * (1.0 - theta) / h - shift);
            out.sigma[row] = velocity ? e / h : 4.0 * e * ups / (h * h);
            // A rigid row has a fraction of its mobility where the system was analysed.
            if (!velocity && e == 0.0) out.sigma[row] = in.sigma[static_cast<std::size_t>(row)];
            if (idle) continue;
            double prescribed = 0.0;
            for (int b = 0; b < info.bodies; ++b)
                for (int j = 0; j < 6; ++j) {
                    if (j < s.dof[b]) out.g(row, s.at[b] + j) += s.j[b][r][j];
                    if (s.dof[b] == 0)
                        prescribed += s.j[b][r][j] * (j < 3 ? s.lin[b][j] : s.ang[b][j - 3]);
                }
            out.c[row] = velocity ? s.g[r] - prescribed
                                  : ups * recall * (out.g.row(row) * v + prescribed) -
                                        4.0 / h * ups * s.g[r] - prescribed;
            if (in.flags[i] & model::kOneSided) {
                // x̄₋: position of the line half a step ago. A line is slack if the mean (x̄₋ +
                // x̄₊)/2 is.
                const double before = s.g[r] - 0.5 * h * (out.g.row(row) * v + prescribed);
                // The damper acts on the rate from x̄₋.
                const double mean = 4.0 / h * ups * recall;  // factor of x̄ in c
                out.c[row] += mean * 0.5 * std::min(before, 0.0);
            }
        }
        if (!idle) add_geometry(ctx, id, s, out);
    }
    const Eigen::Map<const Vector> expected(ctx.model.bodies.v_start.data(), n);
    out.a += out.late * v + out.ahead * expected - out.before * v + out.couple_fixed;
    return out;
}

}  // namespace hawser::test
