// SPDX-License-Identifier: Apache-2.0
#include "support/degenerate/cases.h"

#include <cmath>
#include <string>

namespace hawser::test {
namespace {

void floor_under(Yard& y) { y.plane(y.fixed()); }

}  // namespace

Cases weightless() {
    Cases all;
    WorldDef def;
    def.gravity.setZero();
    all.push_back({"no_normal_force",
                   [](Yard& y) {
                       floor_under(y);
                       y.box({0, 0, 0.5}, 1.0, {0.5, 0.5, 0.5});
                   },
                   1e-9,
                   60,
                   {},
                   def});
    all.push_back({"pushed_without_normal_force",
                   [](Yard& y) {
                       floor_under(y);
                       const BodyId b = y.box({0, 0, 0.5}, 1.0, {0.5, 0.5, 0.5});
                       y.world.set_force(b, {10.0, 0, 0}, {0, 0, 0});
                   },
                   10.5,
                   60,
                   {},
                   def});
    all.push_back({"at_rest_for_ever",
                   [](Yard& y) {
                       for (const ShapeKind k : kMoving) y.any(k, {0, 0, 0}, 1.0, 0.5);
                   },
                   kWhatever,
                   60,
                   {},
                   def});
    return all;
}

Cases frictions() {
    Cases all;
    for (const double mu : {0.0, 100.0}) {
        const std::string tag = mu == 0.0 ? "_0" : "_100";
        all.push_back({"slope_of_friction" + tag,
                       [mu](Yard& y) {
                           y.friction(mu);
                           BodyDef slope;
                           slope.kind = BodyKind::fixed;
                           slope.orientation = Quat(std::cos(0.3), 0, std::sin(0.3), 0);
                           y.plane(y.world.add_body(slope));
                           const Vec3 up = slope.orientation * Vec3(0, 0, 0.5);
                           y.box(up, 1.0, {0.5, 0.5, 0.5}, slope.orientation);
                           y.ball(up + Vec3(0, 3, 0), 1.0, 0.5);
                       },
                       12.0});
        all.push_back({"wedged_with_friction" + tag,
                       [mu](Yard& y) {
                           y.friction(mu);
                           for (const double side : {-1.0, 1.0}) {
                               BodyDef wall;
                               wall.kind = BodyKind::fixed;
                               const double half = 0.5 * side * 1.4;
                               wall.orientation = Quat(std::cos(half), 0, std::sin(half), 0);
                               y.plane(y.world.add_body(wall));
                           }
                           y.ball({0, 0, 1.0}, 1.0, 0.3);
                           const BodyId b = y.box({0, 3, 1.5}, 10.0, {0.2, 0.2, 1.0});
                           y.world.set_velocity(b, {{0, 0, -50.0}, {1, 2, 3}});
                       },
                       80.0});
        all.push_back({"thrown_at_friction" + tag,
                       [mu](Yard& y) {
                           y.friction(mu);
                           floor_under(y);
                           for (const ShapeKind k : kMoving) {
                               const BodyId b =
                                   y.any(k, {0, 3.0 * static_cast<int>(k), 0.6}, 1.0, 0.5);
                               y.world.set_velocity(b, {{200.0, 0, -100.0}, {0, 300.0, 0}});
                           }
                       },
                       400.0});
    }
    return all;
}

Cases teleported() {
    Cases all;
    for (const ShapeKind k : kMoving)
        all.push_back({std::string("teleported_") + to_string(k),
                       [k](Yard& y) {
                           floor_under(y);
                           y.box({0, 0, 1.0}, 1e3, {1, 1, 1});
                           y.any(k, {0, 0, 5.0}, 1.0, 0.4);
                       },
                       kWhatever, 60,
                       [](World& w, int step) {
                           const double s = 0.01 * step;
                           w.set_pose(BodyId{2}, {w.pose(BodyId{1}).position + Vec3(s, -s, 0.5 * s),
                                                  Quat::Identity()});
                       }});
    all.push_back({"teleported_below_the_floor",
                   [](Yard& y) {
                       floor_under(y);
                       y.box({0, 0, 1.0}, 1.0, {1, 1, 1});
                   },
                   kWhatever, 60,
                   [](World& w, int step) {
                       if (step % 3 == 0)
                           w.set_pose(BodyId{1}, {{0, 0, -100.0 * step}, Quat::Identity()});
                   }});
    all.push_back({"teleported_to_the_end_of_the_world",
                   [](Yard& y) {
                       floor_under(y);
                       y.box({0, 0, 1.0}, 1.0, {1, 1, 1});
                       y.ball({5, 0, 1.0}, 1.0, 1.0);
                   },
                   kWhatever, 30,
                   [](World& w, int step) {
                       const double far =
                           std::pow(10.0, std::min(step, 7));  // up to the largest distance
                       w.set_pose(BodyId{1}, {{far, -far, 0.5}, Quat::Identity()});
                       if (step > 10) w.set_pose(BodyId{2}, {{far, -far, -far}, Quat::Identity()});
                   }});
    return all;
}

Cases fast() {
    Cases all;
    for (const ShapeKind k : kMoving)
        for (const double spin : {1e3, 1e5})
            all.push_back({std::string("spinning_") + to_string(k) + (spin > 1e4 ? "_1e5" : "_1e3"),
                           [k, spin](Yard& y) {
                               floor_under(y);
                               for (int i = 0; i < 3; ++i) {
                                   const BodyId b = y.any(k, {4.0 * i, 0, 0.5}, 1.0, 0.5);
                                   Vec3 w = Vec3::Constant(1.0);
                                   w[i] = spin;
                                   y.world.set_velocity(b, {{0, 0, 0}, w});
                               }
                               y.any(k, {0, 0, 1.5}, 1.0, 0.5);
                           }});
    all.push_back({"bullet", [](Yard& y) {
                       floor_under(y);
                       y.box({0, 0, 1.0}, 1.0, {0.01, 1.0, 1.0});
                       const BodyId b = y.ball({-100, 0, 1.0}, 1e-3, 0.01);
                       y.world.set_velocity(b, {{1e5, 0, 0}, {0, 0, 0}});
                       const BodyId c = y.box({100, 0, 1e3}, 1e6, {0.5, 0.5, 0.5});
                       y.world.set_velocity(c, {{0, 0, -1e5}, {0, 0, 0}});
                   }});
    return all;
}

Cases materials() {
    Cases all;
    for (const double stiffness : {1.0, 1e12})
        for (const double damping : {0.0, 1e3})
            for (const double tangential : {0.01, 10.0})
                for (const double e : {0.0, 1.0}) {
                    MaterialDef m;
                    m.stiffness = stiffness;
                    m.damping_time = damping;
                    m.tangential = tangential;
                    m.restitution = e;
                    m.friction = 100.0;
                    all.push_back({"material_" + std::to_string(all.size()), [m](Yard& y) {
                                       y.use(m);
                                       floor_under(y);
                                       y.box({0, 0, 0.45}, 1.0, {0.5, 0.5, 0.5});
                                       y.box({0.3, 0, 2.0}, 1e3, {0.5, 0.5, 0.5});
                                       const BodyId b = y.ball({5, 0, 2.0}, 1.0, 0.5);
                                       y.world.set_velocity(b, {{1, 2, -30}, {5, 6, 7}});
                                   }});
                }
    return all;
}

Cases steps_and_gravity() {
    Cases all;
    for (const double h : {1e-7, 1.0})
        for (const double g : {0.0, 1e4}) {
            WorldDef def;
            def.step = h;
            def.gravity = {0, 0, -g};
            all.push_back({"step_" + std::to_string(all.size()),
                           [](Yard& y) {
                               floor_under(y);
                               for (const ShapeKind k : kMoving)
                                   y.any(k, {0, 1.5 * static_cast<int>(k), 0.49}, 1.0, 0.5);
                           },
                           kWhatever,
                           30,
                           {},
                           def});
        }
    return all;
}

}  // namespace hawser::test
