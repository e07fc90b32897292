// SPDX-License-Identifier: Apache-2.0
#include "observe/axes.h"
#include "observe/start/parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>

namespace hawser::observe::start {

namespace {

/// Share of a repetition, of a unit vector over its rows, below which a row is not part of it. A
/// loop of a million rows has a thousandth in each.
constexpr double kPart = 1e-3;

/// Rows of joints that are compared with each other one by one: some tenths of a second.
constexpr std::size_t kMostDense = 500;

/// What remains open is a contradiction above this part of the reach of a joint; of an angle [rad];
/// of a speed [m/s or rad/s], and of the speed asked for. Below it steps put up with it.
constexpr double kApart = 1e-3, kAngleApart = 1e-3, kSpeedApart = 1e-6;

/// A motor whose force is less than this can be held [N or N m].
constexpr double kUnlimited = 1e29;

/// Joints that say the same thing of their bodies.
struct Group {
    std::vector<std::int32_t> joints;  ///< Indices, ascending.
    int repetitions = 0;               ///< Rows that follow from the others; 0: not counted.
};

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
    void unite(std::size_t a, std::size_t b) {
        a = find(a);
        b = find(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<std::size_t> parent_;
};

class Search {
  public:
    Search(const World& world, JointRows& rows, Findings& out)
        : world_(world),
          rows_(rows),
          out_(out),
          sets_(rows.joints().size()),
          speeds_(rows.speeds()),
          contradicts_(rows.joints().size(), false) {
        joint_of_row_.reserve(rows.rows());
        for (std::size_t j = 0; j < rows.joints().size(); ++j)
            joint_of_row_.insert(joint_of_row_.end(),
                                 static_cast<std::size_t>(rows.joints()[j].rows), j);
    }

    void run() {
        const std::vector<Group> groups = find();
        const std::vector<double> still = rows_.out_of_reach(rows_.speeds());
        find_contradictions();
        for (const Group& group : groups) report(group, still);
    }

  private:
    [[nodiscard]] const Joint& joint(std::size_t j) const { return rows_.joints()[j]; }

    /// Groups at the poses that the rows are of.
    std::vector<Group> find() {
        repeating_.clear();
        sets_ = Sets(rows_.joints().size());
        find_repeating_rows();
        join_by_bodies();
        split_by_rows();
        return gather();
    }

    /// Random vectors, as far as no motion reaches them: a row that repeats nothing has no part.
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
            if (part[r] > kPart) repeating_.push_back(static_cast<std::int32_t>(r));
    }

    /// Joints with repeating rows that share a body that moves.
    void join_by_bodies() {
        std::vector<std::int64_t> first(static_cast<std::size_t>(world_.body_count()), -1);
        for (const std::int32_t row : repeating_) {
            const std::size_t j = joint_of_row_[static_cast<std::size_t>(row)];
            const InteractionDef& def = world_.interaction_def(joint(j).id);
            for (std::size_t b = 0; b < static_cast<std::size_t>(kind_info(def.kind).bodies); ++b) {
                if (freedoms(world_.body_def(def.body[b]).kind) == 0) continue;
                std::int64_t& other = first[static_cast<std::size_t>(def.body[b].index)];
                if (other < 0) other = static_cast<std::int64_t>(j);
                sets_.unite(j, static_cast<std::size_t>(other));
            }
        }
    }

    /// Of each set of moderate size which rows belong to the same repetition; two doors on one
    /// wall have nothing to do with each other.
    void split_by_rows() {
        std::vector<std::vector<std::int32_t>> by_set(rows_.joints().size());
        for (const std::int32_t row : repeating_)
            by_set[sets_.find(joint_of_row_[static_cast<std::size_t>(row)])].push_back(row);
        Sets fine(rows_.joints().size());
        repetitions_.assign(rows_.joints().size(), 0.0);
        for (const std::vector<std::int32_t>& rows : by_set) {
            if (rows.empty()) continue;
            const auto joint_of = [&](std::int32_t row) {
                return joint_of_row_[static_cast<std::size_t>(row)];
            };
            if (rows.size() > kMostDense) {
                for (const std::int32_t row : rows) fine.unite(joint_of(row), joint_of(rows[0]));
                continue;
            }
            const Eigen::MatrixXd basis = rows_.repetitions(rows);
            const Eigen::MatrixXd shared = basis * basis.transpose();
            for (Eigen::Index a = 0; a < shared.rows(); ++a) {
                const auto row = static_cast<std::size_t>(a);
                repetitions_[joint_of(rows[row])] += shared(a, a);  // The trace is the rank.
                for (Eigen::Index b = 0; b < a; ++b)
                    if (std::abs(shared(a, b)) > kPart)
                        fine.unite(joint_of(rows[row]),
                                   joint_of(rows[static_cast<std::size_t>(b)]));
            }
        }
        sets_ = fine;
    }

    std::vector<Group> gather() {
        std::vector<std::int32_t> group_of(rows_.joints().size(), -1);
        std::vector<Group> groups;
        std::vector<double> count;
        for (const std::int32_t row : repeating_) {
            const std::size_t j = joint_of_row_[static_cast<std::size_t>(row)];
            std::int32_t& number = group_of[sets_.find(j)];
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

    /// Close what starts open. Where something stays open, rows that repeat each other there are
    /// what cannot all hold.
    void find_contradictions() {
        if (!any_apart()) return;
        World moved = world_.twin(Coupling::exact);
        rows_.close(moved);
        if (!any_apart()) return;
        for (const Group& group : find()) report_contradiction(group);
    }

    [[nodiscard]] bool any_apart() const {
        for (std::size_t r = 0; r < rows_.rows(); ++r)
            if (is_apart(r, rows_.violations()[r])) return true;
        return false;
    }

    [[nodiscard]] bool is_angle(std::size_t row) const {
        const Joint& j = joint(joint_of_row_[row]);
        const std::size_t k = row - static_cast<std::size_t>(j.row_begin);
        return kind_info(world_.interaction_def(j.id).kind).row_units[j.row[k]] == 'r';
    }
    [[nodiscard]] bool is_apart(std::size_t row, double g) const {
        return std::abs(g) >
               (is_angle(row) ? kAngleApart : kApart * reach(joint(joint_of_row_[row])));
    }

    [[nodiscard]] std::vector<std::string> names_of(const Group& group) const {
        std::vector<std::string> names;
        for (const std::int32_t j : group.joints)
            names.push_back(interaction_label(world_, joint(static_cast<std::size_t>(j)).id));
        return names;
    }

    void report_contradiction(const Group& group) {
        double length = 0.0, angle = 0.0;
        bool apart = false;
        for (const std::int32_t j : group.joints) {
            const Joint& one = joint(static_cast<std::size_t>(j));
            for (std::int32_t k = 0; k < one.rows; ++k) {
                const auto r = static_cast<std::size_t>(one.row_begin + k);
                double& most = is_angle(r) ? angle : length;
                most = std::max(most, std::abs(rows_.violations()[r]));
                apart |= is_apart(r, rows_.violations()[r]);
            }
        }
        if (!apart) return;
        for (const std::int32_t j : group.joints) contradicts_[static_cast<std::size_t>(j)] = true;
        const std::vector<std::string> names = names_of(group);
        const std::string open =
            length > kApart * 0.1 ? with_unit(length, "m") : fmt::format("{:.3g} rad", angle);
        out_.add(
            true, FindingKind::contradiction, names, std::max(length, angle),
            names.size() == 1
                ? fmt::format("{} cannot hold: wherever its bodies go, {} stays open; move "
                              "its points and axes",
                              interaction_in_words(world_, joint(index(group.joints[0])).id), open)
                : fmt::format("the joints {} contradict each other: wherever their bodies go, "
                              "{} stays open; take one away, or move points and axes",
                              in_quotes(names), open));
    }

    void report(const Group& group, const std::vector<double>& still) {
        double speed = 0.0, asked = 0.0;
        bool drives = false;
        for (const std::int32_t j : group.joints) {
            const Joint& one = joint(index(j));
            drives |= one.motor;
            for (std::int32_t k = 0; k < one.rows; ++k) {
                const std::size_t r = index(one.row_begin + k);
                speed = std::max(speed, std::abs(still[r]));
                asked = std::max(asked, std::abs(speeds_[r]));
            }
        }
        const std::vector<std::string> names = names_of(group);
        const bool known = std::any_of(group.joints.begin(), group.joints.end(),
                                       [&](std::int32_t j) { return contradicts_[index(j)]; });
        if (speed > kSpeedApart * std::max(1.0, asked))
            report_motion(group, names, in_quotes(names), speed, drives);
        else if (!known)
            report_repetition(group, names, in_quotes(names), drives);
    }

    [[nodiscard]] static std::size_t index(std::int32_t i) { return static_cast<std::size_t>(i); }
    [[nodiscard]] static std::string in_quotes(std::vector<std::string> names) {
        for (std::string& name : names) name = name_in_quotes(name);
        return names_in_words(names);
    }

    void report_motion(const Group& group, const std::vector<std::string>& names,
                       const std::string& all, double speed, bool drives) {
        if (!drives) {
            out_.add(true, FindingKind::contradiction, names, speed,
                     fmt::format("{} contradict the prescribed velocities of bodies that they hold "
                                 "by {:.3g} m/s or rad/s: no motion of the others satisfies both",
                                 all, speed));
            return;
        }
        for (const std::int32_t j : group.joints) {
            const Joint& one = joint(static_cast<std::size_t>(j));
            if (!one.motor) continue;
            const InteractionDef& def = world_.interaction_def(one.id);
            const double wanted = def.get("speed");
            const bool unlimited =
                def.get("force_max") >= kUnlimited && def.get("force_min") <= -kUnlimited;
            if (wanted == 0.0) continue;
            std::vector<std::string> others;
            for (const std::string& name : names)
                if (name != interaction_label(world_, one.id))
                    others.push_back(name_in_quotes(name));
            out_.add(
                unlimited, FindingKind::motor, names, std::abs(wanted),
                fmt::format("{} wants {:.3g} m/s or rad/s where {} hold still or drive "
                            "otherwise: {}",
                            interaction_in_words(world_, one.id), wanted, names_in_words(others),
                            unlimited ? "with no limit of its force nothing can give way; "
                                        "give it force_min and force_max, or take one away"
                                      : "it will push with all its force and not move"));
        }
    }

    void report_repetition(const Group& group, const std::vector<std::string>& names,
                           const std::string& all, bool drives) {
        const char* what = drives ? "the joints and motors" : "the joints";
        const std::string count = group.repetitions == 1 ? " in one direction"
                                  : group.repetitions > 1
                                      ? fmt::format(" in {} directions", group.repetitions)
                                      : "";
        out_.add(false, FindingKind::repeated, names, group.repetitions,
                 fmt::format("{} {} repeat each other{}: how they share the force there is not "
                             "determined; where that matters, put a joint that holds less in place "
                             "of one",
                             what, all, count));
    }

    const World& world_;
    JointRows& rows_;
    Findings& out_;
    Sets sets_;
    std::vector<double> speeds_;
    std::vector<bool> contradicts_;  ///< By joint: said already.
    std::vector<std::size_t> joint_of_row_;
    std::vector<std::int32_t> repeating_;  ///< Rows, ascending.
    std::vector<double> repetitions_;      ///< By joint: its share of the rank.
};

}  // namespace

void check_repetitions(const World& world, JointRows& rows, Findings& out) {
    Search(world, rows, out).run();
}

}  // namespace hawser::observe::start
