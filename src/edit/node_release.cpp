// SPDX-License-Identifier: Apache-2.0
/// Removal of nodes, see nodes.h.
///
/// The wire near the node loses the deviation from the chord a–b: δ of the position of n and w of
/// its velocity. Up to four nodes on each side compensate for it.
///
/// Positions. All of them move by the same d so that the first moment of mass is preserved. This
/// preserves the angular momentum x × p of the moving piece for any p, which would be by far the
/// largest change. The sag due to weight is not part of δ. Node n was placed below the chord by
/// this amount when inserted (nodes.h); raising it again is driven. All pieces concerned get the
/// rest lengths that keep their tensions; e has the mean of the two, weighted by length.
///
/// Momentum. Let v be the velocities of these nodes, and C the map to momentum and angular momentum
/// (consistent masses included). Let r be the missing momentum, and m the missing rates of lengths.
/// ```
///     v₁ = v + δv     δv = argmin ½ δvᵀ M̃ δv + Σ ½ (h²/4) k (u·δw − m)²     C δv = r
/// ```
/// The second term is the energy that a rate of length causes in the stiffness k in half a step.
///
/// Energy. Let d be a descent direction of the kinetic energy that does not change C. It is the
/// inverse of the same matrix times M̃ v₁, minus the component in C. Along v₁ − t d the kinetic
/// energy is least at t*. There the piece has no internal motion beyond the one of its momenta. The
/// value of t is chosen so that the total energy, with the resulting lengths, is preserved. The
/// bounds are:
/// - t ≤ t*; otherwise n is not removed now.
/// - t ≥ −0.05 t*: the internal motion becomes at most 5 % faster to replace lost energy.
/// If the loss still exceeds 1 % of the stretch energy of the pieces, the node moves relative
/// to its neighbours. It is then not removed now, unless any bend is allowed. Measured on a free
/// wire of 40 elements: a removal loses 2e-6 of the total energy without this bound and 1e-7 with
/// it.

#include "edit/nodes.h"

#include "base/dense.h"
#include "base/index.h"
#include "edit/node_chain.h"
#include "edit/node_pieces.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace hawser::edit {
namespace {

constexpr int kMaxVelocities =
    3 * (2 * kNodeReach + 2);  // includes free ends of the wire within reach
constexpr int kMomentumRows = 6;
constexpr double kAnyBend = 3.14159;  ///< Upper bound of any bend angle [rad].
using Packed = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMaxVelocities, 1>;
using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor,
                             kMaxVelocities, kMaxVelocities>;
using Shares = Eigen::Matrix<double, kMomentumRows, Eigen::Dynamic, Eigen::ColMajor, kMomentumRows,
                             kMaxVelocities>;
using Across = Eigen::Matrix<double, Eigen::Dynamic, kMomentumRows, Eigen::ColMajor, kMaxVelocities,
                             kMomentumRows>;
using Kept = base::Vec6;
using KeptSquare = base::Mat6;

Mat3 cross_matrix(const Vec3& r) {
    Mat3 m;
    m << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
    return m;
}

/// Velocities of moving nodes, and their contributions to momenta.
class ReleaseNeighbourhood {
  public:
    explicit ReleaseNeighbourhood(const NodeChain& chain)
        : chain_(chain), origin_(chain.lump[chain.middle].y) {
        for (std::size_t k = 0; k < chain.count; ++k) {
            first_row_[k] = chain.lump[k].moves ? size_ : -1;
            if (chain.lump[k].moves) size_ += 3;
            reach_ = std::max(reach_, (chain.lump[k].y - origin_).norm());
        }
        mass_.setZero(size_, size_);
        shares_.setZero(kMomentumRows, size_);
        missing_rates_.setZero(size_);
        if (size_ == 0) return;
        for (std::size_t k = 0; k < chain.count; ++k) add_lump(k);
        Square stiff = Square::Zero(size_, size_);
        for (std::size_t k = 0; k + 1 < chain.count; ++k) add_piece(k, stiff);
        momentum_factor_.compute(mass_ + stiff);
        across_ = momentum_factor_.solve(shares_.transpose());
        const KeptSquare unscaled = shares_ * across_;
        // Scale rows of different units by their size.
        scale_ = unscaled.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
        const KeptSquare scaled = scale_.asDiagonal() * unscaled * scale_.asDiagonal();
        eigen_ = base::symmetric_eigen(scaled);
    }
    [[nodiscard]] int size() const noexcept { return size_; }
    [[nodiscard]] const Vec3& origin() const noexcept { return origin_; }

