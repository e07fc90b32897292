// SPDX-License-Identifier: Apache-2.0
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

/// Coordinates are written with six decimals and chains of them add up; a gap this small closes in
/// two steps without anyone noticing. Of the reach of the joint; of an angle [rad].
constexpr double kOpen = 1e-4, kTurned = 1e-3;

/// A speed that a joint takes away in the first step: what gravity gives in a hundredth of a second
/// [m/s].
constexpr double kTearing = 0.1;

bool is_angle(const KindInfo& kind, int row) { return kind.row_units[row] == 'r'; }

struct Worst {
    double length = 0.0, angle = 0.0;
};

Worst worst_of(const World& world, const Joint& joint, const std::vector<double>& values) {
    const KindInfo& kind = kind_info(world.interaction_def(joint.id).kind);
    Worst worst;
    for (std::int32_t k = 0; k < joint.rows; ++k) {
        const double g = std::abs(values[static_cast<std::size_t>(joint.row_begin + k)]);
        double& most =
            is_angle(kind, joint.row[static_cast<std::size_t>(k)]) ? worst.angle : worst.length;
        most = std::max(most, g);
    }
    return worst;
}

}  // namespace

double reach(const Joint& joint) { return std::max(0.1, joint.size); }

void check_gaps(const World& world, const JointRows& rows, Findings& out) {
    for (const Joint& joint : rows.joints()) {
        if (joint.motor) continue;
        const std::string name = record::interaction_label(world, joint.id);
        const Worst gap = worst_of(world, joint, rows.violations());
        if (gap.length > kOpen * reach(joint) || gap.angle > kTurned) {
            const bool open = gap.length > kOpen * reach(joint);
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
        const Worst speed = worst_of(world, joint, rows.rates());
        const double turning = speed.angle * reach(joint);
        if (std::max(speed.length, turning) > kTearing)
            out.add(false, FindingKind::speed, {name}, std::max(speed.length, turning),
                    fmt::format("{} starts with speeds that tear it at {}; the first step takes "
                                "them away with a blow: give its bodies velocities that fit",
                                record::interaction_in_words(world, joint.id),
                                record::with_unit(std::max(speed.length, turning), "m/s")));
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
            const KindInfo &driven = kind_info(motor.kind), &held_by = kind_info(brake.kind);
            const auto bodies = [](const InteractionDef& d) {
                const auto [low, high] = std::minmax(d.body[0].index, d.body[1].index);
                return std::pair<std::int32_t, std::int32_t>(low, high);
            };
            if (driven.coordinate != held_by.coordinate || bodies(motor) != bodies(brake)) continue;
            const double speed = motor.get("speed");
            if (speed == 0.0) continue;
            const double most = speed > 0.0 ? motor.get("force_max") : -motor.get("force_min");
            const double held = brake.get(held_by.params[0].name);
            if (held < most || most <= 0.0) continue;
            const char* unit = driven.coordinate == KindCoordinate::about ? "N m" : "N";
            out.add(
                false, FindingKind::motor,
                {record::interaction_label(world, {m}), record::interaction_label(world, {f})},
                held,
                fmt::format("{} gives at most {}, and {} holds with {}: nothing will move "
                            "until one of them changes",
                            record::interaction_in_words(world, {m}), record::with_unit(most, unit),
                            record::name_in_quotes(record::interaction_label(world, {f})),
                            record::with_unit(held, unit)));
        }
}

}  // namespace hawser::report::start
