// SPDX-License-Identifier: Apache-2.0
#include <hawser/recording.h>
#include "record/small_scene.h"
#include "record/snapshot_file.h"
#include "support/tier.h"

#include <cmath>
#include <random>

namespace hawser::test {

using record::Recording;

constexpr int kSteps = 6;

TEST(Recording, ReturnsWhatWasWritten) {
    const auto file = fresh_folder() / "r.hwr";
    SmallScene scene;
    scene.record(file, kSteps);
    const Recording r = Recording::open(file);
    EXPECT_EQ(r.damage, "");
    EXPECT_EQ(r.scene_name, "small");
    EXPECT_EQ(r.scene_text, scene.info.text);
    EXPECT_EQ(r.scene_hash, scene.info.hash);
    EXPECT_EQ(r.settings.instruction_set, instruction_set());
    ASSERT_EQ(r.bodies.size(), 3u);
    EXPECT_EQ(r.bodies[2].name, "box & <friends>");
    EXPECT_EQ(r.bodies[2].half_size, Vec3(0.3, 0.3, 0.3));
    ASSERT_EQ(r.cables.size(), 1u);
    EXPECT_EQ(r.cables[0].nodes, (std::vector<std::int32_t>{0, 1, 2}));
    EXPECT_EQ(r.element_count, 2);
    ASSERT_EQ(r.inputs.size(), 1u);
    EXPECT_EQ(r.inputs[0].step, 3);
    EXPECT_EQ(r.inputs[0].value, 20.0);
    ASSERT_EQ(r.events.size(), 1u);
    EXPECT_EQ(r.events[0].where, "wire/s1");
    EXPECT_EQ(r.ending, record::Ending::finished);
    EXPECT_EQ(r.end_step, kSteps);
    EXPECT_EQ(r.end_hash, scene.world.state().hash());
    ASSERT_EQ(r.frame_count(), kSteps + 1u);
    const record::Frame last = r.frame(kSteps);
    EXPECT_EQ(last.hash, scene.world.state().hash());
    EXPECT_DOUBLE_EQ(last.time, scene.world.time());
    for (int body = 0; body < 3; ++body) {
        const Pose pose = scene.world.pose({body});
        // Single precision.
        EXPECT_LT((last.poses[std::size_t(body)].position - pose.position).norm(), 1e-6);
        EXPECT_LT(last.poses[std::size_t(body)].orientation.angularDistance(pose.orientation),
                  1e-6);
    }
    EXPECT_FLOAT_EQ(last.tensions[1],
                    float(record::element_tension(scene.world, scene.info.cables[0].elements[1])));
    EXPECT_GT(last.tensions[0], 0.0f);
    ASSERT_EQ(r.outputs.size(), 1u);
    EXPECT_EQ(r.outputs[0].name, "box.z");
    EXPECT_EQ(r.outputs[0].unit, "m");
    EXPECT_EQ(r.output_values(kSteps), std::vector<double>{scene.world.pose({2}).position.z()});
}

TEST(Recording, HasOutputsThatCameAndWent) {
    const auto file = fresh_folder() / "r.hwr";
    SmallScene scene;
    World& world = scene.world;
    record::RecordingWriter out(file, scene.info, world,
                                {.step = world.settings().step,
                                 .instruction_set = instruction_set(),
                                 .version = version(),
                                 .processor = "test"});
    std::vector<double> z, x;
    const auto frame = [&](bool with_x) {
        ASSERT_EQ(world.step(), Status::ok);
        out.add_frame(world);
        z.push_back(world.pose({2}).position.z());
        x.push_back(with_x ? world.pose({2}).position.x() : NAN);
    };
    frame(false);
    const OutputId extra = world.add_output({.name = "x", .body = BodyId{2}, .component = "x"});
    frame(true);
    frame(true);
    world.remove_output(extra);
    frame(false);
    (void)world.add_output({.name = "x", .body = BodyId{2}, .component = "x"});
    frame(true);
    world.remove_output(world.find_output("box.z"));
    world.remove_output(world.find_output("x"));
    frame(false);
    z.back() = NAN;
    out.finish(world, record::Ending::finished);
    const Recording r = Recording::open(file);
    EXPECT_EQ(r.damage, "");
    ASSERT_EQ(r.outputs.size(), 2u);
    ASSERT_EQ(r.frame_count(), z.size() + 1);
    for (std::size_t i = 0; i < z.size(); ++i) {
        const std::vector<double> values = r.output_values(i + 1);
        const auto same = [](double a, double b) { return a == b || (a != a && b != b); };
        EXPECT_TRUE(same(values[0], z[i])) << "frame " << i;
        EXPECT_TRUE(same(values[1], x[i])) << "frame " << i;
    }
}

TEST(Recording, ReplaysFromItsSnapshot) {
    const auto file = fresh_folder() / "r.hwr";
    SmallScene scene;
    ASSERT_EQ(scene.world.step(), Status::ok);
    scene.record(file, kSteps);
    const Recording r = Recording::open(file);
    SmallScene again;
    again.world.state().restore(r.snapshot);
    EXPECT_EQ(again.world.state().hash(), r.start_hash);
    std::size_t next = 0;
    for (std::size_t i = 1; i < r.frame_count(); ++i) {
        for (; next < r.inputs.size() && r.inputs[next].step <= again.world.step_count(); ++next)
            again.world.set_input({r.inputs[next].input}, r.inputs[next].value);
        ASSERT_EQ(again.world.step(), Status::ok);
        EXPECT_EQ(again.world.state().hash(), r.frame_head(i).hash) << "frame " << i;
    }
}

TEST(Recording, CutAnywhereGivesItsWholeFrames) {
    const auto file = fresh_folder() / "r.hwr";
    SmallScene scene;
    scene.record(file, kSteps);
    const std::vector<std::byte> bytes = read_bytes(file);
    const Recording whole = Recording::read(bytes, "whole");
    std::size_t most = 0;
    int readable = 0;
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        try {
            const Recording cut =
                Recording::read({bytes.begin(), bytes.begin() + long(size)}, "cut");
            ++readable;
            EXPECT_NE(cut.damage, "") << "at " << size;
            EXPECT_GE(cut.frame_count(), most) << "at " << size;
            most = cut.frame_count();
            for (std::size_t i = 0; i < cut.frame_count(); ++i)
                ASSERT_EQ(cut.frame(i).hash, whole.frame_head(i).hash);
        } catch (const record::RecordingError&) {
            EXPECT_EQ(readable, 0) << "refused at " << size << " after a shorter one was read";
        }
    }
    EXPECT_EQ(most, whole.frame_count());
}

