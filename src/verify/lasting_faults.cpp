// SPDX-License-Identifier: Apache-2.0
#include "verify/lasting_faults.h"

#include <hawser/limits.h>

#include "record/scene_info.h"
#include "record/units.h"
#include "verify/attached.h"
#include "verify/joint_gap.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hawser::verify {
namespace {

/// A coordinate beyond a limit returns by 4/9 of its excess in a step.
constexpr int kMaxSteps = 6;

/// Return the angle or travel of frame 1 relative to frame 0, about or along z of frame 0.
double coordinate(const World& world, InteractionId id, std::span<const Pose> pose) {
    const Attached at(world, id, pose);
    if (world.interaction_def(id).kind == InteractionKind::SlideRange)
        return (at.point(1) - at.point(0)).dot(at.axis(0, 2));
    return std::atan2(at.axis(1, 0).dot(at.axis(0, 1)), at.axis(1, 0).dot(at.axis(0, 0)));
}

/// Return the thickness of a shape [m]. An object that is deeper emerges on the other side.
/// Infinite for shapes other than spheres, boxes and cylinders.
double shape_thickness(const ShapeDef& s) {
    if (s.body_b.valid()) return HUGE_VAL;
    switch (s.kind) {
        case ShapeKind::sphere:
            return 2.0 * s.radius;
        case ShapeKind::box:
            return 2.0 * s.half_size.minCoeff();
        case ShapeKind::cylinder:
            return 2.0 * std::min(s.radius, s.half_length);
        default:
            return HUGE_VAL;
    }
}

}  // namespace

std::string LastingFaults::after_step(const World& world, std::span<const Pose> pose) {
    std::string fault = check_ranges(world, pose);
    std::string other = check_depths(world);
    return fault.empty() ? other : fault;
}

std::string LastingFaults::check_ranges(const World& world, std::span<const Pose> pose) {
    double worst = 1.0, by = 0.0;
    InteractionId where{};
    for (const InteractionId id : world.interactions()) {
        const InteractionDef& def = world.interaction_def(id);
        const bool hinge = def.kind == InteractionKind::HingeRange;
        if (!hinge && def.kind != InteractionKind::SlideRange) continue;
        if (def.compliance[0] > limit::kMeantRigid || !world.intact(id)) continue;
        const double q = coordinate(world, id, pose), size = joint_size(world, id);
        const double beyond = std::max({0.0, def.get("min") - q, q - def.get("max")});
        const double part =
            (hinge ? 0.5 * size : 1.0) * beyond / (limit::kOpen.wrong * std::max(1.0, size));
        if (part <= worst) continue;
        worst = part;
        by = beyond;
        where = id;
    }
    steps_beyond_ = where.valid() ? steps_beyond_ + 1 : 0;
    if (steps_beyond_ <= kMaxSteps) return {};
    return fmt::format(
        "'{}' has been beyond its range for {} steps, now by {:.4g} {}",
        record::interaction_label(world, where), steps_beyond_, by,
        world.interaction_def(where).kind == InteractionKind::HingeRange ? "rad" : "m");
}

std::string LastingFaults::check_depths(const World& world) {
    double worst = limit::kDeep.wrong;
    const ContactView* where = nullptr;
    const auto contacts = world.contacts();
    for (const ContactView& c : contacts) {
        if (c.asleep) continue;
        const double deep = -c.gap / std::min(shape_thickness(world.shape_def(c.shape[0])),
                                              shape_thickness(world.shape_def(c.shape[1])));
        if (deep <= worst) continue;
        worst = deep;
        where = &c;
    }
    deep_ = where != nullptr ? deep_ + 1 : 0;
    if (deep_ <= kMaxSteps) return {};
    return fmt::format("'{}' and '{}' have lain in each other for {} steps, now by {}",
                       record::body_label(world, world.shape_def(where->shape[0]).body),
                       record::body_label(world, world.shape_def(where->shape[1]).body), deep_,
                       record::with_unit(-where->gap, "m"));
}

}  // namespace hawser::verify
