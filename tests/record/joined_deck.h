// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file joined_deck.h
/// Two hanging wires that are shackled to each other while the world runs, and a box on a stay. A
/// hook takes the box, the stay is cut, and the hook releases it. Contains the recording and the
/// expected lines other than wires.

#include "record/small_scene.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace hawser::test {

struct JoinedDeck {
    /// Steps after which the operations happen.
    static constexpr int kTaken = 10, kJoined = 20, kStayGone = 30, kLetGo = 40, kSteps = 50;
    struct Line {
        std::array<Vec3, 2> ends;
        double pull;
    };

    World w{WorldDef{.step = 0.01}};
    record::SceneInfo info;
    InteractionId stay{};
    WireId a{}, b{};
    /// Links and legs by name, for each frame.
    std::vector<std::map<std::string, Line>> lines;

    JoinedDeck() {
        const BodyId quay = w.add_body({.name = "quay", .kind = BodyKind::fixed});
        const auto hang = [&](const char* name, double x) {
            WireDef def{.name = name, .from = quay, .from_point = {x, 0, 10}, .elements = 4};
            def.length = 8.0;
            def.EA = 1e6;
            def.mass_per_length = 5.0;
            const WireId wire = w.wires().add(def);
            const auto nodes = w.wires().nodes(wire);
            const auto elements = w.wires().elements(wire);
            info.cables.push_back({name,
                                   "wire",
                                   {nodes.begin(), nodes.end()},
                                   {elements.begin(), elements.end()},
                                   1e6,
                                   0.0,
                                   8.0});
            return wire;
        };
        a = hang("a", 0.0);
        b = hang("b", 1.0);
        const BodyId box = w.add_body({.name = "box",
                                       .position = {5, 0, 2},
                                       .mass = 100.0,
                                       .inertia = Mat3::Identity() * 20.0,
                                       .half_size = {0.5, 0.5, 0.5}});
        InteractionDef line{.name = "stay", .kind = InteractionKind::Stretch, .body = {quay, box}};
        line.point[0] = {5, 0, 8};
        line.point[1] = {0, 0, 0.5};
        stay = w.add_interaction(line.set("length", 5.5).set("EA", 1e6));
        w.add(HookDef{
            .name = "hook",
            .body = quay,
            .point = {5, 0, 6},
            .loads = {{.body = box, .eyes = {{0, 0, 0.5}}, .sling_length = 3.6, .sling_EA = 1e6}}});
        info.name = "joined";
    }

    record::Recording record(const std::filesystem::path& file) {
        record::RecordingWriter out(file, info, w,
                                    {.step = w.settings().step,
                                     .instruction_set = instruction_set(),
                                     .version = version(),
                                     .processor = "test"});
        lines.emplace_back();  // frame of the start
        for (int i = 0; i < kSteps; ++i) {
            if (i == kTaken) w.set_system_signal("hook.take", 1);
            if (i == kJoined)
                (void)w.wires().join(
                    a, 1, b, 1,
                    {.name = "strop", .gear = Gear::shackle, .length = 1.0, .reach = 1.0});
            if (i == kStayGone) w.remove_interaction(stay);
            if (i == kLetGo) w.set_system_signal("hook.take", 0);
            EXPECT_EQ(w.step(), Status::ok) << i;
            out.add_frame(w);
            std::map<std::string, Line> there;
            for (const char* name : {"strop", "hook/leg1"})
                if (const InteractionId id = w.find_interaction(name); id.valid())
                    there.emplace(name, Line{w.wires().ends(id), std::max(0.0, -w.force(id)[0])});
            lines.push_back(std::move(there));
        }
        out.finish(w, record::Ending::finished);
        return record::Recording::open(file);
    }
};

}  // namespace hawser::test
