// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file cases.h
/// Degenerate worlds through the public interface.

#include "support/yard.h"

#include <functional>
#include <string>
#include <vector>

namespace hawser::test {

inline constexpr ShapeKind kMoving[] = {ShapeKind::sphere, ShapeKind::capsule, ShapeKind::box,
                                        ShapeKind::cylinder, ShapeKind::hull};
inline constexpr double kWhatever = 1e300;

struct Degenerate {
    std::string name;
    std::function<void(Yard&)> build;
    /// Largest plausible speed of a body's centre [m/s].
    double fastest = kWhatever;
    int steps = 60;
    std::function<void(World&, int)> before_step{};
    WorldDef def{};
};
using Cases = std::vector<Degenerate>;

// Shapes.
Cases coincident();  ///< Four bodies at one position, two each of two kinds.
Cases faces();       ///< Faces on faces: zero gap, redundant points, no free space.
Cases ratios();      ///< Masses and moments of inertia.
Cases sizes();       ///< 1e-6 m to 1e5 m.
Cases features();    ///< Segments of zero length, slivers, flat hulls.

// Motions.
Cases weightless();  ///< Contact without normal force.
Cases frictions();   ///< μ = 0 and 100.
Cases teleported();  ///< Moved into each other before every step.
Cases fast();        ///< Spinning, shot.
Cases materials();   ///< Ends of the ranges.
Cases steps_and_gravity();

}  // namespace hawser::test