    /// Return the velocity changes that give the elements their required rates of length.
    /// velocity_corrections() returns the smallest velocity changes that add a given momentum.
    [[nodiscard]] Packed change_of_rates() const { return momentum_factor_.solve(missing_rates_); }
    [[nodiscard]] Packed velocity_corrections(const NodeMomentum& m) const {
        Kept r;
        r << m.linear, m.angular / reach_;
        return min_change(r);
    }
    /// Return the direction d in which the kinetic energy decreases at constant momentum. Set `far`
    /// to the factor of d at which the energy is least; 0 if no node moves.
    [[nodiscard]] Packed descent_direction(const NodeChain& chain, double& far) const {
        far = 0.0;
        Packed slope(size_);
        if (size_ == 0) return slope;
        for (std::size_t k = 0; k < chain.count; ++k) {
            if (first_row_[k] < 0) continue;
            Vec3 g = chain.lump[k].mass * chain.lump[k].v;
            if (k > 0) g -= chain.piece[k - 1].pair * (chain.lump[k].v - chain.lump[k - 1].v);
            if (k + 1 < chain.count)
                g -= chain.piece[k].pair * (chain.lump[k].v - chain.lump[k + 1].v);
            slope.segment<3>(first_row_[k]) = g;
        }
        const Packed down = momentum_factor_.solve(slope);
        const Packed d = down - min_change(shares_ * down);
        const double curved = d.dot(mass_ * d);
        far = curved > 0.0 ? std::max(0.0, slope.dot(d) / curved) : 0.0;
        return d;
    }
    void add(NodeChain& chain, const Packed& change, double factor) const {
        for (std::size_t k = 0; k < chain.count; ++k)
            if (first_row_[k] >= 0) chain.lump[k].v += factor * change.segment<3>(first_row_[k]);
    }

  private:
    void add_lump(std::size_t k) {
        if (first_row_[k] < 0) return;
        const NodeChain::ChainNode& l = chain_.lump[k];
        mass_.block<3, 3>(first_row_[k], first_row_[k]) += l.mass * Mat3::Identity();
        shares_.block<3, 3>(0, first_row_[k]) += l.mass * Mat3::Identity();
        shares_.block<3, 3>(3, first_row_[k]) += l.mass / reach_ * cross_matrix(l.y - origin_);
    }
    void add_piece(std::size_t k, Square& stiff) {
        const NodeChain::Piece& p = chain_.piece[k];
        const Vec3 separation = chain_.separation(k), u = separation.normalized();
        const double weight = p.pull != 0.0 ? chain_.half * chain_.half * p.EA / p.rest : 0.0;
        const double rate = u.dot(chain_.lump[k + 1].v - chain_.lump[k].v);
        for (std::size_t one = 0; one < 2; ++one) {
            const int row = first_row_[k + one];
            if (row < 0) continue;
            const double sign = one == 0 ? -1.0 : 1.0;
            shares_.block<3, 3>(3, row) -= sign * p.pair / reach_ * cross_matrix(separation);
            missing_rates_.segment<3>(row) += sign * weight * (p.rate - rate) * u;
            for (std::size_t other = 0; other < 2; ++other) {
                const int column = first_row_[k + other];
                if (column < 0) continue;
                const double both = one == other ? 1.0 : -1.0;
                mass_.block<3, 3>(row, column) -= both * p.pair * Mat3::Identity();
                stiff.block<3, 3>(row, column) += both * weight * u * u.transpose();
            }
        }
    }
    [[nodiscard]] Packed min_change(const Kept& r) const {
        Kept y = eigen_.vectors.transpose() * scale_.cwiseProduct(r);
        constexpr double kMinMomentOfInertia = 1e-12;  // for the rotation about a line of nodes
        for (int i = 0; i < kMomentumRows; ++i)
            y[i] = eigen_.values[i] > kMinMomentOfInertia ? y[i] / eigen_.values[i] : 0.0;
        return across_ * scale_.cwiseProduct(eigen_.vectors * y);
    }

