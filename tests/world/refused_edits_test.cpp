// SPDX-License-Identifier: Apache-2.0
/// Rejected calls of several edits have no effect: on the hash, the energy, and the bits of later
/// steps, also with cut interactions.
#include <hawser/hawser.h>

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

namespace hawser::test {
namespace {

/// Two hulls with a wire between them, another wire that hangs from one, and a rod.
struct Harbour {
    World w;
    BodyId left{}, right{};
    WireId tow{}, loose{};
    InteractionId rod{};

    explicit Harbour(Coupling coupling) : w(WorldDef{.step = 1.0 / 60.0, .coupling = coupling}) {
        const auto hull = [&](const char* name, double x, const char* group) {
            return w.add_body({.name = name,
                               .position = {x, 0, 0},
                               .mass = 1e5,
                               .inertia = Mat3::Identity() * 4e6,
                               .gravity = false,
                               .group = group});
        };
        left = hull("left", 0.0, "a");
        right = hull("right", 60.0, "b");
        WireDef def{.name = "tow", .from = left, .to = right, .elements = 12};
        def.EA = 1e7;
        def.mass_per_length = 10.0;
        def.consistent_mass = coupling == Coupling::exact;
        def.length = 59.9;
        tow = w.wires().add(def);
        def.name = "loose";
        def.to = {};
        def.to_point = {0, 0, -20};
        def.length = 20.0;
        def.elements = 4;
        loose = w.wires().add(def);
        rod = w.add(DistanceDef{.name = "rod",
                                .a = left,
                                .b = right,
                                .point_a = {0, 5, 0},
                                .point_b = {0, 5, 0},
                                .compliance = 1e-6});
        w.set_velocity(right, {.linear = {0.2, 0.1, 0}, .angular = Vec3::Zero()});
    }
};

struct Refused {
    const char* name;
    std::function<void(Harbour&)> call;
};

std::vector<Refused> refused_calls() {
    return {
        {"attach to nothing",
         [](Harbour& h) { (void)h.w.wires().attach(h.loose, 1, BodyId{99}, Vec3::Zero()); }},
        {"attach far away",
         [](Harbour& h) {
             (void)h.w.wires().attach(h.loose, 1, h.right, {1e6, 0, 0}, {.name = "left"});
         }},
        {"attach with the name of another",
         [](Harbour& h) {
             (void)h.w.wires().attach(h.loose, 1, h.right, {0, 0, -2},
                                      {.name = "rod", .gear = Gear::shackle});
         }},
        {"a winch with the name of a body",
         [](Harbour& h) {
             (void)h.w.add(WinchDef{.name = "tow", .wire = h.tow, .torque_haul = -1.0});
         }},
        {"a winch whose drum is taken",
         [](Harbour& h) {
             (void)h.w.add_body({.name = "w/drum", .kind = BodyKind::fixed});
             (void)h.w.add(WinchDef{.name = "w", .wire = h.tow});
         }},
        {"a guide far from its wire",
         [](Harbour& h) {
             (void)h.w.add(
                 GuideDef{.name = "g", .wire = h.tow, .body = h.left, .point = {0, 90, 0}});
         }},
        {"a guide whose slide is taken",
         [](Harbour& h) {
             (void)h.w.add(GuideDef{
                 .name = "g", .wire = h.tow, .body = h.left, .point = {1, 0, 0}, .friction = -1.0});
         }},
        {"a node at the end of an element",
         [](Harbour& h) { (void)h.w.wires().insert_node(h.w.wires().elements(h.tow)[3], 1.0); }},
        {"a node of a hull", [](Harbour& h) { (void)h.w.wires().remove_node(h.left); }},
        {"the end of a wire that holds",
         [](Harbour& h) { (void)h.w.wires().join(h.tow, 1, h.loose, 1); }},
        {"a cut beyond the wire", [](Harbour& h) { (void)h.w.wires().cut(h.tow, 1e3); }},
        {"a wire with the name of another",
         [](Harbour& h) { (void)h.w.wires().add({.name = "tow", .from = h.left, .to = h.right}); }},
        {"a wire of no stiffness",
         [](Harbour& h) {
             (void)h.w.wires().add({.name = "new", .from = h.left, .to = h.right, .EA = -1.0});
         }},
        {"a hinge of the name of another",
         [](Harbour& h) { (void)h.w.add(HingeDef{.name = "rod", .a = h.left, .b = h.right}); }},
    };
}

TEST(RefusedEdits, LeaveHashEnergyAndMotionAlone) {
    for (const Coupling coupling : {Coupling::exact, Coupling::compliant})
        for (const Refused& refused : refused_calls()) {
            SCOPED_TRACE(std::string(refused.name) +
                         (coupling == Coupling::exact ? "" : ", compliant"));
            Harbour tried(coupling), plain(coupling);
            for (int i = 0; i < 7; ++i)
                for (Harbour* h : {&tried, &plain}) ASSERT_EQ(h->w.step(), Status::ok);
            // Objects that the call adds before the rejection stay: they are calls of the user.
            if (std::string(refused.name) == "a winch whose drum is taken") {
                (void)plain.w.add_body({.name = "w/drum", .kind = BodyKind::fixed});
                EXPECT_THROW(refused.call(tried), DefError);
            } else {
                const std::uint64_t hash = tried.w.state().hash();
                const double energy = tried.w.energy().mechanical();
                const std::vector<std::byte> saved = tried.w.state().save();
                EXPECT_THROW(refused.call(tried), DefError);
                EXPECT_EQ(tried.w.state().hash(), hash);
                EXPECT_EQ(tried.w.energy().mechanical(), energy);
                // Each analysis sets the positions of ghost bodies again.
                if (coupling == Coupling::exact) {
                    EXPECT_EQ(tried.w.state().save(), saved);
                }
            }
            EXPECT_EQ(tried.w.bodies().size(), plain.w.bodies().size());
            EXPECT_EQ(tried.w.interactions().size(), plain.w.interactions().size());
            for (int i = 0; i < 7; ++i) {
                for (Harbour* h : {&tried, &plain}) ASSERT_EQ(h->w.step(), Status::ok);
                ASSERT_EQ(tried.w.state().hash(), plain.w.state().hash()) << "step " << i;
            }
            EXPECT_EQ(tried.w.energy().mechanical(), plain.w.energy().mechanical());
            EXPECT_EQ(tried.w.energy().edited, plain.w.energy().edited);
        }
}

}  // namespace
}  // namespace hawser::test