TEST(Recording, DamagedBytesAreNoticed) {
    const auto file = fresh_folder() / "r.hwr";
    SmallScene scene;
    scene.record(file, kSteps);
    const std::vector<std::byte> bytes = read_bytes(file);
    std::mt19937 random(first_seed(1));
    const auto stride = static_cast<std::uint32_t>(by_tier(7, 1, 1));
    for (std::size_t at = random() % stride; at < bytes.size(); at += stride) {
        std::vector<std::byte> bad = bytes;
        bad[at] ^= std::byte(1 + random() % 255);
        try {
            const Recording r = Recording::read(bad, "bad");
            EXPECT_NE(r.damage, "") << "byte " << at;
        } catch (const record::RecordingError&) {
        }
    }
}

// Chunks with a valid checksum and invalid contents, like those of an attacker.
TEST(Recording, HostileChunksAreRefused) {
    const auto file = fresh_folder() / "r.hwr";
    SmallScene scene;
    scene.record(file, 1);
    const std::vector<std::byte> bytes = read_bytes(file);
    std::mt19937 random(first_seed(2));
    const int rounds = by_tier(3000, 20'000, 300'000);
    for (int round = 0; round < rounds; ++round) {
        std::vector<std::byte> bad(bytes.begin(), bytes.begin() + 12);
        const std::span<const std::byte> all(bytes);
        record::ByteReader in(all.subspan(12));
        while (in.bytes_left() > 0) {
            auto head = in.take(8);
            record::ByteReader size(head.subspan(4));
            const auto payload = in.take(size.get<std::uint32_t>());
            (void)in.get<std::uint32_t>();
            std::vector<std::byte> changed(payload.begin(), payload.end());
            for (int k = 0; k < 2 && !changed.empty() && random() % 3 == 0; ++k) {
                // Extreme values of whole words detect more than single bits.
                const std::size_t at = random() % changed.size();
                for (std::size_t j = at; j < std::min(changed.size(), at + 4); ++j)
                    changed[j] = std::byte(random() % 2 == 0 ? 0xFF : random() % 256);
            }
            if (random() % 20 == 0) changed.resize(random() % (changed.size() + 1));
            record::ByteWriter out;
            out.write_bytes(head.first(4));
            out.put(std::uint32_t(changed.size()));
            const std::uint32_t crc = record::crc32(changed, record::crc32(out.bytes()));
            out.write_bytes(changed);
            out.put(crc);
            bad.insert(bad.end(), out.bytes().begin(), out.bytes().end());
        }
        try {
            const Recording r = Recording::read(std::move(bad), "hostile");
            for (std::size_t i = 0; i < r.frame_count(); ++i) (void)r.frame(i);
        } catch (const record::RecordingError&) {
        }
    }
}

