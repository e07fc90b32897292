// SPDX-License-Identifier: Apache-2.0
/// What a client reads of a world.
#include <hawser/world.h>

namespace hawser {

Vec3 World::local_point(BodyId id, const Vec3& point) const {
    const Pose p = pose(id);
    return p.orientation.conjugate() * (point - p.position);
}

}  // namespace hawser
