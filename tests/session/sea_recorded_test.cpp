// SPDX-License-Identifier: Apache-2.0
/// Recordings of wires in a sea: loads of the sea on nodes are computed again by the replay, loads
/// with another part are recorded. Recordings of the earlier format contain all loads.
#include <hawser/hawser.h>
#include <hawser/recording.h>
#include <hawser/session.h>

#include "record/bytes.h"
#include "record/recording_listener.h"
#include "record/recording_writer.h"
#include "record/scene_info.h"
#include "support/repeat.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hawser::test {
namespace {

/// A wire in waves of a spectrum, with a clump weight and a floating body in the water; a winch
/// that hauls in and pays out nodes; a cut in a step.
constexpr const char* kWire = R"({
  "version": 1, "name": "wire_at_sea", "settings": {"step": 0.02},
  "line_types": {"wire": {"mass_per_length": 5, "EA": 5e6, "diameter": 0.04, "cd_normal": 1.5}},
  "bodies": [
    {"name": "tug", "kind": "fixed", "position": [0, 0, 3]},
    {"name": "box", "position": [80, 0, 0], "mass": 2000, "inertia": [900, 900, 900],
     "half_size": [0.5, 0.5, 0.5]},
    {"name": "barge", "kind": "fixed", "position": [60, 0, 2]}],
  "cables": [
    {"name": "tow", "line_type": "wire", "from": {"body": "tug"}, "to": {"body": "barge"},
     "length": 64, "elements": 32, "shape": "hanging", "consistent_mass": true},
    {"name": "tail", "line_type": "wire", "from": {"body": "barge"}, "to": {"body": "box"},
     "length": 24, "elements": 8, "shape": "hanging", "consistent_mass": true}],
  "winches": [{"name": "hoist", "cable": "tow", "core_radius": 0.5, "width": 1, "stored": 30,
     "inertia": 60, "torque_haul": 4e4, "brake_static": 2e4}],
  "sea": {"depth": 50, "waves": [{"kind": "jonswap", "height": 2, "period": 6, "components": 40}],
          "current": [{"speed": 0.5, "direction_deg": 90}],
          "bodies": [{"body": "box", "volume": 3, "drag_area": [1, 1, 1], "height": 1}]},
  "timeline": [
    {"at": 0.5, "set": {"hoist.mode": "speed", "hoist.speed": -1.5, "sea.waves": 0.7}},
    {"at": 2, "set": {"hoist.speed": 1.5, "sea.level": 0.4}},
    {"at": 3, "cut": "tow", "s": 30}]
})";
constexpr int kSteps = 250;

std::filesystem::path test_file() {
    return std::filesystem::temp_directory_path() /
           ("hawser_sea_recorded_" + std::to_string(::getpid()) + ".hwr");
}

void run_to(Session& session, int steps) {
    while (session.world().step_count() < steps) ASSERT_EQ(session.step(), Status::ok);
}

/// Read the finished recording and delete it.
record::Recording recording_of(const std::filesystem::path& file) {
    record::Recording out = record::Recording::open(file);
    std::filesystem::remove(file);
    EXPECT_EQ(out.damage, "");
    return out;
}

/// Number of bodies in the loads of a step, and whether the sea acts on other nodes.
struct StepLoads {
    std::size_t bodies = 0;
    bool sea = false;
    std::vector<std::int32_t> body, freedom, source;
};
StepLoads loads_of(const record::RecordedLoads& loads) {
    StepLoads out;
    record::ByteReader in(loads.bytes);
    out.sea = in.get<std::int32_t>() >= 0;
    if (out.sea) (void)in.take(24);
    out.bodies = in.get<std::uint32_t>();
    for (std::size_t i = 0; i < out.bodies; ++i) {
        out.body.push_back(in.get<std::int32_t>());
        (void)in.get<std::int32_t>();
        const auto n = in.get<std::uint8_t>();
        const auto source = in.get<std::uint8_t>();
        out.freedom.push_back(n);
        out.source.push_back(source);
        const std::size_t numbers = n + 3 * (n * (n + 1u) / 2);
        (void)in.take(8 * numbers * (source == 3 ? 2 : 1));
    }
    in.expect_end();
    return out;
}

/// Return the number of nodes that only water loads, among the recorded ones.
std::ptrdiff_t water_nodes(const StepLoads& step) {
    std::ptrdiff_t count = 0;
    for (std::size_t i = 0; i < step.bodies; ++i)
        count += step.freedom[i] == 3 && step.source[i] == 2 ? 1 : 0;
    return count;
}

/// Loads a body like a system of a program.
class Pull final : public System {
  public:
    explicit Pull(BodyId body) : body_(body) {}
    [[nodiscard]] std::string_view name() const noexcept override { return "pull"; }
    void prestep(Prestep& now, Loads& loads) noexcept override {
        if (!now.world.alive(body_)) return;
        count_ += 1.0;
        loads.add_force(body_, {20.0 * std::sin(0.1 * count_), 5.0, -3.0});
    }
    void visit_state(StateVisitor& visitor) override { visitor.visit(count_); }