TEST(Recording, OtherFilesAreRefused) {
    EXPECT_THROW((void)Recording::open("no_such_file.hwr"), record::RecordingError);
    EXPECT_THROW((void)Recording::open("scenes"), record::RecordingError);
    EXPECT_THROW((void)Recording::read({}, "empty"), record::RecordingError);
}

TEST(SnapshotFile, ContinuesTheSame) {
    const auto file = fresh_folder() / "s.hws";
    SmallScene scene;
    for (int i = 0; i < 5; ++i) ASSERT_EQ(scene.world.step(), Status::ok);
    record::save_snapshot(file, scene.info, scene.world);
    SmallScene other;
    record::restore_snapshot(file, other.info, other.world);
    for (int i = 0; i < 5; ++i) {
        ASSERT_EQ(scene.world.step(), Status::ok);
        ASSERT_EQ(other.world.step(), Status::ok);
        EXPECT_EQ(scene.world.state().hash(), other.world.state().hash());
    }
}

TEST(SnapshotFile, RefusesAnotherSceneAndDamage) {
    const auto folder = fresh_folder();
    SmallScene scene;
    ASSERT_EQ(scene.world.step(), Status::ok);
    record::save_snapshot(folder / "s.hws", scene.info, scene.world);
    SmallScene other;
    const std::uint64_t before = other.world.state().hash();
    other.info.hash = 77;
    other.info.name = "another";
    try {
        record::restore_snapshot(folder / "s.hws", other.info, other.world);
        FAIL() << "a snapshot of another scene was accepted";
    } catch (const record::SnapshotError& e) {
        EXPECT_NE(std::string(e.what()).find("\"small\""), std::string::npos) << e.what();
        EXPECT_NE(std::string(e.what()).find("\"another\""), std::string::npos) << e.what();
    }
    other.info.hash = scene.info.hash;
    const std::vector<std::byte> bytes = read_bytes(folder / "s.hws");
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        std::ofstream(folder / "cut.hws", std::ios::binary)
            .write(reinterpret_cast<const char*>(bytes.data()), long(size));
        EXPECT_THROW(record::restore_snapshot(folder / "cut.hws", other.info, other.world),
                     record::SnapshotError);
    }
    EXPECT_EQ(other.world.state().hash(), before);
}

}  // namespace hawser::test
