// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file joint_rows.h
/// The rows of a world that hold rigidly or drive, by themselves: which of them repeat each other,
/// and how near they can all be brought to what they ask for.
///
/// Whether rows repeat each other is a matter of geometry, so bodies have no mass here: a metric in
/// which a turn counts as the way it moves the body's joints. With D its matrix, G the rows and S a
/// billionth of the diagonal of W = G D⁻¹ Gᵀ, one factor of [D Gᵀ; G −S] gives
/// S (W + S)⁻¹ b: the part of b that no motion of the bodies reaches, to first order.

#include <hawser/factor.h>
#include <hawser/hawser.h>
#include <hawser/inspect.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace hawser::report::start {

/// One interaction with rows that hold or drive.
struct Joint {
    InteractionId id{};
    std::int32_t row_begin = 0;  ///< Of its rows in the lists of JointRows.
    std::int32_t rows = 0;
    std::array<std::int8_t, kMaxInteractionRows> row{};  ///< Which of its rows these are.
    bool motor = false;
    double size = 0.0;  ///< The longest arm from a body's centre to it [m].
};

class JointRows {
  public:
    /// Rows whose compliance a step does not feel hold rigidly.
    explicit JointRows(const World& world);

    [[nodiscard]] const std::vector<Joint>& joints() const { return joints_; }
    [[nodiscard]] std::size_t rows() const { return rows_; }

    /// Take rows and metric at the poses of this world, which has the same definitions.
    /// @return false where the factor failed.
    [[nodiscard]] bool update(const World& world);
    /// g of all rows; 0 of those that drive.
    [[nodiscard]] const std::vector<double>& violations() const { return violations_; }
    /// G v that the bodies that move have to come to: the speed of a motor, less what prescribed
    /// velocities do.
    [[nodiscard]] const std::vector<double>& speeds() const { return speeds_; }
    /// G v at present [m/s or rad/s].
    [[nodiscard]] const std::vector<double>& rates() const { return rates_; }
    /// √W_ii of each row: by it rows compare.
    [[nodiscard]] double scale(std::size_t row) const { return scale_[row]; }

    /// The part of b that no motion reaches. update() first.
    [[nodiscard]] std::vector<double> out_of_reach(std::span<const double> b);
    /// Move the bodies of `world`, whose rows these are, to where the squares of the violations
    /// have their least sum (Levenberg and Marquardt); rows and metric follow.
    void close(World& world);
    /// Kernel of Wᵀ of these rows, in the scale of scale(): columns of a matrix, one a repetition.
    /// update() first.
    [[nodiscard]] Eigen::MatrixXd repetitions(std::span<const std::int32_t> rows) const;

  private:
    void find_bodies(const World& world);
    void build_pattern();
    void write_row(const World& world, const Joint& joint);
    void move(World& world);
    /// Σ (g/scale)², scales as they were at the first call of update().
    [[nodiscard]] double open() const;
    [[nodiscard]] std::vector<double> solve(std::span<const double> b);

    std::vector<Joint> joints_;
    std::size_t rows_ = 0;
    std::vector<std::int32_t> node_of_body_;  ///< −1: it does not move, or no joint holds it.
    std::vector<BodyId> bodies_;              ///< By node.
    std::vector<double> length_;              ///< By node: of the metric [m].
    std::vector<std::int32_t> edge_of_slot_;  ///< kMaxInteractionBodies a joint; −1: none.
    BlockPattern pattern_;
    BlockFactor factor_;
    std::vector<double> values_, violations_, speeds_, rates_, scale_, first_scale_;
    double small_ = kSmall;  ///< S over the diagonal of W.

    /// Rows closer than this to each other count as the same. Of a chain of n links between two
    /// fixed points the nearest is about 1/n².
    static constexpr double kSmall = 1e-9;
};

/// Freedoms of a body of this kind.
[[nodiscard]] int freedoms(BodyKind kind) noexcept;

}  // namespace hawser::report::start
