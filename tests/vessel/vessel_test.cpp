// SPDX-License-Identifier: Apache-2.0
/// Vessels in a world: tracks, current, state, rejected definitions.
#include <hawser/hawser.h>
#include <hawser/vessel_ships.h>
#include <hawser/vessel_trials.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

namespace hawser::test {
namespace {

constexpr double kDeg = std::numbers::pi / 180.0;

struct Sailing {
    World world;
    PublishedShip ship;
    explicit Sailing(const PublishedShip& of, const SeaDef* sea = nullptr, double step = 1.0 / 60.0,
                     int threads = 1)
        : world(WorldDef{.step = step, .threads = threads}), ship(of) {
        ship.vessel.body = world.add_body(ship.body);
        if (sea != nullptr) world.add(*sea);
        world.add(ship.vessel);
    }
    void run(double seconds) {
        const long steps = std::lround(seconds / world.settings().step);
        for (long i = 0; i < steps; ++i)
            ASSERT_EQ(world.step(), Status::ok) << to_string(world.bad_load(), world);
    }
    [[nodiscard]] Vec3 place() const { return world.pose(ship.vessel.body).position; }
    [[nodiscard]] double signal(const char* name) const {
        return world.system_signal(ship.vessel.name + "." + name);
    }
    void set(const char* name, double value) {
        world.set_system_signal(ship.vessel.name + "." + name, value);
    }
};

// Figures of the published equations (docs/vessels.md); `hawser validate` has all of them.
TEST(Vessel, TurnsLikeItsReference) {
    const PublishedShip ship = kvlcc2(KvlccScale::l7);
    Sailing s(ship);
    const TurningCircle t = turning_circle(s.world, s.ship.vessel, 35.0 * kDeg, 70.0);
    EXPECT_NEAR(t.advance / ship.length, 3.078, 0.005 * 3.078);
    EXPECT_NEAR(t.transfer / ship.length, 1.332, 0.005 * 1.332);
    EXPECT_NEAR(t.tactical / ship.length, 3.118, 0.005 * 3.118);
    Sailing z(ship);
    const ZigZagTrial zz = zig_zag(z.world, z.ship.vessel, 10.0 * kDeg, 10.0 * kDeg, 2);
    ASSERT_EQ(zz.overshoots.size(), 2u);
    EXPECT_NEAR(zz.overshoots[0] / kDeg, 4.93, 0.1);
    EXPECT_NEAR(zz.overshoots[1] / kDeg, 13.56, 0.1356);
    EXPECT_NEAR(zz.executes[0], 10.59, 0.01 * 10.59);
    EXPECT_NEAR(zz.executes[1], 36.77, 0.01 * 36.77);
}

TEST(Vessel, PositiveRudderTurnsEveryShipToStarboard) {
    for (const char* name : kPublishedShips) {
        const PublishedShip ship = published_ship(name, 30.0);
        if (ship.speed == 0.0) continue;
        Sailing s(ship);
        s.set("rudder", 10.0 * kDeg);
        s.run(4.0 * ship.length / ship.speed);
        EXPECT_GT(s.signal("turn_rate"), 0.0) << name;
        EXPECT_LT(s.place().y(), 0.0) << name;  // starboard is -y with the bow along x
        EXPECT_NEAR(s.place().z(), ship.body.position.z(), 1e-6) << name;
    }
}

// Forces depend on the velocity through the water: a uniform current moves the track with it.
TEST(Vessel, CurrentCarriesTheTrack) {
    const Vec3 flow{0.4, -0.7, 0.0};
    SeaDef still{.depth = 100.0}, sea{.depth = 100.0};
    sea.current.push_back(
        {.depth = 0.0, .speed = flow.norm(), .direction = std::atan2(flow.y(), flow.x())});
    for (const char* name : {"kvlcc2", "mariner", "s175", "esso_190k", "osv"}) {
        const PublishedShip ship = published_ship(name);
        PublishedShip carried = ship;
        carried.body.velocity += flow;
        Sailing a(ship, &still), b(carried, &sea);
        for (Sailing* s : {&a, &b}) {
            if (ship.speed > 0.0)
                s->set("rudder", 20.0 * kDeg);
            else
                s->set("port", 1.0), s->set("bow1", -0.5);
            s->run(100.0);
        }
        const Vec3 separation = b.place() - a.place() - 100.0 * flow;
        // Rounding of sums over 6,000 steps.
        EXPECT_LT(separation.norm(), 1e-6) << name;
        EXPECT_NEAR(a.signal("speed"), b.signal("speed"), 1e-8) << name;
    }
}

// Velocities are extrapolated and tangents implicit: second order in the step.
TEST(Vessel, StepIsOfSecondOrder) {
    const PublishedShip ship = kvlcc2(KvlccScale::l3);
    std::vector<Vec3> places;
    for (const double step : {1.0 / 15.0, 1.0 / 30.0, 1.0 / 60.0, 1.0 / 480.0}) {
        PublishedShip turning = ship;
        turning.body.angular_velocity = {0, 0, -0.05};
        Sailing s(turning, nullptr, step);
        s.run(20.0);
        places.push_back(s.place());
    }
    const double first = (places[0] - places[3]).norm(), second = (places[1] - places[3]).norm();
    const double third = (places[2] - places[3]).norm();
    EXPECT_GT(std::log2(first / second), 1.7);
    EXPECT_GT(std::log2(second / third), 1.6);
    EXPECT_LT(third, 1e-3 * ship.length);
}

// Long steps: vessels are stable at 5 Hz.
TEST(Vessel, LongStepsAreStable) {
    for (const char* name : kPublishedShips) {
        const PublishedShip ship = published_ship(name);
        Sailing s(ship, nullptr, 0.2);
        if (ship.speed > 0.0)
            s.set("rudder", 30.0 * kDeg);
        else
            s.set("port", 1.0);
        s.run(20.0 * ship.length / std::max(ship.speed, 2.0));
        EXPECT_LT(s.signal("speed"), 1.5 * std::max(ship.speed, 8.0)) << name;
        EXPECT_LT(std::abs(s.signal("turn_rate")), 2.0) << name;
    }
}

TEST(Vessel, StateIsSavedRestoredCopiedAndRepeatsForAnyThreads) {
    for (const char* name : {"kvlcc2_l7", "osv", "s175"}) {
        const PublishedShip ship = published_ship(name);
        Sailing a(ship), b(ship, nullptr, 1.0 / 60.0, 3);
        const auto order = [&](World& w) {
            if (ship.speed > 0.0)
                w.set_system_signal(ship.vessel.name + ".rudder", 0.3);
            else {
                w.set_system_signal("osv.port", 0.8);
                w.set_system_signal("osv.port_angle", 0.5);
                w.set_system_signal("osv.bow1", -1.0);
            }
        };
        order(a.world);
        order(b.world);
        a.run(5.0);
        b.run(5.0);
        EXPECT_EQ(a.world.state().hash(), b.world.state().hash()) << name;
        const std::vector<std::byte> kept = a.world.state().save();
        World twin = a.world.twin();
        a.run(5.0);
        const std::uint64_t hash = a.world.state().hash();
        for (int i = 0; i < 300; ++i) ASSERT_EQ(twin.step(), Status::ok);
        EXPECT_EQ(twin.state().hash(), hash) << name;
        Sailing c(ship);
        c.world.state().restore(kept);
        c.run(5.0);
        EXPECT_EQ(c.world.state().hash(), hash) << name;
    }
}

/// Set number `at` of a state's doubles or integers.
class Spoiler final : public StateVisitor {
  public:
    Spoiler(int at, double value, std::int32_t flag) : at_(at), value_(value), flag_(flag) {}
    [[nodiscard]] int count() const noexcept { return count_; }

