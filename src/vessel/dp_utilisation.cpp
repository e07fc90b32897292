// SPDX-License-Identifier: Apache-2.0
/// Smallest utilisation by branch and bound over convex fans (dp_star.h).
#include "vessel/dense_lp.h"
#include "vessel/dp_star.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace hawser::vessel {
namespace {

constexpr double kNoUtilisation = std::numeric_limits<double>::infinity();
constexpr double kMaxGap = 1e-7;  ///< Relative gap at which the search ends.

/// Fans that each thruster may use.
using Node = std::vector<std::pair<std::size_t, std::size_t>>;

/// Tangent of a board's power: Σ slope_i r_i ≤ bound.
struct PowerCut {
    std::vector<double> slopes{};
    double bound = 0.0;
};

/// Solution of a relaxed node.
struct Relaxed {
    double scale = 0.0;  ///< t: load balanced at full capacity; U = 1/t.
    std::vector<Force2> forces{};
    std::vector<double> fractions{};  ///< r_i of the hulls.
};

class Search {
  public:
    Search(const std::vector<Star>& stars, const std::vector<double>& boards, const DpLoad& load)
        : stars_(stars), boards_(boards), load_(load.x, load.y, load.n) {
        for (const Star& s : stars) {
            for (const Fan& f : s.fans)
                for (const Force2& v : f.vertices) force_unit_ = std::max(force_unit_, v.norm());
            moment_arm_ = std::max({moment_arm_, std::abs(s.x), std::abs(s.y)});
        }
        for (std::size_t b = 0; b < boards.size(); ++b) begin_cuts(static_cast<int>(b));
    }

    DpUtilisation run() {
        best_.thrusts.resize(stars_.size());
        best_.value = kNoUtilisation;
        if (load_.isZero(0.0)) {
            best_.value = 0.0;
            return best_;
        }
        if (!(force_unit_ > 0.0)) return best_;
        Node whole;
        for (const Star& s : stars_) whole.emplace_back(0, s.fans.size());
        open_.push_back(whole);
        while (!open_.empty()) {
            const Node node = std::move(open_.back());
            open_.pop_back();
            visit(node);
        }
        return best_;
    }

  private:
    /// Add the first linear constraint on the power of a switchboard: the tangent at which all its
    /// thrusters have equal fractions.
    void begin_cuts(int board) {
        double total = 0.0;
        for (const Star& s : stars_)
            if (s.board == board) total += s.power;
        const double most = boards_[static_cast<std::size_t>(board)];
        if (!(total > most)) return;
        std::vector<double> at(stars_.size(), std::pow(most / total, 2.0 / 3.0));
        cuts_.push_back(tangent(board, at));
    }
    [[nodiscard]] PowerCut tangent(int board, const std::vector<double>& at) const {
        PowerCut cut;
        cut.slopes.assign(stars_.size(), 0.0);
        cut.bound = boards_[static_cast<std::size_t>(board)];
        for (std::size_t i = 0; i < stars_.size(); ++i) {
            if (stars_[i].board != board) continue;
            const double root = std::sqrt(at[i]);
            cut.slopes[i] = 1.5 * root * stars_[i].power;
            cut.bound += 0.5 * root * at[i] * stars_[i].power;
        }
        // In units of the bound.
        for (double& s : cut.slopes) s /= cut.bound;
        cut.bound = 1.0;
        return cut;
    }
    [[nodiscard]] double power(int board, const std::vector<double>& at) const {
        double out = 0.0;
        for (std::size_t i = 0; i < stars_.size(); ++i)
            if (stars_[i].board == board) out += stars_[i].power * at[i] * std::sqrt(at[i]);
        return out;
    }

    /// Solve the linear program of a node of the search, with the linear constraints on power, and
    /// add the constraints that its solution violates.
    [[nodiscard]] bool solve_relaxation(const Node& node, Relaxed& out) {
        for (int rounds = 0; rounds < 40; ++rounds) {
            if (!program(node, out)) return false;
            bool met = true;
            for (std::size_t b = 0; b < boards_.size(); ++b) {
                const int board = static_cast<int>(b);
                if (power(board, out.fractions) <= boards_[b] * (1.0 + kMaxGap)) continue;
                cuts_.push_back(tangent(board, out.fractions));
                met = false;
            }
            if (met) return true;
        }
        return true;
    }

