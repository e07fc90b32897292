// SPDX-License-Identifier: Apache-2.0
#include "monitor/prepare_monitor.h"

#include "base/index.h"
#include "context/copies.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace hawser::monitor {
namespace {

/// Return the size of a rigid body: the edge of a cube with its mass and inertia [m]. It is
/// infinite for other bodies.
double size_of(const model::Bodies& b, std::int32_t body) noexcept {
    if (b.dof(body) != 6) return std::numeric_limits<double>::infinity();
    const double* s = &b.inertia[9 * at(body)];
    return std::sqrt(2.0 * (s[0] + s[4] + s[8]) / b.mass[at(body)]);
}

/// Return the factor that scales the gap of a joint row to its limit: 1 over the largest tolerated
/// gap [1/m, 1/rad]. @param size  Size of the smaller
/// body [m]. @param turns  True for a row of an angle.
double allowance(double size, bool turns) noexcept {
    const double arm = std::isfinite(size) ? 0.5 * size : 0.0;
    return (turns ? arm : 1.0) / (limit::kOpen.doubtful * std::max(1.0, 2.0 * arm));
}

}  // namespace

void prepare_monitors(const context::Model& model, context::State& state) {
    context::MonitorData& d = state.monitor;
    const model::Interactions& in = model.interactions;
    if (!state.edits.any) d.state = {};
    d.allowed.assign(at(context::user_rows(model)), 0.0);
    d.elastic.clear();
    d.line.clear();
    d.lines.clear();
    d.ranges.clear();
    d.range_allowed.clear();
    for (std::int32_t id = 0; id < context::interaction_count(model); ++id) {
        const KindInfo& kind = kind_info(in.kinds[at(id)]);
        if (in.rest_length[at(id)] > 0.0) d.lines.push_back(id);
        if (in.flags[at(id)] & model::kFriction) continue;  // counted as driven
        double size = std::numeric_limits<double>::infinity();
        for (int b = 0; b < in.bodies[at(id)]; ++b)
            size =
                std::min(size, size_of(model.bodies, in.body[at(kMaxInteractionBodies * id + b)]));
        bool soft = false;
        for (int r = 0; r < in.rows[at(id)]; ++r) {
            const auto row = at(in.row_begin[at(id)] + r);
            if (in.row_flags[row] & model::kRowVelocity) continue;
            const double length = in.rest_length[at(id)];
            const bool holds = model::holds_energy(in.epsilon[row], length);
            soft |= holds;
            const bool stiff =
                in.epsilon[row] <= limit::kMeantRigid && model::may_ever_complete(in, id);
            // Wire elements are checked by the cable law instead.
            if ((!stiff && holds) || length != 0.0 || (in.flags[at(id)] & model::kMotor)) continue;
            const double allowed = allowance(size, kind.row_units[r] == 'r');
            if (in.flags[at(id)] & model::kRange) {
                d.ranges.push_back(static_cast<std::int32_t>(row));
                d.range_allowed.push_back(allowed);
            } else {
                d.allowed[row] = allowed;
            }
        }
        if (!soft) continue;
        d.elastic.push_back(id);
        d.line.push_back(kind.is(kAlongLine) && !kind.is(kWoundUp));
    }
    // A new joint that is open has the tolerance of one that the scene opens.
    for (const std::int32_t id : state.edits.interactions) {
        const model::RowState now = in.row_state(id, model.bodies);
        for (int r = 0; r < in.rows[at(id)]; ++r) {
            const double open = std::fabs(now.g[r]) * d.allowed[at(in.row_begin[at(id)] + r)];
            if (open > 1.0) d.state.open_start = std::max(d.state.open_start, open);
        }
    }
    const auto most = static_cast<std::int32_t>(
        std::max({model.bodies.moving.size(), d.allowed.size(), d.elastic.size(), d.lines.size()}));
    d.part.resize(at(context::StepContext::chunks(most)));
    d.nothing = 0.0;
    // [m/s]: resting bodies without weight have only rounding errors
    constexpr double kAtRest = 1e-5;
    for (const std::int32_t b : model.bodies.moving) {
        d.nothing += 0.5 * model.bodies.mass[at(b)] * kAtRest * kAtRest;
        if (model.bodies.weight[at(b)])
            d.nothing +=
                limit::kNothingHigher * model.bodies.mass[at(b)] * model.def.gravity.norm();
    }
    // Sampling a small scene costs almost nothing.
    constexpr std::size_t kSmallScene = 128;
    const bool small = model.bodies.moving.size() + d.elastic.size() <= kSmallScene;
    d.every =
        small ? 1
              : static_cast<std::int32_t>(std::max(1.0, std::round(limit::kLook / model.def.step)));
}

}  // namespace hawser::monitor
