// SPDX-License-Identifier: Apache-2.0
/// Frames, decoded by docs/live.md, compared with their world.
#include "live/frame_writer.h"
#include "live/recorded_scene.h"
#include "live/scene_text.h"

#include "live/client.h"
#include "record/joined_deck.h"

#include <hawser/guide.h>
#include <hawser/scene.h>
#include <hawser/state.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace hawser::test {
namespace {

/// Return a difference of some kilometres in single precision, computed in double precision.
float relative(double value, double origin) { return static_cast<float>(value - origin); }

struct Shown {
    scene::Scene scene;
    live::FramePlan plan;
    nlohmann::json json;
    ReadFrame frame;
    Vec3 origin{120.0, -30.0, 4.0};
    double seconds = 1e9;  ///< Shortest time to make a frame.

    explicit Shown(const std::string& file, int steps) : scene(scene::load_file(file)) {
        scene.world.prepare();
        for (int k = 0; k < steps; ++k) EXPECT_EQ(scene.world.step(), Status::ok);
        plan = live::FramePlan::of(scene);
        live::FrameWriter writer;
        live::Bytes bytes;
        for (int k = 0; k < 20; ++k) {
            writer.write(scene.world, plan, origin, {.epoch = 3, .number = 9, .deadline_ms = 16.0},
                         bytes);
            seconds = std::min(seconds, writer.seconds());
        }
        std::vector<char> copy(bytes.size());
        std::memcpy(copy.data(), bytes.data(), bytes.size());
        frame = read_frame(copy);
        json = nlohmann::json::parse(
            "{" + live::text_of(live::scene_json(scene, plan, {.epoch = 3, .origin = origin})));
    }
    [[nodiscard]] World& world() { return scene.world; }
};

void expect_bodies(Shown& shown) {
    for (const auto& body : shown.json["bodies"]) {
        const BodyId id = shown.world().find_body(body["name"].get<std::string>());
        if (!id.valid()) continue;  // has no name
        const Pose pose = shown.world().pose(id);
        const int slot = body["slot"];
        const std::string kind = body["kind"];
        const auto place = static_cast<std::size_t>(slot);
        if (kind == "rigid") {
            for (int k = 0; k < 3; ++k)
                EXPECT_EQ(shown.frame.rigid[7 * place + static_cast<std::size_t>(k)],
                          relative(pose.position[k], shown.origin[k]));
            EXPECT_EQ(shown.frame.rigid[7 * place + 3], static_cast<float>(pose.orientation.w()));
            EXPECT_EQ(shown.frame.rigid[7 * place + 6], static_cast<float>(pose.orientation.z()));
        } else if (kind == "lump") {
            for (int k = 0; k < 3; ++k)
                EXPECT_EQ(shown.frame.lumps[3 * place + static_cast<std::size_t>(k)],
                          relative(pose.position[k], shown.origin[k]));
        } else if (kind == "scalar") {
            EXPECT_EQ(shown.frame.scalars[place], static_cast<float>(pose.position.x()));
        } else {
            EXPECT_EQ(slot, -1);
        }
    }
}

/// Check points and tensions of wires with all elements present and none over a sheave.
void expect_plain_wires(Shown& shown) {
    std::size_t point = 0, piece = 0;
    const World& world = shown.world();
    for (std::size_t w = 0; w < shown.frame.counts.size(); ++w) {
        const std::size_t n = shown.frame.counts[w];
        const WireId wire = world.wires().find(shown.json["wires"][w]["name"].get<std::string>());
        if (wire.valid()) {
            const auto elements = world.wires().elements(wire);
            ASSERT_EQ(n, elements.size() + 1);
            for (std::size_t e = 0; e < elements.size(); ++e) {
                const auto ends = world.wires().ends(elements[e]);
                for (int k = 0; k < 3; ++k) {
                    const auto c = static_cast<std::size_t>(k);
                    EXPECT_EQ(shown.frame.points[3 * (point + e) + c],
                              relative(ends[0][k], shown.origin[k]));
                    EXPECT_EQ(shown.frame.points[3 * (point + e + 1) + c],
                              relative(ends[1][k], shown.origin[k]));
                }
                EXPECT_EQ(shown.frame.tensions[piece + e],
                          std::max(0.0F, static_cast<float>(-world.force(elements[e])[0])));
            }
        }
        point += n;
        piece += n == 0 ? 0 : n - 1;
    }
    EXPECT_EQ(3 * point, shown.frame.points.size());
    EXPECT_EQ(piece, shown.frame.tensions.size());
}

TEST(LiveFrame, says_what_the_world_of_anchor_contact_is) {
    Shown shown("scenes/anchor_contact.json", 30);
    EXPECT_EQ(shown.frame.epoch, 3U);
    EXPECT_EQ(shown.frame.step, 30);
    EXPECT_EQ(shown.frame.time, shown.world().time());
    expect_bodies(shown);
    expect_plain_wires(shown);
    std::vector<float> contacts;
    for (const ContactView& c : shown.world().contacts()) {
        if (c.force.isZero(0.0)) continue;
        for (int k = 0; k < 3; ++k) contacts.push_back(relative(c.point[k], shown.origin[k]));
        for (int k = 0; k < 3; ++k) contacts.push_back(static_cast<float>(c.force[k]));
    }
    EXPECT_GT(contacts.size(), 6U * 900U);  // 1,080 points on seabed, rollers and deck
    EXPECT_EQ(shown.frame.contacts, contacts);
    std::size_t j = 0;
    for (const auto& joint : shown.json["joints"]) {
        const auto force = shown.world().force({joint["id"].get<std::int32_t>()});
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_EQ(shown.frame.joints[j++], static_cast<float>(force[k]));
    }
    EXPECT_EQ(j, shown.frame.joints.size());
    std::size_t i = 0;
    for (const auto& input : shown.json["inputs"])
        EXPECT_EQ(shown.frame.inputs[i++],
                  static_cast<float>(shown.world().input(
                      shown.world().find_input(input["name"].get<std::string>()))));
    const StepStats& stats = shown.world().stats();
    EXPECT_EQ(shown.json["stats"].size(), shown.frame.stats.size());
    EXPECT_EQ(shown.frame.stats[0], static_cast<float>(1e3 * stats.step_seconds));
    EXPECT_EQ(shown.frame.stats[15], static_cast<float>(stats.contacts));
    EXPECT_EQ(shown.frame.bits & 1U, 1U);  // certified
    EXPECT_LE(shown.frame.length, 72'000U);
    std::printf("frame of anchor_contact: %u bytes, made in %.0f us at best\n", shown.frame.length,
                1e6 * shown.seconds);
}

TEST(LiveFrame, shows_chains_of_links_ropes_over_sheaves_and_scalar_bodies) {
    Shown links("scenes/mooring.json", 3);
    expect_bodies(links);
    ASSERT_EQ(links.frame.counts.size(), 10U);
    EXPECT_EQ(links.json["wires"][0]["kind"], "links");
    EXPECT_GT(*std::max_element(links.frame.tensions.begin(), links.frame.tensions.end()), 1e3F);

    Shown crane("scenes/crane_knuckle.json", 60);
    expect_bodies(crane);
    int lines = 0;
    for (std::size_t w = 0, at = 0; w < crane.frame.counts.size(); ++w) {
        const auto& wire = crane.json["wires"][w];
        const InteractionId id = crane.world().find_interaction(wire["name"].get<std::string>());
        if (id.valid()) {
            ++lines;
            const auto ends = crane.world().wires().ends(id);
            for (std::size_t k = 0; k < 6; ++k)
                EXPECT_EQ(crane.frame.points[3 * at + k],
                          relative(ends[k / 3][static_cast<int>(k % 3)],
                                   crane.origin[static_cast<int>(k % 3)]));
        }
        at += crane.frame.counts[w];
    }
    EXPECT_GE(lines, 3);
    EXPECT_FALSE(crane.json["wheels"].empty());
    ASSERT_EQ(crane.frame.outputs.size(), crane.json["outputs"].size());
    for (std::size_t k = 0; k < crane.frame.outputs.size(); ++k)
        EXPECT_EQ(crane.frame.outputs[k], static_cast<float>(crane.world().outputs()[k]));
}

/// On a bollard the wire is drawn through: a piece along the circle joins the points where it
/// leaves.
TEST(LiveFrame, joins_the_two_sides_of_a_wire_on_a_wheel) {
    scene::Scene scene;
    World& world = scene.world;
    const BodyId quay = world.add_body({.name = "quay", .kind = BodyKind::fixed});
    WireDef def{.name = "wire", .from = quay, .from_point = {-12, 0, 1}};
    def.to = quay;
    def.to_point = {12, 0, -6};
    def.elements = 6;
    def.length = 25.4;
    def.EA = 1e7;
    def.mass_per_length = 10.0;
    def.consistent_mass = true;
    const WireId wire = world.wires().add(def);
    const Vec3 centre(1.0, 0.0, -3.1);  // under the wire, which it raises by 0.2 m
    world.add(GuideDef{.name = "post",
                       .wire = wire,
                       .body = quay,
                       .point = centre,
                       .radius = 0.5,
                       .friction = 0.1,
                       .element_length = 2.0});
    for (int k = 0; k < 30; ++k) ASSERT_EQ(world.step(), Status::ok);
    const live::FramePlan plan = live::FramePlan::of(scene);
    live::FrameWriter writer;
    live::Bytes bytes;
    writer.write(world, plan, Vec3::Zero(), {}, bytes);
    std::vector<char> copy(bytes.size());
    std::memcpy(copy.data(), bytes.data(), bytes.size());
    const ReadFrame frame = read_frame(copy);
    ASSERT_EQ(frame.counts.at(0), world.wires().elements(wire).size() + 2);
    int on_circle = 0;
    for (std::size_t p = 0; p < frame.counts[0]; ++p) {
        const Vec3 at(frame.points[3 * p], frame.points[3 * p + 1], frame.points[3 * p + 2]);
        on_circle += std::abs((at - centre).norm() - 0.5) < 1e-5 ? 1 : 0;  // single precision
    }
    EXPECT_EQ(on_circle, 2);
    EXPECT_EQ(std::count(frame.tensions.begin(), frame.tensions.end(), -1.0F), 0);
}

TEST(LiveFrame, keeps_its_scene_while_nodes_come_and_go_and_takes_another_for_a_cut) {
    scene::Scene scene = scene::load_file("scenes/tow_payout.json");
    World& world = scene.world;
    world.prepare();
    const live::FramePlan before = live::FramePlan::of(scene);
    ASSERT_TRUE(before.current(world));
    const WireId wire = world.wires().ids().front();
    const auto nodes = world.wires().nodes(wire).size();
    InteractionId middle = world.wires().elements(wire)[world.wires().elements(wire).size() / 2];
    (void)world.wires().insert_node(middle, 0.5);
    ASSERT_EQ(world.wires().nodes(wire).size(), nodes + 1);
    EXPECT_FALSE(before.current(world));
    const live::FramePlan after = live::FramePlan::of(scene);
    EXPECT_TRUE(after.is_same_scene(before));
    (void)world.wires().cut(wire, 0.5 * world.wires().length(wire));
    const live::FramePlan cut = live::FramePlan::of(scene);
    EXPECT_FALSE(cut.is_same_scene(after));
    EXPECT_EQ(cut.wires.size(), after.wires.size() + 1);
}

/// The page shows a recording with the links and legs that were added while it was made.
TEST(LiveFrame, shows_links_and_legs_of_a_recording_while_they_are_there) {
    JoinedDeck deck;
    const record::Recording recording = deck.record(fresh_folder() / "r.hwr");
    const live::RecordedScene shown(recording);
    const nlohmann::json wires = shown.json()["wires"];
    const auto number = [&](const std::string& name) {
        for (std::size_t w = 0; w < wires.size(); ++w)
            if (wires[w]["name"] == name) {
                EXPECT_EQ(wires[w]["kind"], "line");
                return w;
            }
        throw std::runtime_error("there is no " + name);
    };
    const std::size_t strop = number("strop"), leg = number("hook/leg1");
    for (std::size_t f = 0; f < recording.frame_count(); ++f) {
        live::Bytes bytes;
        shown.write(f, 0, 1, bytes);
        std::vector<char> copy(bytes.size());
        std::memcpy(copy.data(), bytes.data(), bytes.size());
        const ReadFrame frame = read_frame(copy);
        EXPECT_EQ(frame.counts.at(strop), 2 * deck.lines[f].count("strop")) << f;
        EXPECT_EQ(frame.counts.at(leg), 2 * deck.lines[f].count("hook/leg1")) << f;
    }
}

/// A broken element is sent as −1, and the rest of the wire is unchanged.
TEST(LiveFrame, tells_what_has_parted) {
    scene::Scene scene = scene::load_file("scenes/anchor_lines.json");
    World& world = scene.world;
    world.prepare();
    ASSERT_EQ(world.step(), Status::ok);
    const WireId wire = world.wires().find("work1");
    world.wires().part(wire, 0.5 * world.wires().length(wire));
    const live::FramePlan plan = live::FramePlan::of(scene);
    live::FrameWriter writer;
    live::Bytes bytes;
    writer.write(world, plan, Vec3::Zero(), {}, bytes);
    std::vector<char> copy(bytes.size());
    std::memcpy(copy.data(), bytes.data(), bytes.size());
    const ReadFrame frame = read_frame(copy);
    EXPECT_EQ(std::count(frame.tensions.begin(), frame.tensions.end(), -1.0F), 1);
}

}  // namespace
}  // namespace hawser::test