    [[nodiscard]] bool program(const Node& node, Relaxed& out) const {
        std::vector<std::pair<std::size_t, Force2>> columns;
        for (std::size_t i = 0; i < stars_.size(); ++i)
            for (std::size_t k = node[i].first; k < node[i].second; ++k)
                for (const Force2& v : stars_[i].fans[k].vertices) columns.emplace_back(i, v);
        const auto count = static_cast<Eigen::Index>(columns.size());
        const auto thrusters = static_cast<Eigen::Index>(stars_.size());
        DenseLp lp(count + 1, 3, thrusters + static_cast<Eigen::Index>(cuts_.size()));
        const double moment = force_unit_ * std::max(moment_arm_, 1.0);
        const Vec3 scaled(load_[0] / force_unit_, load_[1] / force_unit_, load_[2] / moment);
        const double size = scaled.norm();
        for (Eigen::Index j = 0; j < count; ++j) {
            const auto& [i, v] = columns[static_cast<std::size_t>(j)];
            lp.equality(0, j) = v.x() / force_unit_;
            lp.equality(1, j) = v.y() / force_unit_;
            lp.equality(2, j) = (stars_[i].x * v.y() - stars_[i].y * v.x()) / moment;
            lp.limit(static_cast<Eigen::Index>(i), j) = 1.0;
            for (std::size_t c = 0; c < cuts_.size(); ++c)
                lp.limit(thrusters + static_cast<Eigen::Index>(c), j) = cuts_[c].slopes[i];
        }
        for (Eigen::Index row = 0; row < 3; ++row) lp.equality(row, count) = scaled[row] / size;
        lp.cost(count) = 1.0;
        for (Eigen::Index i = 0; i < thrusters; ++i) lp.bound(i) = 1.0;
        for (std::size_t c = 0; c < cuts_.size(); ++c)
            lp.bound(thrusters + static_cast<Eigen::Index>(c)) = cuts_[c].bound;
        if (!lp.solve()) return false;
        out.scale = lp.value() / size;
        out.forces.assign(stars_.size(), Force2::Zero());
        out.fractions.assign(stars_.size(), 0.0);
        for (Eigen::Index j = 0; j < count; ++j) {
            const auto& [i, v] = columns[static_cast<std::size_t>(j)];
            out.forces[i] += lp.solution()[j] * v;
            out.fractions[i] += lp.solution()[j];
        }
        return lp.value() > 1e-9;
    }

    void visit(const Node& node) {
        Relaxed r;
        if (!solve_relaxation(node, r)) return;
        const double bound = 1.0 / r.scale;
        if (bound >= best_.value * (1.0 - kMaxGap)) return;
        std::vector<double> fractions(stars_.size(), 0.0);
        double most = 0.0;
        std::size_t branch = stars_.size();
        double separation = 0.0;
        for (std::size_t i = 0; i < stars_.size(); ++i) {
            fractions[i] = utilisation_factor(stars_[i], r.forces[i]);
            most = std::max(most, fractions[i]);
            const double off = fractions[i] - r.fractions[i];
            if (node[i].second - node[i].first > 1 && off > separation) {
                separation = off;
                branch = i;
            }
        }
        most = std::max(most, 1e-300);
        for (std::size_t b = 0; b < boards_.size() && std::isfinite(most); ++b)
            most = std::max(
                most, std::pow(power(static_cast<int>(b), fractions) / boards_[b], 2.0 / 3.0));
        const double reached = std::max(bound, bound * most);
        if (reached < best_.value) store_relaxed(r, reached, fractions);
        if (branch == stars_.size() || reached <= bound * (1.0 + kMaxGap)) return;
        const auto [first, last] = node[branch];
        Node left = node, right = node;
        left[branch].second = right[branch].first = first + (last - first) / 2;
        open_.push_back(std::move(left));
        open_.push_back(std::move(right));
    }

    void store_relaxed(const Relaxed& r, double value, const std::vector<double>& fractions) {
        best_.value = value;
        for (std::size_t i = 0; i < stars_.size(); ++i) {
            const Force2 f = r.forces[i] / r.scale;
            best_.thrusts[i] = {f.x(), f.y(), fractions[i] / r.scale};
        }
    }

    const std::vector<Star>& stars_;
    const std::vector<double>& boards_;
    Vec3 load_;
    double force_unit_ = 0.0, moment_arm_ = 0.0;
    std::vector<PowerCut> cuts_;
    std::vector<Node> open_;
    DpUtilisation best_;
};

}  // namespace

DpUtilisation smallest_utilisation(const std::vector<Star>& stars,
                                   const std::vector<double>& boards, const DpLoad& load) {
    return Search(stars, boards, load).run();
}

}  // namespace hawser::vessel
