// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file small_scene.h
/// A box on a short cable, pushed by an input: small enough to truncate its recording at every
/// byte.

#include <hawser/recording.h>
#include "record/recording_writer.h"
#include "record/scene_info.h"

#include <gtest/gtest.h>
#include <hawser/hawser.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace hawser::test {

struct SmallScene {
    World world;
    record::SceneInfo info;

    SmallScene() : world(WorldDef{.step = 1.0 / 60.0}) {
        const BodyId top = world.add_body({.name = "top", .kind = BodyKind::fixed});
        const BodyId node = world.add_body(
            {.name = "wire/1", .kind = BodyKind::lump, .position = {0.3, 0, -1}, .mass = 2.0});
        const BodyId box = world.add_body({.name = "box & <friends>",
                                           .position = {0.6, 0, -2},
                                           .mass = 50.0,
                                           .inertia = Mat3::Identity() * 4.0,
                                           .half_size = {0.3, 0.3, 0.3}});
        std::vector<InteractionId> elements;
        for (const auto& [a, b] : {std::pair(top, node), std::pair(node, box)}) {
            InteractionDef def{.name = "wire/s" + std::to_string(elements.size()),
                               .kind = InteractionKind::Stretch,
                               .body = {a, b}};
            elements.push_back(world.add_interaction(def.set("length", 1.04).set("EA", 1e5)));
        }
        world.add_input(
            {.name = "box.push", .param = {}, .body = box, .component = 0, .min = -50, .max = 50});
        world.add_output({.name = "box.z", .body = box, .component = "z", .unit = "m"});
        info.name = "small";
        info.path = "small.json";
        info.text = "{\"name\": \"small\"}";
        info.hash = 0x1234;
        info.cables.push_back({"wire", "rope", {top, node, box}, elements, 1e5, 1e4, 2.08});
        info.plot_cables = {0};
        info.plot_bodies = {box};
    }

    /// Record `steps` steps with a push after the third.
    void record(const std::filesystem::path& file, int steps) {
        record::RecordingWriter out(file, info, world,
                                    {.step = world.settings().step,
                                     .instruction_set = instruction_set(),
                                     .version = version(),
                                     .processor = "test"});
        for (int i = 0; i < steps; ++i) {
            if (i == 3) {
                const record::RecordedInput push{world.step_count(), 0, 20.0};
                world.set_input({0}, push.value);
                out.add_inputs({&push, 1});
            }
            ASSERT_EQ(world.step(), Status::ok);
            out.add_frame(world);
        }
        out.add_event(world, {1.5, EventKind::line_break, {1}, 7e3});
        out.finish(world, record::Ending::finished);
    }
};

inline std::vector<std::byte> read_bytes(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    const std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    const auto* data = reinterpret_cast<const std::byte*>(text.data());
    return {data, data + text.size()};
}

/// Return an empty folder of this test.
inline std::filesystem::path fresh_folder() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    const auto folder = std::filesystem::path(testing::TempDir()) / "hawser" /
                        (std::string(test->test_suite_name()) + "." + test->name());
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    return folder;
}

}  // namespace hawser::test
