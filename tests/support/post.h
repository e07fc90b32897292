// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file post.h
/// Two weights on a line over a bollard.

#include <hawser/hawser.h>
#include <hawser/route.h>

#include <cmath>
#include <numbers>

namespace hawser::test {

/// The second weight is a fraction `share` of the one that friction can hold against the first one,
/// with a given number of touching points and turns around the bollard.
struct Post {
    static constexpr double kRub = 0.3, kLight = 50.0;
    World w;
    BodyId post{}, first{}, second{};
    Route line;
    double ratio;

    Post(int places, double turns, double share, const WorldDef& world = {},
         double damping_time = 0.02)
        : w(world), ratio(std::exp(kRub * 2.0 * std::numbers::pi * turns)) {
        post = w.add_body({.name = "post", .kind = BodyKind::fixed});
        const auto weight = [&](const char* name, double x, double mass) {
            return w.add_body(
                {.name = name, .kind = BodyKind::lump, .position = {x, 0, -5.0}, .mass = mass});
        };
        first = weight("light", -0.5, kLight);
        second = weight("heavy", 0.5, kLight * share * ratio);
        RouteDef def{.name = "line",
                     .EA = 2.33e8,
                     .first = {.body = first},
                     .last = {.body = second},
                     .tension = kLight * 9.81,
                     .damping_time = damping_time};
        for (int i = 0; i < places; ++i) {
            const double s = places == 1 ? 0.5 : static_cast<double>(i) / (places - 1);
            def.places.push_back(
                {.body = post,
                 .point = {s - 0.5, 0, places == 1 ? 0.0 : 0.3 * std::sin(std::numbers::pi * s)},
                 .radius = places == 1 ? 0.5 : 0.0,
                 .friction = kRub,
                 .turns = places == 1 ? static_cast<int>(turns) : 0,
                 .angle = 2.0 * std::numbers::pi * turns / places});
        }
        line = w.add(def);
    }
    [[nodiscard]] double slid() const { return w.pose(line.slides.front()).position.x(); }
    [[nodiscard]] double tensions() const {
        return w.force(line.parts.back())[0] / w.force(line.parts.front())[0];
    }
};

}  // namespace hawser::test