    const NodeChain& chain_;
    Vec3 origin_;
    int size_ = 0;
    double reach_ = 1e-9;
    std::array<int, NodeChain::kMaxNodes> first_row_{};
    Square mass_;
    Shares shares_;
    Packed missing_rates_;
    Across across_;
    Kept scale_;
    Eigen::LLT<Square> momentum_factor_;
    base::SymmetricEigen<kMomentumRows> eigen_;
};

/// Move the free nodes of chain `now` so that its centre of mass equals that of chain `was`.
void preserve_mass_centre(NodeChain& now, const NodeChain& was) noexcept {
    Vec3 moment = Vec3::Zero();
    double mass = 0.0;
    const Vec3 origin = was.lump[was.middle].y;
    for (std::size_t k = 0; k < was.count; ++k)
        moment += was.lump[k].mass * (was.lump[k].y - origin);
    for (std::size_t k = 0; k < now.count; ++k) {
        moment -= now.lump[k].mass * (now.lump[k].y - origin);
        if (now.lump[k].moves) mass += now.lump[k].mass;
    }
    for (std::size_t k = 0; k < now.count; ++k)
        if (now.lump[k].moves) now.lump[k].y += moment / mass;
}

/// Change the velocities so that the linear and angular momentum equal `had`.
void preserve_momenta(NodeChain& now, const ReleaseNeighbourhood& patch,
                      const NodeMomentum& had) noexcept {
    if (patch.size() == 0) return;
    patch.add(now, patch.change_of_rates(), 1.0);
    // Nodes nearly on a line have almost no moment of inertia about it: repeat to remove the
    // rounding error.
    constexpr int kMomentumPasses = 3;
    for (int i = 0; i < kMomentumPasses; ++i) {
        const NodeMomentum has = momentum_of(now, patch.origin());
        patch.add(now,
                  patch.velocity_corrections({had.linear - has.linear, had.angular - has.angular}),
                  1.0);
    }
}

/// Change the velocities along the direction of descent until the energy is at most `energy`.
/// @param any  True: accept any loss of energy.
/// @return false if no change suffices, or if too much energy is lost.
bool preserve_energy(NodeChain& now, const ReleaseNeighbourhood& patch, double energy,
                     bool any) noexcept {
    double far = 0.0;
    const Packed down = patch.descent_direction(now, far);
    NodeChain tried = now;
    const auto at_fraction = [&](double t) {
        tried = now;
        patch.add(tried, down, -t);
        fit_lengths(tried);
        return energy_of(tried) <= energy;
    };
    constexpr double kGivenBack = 0.05, kMaxLost = 0.01;
    double low = -kGivenBack * far, high = far;
    if (at_fraction(low)) {
        const double lost = energy - energy_of(tried);
        if (!any && lost > kMaxLost * stretch_energy_of(tried)) return false;
        now = tried;
        return true;
    }
    if (!at_fraction(high)) return false;
    constexpr int kMaxHalvings = 60;
    for (int i = 0; i < kMaxHalvings; ++i) {
        const double t = 0.5 * (low + high);
        (at_fraction(t) ? high : low) = t;
    }
    (void)at_fraction(high);
    now = tried;
    return true;
}

void write_nodes(context::StepContext& ctx, const NodeChain& now) noexcept {
    model::Bodies& b = ctx.model.bodies;
    for (std::size_t k = 0; k < now.count; ++k) {
        const NodeChain::ChainNode& l = now.lump[k];
        if (!l.moves) continue;
        const Vec3 x = l.y + now.half * l.v;
        const auto dof = at(b.dof_begin[at(l.body)]);
        for (std::size_t i = 0; i < 3; ++i) {
            const double v = l.v[static_cast<int>(i)];
            b.v_start[dof + i] += v - b.v[dof + i];
            b.v[dof + i] = v;
            b.x[3 * at(l.body) + i] = x[static_cast<int>(i)];
        }
    }
}

}  // namespace

bool release_node(context::StepContext& ctx, const NodeSurroundings& place, double bend) noexcept {
    model::Interactions& in = ctx.model.interactions;
    NodeChain was = nearby_chain(ctx, place);
    const std::size_t n = was.middle;
    const Vec3 first = was.separation(n - 1), second = was.separation(n);
    if (std::atan2(first.cross(second).norm(), first.dot(second)) > bend) return false;
    const double energy = energy_of(was);
    NodeChain now = without_node(was);
    const double share = was.piece[n - 1].rest / now.piece[n - 1].rest;
    was.lump[n].y -=
        sag_below_chord(now.separation_at_pose(n - 1), share,
                        weight_of(ctx, place.first, was.lump[n].mass), now.piece[n - 1].pull);
    preserve_mass_centre(now, was);
    const ReleaseNeighbourhood patch(now);
    preserve_momenta(now, patch, momentum_of(was, patch.origin()));
    if (!preserve_energy(now, patch, energy, bend >= kAnyBend)) return false;
    write_nodes(ctx, now);

    const std::int32_t e = place.first, f = place.second;
    const std::int32_t a = end_of(ctx, e, 0), b = end_of(ctx, f, 1);
    const double mass[2] = {was.piece[n - 1].mass, was.piece[n].mass};
    const double total = std::max(mass[0] + mass[1], 1e-300);
    const Vec3 drag = damping_of(ctx, place.node);
    add_mass(ctx, a, 0.5 * mass[1], mass[1] / total * drag);
    add_mass(ctx, b, 0.5 * mass[0], mass[0] / total * drag);
    in.def[at(e)].point[1] = in.def[at(f)].point[1];
    in.rewire(e, 1, ctx.model.bodies.id(b), ctx.model.bodies);
    for (std::size_t k = 0; k + 1 < now.count; ++k) {
        const NodeChain::Piece& p = now.piece[k];
        if (now.lump[k].moves || now.lump[k + 1].moves || p.id == e)
            set_element(ctx, p.id, p.rest, p.mass, p.pull);
    }
    NodeSurroundings after = place;
    after.second = after.node = after.bend[1] = -1;
    if (place.bend[0] >= 0) in.rewire(place.bend[0], 2, ctx.model.bodies.id(b), ctx.model.bodies);
    if (place.bend[2] >= 0) in.rewire(place.bend[2], 0, ctx.model.bodies.id(a), ctx.model.bodies);
    set_bend(ctx, place.bend[0], place.before[0], e);
    set_bend(ctx, place.bend[2], e, place.after[0]);
    update_for_masses(ctx, after);
    return true;
}

}  // namespace hawser::edit