  private:
    BodyId body_;
    double count_ = 0.0;  ///< Memory that the replay does not have.
};

/// Moves an input in each step.
class Feed final : public System {
  public:
    Feed(InputId input, double from) : input_(input), length_(from) {}
    [[nodiscard]] std::string_view name() const noexcept override { return "feed"; }
    void prestep(Prestep& now, Loads&) noexcept override {
        length_ += 0.002;
        now.set_input(input_, length_);
    }
    void visit_state(StateVisitor& visitor) override { visitor.visit(length_); }

  private:
    InputId input_;
    double length_;
};

void expect_same_energy(const Energy& a, const Energy& b) {
    EXPECT_EQ(a.kinetic, b.kinetic);
    EXPECT_EQ(a.elastic, b.elastic);
    EXPECT_EQ(a.added, b.added);
    EXPECT_EQ(a.system, b.system);
    EXPECT_EQ(a.water, b.water);
    EXPECT_EQ(a.dissipated, b.dissipated);
    EXPECT_EQ(a.mechanical(), b.mechanical());
}

TEST(SeaRecorded, LoadsOnNodesAreComputedAgain) {
    Session session({.scene_text = kWire});
    session.record(test_file());
    run_to(session, kSteps);
    session.finish();
    const record::Recording r = recording_of(test_file());
    EXPECT_EQ(r.format, 3U);
    EXPECT_EQ(r.seas.size(), 1U);
    ASSERT_GE(r.loads.size(), static_cast<std::size_t>(kSteps));
    std::size_t without = 0;
    for (const record::RecordedLoads& loads : r.loads) {
        const StepLoads step = loads_of(loads);
        without += step.sea ? 0 : 1;
        // The box, the drum and the node beside it are left. The step of the cut has all loads.
        if (step.sea) {
            EXPECT_LE(step.bodies, 3U) << loads.step;
            EXPECT_EQ(water_nodes(step), 0) << loads.step;
        }
    }
    EXPECT_LE(without, 1U);
    for (const int threads : {1, 2}) {
        const Repeated again = expect_repeats(r, threads);
        EXPECT_EQ(again.scene.world.step_count(), kSteps);
        expect_same_energy(again.scene.world.energy(), session.world().energy());
    }
    EXPECT_NE(session.world().energy().water, 0.0);
}

/// Loads of a user's system on nodes in the water, before and after the sea acts.
TEST(SeaRecorded, NodesWithOtherLoadsAreRecorded) {
    scene::Scene scene = scene::load_text(kWire, "wire");
    World& world = scene.world;
    const auto nodes = world.wires().nodes(world.wires().find("tow"));
    const BodyId first = nodes[14], second = nodes[20];
    std::unique_ptr<System> sea = world.remove_system(*world.find_system("sea"));
    world.add_system(std::make_unique<Pull>(first));
    world.add_system(std::move(sea));
    Session session(std::move(scene));
    session.record(test_file());
    run_to(session, 60);
    // A change of the systems within the run.
    World& now = session.world();
    (void)now.remove_system(*now.find_system("pull"));
    now.add_system(std::make_unique<Pull>(second));
    run_to(session, kSteps);
    session.finish();
    const record::Recording r = recording_of(test_file());
    for (const record::RecordedLoads& loads : r.loads) {
        const StepLoads step = loads_of(loads);
        const BodyId pulled = loads.step < 60 ? first : second;
        const auto at = std::find(step.body.begin(), step.body.end(), pulled.index);
        ASSERT_NE(at, step.body.end()) << loads.step;
        if (!step.sea) continue;
        EXPECT_LE(step.bodies, 4U) << loads.step;
        EXPECT_EQ(water_nodes(step), 0) << loads.step;
        EXPECT_NE(step.source[static_cast<std::size_t>(at - step.body.begin())] & 1, 0);
    }
    for (const int threads : {1, 2}) {
        const Repeated again = expect_repeats(r, threads);
        expect_same_energy(again.scene.world.energy(), session.world().energy());
    }
}

