// SPDX-License-Identifier: Apache-2.0
// Shapes and contacts in Bullet, equal for both of its solvers.
#if HAWSER_HAVE_BULLET
#include "bullet_common.h"

#include <cmath>

namespace hawser::bench {
namespace {

constexpr int kFloorGroup = 1, kBodyGroup = 2;

}  // namespace

std::unique_ptr<btCollisionShape> bullet_shape(const BodyShape& shape) {
    switch (shape.kind) {
        case BodyShape::Kind::none:
            return nullptr;
        case BodyShape::Kind::capsule:
            return std::make_unique<btCapsuleShapeX>(shape.radius, 2.0 * shape.half_length);
        case BodyShape::Kind::box:
            return std::make_unique<btBoxShape>(to_bullet(shape.half_size));
    }
    return nullptr;
}

BulletTouching::BulletTouching(const Scene& scene, btCollisionWorld& world, BulletParts& parts)
    : world_(world), parts_(parts), how_(*scene.touching), plane_(btVector3(0, 0, 1), how_.floor) {
    // By default a capsule on a plane gets one point per step; this requests both ends.
    parts.configuration.setPlaneConvexMultipointIterations(3, 3);
    floor_.setCollisionShape(&plane_);
    surface(floor_);
    world_.addCollisionObject(&floor_, kFloorGroup, kBodyGroup);
}

BulletTouching::~BulletTouching() { world_.removeCollisionObject(&floor_); }

int BulletTouching::mask() const { return how_.bodies ? kFloorGroup | kBodyGroup : kFloorGroup; }
int BulletTouching::group() const { return kBodyGroup; }

void BulletTouching::surface(btCollisionObject& object) const {
    object.setFriction(std::sqrt(how_.friction));  // Bullet multiplies the values of two surfaces
    object.setRestitution(0);
}

int BulletTouching::points() const {
    int n = 0;
    for (int i = 0; i < parts_.dispatcher.getNumManifolds(); ++i)
        n += parts_.dispatcher.getManifoldByIndexInternal(i)->getNumContacts();
    return n;
}

}  // namespace hawser::bench

#endif  // HAWSER_HAVE_BULLET
