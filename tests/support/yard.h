// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file yard.h
/// A world with shapes, made by short calls, and checks that hold for every world.

#include <hawser/world.h>

#include <string>

namespace hawser::test {

/// Return the inertia of a solid box of uniform density [kg m²].
[[nodiscard]] Mat3 box_inertia(double mass, const Vec3& half_size);

struct Yard {
    World world;
    MaterialId material{};  ///< Material of shapes added later.

    explicit Yard(const WorldDef& def = {}) : world(def) {}

    /// Set the material of shapes added later.
    void use(const MaterialDef& def);
    void friction(double mu);

    BodyId fixed(const Vec3& at = Vec3::Zero());
    /// Add a body with the inertia of a box, without shapes.
    BodyId body(const Vec3& at, double mass, const Vec3& half_size,
                const Quat& turn = Quat::Identity());
    BodyId lump(const Vec3& at, double mass);

    void plane(BodyId on);
    void add(ShapeDef shape, BodyId on);
    /// Add a body with a shape.
    BodyId box(const Vec3& at, double mass, const Vec3& half_size,
               const Quat& turn = Quat::Identity());
    BodyId ball(const Vec3& at, double mass, double radius);
    /// Add a body with a shape of a kind that may move, of about this half size.
    BodyId any(ShapeKind kind, const Vec3& at, double mass, double half_size);
    void segment(BodyId a, BodyId b, double radius);

    int names = 0;  ///< Number of materials.
};

/// Return a shape of a kind that may move, of about this half size.
[[nodiscard]] ShapeDef shape_of(ShapeKind kind, double half_size);

/// Return the name of the first value that is not finite, of poses, velocities, energy, contacts
/// and statistics; "" if all are finite.
[[nodiscard]] std::string not_finite(const World& world);

/// Return the largest speed of a body [m/s].
[[nodiscard]] double fastest(const World& world);

}  // namespace hawser::test
