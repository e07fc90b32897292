// SPDX-License-Identifier: Apache-2.0
#include <hawser/limits.h>

#include "record/units.h"
#include "report/start/parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace hawser::report::start {

namespace {

/// Tolerated gap, relative to the reach of the joint; for an angle [rad]. Coordinates have six
/// decimals, and their errors add up along chains. A gap of this size closes in two steps without
/// visible effect.
constexpr double kMaxStartGap = 1e-4, kMaxStartAngle = 1e-3;

/// Tolerated speed that a joint removes in the first step: the effect of gravity in a hundredth of
/// a second [m/s].
constexpr double kMaxStartSpeed = 0.1;

bool is_angle(const KindInfo& kind, int row) { return kind.row_units[row] == 'r'; }

struct Worst {
    double length = 0.0, angle = 0.0;
};

Worst worst_value(const World& world, const Joint& joint, const std::vector<double>& values) {
    const KindInfo& kind = kind_info(world.interaction_def(joint.id).kind);
    Worst worst;
    for (std::int32_t k = 0; k < joint.rows; ++k) {
        const double g = std::abs(
            values[static_cast<std::size_t>(joint.row_begin) + static_cast<std::size_t>(k)]);
        double& most =
            is_angle(kind, joint.row[static_cast<std::size_t>(k)]) ? worst.angle : worst.length;
        most = std::max(most, g);
    }
    return worst;
}

}  // namespace

double comparison_length(const Joint& joint) { return std::max(0.1, joint.size); }

void check_gaps(const World& world, const JointRows& rows, Findings& out) {
    for (const Joint& joint : rows.joints()) {
        if (joint.motor) continue;
        const std::string name = record::interaction_label(world, joint.id);
        const Worst gap = worst_value(world, joint, rows.violations());
        if (gap.length > kMaxStartGap * comparison_length(joint) || gap.angle > kMaxStartAngle) {
            const bool open = gap.length > kMaxStartGap * comparison_length(joint);
            const auto first = static_cast<std::size_t>(joint.row_begin);
            const bool is_rod = kind_info(world.interaction_def(joint.id).kind).is(kAlongLine);
            out.add(false, FindingKind::gap, {name}, open ? gap.length : gap.angle,
                    fmt::format("{} starts {}; the first steps close that with a blow: {}",
                                record::interaction_in_words(world, joint.id),
                                open ? record::with_unit(gap.length, "m") +
                                           (is_rod ? rows.violations()[first] > 0.0 ? " too long"
                                                                                    : " too short"
                                                   : " apart")
                                     : fmt::format("{:.3g} degrees out of line",
                                                   gap.angle * 180.0 / std::numbers::pi),
                                is_rod ? "move the bodies or give it another `length`"
                                       : "move the bodies or the joint's points"));
        }
        const Worst speed = worst_value(world, joint, rows.rates());
        const double turning = speed.angle * comparison_length(joint);
        if (std::max(speed.length, turning) > kMaxStartSpeed)
            out.add(false, FindingKind::speed, {name}, std::max(speed.length, turning),
                    fmt::format(
                        "{} starts with inconsistent speeds, which separate it at {}; the first "
                        "step removes them with an impact: give its bodies matching velocities",
                        record::interaction_in_words(world, joint.id),
                        record::with_unit(std::max(speed.length, turning), "m/s")));
    }
}

namespace {

struct Range {
    InteractionId id;
    double min, max;
    std::pair<std::int32_t, std::int32_t> bodies;
    KindCoordinate coordinate;
    [[nodiscard]] std::string text() const { return fmt::format("[{:.4g}, {:.4g}]", min, max); }
};

/// Return the ranges of zero width, which act like joints, with the order of their bodies.
std::vector<Range> rigid_ranges(const World& world) {
    std::vector<Range> out;
    for (const InteractionId id : world.interactions()) {
        const InteractionDef& d = world.interaction_def(id);
        const KindInfo& kind = kind_info(d.kind);
        if (!kind.is(kRangeKind) || d.compliance[0] > limit::kMeantRigid) continue;
        out.push_back(
            {id, d.get("min"), d.get("max"), {d.body[0].index, d.body[1].index}, kind.coordinate});
    }
    return out;
}

/// True if two ranges measure the same coordinate: equal bodies, and equal axes in the frame of the
/// first body.
bool same_coordinate(const World& world, const Range& a, const Range& b) {
    if (a.bodies != b.bodies || a.coordinate != b.coordinate) return false;
    const double separation = std::abs(world.coordinate(a.id) - world.coordinate(b.id));
    const InteractionDef &d = world.interaction_def(a.id), &e = world.interaction_def(b.id);
    const Vec3 u = d.frame[0] * Vec3::UnitZ(), v = e.frame[0] * Vec3::UnitZ();
    return separation < 1e-9 && (u - v).norm() < 1e-9;
}

}  // namespace

