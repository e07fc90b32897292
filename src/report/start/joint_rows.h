// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file joint_rows.h
/// Rigid and driving rows of a world: find redundant rows, and the least possible distance of all
/// rows from their required values.
///
/// Redundancy is a matter of geometry, so bodies have no mass here. The metric weights a rotation
/// by the displacement of the body's joints. Let D be its matrix, G the rows and S a billionth of
/// the diagonal of W = G D⁻¹ Gᵀ. One factor of [D Gᵀ; G −S] then gives S (W + S)⁻¹ b.
/// This is, to first order, the part of b that no motion of the bodies reaches.

#include <hawser/factor.h>
#include <hawser/hawser.h>
#include <hawser/inspect.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace hawser::report::start {

/// One interaction with rigid or driving rows.
struct Joint {
    InteractionId id{};
    std::int32_t row_begin = 0;  ///< Index of its first row in the lists of JointRows.
    std::int32_t rows = 0;
    std::array<std::int8_t, kMaxInteractionRows>
        row{};  ///< Indices of these rows within the interaction.
    bool motor = false;
    double size = 0.0;  ///< Longest arm from a body's centre to the joint [m].
};

class JointRows {
  public:
    /// Collect the rows of a world's joints. A row is rigid if its compliance has no effect in a
    /// step.
    explicit JointRows(const World& world);

    [[nodiscard]] const std::vector<Joint>& joints() const { return joints_; }
    [[nodiscard]] std::size_t rows() const { return rows_; }

    /// Compute rows and metric at the poses of a world with the same definitions. @return false if
    /// the factorisation failed.
    [[nodiscard]] bool update(const World& world);
    /// Return g of all rows; 0 for driving rows.
    [[nodiscard]] const std::vector<double>& violations() const { return violations_; }
    /// Return the value of G v that the moving bodies must reach: the speed of a motor minus the
    /// rate of prescribed velocities.
    [[nodiscard]] const std::vector<double>& speeds() const { return speeds_; }
    /// Return the present G v of all rows [m/s or rad/s].
    [[nodiscard]] const std::vector<double>& rates() const { return rates_; }
    /// Return √W_ii of a row, which makes rows comparable.
    [[nodiscard]] double scale(std::size_t row) const { return scale_[row]; }

    /// Return the part of the required rates b that no motion of the bodies can produce. Call
    /// update() first.
    [[nodiscard]] std::vector<double> out_of_reach(std::span<const double> b);
    /// Move the bodies of `world` so that the sum of squared violations is least (Levenberg and
    /// Marquardt). `world` must be the world of these rows. Rows and metric are updated.
    void close(World& world);
    /// Return the kernel of Wᵀ of these rows, in the scale of scale(). The matrix has one column
    /// for each redundancy. Call update() first.
    [[nodiscard]] Eigen::MatrixXd repetition_kernel(std::span<const std::int32_t> rows) const;

  private:
    void find_bodies(const World& world);
    void build_pattern();
    void write_row(const World& world, const Joint& joint);
    void move(World& world);
    /// Return the sum of squared violations Σ (g/scale)², with the scales of the first call of
    /// update().
    [[nodiscard]] double open() const;
    [[nodiscard]] std::vector<double> solve(std::span<const double> b);

    std::vector<Joint> joints_;
    std::size_t rows_ = 0;
    std::vector<std::int32_t>
        node_of_body_;            ///< Node of each body; −1: it is fixed, or has no joint.
    std::vector<BodyId> bodies_;  ///< Body of each node.
    std::vector<double> length_;  ///< Length of each node in the metric [m].
    std::vector<std::int32_t> edge_of_slot_;  ///< Edge of each body of a joint,
                                              ///< kMaxInteractionBodies per joint; −1: none.
    BlockPattern pattern_;
    BlockFactor factor_;
    std::vector<double> values_, violations_, speeds_, rates_, scale_, first_scale_;
    double small_ = kSmallEigenvalue;  ///< Ratio of S to the diagonal of W.

    /// Rows whose difference is below this count as equal. In a chain of n links between two fixed
    /// points the smallest difference is about 1/n².
    static constexpr double kSmallEigenvalue = 1e-9;
};

}  // namespace hawser::report::start
