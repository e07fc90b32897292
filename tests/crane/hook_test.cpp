// SPDX-License-Identifier: Apache-2.0
/// Hooks that take and let go, bits that do not depend on threads or restoring, refusals.
#include "support/cranes_yard.h"

#include <hawser/structure.h>

#include <functional>

namespace hawser {
namespace {

using test::knuckle_crane;
using test::KnuckleYard;
using test::lattice_crane;
using test::LatticeYard;

TEST(CraneHook, TakesWhatIsInReachAndLetsItFall) {
    KnuckleYard y(knuckle_crane, 20e3, [](KnuckleCraneDef& d) { d.take = 0; });
    // On a rod a metre below the reach of its sling.
    const Vec3 at = y.w.pose(y.box).position - Vec3(0, 0, 1.0);
    y.w.set_pose(y.box, {.position = at});
    y.w.add(BallDef{.name = "stand", .a = y.quay, .b = y.box, .point = at});
    y.order("take", 1.0);
    y.run(2.0);
    EXPECT_EQ(y.signal("held"), 0.0);
    EXPECT_EQ(y.count(EventKind::join), 0);
    y.order("hoist", -0.4);
    y.run(6.0);
    y.order("hoist", 0.0);
    EXPECT_EQ(y.signal("held"), 1.0);
    ASSERT_EQ(y.count(EventKind::join), 1);
    EXPECT_EQ(y.w.event_extremes(EventKind::join).first.body, y.box);
    EXPECT_LE(y.w.event_extremes(EventKind::join).first.value, test::kSling + 0.01);
    (void)y.w.remove_interaction(y.w.find_interaction("stand"));
    y.run(20.0);
    EXPECT_NEAR(y.signal("load"), 20e3, 50.0);
    y.order("take", 0.0);
    y.run(2.0 * test::kYardStep);
    EXPECT_EQ(y.signal("held"), 0.0);
    EXPECT_FALSE(y.w.find_interaction("crane/sling1").valid());
    ASSERT_EQ(y.count(EventKind::detach), 1);
    const double before = y.w.velocity(y.box).linear.z();
    y.run(0.5);
    EXPECT_NEAR(y.w.velocity(y.box).linear.z() - before, -0.5 * test::kG, 1e-9);
}

TEST(CraneHook, SlingsThatAreTakenAwayAreLetGo) {
    KnuckleYard y(knuckle_crane, 20e3);
    y.run(1.0);
    ASSERT_EQ(y.signal("held"), 1.0);
    (void)y.w.remove_interaction(y.w.find_interaction("crane/sling1"));
    y.order("take", 0.0);
    y.run(0.5);
    EXPECT_EQ(y.signal("held"), 0.0);
    KnuckleYard gone(knuckle_crane, 20e3);
    gone.run(1.0);
    (void)gone.w.remove_body(gone.box);
    gone.run(1.0);
    EXPECT_EQ(gone.signal("held"), 0.0);
    EXPECT_THROW((void)gone.w.remove_body(gone.ids.hook), DefError);
}

/// Slews and hoists; lets go at step 350.
template <class Yard>
void work(Yard& y, int from, int to) {
    for (int i = from; i < to; ++i) {
        if (i == 30) y.order("slew", 0.03);
        if (i == 60) y.order("hoist", 0.1);
        if (i == 90) y.order("luff", -0.05);
        if (i == 350) y.order("take", 0.0);
        ASSERT_EQ(y.w.step(), Status::ok);
    }
}

template <class Yard, class Make>
void expect_same_bits(Make make, double mass) {
    std::vector<std::uint64_t> hashes;
    for (const int threads : {1, 2, 4, 8}) {
        Yard y(make, mass, [](auto&) {}, threads);
        work(y, 0, 500);
        hashes.push_back(y.w.state_hash());
    }
    for (const int at : {0, 45, 200, 400}) {
        Yard y(make, mass);
        work(y, 0, at);
        const Structure made_of = y.w.structure();
        const std::vector<std::byte> saved = y.w.save();
        work(y, at, 500);
        y.w.restore(made_of, saved);
        work(y, at, 500);
        hashes.push_back(y.w.state_hash());
        // In a world of its own that has only been set up.
        Yard other(make, mass);
        other.w.restore(made_of, saved);
        work(other, at, 500);
        hashes.push_back(other.w.state_hash());
    }
    for (std::size_t i = 0; i < hashes.size(); ++i) EXPECT_EQ(hashes[i], hashes.front()) << i;
}

TEST(CraneBits, DoNotDependOnThreadsOrRestoring) {
    expect_same_bits<KnuckleYard>(knuckle_crane, 20e3);
    expect_same_bits<LatticeYard>(lattice_crane, 300e3);
}

TEST(CraneBits, TwinsGoOnTheSame) {
    KnuckleYard y(knuckle_crane, 20e3);
    work(y, 0, 100);
    World twin = y.w.twin();
    for (int i = 0; i < 100; ++i) {
        ASSERT_EQ(y.w.step(), Status::ok);
        ASSERT_EQ(twin.step(), Status::ok);
    }
    EXPECT_EQ(y.w.state_hash(), twin.state_hash());
}

template <class Def>
std::string refused(Def (*make)(BodyId), const std::function<void(Def&)>& change) {
    World w;
    const BodyId quay = w.add_body({.name = "quay", .kind = BodyKind::fixed});
    const BodyId spool = w.add_body({.name = "spool", .kind = BodyKind::scalar, .mass = 1.0});
    static_cast<void>(spool);
    Def def = make(quay);
    change(def);
    try {
        (void)w.add(def);
    } catch (const DefError& error) {
        EXPECT_EQ(w.bodies().size(), 2u);
        EXPECT_TRUE(w.interactions().empty());
        EXPECT_TRUE(w.inputs().empty());
        EXPECT_EQ(w.system_count(), 0);
        return error.what();
    }
    return "taken";
}

TEST(CraneRefusals, NameTheFieldAndLeaveNothing) {
    using K = KnuckleCraneDef;
    using L = LatticeCraneDef;
    struct Row {
        std::function<void(K&)> change;
        const char* words;
    };
    const BodyId nobody{77};
    for (const Row& row : std::vector<Row>{
             {[](K& d) { d.name = ""; }, "needs a name"},
             {[&](K& d) { d.mount.on = nobody; }, "is not there"},
             {[](K& d) { d.mount.on = BodyId{1}; }, "mount/on: a crane stands on"},
             {[](K& d) { d.hoist.efficiency = 0.0; }, "hoist/efficiency: 0; give"},
             {[](K& d) { d.hoist.efficiency = 1.01; }, "hoist/efficiency: 1.01"},
             {[](K& d) { d.hoist.falls = 0; }, "hoist/falls"},
             {[](K& d) { d.hoist.EA = kDefault; }, "hoist/EA"},
             {[](K& d) { d.boom.length = -1.0; }, "boom/length"},
             {[](K& d) { d.boom.centre = 20.0; }, "boom/centre"},
             {[](K& d) { d.boom_foot.y() = 0.1; }, "boom_foot"},
             {[](K& d) { d.boom_cylinder.max_length = 8.0; }, "boom_cylinder/max_length"},
             {[](K& d) { d.boom_cylinder.min_length = 2.0; }, "boom_cylinder/min_length"},
             {[](K& d) { d.jib_cylinder.max_length = 12.0; }, "jib_cylinder/max_length"},
             {[](K& d) { d.jib_cylinder.head = {0, 0, 0}; }, "jib_cylinder/head"},
             {[](K& d) { d.hook.hang = 0.5; }, "hook/hang"},
             {[](K& d) { d.hook.least_hang = 9.0; }, "hook/least_hang"},
             {[](K& d) { d.rating.curve[1].radius = 14.0; }, "rating/curve/1"},
             {[](K& d) { d.rating.curve[2].mass = 24e3; }, "rating/curve/2"},
             {[](K& d) { d.rating.warning = 1.1; }, "rating/warning"},
             {[](K& d) { d.take = 1; }, "take"},
             {[&](K& d) {
                  d.loads = {
                      {.body = nobody, .eyes = {{0, 0, 0}}, .sling_length = 1.0, .sling_EA = 1e8}};
              },
              "loads/0/body"},
             {[](K& d) {
                  d.loads = {{.body = BodyId{0}, .eyes = {}, .sling_length = 1.0, .sling_EA = 1e8}};
              },
              "loads/0/eyes"},
             {[](K& d) {
                  d.loads = {{.body = BodyId{0},
                              .eyes = {{0, 0, 0}},
                              .sling_length = 1.0,
                              .sling_EA = 1e8}};
              },
              "loads/0/body: a load is"},
             {[](K& d) { d.hoist.drum = {2.5, 0, 14}; }, "jib_angle"}})
        EXPECT_NE(refused<K>(knuckle_crane, row.change).find(row.words), std::string::npos)
            << row.words << ": " << refused<K>(knuckle_crane, row.change);
    for (const auto& [change, words] : std::vector<std::pair<std::function<void(L&)>, const char*>>{
             {[](L& d) { d.boom_angle = 1.5; }, "boom_angle"},
             {[](L& d) { d.gantry = {3, 0, 16}; }, "gantry"},
             {[](L& d) { d.pendant_length = 60.0; }, "pendant_length"},
             {[](L& d) { d.luffing.efficiency = -1.0; }, "luffing/efficiency"},
             {[](L& d) { d.gantry = {-8, 0, -40}; }, "gantry"}})
        EXPECT_NE(refused<L>(lattice_crane, change).find(words), std::string::npos)
            << words << ": " << refused<L>(lattice_crane, change);
    World w;
    const BodyId quay = w.add_body({.kind = BodyKind::fixed});
    (void)w.add(knuckle_crane(quay));
    const std::size_t bodies = w.bodies().size();
    EXPECT_THROW((void)w.add(lattice_crane(quay)), DefError);  // the name is taken
    EXPECT_EQ(w.bodies().size(), bodies);
    EXPECT_EQ(w.step(), Status::ok);
}

/// Any number of falls, on a body that is turned and leans: what hangs is what is shown.
template <class Def>
void hang_on_falls(Def (*make)(BodyId), double mass) {
    for (const int falls : {1, 2, 3, 4, 5, 8, 13}) {
        SCOPED_TRACE(falls);
        World w;
        const Quat leans(Eigen::AngleAxisd(0.05, Vec3(0.6, 0.8, 0)));
        const BodyId ship = w.add_body({.name = "ship",
                                        .kind = BodyKind::fixed,
                                        .position = {10, -20, 3},
                                        .orientation = leans});
        Def def = make(ship);
        def.mount.orientation = Quat(Eigen::AngleAxisd(2.5, Vec3::UnitZ()));
        def.slew.angle = -0.7;
        def.hoist.falls = falls;
        def.hoist.breaking_load = 1e30;  // one fall has what twelve are made for
        def.hoist.pull = def.hoist.brake = mass * test::kG * 1.5;
        const CraneIds ids = w.add(def);
        ASSERT_EQ(ids.falls.size(), static_cast<std::size_t>(falls));
        w.set_force(ids.hook, {0, 0, -mass * test::kG}, Vec3::Zero());
        double shown = 0.0;
        for (int i = 0; i < 2400; ++i) {
            ASSERT_EQ(w.step(), Status::ok);
            if (i >= 1200) shown += w.system_signal("crane.load") / 1200.0;
        }
        EXPECT_NEAR(shown / mass, 1.0, 5e-3);
        EXPECT_EQ(w.verdict().grade, Grade::good);
        for (const InteractionId fall : ids.falls)
            EXPECT_NEAR(w.force(fall)[0] / w.force(ids.falls[0])[0], 1.0, 1e-3);
    }
}

TEST(CraneFalls, OfAnyNumberCarryTheHook) {
    hang_on_falls(knuckle_crane, 15e3);
    hang_on_falls(lattice_crane, 200e3);
}

TEST(CraneRefusals, OnesThatMoveWithTheirBodyAreTaken) {
    // On a ship that moves: the crane starts with its velocity.
    World w;
    const BodyId ship = w.add_body({.name = "ship",
                                    .kind = BodyKind::kinematic,
                                    .position = {5, 3, 1},
                                    .velocity = {2, 0, 0}});
    KnuckleCraneDef def = knuckle_crane(ship);
    def.mount.orientation = Quat(Eigen::AngleAxisd(2.0, Vec3::UnitZ()));
    const CraneIds ids = w.add(def);
    for (int i = 0; i < 300; ++i) ASSERT_EQ(w.step(), Status::ok);
    EXPECT_NEAR(w.system_signal("crane.radius"), 17.18, 0.05);
    EXPECT_NEAR(w.velocity(ids.hook).linear.x(), 2.0, 0.02);
}

}  // namespace
}  // namespace hawser
