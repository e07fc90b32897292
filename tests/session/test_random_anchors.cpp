// SPDX-License-Identifier: Apache-2.0
// Random anchor handling. A tug's winch runs through its modes. Its wire of any type leads over a
// stern guide to a barge, an anchor on the bed, or a hanging weight. Random limits insert and
// remove nodes; the wire lies on the bed; it is cut or not. Separate code verifies all steps.
#include <hawser/hawser.h>
#include <hawser/scene.h>
#include <hawser/session.h>

#include "support/random.h"
#include "support/sanitizer.h"
#include "support/tier.h"

#include <gtest/gtest.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace hawser::test {
namespace {

using Json = nlohmann::json;
using XYZ = std::array<double, 3>;
constexpr double kRigSeconds = 30.0;
constexpr double kStern = -28.0, kInboard = 22.0, kAxis = 2.0;  // of the roller [m]

enum class Far { anchor, barge, weight };

template <class T, std::size_t N>
T pick(Random& random, const std::array<T, N>& from) {
    return from[static_cast<std::size_t>(random.integer(0, static_cast<int>(N) - 1))];
}

Json hull(const char* name, const XYZ& at, double mass, const XYZ& inertia, double beam) {
    return {{"name", name},
            {"position", at},
            {"mass", mass},
            {"inertia", inertia},
            {"gravity", false},
            {"half_size", {30, beam, 4}},
            {"linear_damping", {0.03 * mass, 0.13 * mass, 0}},
            {"angular_damping", {0, 0, 0.05 * inertia[2]}}};
}

Json water(const char* body, double height) {
    return {{"name", std::string(body) + "_water"},
            {"kind", "hydrostatic"},
            {"bodies", {body}},
            {"rest_height", height},
            {"heave_stiffness", 5e6},
            {"roll_stiffness", 1.8e7},
            {"pitch_stiffness", 7.4e8},
            {"heave_damping", 5.5e5},
            {"roll_damping", 5.1e6},
            {"pitch_damping", 1e8}};
}

Json block(const XYZ& at, double mass) {
    return {{"name", "far"},
            {"position", at},
            {"mass", mass},
            {"box", {2.5, 2.5, 0.8}},
            {"linear_damping", 1e4},
            {"angular_damping", 2e4},
            {"shapes",
             {{{"kind", "box"},
               {"half_size", {2.5, 2.5, 0.8}},
               {"material", "anchor"},
               {"groups", "anchor"},
               {"touches", "bed"}}}}};
}

Json random_orders(Random& random, double length) {
    Json out = Json::array();
    for (double t = 1.0; t < kRigSeconds; t += random.uniform(2, 8)) {
        constexpr std::array<const char*, 8> kModes{"speed", "speed", "tension", "render",
                                                    "brake", "brake", "free",    "release"};
        const std::string mode =
            kModes[static_cast<std::size_t>(random.integer(0, t < 20 ? 5 : 7))];
        Json set{{"winch.mode", mode}};
        if (mode == "speed") set["winch.speed"] = random.uniform(-1.5, 1.5);
        if (mode == "tension" || mode == "render") set["winch.tension"] = random.uniform(1e4, 6e5);
        out.push_back({{"at", t}, {"set", set}});
    }
    // The only known property of its length then is that it exceeds this.
    if (random.chance(0.25))
        out.push_back({{"at", random.uniform(5, 12)},
                       {"cut", "line"},
                       {"s", random.uniform(0.1, 0.6) * length}});
    std::stable_sort(out.begin(), out.end(),
                     [](const Json& a, const Json& b) { return a["at"] < b["at"]; });
    return out;
}

Json random_wire(Random& random, Far far, double wheel) {
    Json out{{"name", "line"}, {"consistent_mass", true}};
    out["line_type"] = {{"mass_per_length", random.uniform(5, 130)},
                        {"EA", std::pow(10.0, random.uniform(7.3, 8.8))},
                        {"EI", pick(random, std::array{0.0, 5e3, 5e4})},
                        {"diameter", 0.076},
                        {"drag", 20},
                        {"axial_damping", pick(random, std::array{0.05, 0.3, 1.0})},
                        {"submerged_factor", 0.87}};
    if (random.chance(0.8)) {
        const double least = random.uniform(2, 6);
        out["resolution"] = {{"min_length", least},
                             {"max_length", std::max(2 * least, random.uniform(8, 40))},
                             {"patience", pick(random, std::array{0.5, 2.0, 3.0})},
                             {"interval", pick(random, std::array{1, 2, 4, 8})}};
    }
    if (random.chance(0.7)) {
        out["contact"] = {{"material", "wire"}, {"groups", "lines"}, {"touches", "bed"}};
        if (random.chance(0.5)) out["contact"]["to_ends"] = true;
    }
    out["element"] = random.uniform(far == Far::weight ? std::max(2.5, 3.0 * wheel) : 2.5, 9.0);
    return out;
}

/// Return the route of the wire at the start, from the winch to the far end.
std::vector<XYZ> way_of(Far far, double wheel, const XYZ& end) {
    const double top = kAxis + wheel;
    std::vector<XYZ> out{{kStern + kInboard, 0, top}, {kStern, 0, top}};
    if (far == Far::weight) out.push_back({kStern - wheel, 0, top});
    out.push_back(end);
    return out;
}

Json random_rig(std::uint32_t seed) {
    Random random(seed);
    const double depth = pick(random, std::array{30.0, 60.0, 100.0, 150.0});
    const Far far = pick(random, std::array{Far::anchor, Far::barge, Far::weight});
    const double wheel = pick(random, std::array{0.5, 1.0, 1.75}) + 0.038;
    const double span = random.uniform(60, 250), hang = random.uniform(0.3, 0.7) * depth;
    Json scene{{"version", 1}, {"name", "rig"}};
    scene["settings"] = {
        {"duration", kRigSeconds},
        {"step", pick(random, std::array{1.0 / 60, 1.0 / 60, 1.0 / 120, 1.0 / 30})}};
    scene["materials"] = {
        {"wire", Json::object()}, {"bed", Json::object()}, {"anchor", Json::object()}};
    scene["material_pairs"] = {
        {{"between", {"wire", "bed"}}, {"friction", random.uniform(0.2, 0.9)}, {"stiffness", 1e5}},
        {{"between", {"anchor", "bed"}}, {"friction", 0.8}, {"stiffness", 2e7}}};
    Json tug = hull("tug", {0, 0, 0.5}, pick(random, std::array{4e5, 1.5e6, 4e6}),
                    {3.75e7, 3.4e8, 3.4e8}, 7);
    tug["force"] = {random.uniform(0, 4e5), random.uniform(-1e5, 1e5), 0};
    Json bed{{"name", "bed"},
             {"kind", "fixed"},
             {"position", {0, 0, -depth}},
             {"shapes", {{{"kind", "plane"}, {"material", "bed"}, {"groups", "bed"}}}}};
    scene["bodies"] = {tug, bed};
    scene["interactions"] = Json::array({water("tug", 0.5)});
    XYZ end{kStern - span, 0, kAxis}, point{30, 0, kAxis - 0.5};
    if (far == Far::barge) {
        scene["bodies"].push_back(hull("far", {end[0] - 30, 0, 0.5}, 6e6, {3.8e8, 4e9, 4e9}, 12));
        scene["interactions"].push_back(water("far", 0.5));
    } else if (far == Far::anchor) {
        end = {kStern - span, 0, 0.8 - depth};
        point = {2.5, 0, 0};
        scene["bodies"].push_back(block({end[0] - 2.5, 0, end[2]}, 15e3));
    } else {
        end = {kStern - wheel, 0, -hang};
        point = {0, 0, 0.8};
        scene["bodies"].push_back(
            block({end[0], 0, -hang - 0.8}, pick(random, std::array{3e3, 15e3, 3e4})));
    }
    const std::vector<XYZ> way = way_of(far, wheel, end);
    double length = 0.0;
    for (std::size_t k = 1; k < way.size(); ++k)
        length += std::hypot(way[k][0] - way[k - 1][0], way[k][2] - way[k - 1][2]);
    if (far != Far::weight) length *= pick(random, std::array{1.0, 1.005, 1.02, 1.1});
    Json wire = random_wire(random, far, wheel);
    wire["elements"] = std::max(8, static_cast<int>(length / wire["element"].get<double>()));
    const double line = wire["line_type"]["mass_per_length"];
    wire.erase("element");
    wire["length"] = length;
    wire["shape"] = "path";
    wire["path"] = way;
    wire["from"] = {{"body", "tug"}, {"point", {way[0][0], 0, way[0][2] - 0.5}}};
    wire["to"] = {{"body", "far"}, {"point", point}};
    scene["cables"] = Json::array({wire});
    Json roller{{"name", "roller"},
                {"cable", "line"},
                {"on", "tug"},
                {"point", {kStern, 0, kAxis - 0.5}},
                {"axis", {0, 1, 0}},
                {"radius", -wheel},
                {"friction", pick(random, std::array{0.0, 0.1, 0.3})}};
    if (random.chance(0.3)) roller["efficiency"] = random.uniform(0.9, 0.99);
    if (random.chance(0.3)) roller["inertia"] = random.uniform(100, 2e4);
    scene["guides"] = Json::array({roller});
    scene["winches"] = Json::array({{{"name", "winch"},
                                     {"cable", "line"},
                                     {"core_radius", 0.6},
                                     {"width", 2.4},
                                     {"wire_diameter", line > 60 ? 0.137 : 0.076},
                                     {"stored", random.uniform(100, 600)},
                                     {"inertia", 4e4},
                                     {"torque_haul", pick(random, std::array{2e5, 8e5, 1.5e6})},
                                     {"torque_pay", 1.5e6},
                                     {"brake_static", pick(random, std::array{3e5, 1e6, 3e6})},
                                     {"band_friction", 0.3},
                                     {"band_angle", 4.7},
                                     {"mode", "brake"}}});
    scene["timeline"] = random_orders(random, length);
    return scene;
}

TEST(RandomAnchors, AreVerifiedOverGuides) {
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() /
        ("hawser_random_anchor_" + std::to_string(::getpid()) + ".json");
    const std::uint32_t first = first_seed(1);
    const std::uint32_t last =
        first + static_cast<std::uint32_t>(seed_count(kSanitized ? 1 : 2, 20, 300)) - 1;
    int refused = 0, ended = 0, cut = 0;
    long steps = 0, edits = 0;
    for (std::uint32_t seed = first; seed <= last && !HasFailure(); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::ofstream(file) << random_rig(seed);
        try {
            Session session({.scene = file.string(), .verify = true});
            Status status = Status::ok;
            while (status == Status::ok && session.time() < kRigSeconds - 1e-9)
                status = session.step();
            EXPECT_EQ(session.objection(), "") << session.time();
            const World& world = session.world();
            if (status == Status::ok) {
                EXPECT_NE(world.verdict().grade, Grade::wrong);
            } else {
                ++ended;
                std::printf("seed %u ends at %.2f s: %s\n", seed, session.time(),
                            to_string(status));
            }
            steps += static_cast<long>(world.step_count());
            edits += static_cast<long>(world.stats().repairs + world.stats().plans);
            cut += world.events().extremes(EventKind::cut).count > 0 ? 1 : 0;
            session.finish();
        } catch (const scene::SceneError& error) {
            ++refused;  // an element that starts inside the wheel
            EXPECT_NE(std::string(error.what()).find("closer than their radii"), std::string::npos)
                << error.what();
        }
    }
    std::filesystem::remove(file);
    const auto count = static_cast<int>(last - first + 1);
    std::printf("%d rigs, %ld steps, %ld with edits, %d wires cut, %d refused, %d ended early\n",
                count, steps, edits, cut, refused, ended);
    EXPECT_LE(refused, count / 2);
    EXPECT_LE(ended, count / 20);
}

}  // namespace
}  // namespace hawser::test
