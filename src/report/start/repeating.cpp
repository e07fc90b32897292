// SPDX-License-Identifier: Apache-2.0
#include "report/start/repeating.h"

#include "base/body_dof.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace hawser::report::start {

namespace {

/// Fraction of a repetition, as a unit vector over its rows, below which a row does not belong to
/// it. In a loop of a million rows each has a thousandth.
constexpr double kMinRowPart = 1e-3;

/// Largest number of joint rows that are compared one by one, which takes some tenths of a second.
constexpr std::size_t kMaxDense = 500;

/// Disjoint sets of joints.
class Sets {
  public:
    explicit Sets(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    }
    std::size_t find(std::size_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void unite_sets(std::size_t a, std::size_t b) {
        a = find(a);
        b = find(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<std::size_t> parent_;
};

class GroupFinder {
  public:
    GroupFinder(const World& world, JointRows& rows)
        : world_(world), rows_(rows), body_sets_(rows.joints().size()) {
        for (std::size_t j = 0; j < rows.joints().size(); ++j)
            joint_of_row_.insert(joint_of_row_.end(),
                                 static_cast<std::size_t>(rows.joints()[j].rows), j);
    }

    std::vector<Group> find() {
        find_repeating_rows();
        join_by_bodies();
        split_by_rows();
        return gather();
    }

  private:
    /// Find rows that repeat a combination of other rows. For random required rates, the part that
    /// no motion can produce is zero in all other rows.
    void find_repeating_rows() {
        std::vector<double> part(rows_.rows(), 0.0);
        std::uint64_t state = 0x9e3779b97f4a7c15U;
        for (int k = 0; k < 3; ++k) {
            std::vector<double> z(rows_.rows());
            for (std::size_t r = 0; r < z.size(); ++r) {
                // splitmix64 (Steele, Lea, Flood 2014).
                std::uint64_t bits = state += 0x9e3779b97f4a7c15U;
                bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9U;
                bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebU;
                bits ^= bits >> 31;
                z[r] = rows_.scale(r) * (2.0 * (static_cast<double>(bits >> 11) * 0x1p-53) - 1.0);
            }
            const std::vector<double> rest = rows_.out_of_reach(z);
            for (std::size_t r = 0; r < z.size(); ++r)
                part[r] = std::max(part[r], std::abs(rest[r]) / rows_.scale(r));
        }
        for (std::size_t r = 0; r < part.size(); ++r)
            if (part[r] > kMinRowPart) repeating_.push_back(static_cast<std::int32_t>(r));
    }

    /// Unite joints with repeating rows that share a moving body.
    void join_by_bodies() {
        std::vector<std::int64_t> first(static_cast<std::size_t>(world_.body_count()), -1);
        for (const std::int32_t row : repeating_) {
            const std::size_t j = joint_of_row_[static_cast<std::size_t>(row)];
            const InteractionDef& def = world_.interaction_def(rows_.joints()[j].id);
            for (std::size_t b = 0; b < static_cast<std::size_t>(kind_info(def.kind).bodies); ++b) {
                if (base::dof_of(world_.body_def(def.body[b]).kind) == 0) continue;
                std::int64_t& other = first[static_cast<std::size_t>(def.body[b].index)];
                if (other < 0) other = static_cast<std::int64_t>(j);
                body_sets_.unite_sets(j, static_cast<std::size_t>(other));
            }
        }
    }

    /// Split each set of moderate size by repetition. Two doors on one wall share a body, but no
    /// repetition.
    void split_by_rows() {
        std::vector<std::vector<std::int32_t>> by_set(rows_.joints().size());
        for (const std::int32_t row : repeating_)
            by_set[body_sets_.find(joint_of_row_[static_cast<std::size_t>(row)])].push_back(row);
        Sets fine(rows_.joints().size());
        repetitions_.assign(rows_.joints().size(), 0.0);
        for (const std::vector<std::int32_t>& rows : by_set) {
            if (rows.empty()) continue;
            const auto joint_of = [&](std::int32_t row) {
                return joint_of_row_[static_cast<std::size_t>(row)];
            };
            if (rows.size() > kMaxDense) {
                for (const std::int32_t row : rows)
                    fine.unite_sets(joint_of(row), joint_of(rows[0]));
                continue;
            }
            const Eigen::MatrixXd basis = rows_.repetition_kernel(rows);
            const Eigen::MatrixXd shared = basis * basis.transpose();
            for (Eigen::Index a = 0; a < shared.rows(); ++a) {
                const auto row = static_cast<std::size_t>(a);
                repetitions_[joint_of(rows[row])] += shared(a, a);  // The trace is the rank.
                for (Eigen::Index b = 0; b < a; ++b)
                    if (std::abs(shared(a, b)) > kMinRowPart)
                        fine.unite_sets(joint_of(rows[row]),
                                        joint_of(rows[static_cast<std::size_t>(b)]));
            }
        }
        body_sets_ = fine;
    }

    std::vector<Group> gather() {
        std::vector<std::int32_t> group_of(rows_.joints().size(), -1);
        std::vector<Group> groups;
        std::vector<double> count;
        for (const std::int32_t row : repeating_) {
            const std::size_t j = joint_of_row_[static_cast<std::size_t>(row)];
            std::int32_t& number = group_of[body_sets_.find(j)];
            if (number < 0) {
                number = static_cast<std::int32_t>(groups.size());
                groups.emplace_back();
                count.push_back(0.0);
            }
            Group& group = groups[static_cast<std::size_t>(number)];
            if (!group.joints.empty() && group.joints.back() == static_cast<std::int32_t>(j))
                continue;
            group.joints.push_back(static_cast<std::int32_t>(j));
            count[static_cast<std::size_t>(number)] += repetitions_[j];
        }
        for (std::size_t g = 0; g < groups.size(); ++g)
            groups[g].repetitions = static_cast<int>(std::lround(count[g]));
        return groups;
    }

    const World& world_;
    JointRows& rows_;
    Sets body_sets_;
    std::vector<std::size_t> joint_of_row_;
    std::vector<std::int32_t> repeating_;  ///< Rows, ascending.
    std::vector<double> repetitions_;      ///< Fraction of the rank for each joint.
};

}  // namespace

std::vector<Group> find_groups(const World& world, JointRows& rows) {
    return GroupFinder(world, rows).find();
}

}  // namespace hawser::report::start