/// An input of an element set after the sea has acted: its nodes have the loads of the length
/// before.
TEST(SeaRecorded, LengthsSetAfterTheSeaAreRecorded) {
    for (const bool dry : {false, true}) {
        scene::Scene scene = scene::load_text(kWire, "wire");
        World& world = scene.world;
        const auto elements = world.wires().elements(world.wires().find("tow"));
        const InteractionId element = elements[dry ? elements.size() - 2 : 16];
        const double length = world.interaction_def(element).get("length");
        const InputId input = world.add_input({.name = "feed.length",
                                               .interaction = element,
                                               .param = "length",
                                               .min = 0.1,
                                               .max = 10.0});
        world.add_system(std::make_unique<Feed>(input, length));
        Session session(std::move(scene));
        session.record(test_file());
        run_to(session, 120);
        session.finish();
        const record::Recording r = recording_of(test_file());
        std::size_t with = 0, unloaded = 0;
        for (const record::RecordedLoads& loads : r.loads) {
            const StepLoads step = loads_of(loads);
            with += step.sea && water_nodes(step) == 2 ? 1 : 0;
            unloaded +=
                static_cast<std::size_t>(std::count(step.freedom.begin(), step.freedom.end(), 0));
        }
        EXPECT_EQ(with > 100, !dry) << with;
        EXPECT_EQ(unloaded > 50, dry) << unloaded;
        // The scene of the recording has no such input: add it.
        scene::Scene again = scene::load_text(r.scene_text, "wire");
        while (again.world.system_count() > 0)
            (void)again.world.remove_system(again.world.system(0));
        (void)again.world.add_input({.name = "feed.length",
                                     .interaction = element,
                                     .param = "length",
                                     .min = 0.1,
                                     .max = 10.0});
        again.world.prepare();
        again.world.state().restore(r.snapshot);
        record::Repeater repeater(r);
        for (std::size_t i = 0; i < r.frame_count(); ++i) {
            const record::Frame frame = r.frame_head(i);
            while (again.world.step_count() < frame.step) {
                repeater.before_step(again.world);
                ASSERT_EQ(again.world.step(), Status::ok);
            }
            ASSERT_EQ(again.world.state().motion_hash(), frame.hash) << "step " << frame.step;
        }
    }
}

/// Back to earlier states with other nodes and other inputs of the sea, and another sea.
TEST(SeaRecorded, RestoredStatesAndAnotherSeaAreRepeated) {
    Session session({.scene_text = kWire});
    session.record(test_file());
    run_to(session, 40);
    const Structure made_of = session.world().state().structure();
    const std::vector<std::byte> state = session.world().state().save();
    run_to(session, 170);
    session.restore(made_of, state);
    session.set_input("sea.current", 2.0);
    run_to(session, 102);  // after the timeline has set the sea
    World& world = session.world();
    SeaDef other = *find_sea(world);
    other.waves[0].seed = 7;
    (void)world.remove_system(*world.find_system("sea"));
    run_to(session, 110);
    world.add(other);
    run_to(session, 200);
    session.finish();
    const record::Recording r = recording_of(test_file());
    EXPECT_EQ(r.takes.size(), 1U);
    EXPECT_EQ(r.seas.size(), 2U);
    for (const int threads : {1, 2}) {
        const Repeated again = expect_repeats(r, threads);
        EXPECT_EQ(again.scene.world.step_count(), 200);
    }
}

/// Record the run of a scene with a writer of a storage.
std::uintmax_t record_with(record::LoadStorage storage, const std::filesystem::path& file) {
    scene::Scene scene = scene::load_text(kWire, "wire");
    World& world = scene.world;
    world.prepare();
    const record::SceneInfo info = record::make_scene_info(scene);
    {
        record::RecordingWriter out(file, info, world,
                                    {.step = world.settings().step,
                                     .instruction_set = instruction_set(),
                                     .version = version(),
                                     .processor = "test"},
                                    storage);
        record::RecordingListener listener(out, world);
        for (int i = 0; i < 100; ++i) {
            listener.flush();
            const std::int64_t step = world.step_count();
            EXPECT_EQ(world.step(), Status::ok);
            listener.flush(step);
            out.add_loads(world);
            out.add_frame(world);
        }
        out.finish(world, record::Ending::finished);
    }
    return std::filesystem::file_size(file);
}

TEST(SeaRecorded, EarlierFormatIsRepeated) {
    const std::uintmax_t all = record_with(record::LoadStorage::all, test_file());
    const record::Recording r = recording_of(test_file());
    EXPECT_EQ(r.format, 2U);
    EXPECT_TRUE(r.seas.empty());
    for (const int threads : {1, 2})
        EXPECT_EQ(expect_repeats(r, threads).scene.world.step_count(), 100);
    const std::uintmax_t needed = record_with(record::LoadStorage::needed, test_file());
    const record::Recording small = recording_of(test_file());
    EXPECT_EQ(small.format, 3U);
    (void)expect_repeats(small, 1);
    // Head of the chunk, box, drum and the node beside it (docs/recording.md, LOAD).
    constexpr std::size_t kHead = 4 + 24 + 4, kBox = 10 + 8 * 69, kDrum = 10 + 8 * 4,
                          kNode = 10 + 2 * 8 * 21;
    std::size_t bytes = 0;
    for (const record::RecordedLoads& loads : small.loads) bytes += loads.bytes.size();
    EXPECT_LE(bytes, small.loads.size() * (kHead + kBox + kDrum + kNode));
    std::size_t before = 0;
    for (const record::RecordedLoads& loads : r.loads) before += loads.bytes.size();
    EXPECT_LT(4 * bytes, before);
    EXPECT_LT(needed + 3 * (before / 4), all + 4096);
    // The estimate for the stride of frames counts name, length, checksum, step and the box.
    const scene::Scene scene = scene::load_text(kWire, "wire");
    EXPECT_EQ(record::sea_load_bytes(scene.world), 12 + 8 + kHead + kBox);
}

}  // namespace
}  // namespace hawser::test
