// SPDX-License-Identifier: Apache-2.0
#include "solve/wraps.h"

#include "base/index.h"

#include <algorithm>
#include <cmath>

namespace hawser::solve {
namespace {

constexpr double kTurn = 6.283185307179586;

bool has_direction(const context::Model& model, const FrictionLoad& load) noexcept {
    return load.interaction.valid() &&
           kind_info(model.interactions.kinds[at(load.interaction.index)]).uses_points;
}

}  // namespace

double wrap_angle(const context::Model& model, std::int32_t friction) noexcept {
    const model::Interactions& in = model.interactions;
    const model::Bodies& bodies = model.bodies;
    const InteractionDef& d = in.def[at(friction)];
    const double defined = d.params[3];
    if (!has_direction(model, d.load[0]) || !has_direction(model, d.load[1])) return defined;
    const std::int32_t before = d.load[0].interaction.index, behind = d.load[1].interaction.index;
    const model::LineShape shape = in.line_shape(before, bodies);
    const Vec3 u = shape.along, v = in.line_shape(behind, bodies).along;
    const Vec3 turn = u.cross(v);
    const InteractionDef& part = in.def[at(before)];
    const double wheel = shape.wheel[1];
    if (wheel == 0.0) return std::atan2(turn.norm(), u.dot(v));
    const auto body = at(part.body[1].index);
    Vec3 axis = part.frame[1] * Vec3::UnitZ();
    if (bodies.turns(part.body[1].index)) {
        using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
        axis = Eigen::Map<const RowMajor>(&bodies.r[9 * body]) * axis;
    }
    // Across the axis only.
    const double across = u.dot(v) - u.dot(axis) * v.dot(axis);
    const double about = std::atan2(turn.dot(axis), across) * (wheel > 0.0 ? 1.0 : -1.0);
    // The earlier angle, plus the change of the arc of each part on the wheel.
    const double lies = defined + in.wrapped(before, bodies)[1] + in.wrapped(behind, bodies)[0];
    return std::max(0.0, lies + std::remainder(about - lies, kTurn));
}

void note_wheels(const context::Model& model, context::Work& work) noexcept {
    const model::Interactions& in = model.interactions;
    for (std::size_t i = 0; i < in.spans.size(); ++i)
        work.wheel_angles[i] = in.wheel_angles(in.spans[i], model.bodies);
}

void follow_wheels(context::Model& model, const context::Work& work) noexcept {
    model::Interactions& in = model.interactions;
    for (std::size_t i = 0; i < in.spans.size(); ++i)
        in.update_whole_turns(in.spans[i], work.wheel_angles[i], model.bodies);
}

void follow_wraps(context::Model& model) noexcept {
    model::Interactions& in = model.interactions;
    for (const std::int32_t id : in.frictions) {
        if (!kind_info(in.kinds[at(id)]).is(kFollowsAngle) || in.load_begin[at(id)] < 0) continue;
        const InteractionDef& d = in.def[at(id)];
        const double exponent = d.params[1] * wrap_angle(model, id) - std::log(d.params[2]);
        for (std::size_t k = 0; k < kMaxFrictionLoads; ++k)
            in.loads[at(in.load_begin[at(id)]) + k].factor = std::tanh(0.5 * exponent);
    }
}

}  // namespace hawser::solve
