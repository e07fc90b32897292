// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file yard.h
/// A world with shapes, made by short calls; and its invariants.

#include <hawser/world.h>

#include <string>

namespace hawser::test {

/// Inertia of a solid box of uniform density [kg m²].
[[nodiscard]] Mat3 box_inertia(double mass, const Vec3& half_size);

struct Yard {
    World world;
    MaterialId material{};  ///< Material of shapes added from here on.

    explicit Yard(const WorldDef& def = {}) : world(def) {}

    /// Shapes from now on have these values.
    void use(const MaterialDef& def);
    void friction(double mu);

    BodyId fixed(const Vec3& at = Vec3::Zero());
    /// A body of the inertia of a box, without shapes.
    BodyId body(const Vec3& at, double mass, const Vec3& half_size,
                const Quat& turn = Quat::Identity());
    BodyId lump(const Vec3& at, double mass);

    void plane(BodyId on);
    void add(ShapeDef shape, BodyId on);
    /// Body and shape in one.
    BodyId box(const Vec3& at, double mass, const Vec3& half_size,
               const Quat& turn = Quat::Identity());
    BodyId ball(const Vec3& at, double mass, double radius);
    /// One of each kind that may move, of about this half size.
    BodyId any(ShapeKind kind, const Vec3& at, double mass, double half_size);
    void segment(BodyId a, BodyId b, double radius);

    int names = 0;  ///< Materials so far.
};

/// A shape of a kind that may move, of about this half size.
[[nodiscard]] ShapeDef shape_of(ShapeKind kind, double half_size);

/// Return the name of the first value that is not finite among poses, velocities, energy, contacts
/// and figures; "" if all are finite.
[[nodiscard]] std::string not_finite(const World& world);

/// Greatest speed of a body [m/s].
[[nodiscard]] double fastest(const World& world);

}  // namespace hawser::test
