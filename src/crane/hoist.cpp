// SPDX-License-Identifier: Apache-2.0
/// Build the reeving of a hoist.
///
/// ```
///   drum ──▸ head 1       head 2        head 3         each sheave of the head turns the
///            │   ▴────────╯ │  ▴────────╯ │            line about +y: the line runs down in
///            ▾   │          ▾  │          ▾            front, under a sheave of the hook, up
///            hook 1        hook 2        dead end      behind, and over the next head sheave
/// ```
/// Even numbers of falls end at the head, odd ones at the hook. Sheaves of one block have a
/// common axis along y.
///
/// A sheave of the hook is modelled by two eyes at a distance of one diameter, each with the square
/// root of its efficiency. The tensions at both sides are those of a sheave, for any orientation of
/// the block. A wheel would require an axis almost perpendicular to the falls
/// (model/kinds/routes.h), but a slack hook tips over.
#include "crane/builder.h"

#include <cmath>

namespace hawser::crane {
namespace {

/// Distance of adjacent sheaves over their radius: two ropes of R/10.
constexpr double kSheaveSeparation = 0.2;

}  // namespace

Link add_hoist(Builder& b, const Common& c, const Link& drum_on, const Link* over, const Link& head,
               double head_at) {
    const CraneTackle& t = c.hoist;
    const CraneHook& h = c.hook;
    const double r = t.sheave_radius;
    const Vec3 side = -b.raise_axis();  // y axis of the column
    // A single fall hangs ahead of the head's sheave, several falls on both sides of it.
    const Vec3 top = head.world({head_at, 0.0, 0.0}) + (t.falls == 1 ? r : 0.0) * b.ahead();
    Mat3 axes;
    axes.col(2) = b.vertical();
    axes.col(0) = b.ahead();
    axes.col(1) = axes.col(2).cross(axes.col(0));
    const Link hook =
        b.add_box("hook", h.mass, h.half_size, top - (h.hang + 0.5 * h.height) * b.vertical(),
                  Quat(axes), Vec3::Zero(), Vec3::Constant(h.angular_damping));
    const Vec3 axle{0.0, 0.0, 0.5 * h.height};

    RouteDef route;
    route.name = b.part_name("hoist");
    route.EA = t.EA;
    route.breaking_load = t.breaking_load;
    route.damping_time = t.damping_time;
    route.tension = h.mass * b.gravity().norm() / t.falls;
    route.first = {drum_on.id, drum_on.local(t.drum), b.add_drum("hoist", t), t.drum_radius};
    const auto wheel = [&](BodyId body, const Vec3& at) {
        RoutePlace p;
        p.body = body;
        p.point = at;
        p.radius = r;
        p.efficiency = t.efficiency;
        p.inertia = t.sheave_inertia;
        route.places.push_back(p);
    };
    if (over != nullptr) wheel(over->id, over->local({c.boom.length, 0.0, 0.0}));
    const int heads = head_sheaves(t.falls), hooks = hook_sheaves(t.falls);
    const auto across = [&](int i) {
        return (i - 0.5 * (heads - 1)) * kSheaveSeparation * r * Vec3::UnitY();
    };
    for (int i = 0; i < heads; ++i) {
        wheel(head.id, head.local(Vec3(head_at, 0.0, 0.0) + across(i)));
        if (i >= hooks) continue;
        for (const double to : {r, -r}) {
            RoutePlace eye;
            eye.body = hook.id;
            eye.point = axle + to * Vec3::UnitX() + across(i);
            eye.efficiency = std::sqrt(t.efficiency);
            route.places.push_back(eye);
        }
    }
    if (t.falls == 1) {
        route.last = {hook.id, axle};
    } else if (t.falls % 2 == 1) {
        route.last = {hook.id, axle + r * Vec3::UnitX() + across(heads - 1)};
    } else {
        const Vec3 behind =
            head.world({head_at, 0.0, 0.0}) - r * b.ahead() + across(heads - 1).y() * side;
        route.last = {head.id, head.of_world(behind)};
    }
    b.add_route(route);
    return hook;
}

void add_slings(Builder& b, const Common& c, const Link& hook) {
    if (c.take == 0) return;
    const CraneLoad& load = c.loads[static_cast<std::size_t>(c.take - 1)];
    const Vec3 own{0.0, 0.0, -0.5 * c.hook.height}, point = hook.world(own);
    const CraneBody body = b.find(load.body);
    for (std::size_t i = 0; i < load.eyes.size(); ++i) {
        const Vec3 eye = body.pose.position + body.pose.orientation * load.eyes[i];
        const double way = (eye - point).norm();
        if (way > load.sling_length + load.reach)
            throw_def_error(c.name, "take",
                            "an eye of the load is " + number(way) +
                                " m from the hook's point, and its " + "sling reaches " +
                                number(load.sling_length + load.reach) +
                                " m; attach it later, or move the hook nearer");
        b.add(sling_of(load, i, part(c.name, "sling") + std::to_string(i + 1), hook.id, own, way));
    }
}

}  // namespace hawser::crane
