// SPDX-License-Identifier: Apache-2.0
#include "support/degenerate/cases.h"

#include <cmath>
#include <string>

namespace hawser::test {
namespace {

void add_floor(Yard& y) { y.plane(y.fixed()); }

}  // namespace

Cases coincident() {
    Cases all;
    for (const ShapeKind a : kMoving)
        for (const ShapeKind b : kMoving)
            all.push_back(
                {std::string("coincident_") + to_string(a) + "_" + to_string(b), [a, b](Yard& y) {
                     add_floor(y);
                     for (int i = 0; i < 2; ++i) {
                         y.any(a, {0, 0, 0.5}, 1.0, 0.5);
                         y.any(b, {0, 0, 0.5}, 2.0, 0.5);
                     }
                 }});
    return all;
}

Cases faces() {
    return {
        {"zero_gap",
         [](Yard& y) {
             add_floor(y);
             for (int i = 0; i < 4; ++i) y.box({0, 0, 0.5 + i}, 1.0, {0.5, 0.5, 0.5});
         },
         0.2},
        {"redundant_shapes",  // ten faces of four points at one position
         [](Yard& y) {
             add_floor(y);
             const BodyId b = y.body({0, 0, 0.5}, 1.0, {0.5, 0.5, 0.5});
             for (int i = 0; i < 10; ++i) y.add(shape_of(ShapeKind::box, 0.5), b);
         },
         0.2},
        {"between_two_planes",  // fixed planes, 1 mm too close
         [](Yard& y) {
             add_floor(y);
             const BodyId lid = y.fixed({0, 0, 0.999});
             ShapeDef d;
             d.kind = ShapeKind::plane;
             d.orientation = Quat(0, 1, 0, 0);
             y.add(d, lid);
             y.box({0, 0, 0.4995}, 1.0, {0.5, 0.5, 0.5});
         },
         1.0},
        {"crushed",  // a plane that moves down at 1 m/s, to 0.1 m below the floor
         [](Yard& y) {
             add_floor(y);
             BodyDef press;
             press.kind = BodyKind::kinematic;
             press.position = {0, 0, 1.1};
             press.velocity = {0, 0, -1.0};
             const BodyId p = y.world.add_body(press);
             ShapeDef d;
             d.kind = ShapeKind::plane;
             d.orientation = Quat(0, 1, 0, 0);
             y.add(d, p);
             y.box({0, 0, 0.5}, 1.0, {0.5, 0.5, 0.5});
             y.ball({3, 0, 0.5}, 1.0, 0.5);
         },
         kWhatever, 72},
        {"edge_on_edge",
         [](Yard& y) {
             const BodyId below = y.fixed();
             y.add(shape_of(ShapeKind::box, 0.5), below);
             y.box({1.0, 0.0, 1.0}, 1.0, {0.5, 0.5, 0.5});
             y.box({0.0, 1.0, 0.0}, 1.0, {0.5, 0.5, 0.5});
             y.box({-1.0, -1.0, 1.0}, 1.0, {0.5, 0.5, 0.5});
         },
         20.0},
    };
}

Cases ratios() {
    Cases all;
    for (const double heavy : {1e-6, 1e6})
        all.push_back({heavy < 1.0 ? "heavy_below_light" : "light_below_heavy",
                       [heavy](Yard& y) {
                           add_floor(y);
                           y.box({0, 0, 0.5}, 1.0, {0.5, 0.5, 0.5});
                           y.box({0, 0, 1.5}, heavy, {0.5, 0.5, 0.5});
                           y.box({0, 0, 2.5}, 1.0, {0.5, 0.5, 0.5});
                       },
                       1.0});
    // Moments of inertia with ratios of up to 1e12, the limit of a body. Not all of their steps are
    // solved (the smallest moment is 1e-18 kg m²), and the residual moves them.
    for (const double thin : {1e-3, 1e-6})
        for (const double mass : {1e-6, 1.0, 1e6})
            all.push_back({"needle_of_" + std::to_string(static_cast<int>(1e6 * thin)) + "um_" +
                               std::to_string(static_cast<int>(std::log10(mass))),
                           [thin, mass](Yard& y) {
                               add_floor(y);
                               y.box({0, 0, 1.1}, mass, {thin, thin, 1.0},
                                     Quat(0.99, 0.1, 0, 0).normalized());
                               y.box({3, 0, 0.2}, 1.0, {thin, 1.0, thin});
                               y.box({3, 0, 0.3}, mass, {1.0, thin, thin});
                           },
                           thin < 1e-4 ? kWhatever : 20.0, 120});
    return all;
}

Cases sizes() {
    Cases all;
    for (const ShapeKind k : kMoving)
        for (const double size : {1e-6, 1e-3, 1e5})
            for (const double mass : {1e-9, 1.0, 1e9}) {
                all.push_back({std::string("size_") + to_string(k) + "_" +
                                   std::to_string(static_cast<int>(std::log10(size))) + "_" +
                                   std::to_string(static_cast<int>(std::log10(mass))),
                               [k, size, mass](Yard& y) {
                                   add_floor(y);
                                   y.any(k, {0, 0, size}, mass, size);
                                   y.any(k, {0, 0, 3.0 * size}, mass, size);
                                   y.box({0, 0, 5.0 * size}, 1.0, Vec3::Constant(size));
                               },
                               kWhatever, 30});
            }
    return all;
}

Cases features() {
    return {
        {"segment_without_length",
         [](Yard& y) {
             add_floor(y);
             const BodyId a = y.lump({0, 0, 0.05}, 1.0), b = y.lump({0, 0, 0.05}, 1.0);
             const BodyId c = y.lump({1, 0, 0.05}, 1.0);
             y.segment(a, b, 0.05);
             y.segment(b, c, 0.05);
             const BodyId d = y.lump({0, 0, 0.05}, 1.0), e = y.lump({1, 0, 0.05}, 1.0);
             y.segment(d, e, 0.05);
         }},
        {"mesh_of_slivers",
         [](Yard& y) {
             ShapeDef d;
             d.kind = ShapeKind::mesh;
             d.vertices = {{-1, 0, 0}, {1, 0, 0}, {1, 1e-8, 0}, {0, 1, 0}, {0, 1, 1e-8}};
             d.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 3}, {1, 4, 2}};
             y.add(d, y.fixed());
             for (const ShapeKind k : kMoving) y.any(k, {0, 0, 0.3}, 1.0, 0.3);
         }},
        {"flat_hull",
         [](Yard& y) {
             add_floor(y);
             ShapeDef d;
             d.kind = ShapeKind::hull;
             for (int i = 0; i < 8; ++i)
                 d.vertices.push_back(
                     {i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 2e-6 : -2e-6});
             y.add(d, y.body({0, 0, 1e-5}, 1.0, {0.5, 0.5, 0.01}));
             y.any(ShapeKind::hull, {0, 0, 0.5}, 1.0, 0.5);
         }},
        {"thin_box",
         [](Yard& y) {
             add_floor(y);
             y.box({0, 0, 1e-9}, 1.0, {1.0, 1.0, 1e-9});
             y.ball({0, 0, 0.5}, 1.0, 0.5);
             y.box({0, 0, 1.0}, 1.0, {1e-9, 1.0, 1.0});
         }},
        {"flat_heightfield",
         [](Yard& y) {
             ShapeDef d;
             d.kind = ShapeKind::heightfield;
             d.rows = d.columns = 3;
             d.cell = {1e-3, 1e3};
             d.heights.assign(9, 0.0);
             y.add(d, y.fixed());
             for (const ShapeKind k : kMoving)
                 y.any(k, {0, 3.0 * static_cast<int>(k), 0.3}, 1.0, 0.3);
         }},
    };
}

}  // namespace hawser::test
