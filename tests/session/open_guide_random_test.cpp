// SPDX-License-Identifier: Apache-2.0
/// Check rest length and momentum of a wire that leaves an open guide and comes back. Routes are
/// random, steps 1/240 s to 1/20 s.
#include <hawser/hawser.h>
#include <hawser/session.h>

#include "support/random.h"
#include "support/tier.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace hawser::test {
namespace {

constexpr double kMassPerLength = 25.0;  // [kg/m]
/// Tolerance relative to the length of the wire. The node of the lifted element hangs below its
/// chord by w l²/8T, which makes the path longer by 3e-5 m at 300 kN.
constexpr double kLengthKept = 1e-6;
/// Tolerance relative to the sum of |m v|. Parts have the mass of their rest length here, and of
/// their material in the guide. Node edits make the two differ by 1e-4.
constexpr double kMomentumKept = 1e-3;
/// A wire that bounces off once or twice is right; before, it bounced until the run failed.
constexpr int kMaxReturns = 4;

/// Rest length of a wire [m], its momentum and that of the deck under its guide [kg m/s].
struct WireSums {
    double length = 0.0;
    Vec3 momentum = Vec3::Zero();
    double moving = 0.0;  ///< Sum of |m v| of the nodes.
};

/// Sum up the nodes of a wire and the elements at its guide. Half of the mass of such an element
/// moves with its node, the other half runs over the wheel with the slide.
WireSums sums_of(const World& w, WireId wire) {
    WireSums out{.length = w.wires().length(wire)};
    const auto add = [&](double mass, const Vec3& v) {
        out.momentum += mass * v;
        out.moving += mass * v.norm();
    };
    for (const BodyId id : w.wires().nodes(wire))
        if (w.alive(id) && w.body_def(id).kind == BodyKind::lump)
            add(w.body_def(id).mass, w.velocity(id).linear);
    for (const InteractionId id : w.wires().elements(wire)) {
        const InteractionDef& d = w.interaction_def(id);
        if (!kind_info(d.kind).is(kAtGuide)) continue;
        const double turned = w.pose(d.body[2]).position.x() - d.get("drum_zero");
        const double half = 0.5 * kMassPerLength * (d.get("length") + d.get("radius") * turned);
        const std::array<Vec3, 2> ends = w.wires().ends(id);
        for (const BodyId far : {d.body[0], d.body[1]})
            if (w.body_def(far).kind == BodyKind::lump) add(half, w.velocity(far).linear);
        add(half, w.velocity(d.body[2]).linear.x() * (ends[1] - ends[0]).normalized());
    }
    const BodyId deck = w.find_body("deck");
    out.momentum += w.body_def(deck).mass * w.velocity(deck).linear;
    return out;
}

/// Reads the wire after the guide has edited it and before the step is taken.
class Watch final : public System {
  public:
    Watch(WireId wire, WireSums* out) : wire_(wire), out_(out) {}
    [[nodiscard]] std::string_view name() const noexcept override { return "watch"; }
    void prestep(Prestep& /*now*/, Loads& /*loads*/) noexcept override {}
    void before_step(NodeEdits& nodes) noexcept override { *out_ = sums_of(nodes.world, wire_); }
    [[nodiscard]] std::unique_ptr<System> clone() const override {
        return std::make_unique<Watch>(wire_, out_);
    }

