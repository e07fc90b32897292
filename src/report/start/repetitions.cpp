// SPDX-License-Identifier: Apache-2.0
#include "record/units.h"
#include "report/start/parts.h"
#include "report/start/repeating.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace hawser::report::start {

namespace {

/// Tolerance of a remaining violation: a fraction of a joint's reach; for an angle [rad]; for a
/// speed a fraction of the largest required speed. A larger violation is a contradiction; steps
/// tolerate smaller ones.
constexpr double kGapTolerance = 1e-3, kAngleTolerance = 1e-3, kSpeedTolerance = 1e-3;

/// Speed that counts as zero: round-off of other speeds [m/s or rad/s].
constexpr double kZeroSpeed = 1e-6;

/// Force limit from which a motor counts as unlimited [N or N m].
constexpr double kUnlimited = 1e29;

class Search {
  public:
    Search(const World& world, JointRows& rows, Findings& out)
        : world_(world),
          rows_(rows),
          out_(out),
          speeds_(rows.speeds()),
          contradicts_(rows.joints().size(), false) {
        joint_of_row_.reserve(rows.rows());
        for (std::size_t j = 0; j < rows.joints().size(); ++j)
            joint_of_row_.insert(joint_of_row_.end(),
                                 static_cast<std::size_t>(rows.joints()[j].rows), j);
    }

    void run() {
        const std::vector<Group> groups = find_groups(world_, rows_);
        const std::vector<double> still = rows_.out_of_reach(rows_.speeds());
        find_contradictions();
        for (const Group& group : groups) report(group, still);
    }

  private:
    [[nodiscard]] const Joint& joint(std::size_t j) const { return rows_.joints()[j]; }

    /// Try to close the rows that start open. If some stay open, report the redundant rows among
    /// them as inconsistent.
    void find_contradictions() {
        if (!any_separated()) return;
        World moved = world_.twin(Coupling::exact);
        rows_.close(moved);
        if (!any_separated()) return;
        for (const Group& group : find_groups(world_, rows_)) report_contradiction(group);
    }

    [[nodiscard]] bool any_separated() const {
        for (std::size_t r = 0; r < rows_.rows(); ++r)
            if (is_separated(r, rows_.violations()[r])) return true;
        return false;
    }

    [[nodiscard]] bool is_angle(std::size_t row) const {
        const Joint& j = joint(joint_of_row_[row]);
        const std::size_t k = row - static_cast<std::size_t>(j.row_begin);
        return kind_info(world_.interaction_def(j.id).kind).row_units[j.row[k]] == 'r';
    }
    [[nodiscard]] bool is_separated(std::size_t row, double g) const {
        return std::abs(g) > (is_angle(row)
                                  ? kAngleTolerance
                                  : kGapTolerance * comparison_length(joint(joint_of_row_[row])));
    }

    [[nodiscard]] std::vector<std::string> names_of(const Group& group) const {
        std::vector<std::string> names;
        for (const std::int32_t j : group.joints)
            names.push_back(
                record::interaction_label(world_, joint(static_cast<std::size_t>(j)).id));
        return names;
    }

    void report_contradiction(const Group& group) {
        double length = 0.0, angle = 0.0;
        bool apart = false;
        for (const std::int32_t j : group.joints) {
            const Joint& one = joint(static_cast<std::size_t>(j));
            for (std::int32_t k = 0; k < one.rows; ++k) {
                const std::size_t r =
                    static_cast<std::size_t>(one.row_begin) + static_cast<std::size_t>(k);
                double& most = is_angle(r) ? angle : length;
                most = std::max(most, std::abs(rows_.violations()[r]));
                apart |= is_separated(r, rows_.violations()[r]);
            }
        }
        if (!apart) return;
        for (const std::int32_t j : group.joints) contradicts_[static_cast<std::size_t>(j)] = true;
        const std::vector<std::string> names = names_of(group);
        const std::string open = length > kGapTolerance * 0.1 ? record::with_unit(length, "m")
                                                              : fmt::format("{:.3g} rad", angle);
        out_.add(
            true, FindingKind::contradiction, names, std::max(length, angle),
            names.size() == 1
                ? fmt::format(
                      "{} cannot be satisfied: at any position of its bodies {} stays open; move "
                      "its points and axes",
                      record::interaction_in_words(world_, joint(index(group.joints[0])).id), open)
                : fmt::format("the joints {} are inconsistent: at any position of their bodies {} "
                              "stays open; remove one, or move points and axes",
                              in_quotes(names), open));
    }