void check_ranges(const World& world, Findings& out) {
    const std::vector<Range> ranges = rigid_ranges(world);
    for (std::size_t i = 0; i < ranges.size(); ++i) {
        const Range& r = ranges[i];
        const char* unit = r.coordinate == KindCoordinate::about ? "rad" : "m";
        const std::string name = record::interaction_label(world, r.id);
        const double q = world.coordinate(r.id);
        const double beyond = std::max(r.min - q, q - r.max);
        if (beyond > limit::kOpen.doubtful)
            out.add(false, FindingKind::gap, {name}, beyond,
                    fmt::format("{} starts at {:.4g} {}, outside of its range {}; the first steps "
                                "close that with a blow: start inside",
                                record::interaction_in_words(world, r.id), q, unit, r.text()));
        // The angle of a hinge excludes full turns. Larger limits do not limit.
        constexpr double kTurn = std::numbers::pi, kNoEnd = 1e3;
        for (const double end : {r.min, r.max})
            if (r.coordinate == KindCoordinate::about && std::abs(end) > kTurn &&
                std::abs(end) < kNoEnd)
                out.add(
                    false, FindingKind::gap, {name}, end,
                    fmt::format("{} has an end at {:.4g} rad, but its angle is between -pi and pi, "
                                "so that this end has no effect; rotate the axes so that the range "
                                "is within these limits, or limit a drum or slide that it drives",
                                record::interaction_in_words(world, r.id), end));
        for (std::size_t k = i + 1; k < ranges.size(); ++k) {
            const Range& other = ranges[k];
            if (!same_coordinate(world, r, other)) continue;
            const double separation = std::max(r.min, other.min) - std::min(r.max, other.max);
            if (separation <= 0.0) continue;
            out.add(true, FindingKind::contradiction,
                    {name, record::interaction_label(world, other.id)}, separation,
                    fmt::format("{} and {} contradict each other: no value lies in {} and in {}",
                                record::interaction_in_words(world, r.id),
                                record::name_in_quotes(record::interaction_label(world, other.id)),
                                r.text(), other.text()));
        }
    }
}

void check_motor_friction(const World& world, Findings& out) {
    std::vector<InteractionId> motors, brakes;
    for (const InteractionId i : world.interactions()) {
        const KindInfo& kind = kind_info(world.interaction_def(i).kind);
        if (kind.is(kMotorKind)) motors.push_back(i);
        if (kind.is(kFrictionKind)) brakes.push_back(i);
    }
    for (const InteractionId m : motors)
        for (const InteractionId f : brakes) {
            const InteractionDef& motor = world.interaction_def(m);
            const InteractionDef& brake = world.interaction_def(f);
            const KindInfo &driven = kind_info(motor.kind), &brake_kind = kind_info(brake.kind);
            const auto bodies = [](const InteractionDef& d) {
                const auto [low, high] = std::minmax(d.body[0].index, d.body[1].index);
                return std::pair<std::int32_t, std::int32_t>(low, high);
            };
            if (driven.coordinate != brake_kind.coordinate || bodies(motor) != bodies(brake))
                continue;
            const double speed = motor.get("speed");
            if (speed == 0.0) continue;
            const double most = speed > 0.0 ? motor.get("force_max") : -motor.get("force_min");
            const double held = brake.get(brake_kind.params[0].name);
            if (held < most || most <= 0.0) continue;
            const char* unit = driven.coordinate == KindCoordinate::about ? "N m" : "N";
            out.add(
                false, FindingKind::motor,
                {record::interaction_label(world, {m}), record::interaction_label(world, {f})},
                held,
                fmt::format("{} has at most {}, but {} holds with {}: nothing moves until one of "
                            "them changes",
                            record::interaction_in_words(world, {m}), record::with_unit(most, unit),
                            record::name_in_quotes(record::interaction_label(world, {f})),
                            record::with_unit(held, unit)));
        }
}

namespace {

/// Return the bodies of an interaction in ascending order.
std::pair<std::int32_t, std::int32_t> body_pair(const InteractionDef& d) {
    const auto [low, high] = std::minmax(d.body[0].index, d.body[1].index);
    return {low, high};
}

/// Return the speed at which a motor changes the coordinate of a range of the same bodies and axis,
/// 0 if the axes differ [m/s or rad/s].
double speed_of_range(const World& world, const InteractionDef& motor,
                      const InteractionDef& range) {
    const auto axis = [&](const InteractionDef& d) {
        return Vec3(world.pose(d.body[0]).orientation * (d.frame[0] * Vec3::UnitZ()));
    };
    const double cosine = axis(motor).dot(axis(range));
    if (std::abs(cosine) < 1.0 - 1e-9) return 0.0;
    const bool swapped = motor.body[0].index != range.body[0].index;
    return ((cosine > 0.0) != swapped ? 1.0 : -1.0) * motor.get("speed");
}

}  // namespace

void check_motor_ranges(const World& world, Findings& out) {
    constexpr double kUnlimited = 1e30;
    for (const Range& r : rigid_ranges(world)) {
        const InteractionDef& range = world.interaction_def(r.id);
        const double q = world.coordinate(r.id);
        for (const InteractionId m : world.interactions()) {
            const InteractionDef& motor = world.interaction_def(m);
            const KindInfo& kind = kind_info(motor.kind);
            if (!kind.is(kMotorKind) || kind.bodies != 2 || kind.coordinate != r.coordinate ||
                body_pair(motor) != body_pair(range))
                continue;
            const double most =
                motor.get("speed") > 0.0 ? motor.get("force_max") : -motor.get("force_min");
            const double speed = speed_of_range(world, motor, range);
            const double time =
                speed == 0.0 ? HUGE_VAL : ((speed > 0.0 ? r.max : r.min) - q) / speed;
            // An hour is longer than any motion towards an end that is meant.
            constexpr double kMaxTimeToEnd = 3600.0;
            if (most < kUnlimited || !(time >= 0.0 && time < kMaxTimeToEnd)) continue;
            out.add(
                false, FindingKind::motor,
                {record::interaction_label(world, m), record::interaction_label(world, r.id)}, time,
                fmt::format("{} has no limit of force and reaches the end of {} after {:.3g} s; "
                            "the run then fails: give it `force_min` and `force_max`, or "
                            "another speed",
                            record::interaction_in_words(world, m),
                            record::name_in_quotes(record::interaction_label(world, r.id)), time));
        }
    }
}

}  // namespace hawser::report::start