  private:
    WireId wire_;
    WireSums* out_;
};

/// A wire from a bollard over a roller to a body that is pulled down, up and down again. The deck
/// is a body of 20,000 t on which the opposite of the pull acts.
struct RandomPull {
    double step, radius, pull, up, ramp;
    int elements;
    explicit RandomPull(std::uint32_t seed) {
        Random random(seed);
        constexpr std::array<double, 5> kSteps{1.0 / 240, 1.0 / 120, 1.0 / 60, 1.0 / 30, 1.0 / 20};
        step = kSteps[static_cast<std::size_t>(random.integer(0, 4))];
        radius = random.uniform(0.2, 0.8);
        elements = random.integer(12, 18);
        pull = random.uniform(0.3e6, 1.5e6);
        up = random.uniform(0.5, 1.2);
        ramp = random.uniform(4.0, 12.0);
    }
    [[nodiscard]] double end() const { return 4.0 * ramp + 15.0; }
    [[nodiscard]] double angle(double time) const {
        const auto moved = [&](double begin) {
            const double s = std::clamp((time - begin) / ramp, 0.0, 1.0);
            return s * s * (3.0 - 2.0 * s);
        };
        constexpr double kDown = -0.45;
        return kDown + (up - kDown) * (moved(5.0) - moved(5.0 + 2.0 * ramp));
    }
    [[nodiscard]] std::string scene() const {
        return fmt::format(
            R"({{"version": 1, "name": "over_roller", "settings": {{"step": {}, "duration": 90}},
        "line_types": {{"wire": {{"mass_per_length": 25, "EA": 3e8, "diameter": 0.076}}}},
        "bodies": [{{"name": "deck", "mass": 2e7, "gravity": false, "box": [60, 20, 10],
            "linear_damping": [1e9, 1e9, 1e9], "angular_damping": [1e13, 1e13, 1e13]}},
          {{"name": "end", "position": [42, 0, -20], "mass": 20000, "gravity": false,
            "box": [1, 1, 1], "linear_damping": [6e4, 6e4, 6e4],
            "angular_damping": [1e5, 1e5, 1e5]}}],
        "cables": [{{"name": "tow", "line_type": "wire", "from": {{"body": "deck",
          "point": [-30, 0, {}]}}, "to": {{"body": "end"}}, "shape": "path", "path": [[0, 0, {}]],
          "elements": {}, "consistent_mass": true}}],
        "guides": [{{"name": "roller", "cable": "tow", "on": "deck", "point": [0, 0, 0],
          "radius": {}, "closed": false}}],
        "inputs": [{{"name": "x", "body": "end", "component": "force_x", "min": -1e7, "max": 1e7}},
                   {{"name": "z", "body": "end", "component": "force_z", "min": -1e7, "max": 1e7}},
                   {{"name": "dx", "body": "deck", "component": "force_x", "min": -1e7,
                     "max": 1e7}},
                   {{"name": "dz", "body": "deck", "component": "force_z", "min": -1e7,
                     "max": 1e7}}]
        }})",
            step, radius, radius, elements, radius);
    }
};

void check_route(std::uint32_t seed) {
    const RandomPull route(seed);
    SCOPED_TRACE(fmt::format("HAWSER_SEED={}: step {:.5f}, radius {:.3f}, {} elements, {:.3g} N",
                             seed, route.step, route.radius, route.elements, route.pull));
    Session session({.scene_text = route.scene()});
    World& w = session.world();
    const WireId wire = w.wires().find("tow");
    WireSums after;
    w.add_system(std::make_unique<Watch>(wire, &after));
    const double length = w.wires().length(wire);
    const auto events = [&w] {
        return std::array{w.events().extremes(EventKind::lift_off).count,
                          w.events().extremes(EventKind::lay_on).count};
    };
    while (w.time() < route.end()) {
        const double angle = route.angle(w.time());
        session.set_input("x", route.pull * std::cos(angle));
        session.set_input("z", route.pull * std::sin(angle));
        session.set_input("dx", -route.pull * std::cos(angle));
        session.set_input("dz", -route.pull * std::sin(angle));
        const auto had = events();
        const WireSums before = sums_of(w, wire);
        const Status status = session.step();
        ASSERT_EQ(status, Status::ok) << w.time() << " s: " << session.objection();
        if (events() == had) continue;
        SCOPED_TRACE(fmt::format("{:.4f} s", w.time()));
        EXPECT_NEAR(after.length, before.length, kLengthKept * length);
        EXPECT_LT((after.momentum - before.momentum).norm(), kMomentumKept * before.moving);
    }
    const auto happened = events();
    EXPECT_GE(happened[0], 1);
    EXPECT_EQ(happened[0], happened[1]);
    EXPECT_LE(happened[0], kMaxReturns);
    EXPECT_GT(w.system_signal("roller.angle"), 0.1) << "the wire lies on the roller at the end";
    EXPECT_NE(w.verdict().grade, Grade::wrong);
}

TEST(OpenGuideRandom, KeepsLengthAndMomentumOfItsWire) {
    for (const std::uint32_t seed : seeds(1, 6, 60, 600)) check_route(seed);
}

}  // namespace
}  // namespace hawser::test