    void report(const Group& group, const std::vector<double>& still) {
        double speed = 0.0, asked = 0.0;
        const char* unit = "";
        bool drives = false;
        for (const std::int32_t j : group.joints) {
            const Joint& one = joint(index(j));
            drives |= one.motor;
            for (std::int32_t k = 0; k < one.rows; ++k) {
                const std::size_t r = index(one.row_begin + k);
                if (std::abs(still[r]) > speed) unit = unit_of(one, k);
                speed = std::max(speed, std::abs(still[r]));
                asked = std::max(asked, std::abs(speeds_[r]));
            }
        }
        const std::vector<std::string> names = names_of(group);
        const bool known = std::any_of(group.joints.begin(), group.joints.end(),
                                       [&](std::int32_t j) { return contradicts_[index(j)]; });
        if (speed > std::max(kZeroSpeed, kSpeedTolerance * asked))
            report_motion(group, names, in_quotes(names), speed, unit, drives);
        else if (!known)
            report_repetition(group, names, in_quotes(names), drives);
    }

    /// Return the unit of the rate of a joint's k-th row; a scalar body has metres or radians.
    [[nodiscard]] const char* unit_of(const Joint& one, std::int32_t k) const {
        const KindInfo& kind = kind_info(world_.interaction_def(one.id).kind);
        if (kind.coordinate == KindCoordinate::scalar) return "m/s or rad/s";
        if (one.motor) return kind.coordinate == KindCoordinate::about ? "rad/s" : "m/s";
        return kind.row_units[one.row[index(k)]] == 'r' ? "rad/s" : "m/s";
    }

    [[nodiscard]] static std::size_t index(std::int32_t i) { return static_cast<std::size_t>(i); }
    [[nodiscard]] static std::string in_quotes(std::vector<std::string> names) {
        for (std::string& name : names) name = record::name_in_quotes(name);
        return record::names_in_words(names);
    }

    void report_motion(const Group& group, const std::vector<std::string>& names,
                       const std::string& all, double speed, const char* unit, bool drives) {
        if (!drives) {
            out_.add(
                true, FindingKind::contradiction, names, speed,
                fmt::format("{} are inconsistent with the prescribed velocities of their bodies by "
                            "{:.3g} {}: no motion of the other bodies satisfies both",
                            all, speed, unit));
            return;
        }
        for (const std::int32_t j : group.joints) {
            const Joint& one = joint(static_cast<std::size_t>(j));
            if (!one.motor) continue;
            const InteractionDef& def = world_.interaction_def(one.id);
            const double motor_speed = def.get("speed");
            const bool unlimited =
                def.get("force_max") >= kUnlimited && def.get("force_min") <= -kUnlimited;
            if (motor_speed == 0.0) continue;
            std::vector<std::string> others;
            for (const std::string& name : names)
                if (name != record::interaction_label(world_, one.id))
                    others.push_back(record::name_in_quotes(name));
            out_.add(
                unlimited, FindingKind::motor, names, std::abs(motor_speed),
                fmt::format(
                    "{} wants {:.3g} {} where {} otherwise: {}",
                    record::interaction_in_words(world_, one.id), motor_speed, unit_of(one, 0),
                    record::names_in_words(others) +
                        (others.size() == 1 ? " holds still or drives" : " hold still or drive"),
                    unlimited ? "without a limit of its force none of them can yield; give it "
                                "force_min and force_max, or remove one"
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
        out_.add(
            false, FindingKind::repeated, names, group.repetitions,
            fmt::format("{} {} are redundant{}: the distribution of the force among them is not "
                        "determined; if it matters, replace one by a joint with fewer constraints",
                        what, all, count));
    }

    const World& world_;
    JointRows& rows_;
    Findings& out_;
    std::vector<double> speeds_;
    std::vector<bool> contradicts_;  ///< For each joint, true if a contradiction was reported.
    std::vector<std::size_t> joint_of_row_;
};

}  // namespace

void check_repetitions(const World& world, JointRows& rows, Findings& out) {
    Search(world, rows, out).run();
}

}  // namespace hawser::report::start
