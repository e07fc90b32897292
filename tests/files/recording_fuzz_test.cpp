// SPDX-License-Identifier: Apache-2.0
/// Recordings and snapshot files with changed contents and valid checksums are rejected or read.
/// Files that were read can be drawn.
#include "draw/plots.h"
#include "draw/raster.h"
#include "draw/svg.h"
#include "export/gltf_layout.h"
#include "files/mutate.h"
#include "record/bytes.h"
#include "record/joined_deck.h"
#include "record/small_scene.h"
#include "record/snapshot_file.h"

#include <cmath>
#include <cstdio>

namespace hawser::test {
namespace {

using record::Recording;

struct Chunk {
    std::array<std::byte, 4> kind{};
    std::vector<std::byte> payload;
};

constexpr std::size_t kMagicBytes = 12;

std::vector<Chunk> chunks_of(std::span<const std::byte> file) {
    std::vector<Chunk> out;
    record::ByteReader in(file.subspan(kMagicBytes));
    while (in.bytes_left() > 0) {
        Chunk chunk;
        std::memcpy(chunk.kind.data(), in.take(4).data(), 4);
        const auto payload = in.take(in.get<std::uint32_t>());
        chunk.payload.assign(payload.begin(), payload.end());
        (void)in.get<std::uint32_t>();
        out.push_back(std::move(chunk));
    }
    return out;
}

/// Write a file of some chunks, each with a valid checksum.
std::vector<std::byte> file_of(std::span<const std::byte> magic, const std::vector<Chunk>& chunks) {
    record::ByteWriter out;
    out.write_bytes(magic);
    for (const Chunk& chunk : chunks) {
        const std::size_t from = out.bytes().size();
        out.write_bytes(chunk.kind);
        out.put(static_cast<std::uint32_t>(chunk.payload.size()));
        out.write_bytes(chunk.payload);
        out.put(record::crc32(out.bytes().subspan(from)));
    }
    return {out.bytes().begin(), out.bytes().end()};
}

void forge(std::vector<Chunk>& chunks, Random& random) {
    const auto any = [&] {
        return static_cast<std::size_t>(random.integer(0, static_cast<int>(chunks.size()) - 1));
    };
    for (int i = random.integer(1, 3); i > 0; --i) {
        std::vector<std::byte>& payload = chunks[any()].payload;
        mutate(payload, random);
        if (random.chance(0.05) && !payload.empty())
            payload.resize(
                static_cast<std::size_t>(random.integer(0, static_cast<int>(payload.size()) + 16)));
    }
    if (random.chance(0.05)) std::swap(chunks[any()], chunks[any()]);
    if (random.chance(0.05)) chunks.push_back(chunks[any()]);
    if (random.chance(0.02)) chunks.erase(chunks.begin() + static_cast<std::ptrdiff_t>(any()));
}

/// Check the guarantees of the reader.
void expect_sound(const Recording& r) {
    std::int64_t step = r.start_step - 1;
    for (std::size_t i = 0; i < r.frame_count(); ++i) {
        const record::Frame frame = r.frame(i);
        ASSERT_GT(frame.step, step);
        ASSERT_TRUE(i == 0 || frame.step - step <= r.settings.stride);
        step = frame.step;
        ASSERT_TRUE(std::isfinite(frame.energy));
        ASSERT_EQ(frame.poses.size(), r.bodies.size());
        for (const Pose& pose : frame.poses) {
            ASSERT_TRUE(pose.position.allFinite());
            ASSERT_NEAR(pose.orientation.norm(), 1.0, 2e-3);
        }
        for (const float tension : frame.tensions) ASSERT_TRUE(std::isfinite(tension));
        for (const float pull : frame.line_pulls) ASSERT_TRUE(std::isfinite(pull));
        ASSERT_TRUE(frame.lines == nullptr || frame.gone_joints != nullptr);
        const std::vector<double> outputs = r.output_values(i);
        ASSERT_EQ(outputs.size(), r.outputs.size());
        for (const double value : outputs) ASSERT_FALSE(std::isinf(value));
    }
    for (const record::RecordedInput& input : r.inputs) ASSERT_GE(input.input, 0);
    if (r.ending != record::Ending::unknown) {
        ASSERT_GE(r.end_step, step);
    }
}

void draw(const Recording& r) {
    if (r.frame_count() == 0) return;
    const record::Series series = record::collect_series(r);
    for (const auto& drawing :
         {draw::plot_tensions(r, series), draw::plot_motions(r, series),
          draw::plot_views(r, series, r.frame_count() - 1), draw::plot_details(r, 0),
          draw::plot_space(r, series, r.frame_count() - 1, {})})
        if (drawing) (void)draw::to_svg(*drawing);
    const auto frames = exporting::choose_frames(r, 2, -1e300, 1e300);
    if (!frames.empty()) (void)exporting::compute_layout(r, frames);
}

void forge_recordings(const std::filesystem::path& file, int inputs) {
    const std::vector<std::byte> good = read_bytes(file);
    const std::vector<Chunk> chunks = chunks_of(good);
    const auto magic = std::span<const std::byte>(good).first(kMagicBytes);
    ASSERT_EQ(file_of(magic, chunks), good);
    Random random(first_seed(8));
    int whole = 0, partly = 0, refused = 0;
    for (int i = 0; i < inputs; ++i) {
        std::vector<Chunk> bad = chunks;
        forge(bad, random);
        try {
            const Recording r = Recording::read(file_of(magic, bad), "forged");
            ++(r.damage.empty() ? whole : partly);
            expect_sound(r);
            ASSERT_FALSE(testing::Test::HasFatalFailure()) << "input " << i;
            if (i % 20 == 0) draw(r);  // slow
        } catch (const record::RecordingError& e) {
            ++refused;
            ASSERT_EQ(std::string(e.what()).rfind("forged: ", 0), 0u) << e.what();
        }
    }
    std::printf("%d forged recordings: %d refused, %d read in part, %d whole\n", inputs, refused,
                partly, whole);
    EXPECT_GT(whole, 0);
    EXPECT_GT(partly, 0);
    EXPECT_GT(refused, 0);
}

TEST(ForgedRecordings, AreRefusedOrSound) {
    const auto file = fresh_folder() / "r.hwr";
    SmallScene scene;
    scene.record(file, 5);
    forge_recordings(file, inputs_of(1000, 10'000, 500'000));
}

/// With lines that are added and removed.
TEST(ForgedRecordings, OfJoinedWiresAreRefusedOrSound) {
    const auto file = fresh_folder() / "r.hwr";
    (void)JoinedDeck().record(file);
    forge_recordings(file, inputs_of(300, 3000, 100'000));
}

/// Forge a file of the world's state and restore it in that world. The world stays unchanged or
/// accepts it. @param first  Number of leading bytes that are changed in every other file.
void forge_snapshots(SmallScene& scene, bool with_structure, std::size_t first) {
    const auto folder = fresh_folder();
    record::save_snapshot(folder / "good.hws", scene.info, scene.world, with_structure);
    const std::vector<std::byte> good = read_bytes(folder / "good.hws");
    const auto hash = scene.world.state().hash();
    Random random(first_seed(9));
    int taken = 0, refused = 0;
    for (int i = 0; i < inputs_of(100, 1000, 20'000); ++i) {
        std::vector<std::byte> bad = good;
        mutate(std::span(bad).first(random.chance(0.5) ? first : bad.size() - 4), random);
        const std::uint32_t crc = record::crc32(std::span(bad).first(bad.size() - 4));
        write_at(std::span(bad), bad.size() - 4, crc);
        std::ofstream(folder / "bad.hws", std::ios::binary)
            .write(reinterpret_cast<const char*>(bad.data()), std::ssize(bad));
        try {
            record::restore_snapshot(folder / "bad.hws", scene.info, scene.world);
            ++taken;
        } catch (const record::SnapshotError&) {
            ++refused;
        }
        ASSERT_EQ(scene.world.state().hash(), hash) << "input " << i;
    }
    std::printf("forged snapshot files%s: %d refused, %d taken\n",
                with_structure ? " with a structure" : "", refused, taken);
    EXPECT_GT(refused, 0);
}

/// Header around the state of a world: name, time and hash of the file.
TEST(ForgedRecordings, SnapshotFilesAreRefusedOrTaken) {
    SmallScene scene;
    ASSERT_EQ(scene.world.step(), Status::ok);
    forge_snapshots(scene, false, 64);
}

/// Definitions of the world.
TEST(ForgedRecordings, SnapshotFilesWithAStructureAreRefusedOrTaken) {
    SmallScene scene;
    World& w = scene.world;
    const BodyId post =
        w.add_body({.name = "post", .kind = BodyKind::fixed, .position = {0, 9, 9}});
    const WireId wire = w.wires().add({.name = "cut in two",
                                       .from = post,
                                       .elements = 6,
                                       .length = 12.0,
                                       .EA = 1e6,
                                       .mass_per_length = 3.0,
                                       .EI = 10.0,
                                       .radius = 0.02,
                                       .consistent_mass = true});
    ASSERT_EQ(w.step(), Status::ok);
    (void)w.wires().cut(wire, 5.0);
    ASSERT_EQ(w.step(), Status::ok);
    forge_snapshots(scene, true, 8000);
}

}  // namespace
}  // namespace hawser::test