  protected:
    void bytes(void* data, std::size_t size) override {
        if (count_++ == at_ && size == 4) *static_cast<std::int32_t*>(data) = flag_;
    }
    void numbers(std::span<double> values) override {
        for (double& x : values)
            if (count_++ == at_) x = value_;
    }

  private:
    int at_, count_ = 0;
    double value_;
    std::int32_t flag_;
};

// State values that determine a step are rejected if out of range. Outputs and inputs may have any
// value here: the next step computes them, or the world checks their range.
TEST(Vessel, RestoredStateIsChecked) {
    Sailing s(kvlcc2(KvlccScale::full));
    System* system = s.world.find_system("kvlcc2");
    ASSERT_NE(system, nullptr);
    int refused = 0;
    Spoiler counter(-1, 0.0, 0);
    system->visit_state(counter);
    const std::vector<std::byte> good = s.world.state().save();
    for (int i = 0; i < counter.count(); ++i) {
        Spoiler spoiler(i, 1e9, 7);
        system->visit_state(spoiler);
        StateRules rules;
        system->check_state(s.world, rules);
        refused += *rules.fault() != '\0' ? 1 : 0;
        s.world.state().restore(good);
    }
    // Last velocities, flags, rudder and revolutions, last failures of both.
    EXPECT_EQ(refused, 6 + 2 + 2 + 2);
}

std::string refusal(const std::function<void(PublishedShip&)>& spoil, const char* name = "kvlcc2") {
    World world;
    PublishedShip ship = published_ship(name);
    ship.vessel.body = world.add_body(ship.body);
    spoil(ship);
    try {
        world.add(ship.vessel);
    } catch (const DefError& error) {
        return error.what();
    }
    return "";
}

TEST(Vessel, RefusesBadDefinitions) {
    const auto has = [](const std::string& text, const char* part) {
        return text.find(part) != std::string::npos ? std::string(part) : text;
    };
    using S = PublishedShip;
    EXPECT_EQ(refusal([](S&) {}), "");
    EXPECT_EQ(has(refusal([](S& s) { s.vessel.body = BodyId{9}; }), "body: there is no such body"),
              "body: there is no such body");
    EXPECT_EQ(has(refusal([](S& s) { s.vessel.polynomial.terms[2].of = "vx"; }),
                  "polynomial/terms/2/of: 'vx' has the letter 'x'"),
              "polynomial/terms/2/of: 'vx' has the letter 'x'");
    EXPECT_EQ(has(refusal([](S& s) { s.vessel.added_mass(0, 0) = -1e12; }), "added_mass: "),
              "added_mass: ");
    EXPECT_EQ(has(refusal([](S& s) { s.vessel.restoring(5, 5) = 1.0; }), "restoring: "),
              "restoring: ");
    EXPECT_EQ(has(refusal([](S& s) { s.vessel.mmg.rudder_area = 0.0; }), "mmg/rudder_area: 0"),
              "mmg/rudder_area: 0");
    // Thrusters on a body without a hull.
    const auto bare = [](S& s) {
        VesselDef v;
        v.body = s.vessel.body;
        v.propulsors = s.vessel.propulsors;
        s.vessel = v;
    };
    EXPECT_EQ(has(refusal(bare, "osv"), "propulsors: the body has no hull"),
              "propulsors: the body has no hull");
    EXPECT_EQ(has(refusal([](S& s) { s.vessel.propulsors[1].name = "bow1"; }, "osv"),
                  "propulsors/1/name: the name 'bow1' is taken"),
              "propulsors/1/name: the name 'bow1' is taken");
    EXPECT_EQ(has(refusal(
                      [](S& s) {
                          RudderDef r;
                          r.area = 10.0;
                          r.behind = "prot";
                          s.vessel.rudders.push_back(r);
                      },
                      "osv"),
                  "rudders/0/behind: there is no propulsor 'prot'"),
              "rudders/0/behind: there is no propulsor 'prot'");
    EXPECT_THROW((void)esso_190k(18.0), DefError);
    EXPECT_THROW((void)published_ship("kvlcc"), DefError);
}

// Coefficients of the model on the full-scale body, and vice versa.
TEST(Vessel, NamesValuesOfAnotherScale) {
    for (const char* name : kPublishedShips) {
        World world;
        PublishedShip ship = published_ship(name, 30.0);
        ship.vessel.body = world.add_body(ship.body);
        EXPECT_TRUE(unusual_values(world, ship.vessel).empty())
            << name << ": " << unusual_values(world, ship.vessel).front();
    }
    World world;
    PublishedShip full = kvlcc2(KvlccScale::full), model = kvlcc2(KvlccScale::l7);
    full.vessel.body = world.add_body(full.body);
    VesselDef mixed = full.vessel;
    mixed.mmg = model.vessel.mmg;
    EXPECT_FALSE(unusual_values(world, mixed).empty());
    mixed = full.vessel;
    mixed.added_mass = model.vessel.added_mass;
    EXPECT_FALSE(unusual_values(world, mixed).empty());
    mixed = full.vessel;
    for (HullTerm& t : mixed.polynomial.terms) t.value *= 1e-3;  // a table in 1e-5, read as 1e-8
    EXPECT_FALSE(unusual_values(world, mixed).empty());
}

TEST(Vessel, NamesWeightThatNothingOrTwoThingsCarry) {
    const auto warnings = [](bool gravity, bool hull) {
        World world;
        PublishedShip ship = osv();
        ship.body.gravity = gravity;
        ship.vessel.body = world.add_body(ship.body);
        SeaDef sea{.depth = 100.0};
        if (hull) {
            WaterHull h;
            h.body = ship.vessel.body;
            h.mesh = box_hull({41.5, 9.0, 6.0});
            sea.hulls.push_back(h);
        }
        world.add(sea);
        return unusual_values(world, ship.vessel).size();
    };
    EXPECT_EQ(warnings(false, false), 0u);
    EXPECT_EQ(warnings(true, false), 1u);
    EXPECT_EQ(warnings(true, true), 1u);  // hull of the sea and `restoring`
}

TEST(Trials, ImoLimitsFollowLengthOverSpeed) {
    TurningCircle turn;
    turn.turned = true;
    turn.advance = 4.0 * 100.0;
    turn.tactical = 5.5 * 100.0;
    ZigZagTrial ten, twenty;
    ten.overshoots = {12.0 * kDeg, 20.0 * kDeg};
    twenty.overshoots = {26.0 * kDeg};
    // L/V = 20 s: 5 + 10 = 15 and 17.5 + 15 = 32.5 degrees.
    const auto all = imo_criteria(100.0, 5.0, turn, ten, twenty);
    ASSERT_EQ(all.size(), 5u);
    EXPECT_TRUE(all[0].met());
    EXPECT_FALSE(all[1].met());
    EXPECT_DOUBLE_EQ(all[2].limit, 15.0);
    EXPECT_DOUBLE_EQ(all[3].limit, 32.5);
    EXPECT_FALSE(all[4].met());
    EXPECT_DOUBLE_EQ(imo_criteria(100.0, 12.0, turn, ten, twenty)[2].limit, 10.0);
    EXPECT_DOUBLE_EQ(imo_criteria(100.0, 2.0, turn, ten, twenty)[3].limit, 40.0);
}

}  // namespace
}  // namespace hawser::test
