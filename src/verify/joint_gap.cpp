// SPDX-License-Identifier: Apache-2.0
#include "verify/joint_gap.h"

#include "verify/interaction_forces.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hawser::verify {

namespace {

double angle_between_axes(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace

JointGap joint_gap(const World& world, InteractionId id, std::span<const Pose> pose) {
    using enum InteractionKind;
    const InteractionDef& def = world.interaction_def(id);
    const bool joint = def.kind == Ball || def.kind == Hinge || def.kind == Prismatic ||
                       def.kind == Cylindrical || def.kind == Universal || def.kind == Lock;
    // An interaction softer than this is a spring or a mount [m/N].
    constexpr double kRigid = 1e-11;
    if ((!joint && def.kind != Distance) || !world.intact(id) || def.compliance[0] > kRigid)
        return {};
    const Attached at(world, id, pose);
    const Vec3 separation = at.point(1) - at.point(0);
    if (!joint) return {std::abs(separation.norm() - parameter(world, id, "length")), 0.0, true};
    JointGap gap{separation.norm(), 0.0, true};
    if (def.kind == Ball) return gap;
    const Vec3 p = at.axis(0, 2), q = at.axis(1, 2);
    if (def.kind == Prismatic || def.kind == Cylindrical)
        gap.separation = (separation - separation.dot(p) * p).norm();
    if (def.kind == Hinge || def.kind == Cylindrical) gap.turned = angle_between_axes(p, q);
    if (def.kind == Prismatic || def.kind == Lock)
        gap.turned = at.frame(0).angularDistance(at.frame(1));
    if (def.kind == Universal) gap.turned = std::abs(std::asin(std::clamp(p.dot(q), -1.0, 1.0)));
    return gap;
}

double joint_size(const World& world, InteractionId id) {
    const InteractionDef& def = world.interaction_def(id);
    double size = std::numeric_limits<double>::infinity();
    for (std::size_t b = 0; b < 2; ++b) {
        const BodyDef& body = world.body_def(def.body[b]);
        if (body.kind == BodyKind::rigid)
            size = std::min(size, std::sqrt(2.0 * body.inertia.trace() / body.mass));
    }
    return std::isfinite(size) ? size : 0.0;
}

}  // namespace hawser::verify
