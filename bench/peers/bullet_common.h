// SPDX-License-Identifier: Apache-2.0
/// @file
/// Code shared by both Bullet runners. Include it before any other header of Bullet. The library
/// variant in use is the double-precision one (libBulletDynamics-float64): without
/// BT_USE_DOUBLE_PRECISION every structure of its headers has the wrong layout.
#pragma once

#ifndef BT_USE_DOUBLE_PRECISION
#define BT_USE_DOUBLE_PRECISION
#endif
#include "scenes.h"

#include <BulletCollision/CollisionDispatch/btSimulationIslandManager.h>
#include <btBulletCollisionCommon.h>
#include <btBulletDynamicsCommon.h>
#include <memory>

namespace hawser::bench {

inline btVector3 to_bullet(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
inline btQuaternion to_bullet(const Quat& q) { return {q.x(), q.y(), q.z(), q.w()}; }
inline Vec3 from_bullet(const btVector3& v) { return {v.x(), v.y(), v.z()}; }
inline Quat from_bullet(const btQuaternion& q) { return {q.w(), q.x(), q.y(), q.z()}; }

/// Objects that every Bullet world needs and that have no effect here.
struct BulletParts {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broadphase;
};

/// A Bullet world that detects contacts only if the scene has any.
template <class World>
class CollidesIfAsked : public World {
  public:
    using World::World;
    void performDiscreteCollisionDetection() override {
        if (collides) World::performDiscreteCollisionDetection();
    }
    bool collides = false;
};

/// Make the shape of a body, or null.
std::unique_ptr<btCollisionShape> bullet_shape(const BodyShape& shape);

/// Additions to a Bullet world for a scene with contacts: the floor, surfaces, collision groups.
class BulletTouching {
  public:
    /// Add them. @pre scene.touching
    BulletTouching(const Scene& scene, btCollisionWorld& world, BulletParts& parts);
    ~BulletTouching();
    BulletTouching(const BulletTouching&) = delete;
    BulletTouching& operator=(const BulletTouching&) = delete;

    /// Set the friction of an object.
    void surface(btCollisionObject& object) const;

    /// Return the collision group of bodies, and the groups that it touches.
    [[nodiscard]] int group() const;
    [[nodiscard]] int mask() const;

    /// Return the contact points of the last step.
    [[nodiscard]] int points() const;

  private:
    btCollisionWorld& world_;
    BulletParts& parts_;
    Touching how_;
    btStaticPlaneShape plane_;
    btCollisionObject floor_;
};

}  // namespace hawser::bench
