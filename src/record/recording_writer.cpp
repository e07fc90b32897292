// SPDX-License-Identifier: Apache-2.0
#include "record/recording_writer.h"
#include "base/body_dof.h"
#include "record/event_input.h"
#include "record/field_bytes.h"

#include "record/files.h"
#include "record/layout_writer.h"
#include "record/outlines.h"
#include "record/recording_format.h"
#include "record/wire_position.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <limits>

namespace hawser::record {

std::size_t frame_bytes(const World& world, const SceneInfo& scene) {
    std::size_t floats = 0;
    for (const BodyId id : world.bodies())
        floats += static_cast<std::size_t>(pose_floats(world.body_def(id).kind));
    for (const CableInfo& cable : scene.cables) floats += cable.elements.size();
    const std::size_t outputs = world.output_ids().size();
    return kChunkOverhead + kFrameHeadBytes + 4 * floats +
           (outputs > 0 ? kChunkOverhead + 8 * outputs : 0);
}

std::size_t sea_load_bytes(const World& world) {
    const SeaDef* sea = find_sea(world);
    if (sea == nullptr) return 0;
    std::vector<BodyId> bodies;
    for (const auto& body : sea->bodies) bodies.push_back(body.body);
    for (const auto& hull : sea->hulls) bodies.push_back(hull.body);
    for (const auto& rod : sea->rods) bodies.push_back(rod.body);
    std::sort(bodies.begin(), bodies.end());
    bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
    std::size_t bytes = kChunkOverhead + kLoadHeadBytes;
    for (const BodyId id : bodies)
        if (const auto n = static_cast<std::size_t>(base::dof_of(world.body_def(id).kind)); n > 0)
            bytes += kLoadBodyBytes + 8 * load_numbers(n);
    return bytes;
}

namespace {

// Clamp a value to the range of single precision, because readers accept only finite numbers.
double in_range(double value) {
    constexpr double kMaximum = std::numeric_limits<double>::max();
    return std::isnan(value) ? 0.0 : std::clamp(value, -kMaximum, kMaximum);
}
float to_float(double value) {
    constexpr double kMaximum = std::numeric_limits<float>::max();
    return static_cast<float>(std::isnan(value) ? 0.0 : std::clamp(value, -kMaximum, kMaximum));
}

// Write a pose. The position is stored as the difference from the start, because at a kilometre
// from the origin single precision would round it to a tenth of a millimetre.
void write_pose(ByteWriter& out, const Pose& pose, const Pose& start, BodyKind kind) {
    const int floats = pose_floats(kind);
    for (int k = 0; k < std::min(3, floats); ++k)
        out.put(to_float(pose.position[k] - start.position[k]));
    if (floats == 7)
        for (const double q : {pose.orientation.w(), pose.orientation.x(), pose.orientation.y(),
                               pose.orientation.z()})
            out.put(static_cast<float>(q));
}

}  // namespace

RecordingWriter::RecordingWriter(const std::filesystem::path& file, const SceneInfo& scene,
                                 const World& world, const RecordingSettings& settings,
                                 LoadStorage loads)
    : file_(file), loads_(loads), wires_(world), lines_(world, drawn_joints(scene, world)) {
    // A pipe would be waited for.
    if (const std::string fault = output_fault(file); !fault.empty())
        throw RecordingError(
            fmt::format("{}: cannot write the recording: {}", file.string(), fault));
    out_.reset(std::fopen(file.c_str(), "wb"));
    if (!out_) fail();
    for (const CableInfo& cable : scene.cables)
        elements_.insert(elements_.end(), cable.elements.begin(), cable.elements.end());

    // Indices of bodies in the layout are their indices in the world.
    if (world.bodies().size() != static_cast<std::size_t>(world.body_count()))
        throw RecordingError(file.string() +
                             ": bodies were removed before the recording began; begin the "
                             "recording with a world without removals, such as a scene's");
    for (const BodyId id : world.bodies())
        bodies_.push_back({id, world.body_def(id).kind, world.pose(id)});

    const std::uint32_t format = loads == LoadStorage::all ? kAllLoadsVersion : kFormatVersion;
    if (std::fwrite(kMagic, 1, sizeof kMagic, out_.get()) != sizeof kMagic ||
        std::fwrite(&format, 1, sizeof format, out_.get()) != sizeof format)
        fail();

    payload_.put(scene.hash);
    for (const std::string& text : {scene.name, scene.path, scene.text}) payload_.put_text(text);
    write_chunk(kSceneChunk);

    payload_.put(settings.step);
    payload_.put(static_cast<std::uint8_t>(settings.form));
    payload_.put(settings.threads);
    payload_.put(settings.stride);
    for (const std::string& text : {settings.instruction_set, settings.version, settings.processor})
        payload_.put_text(text);
    write_chunk(kSettingsChunk);

    write_layout(payload_, scene, world);
    write_chunk(kLayoutChunk);

    payload_.put(world.step_count());
    payload_.put(world.state().motion_hash());
    payload_.write_bytes(world.state().save_motion());
    write_chunk(kSnapshotChunk);

    write_input_names(payload_, world);
    write_chunk(kInputNamesChunk);
    if (const auto outlines = make_outlines(scene, world); !outlines.empty()) {
        write_outlines(payload_, outlines);
        write_chunk(kOutlineChunk);
    }
    add_frame(world);
}

void RecordingWriter::fail() const {
    throw RecordingError(
        fmt::format("{}: cannot write the recording: {}; free space or choose "
                    "another file",
                    file_.string(), std::strerror(errno)));
}

void RecordingWriter::write_chunk(const char* kind) {
    const std::span<const std::byte> payload = payload_.bytes();
    if (payload.size() > kMaxChunk)
        throw RecordingError(
            fmt::format("{}: the scene is too large for a recording: a chunk "
                        "of {} bytes, at most {}",
                        file_.string(), payload.size(), kMaxChunk));
    ByteWriter head;
    head.write_bytes(std::as_bytes(std::span(kind, 4)));
    head.put(static_cast<std::uint32_t>(payload.size()));
    const std::uint32_t crc = crc32(payload, crc32(head.bytes()));
    if (std::fwrite(head.bytes().data(), 1, head.bytes().size(), out_.get()) !=
            head.bytes().size() ||
        std::fwrite(payload.data(), 1, payload.size(), out_.get()) != payload.size() ||
        std::fwrite(&crc, 1, sizeof crc, out_.get()) != sizeof crc)
        fail();
    payload_.clear();
}

void RecordingWriter::check_complete(const ChangeBytes& changes) const {
    if (changes.failed())
        throw RecordingError(file_.string() +
                             ": a change of the world did not fit into memory; the recording ends "
                             "before it");
}

void RecordingWriter::add_changes(std::int64_t step, std::span<const std::byte> changes,
                                  bool bodies_changed) {
    if (changes.empty()) return;
    payload_.put(step);
    payload_.write_bytes(changes);
    write_chunk(kChangesChunk);
    bodies_changed_ = bodies_changed_ || bodies_changed;
}

/// Choose the bodies of the following frames: those that still exist, by their numbers in the file.
void RecordingWriter::follow_bodies(const World& world) {
    bodies_changed_ = false;
    std::vector<FramedBody> now;
    payload_.put(static_cast<std::uint32_t>(world.bodies().size()));
    auto before = bodies_.begin();
    for (const BodyId id : world.bodies()) {
        while (before != bodies_.end() && before->id < id) ++before;
        if (before != bodies_.end() && before->id == id) {
            payload_.put(static_cast<std::int32_t>(before - bodies_.begin()));
            now.push_back(*before);
            continue;
        }
        payload_.put(std::int32_t{-1});
        write_body(payload_, world.body_def(id), world.pose(id));
        now.push_back({id, world.body_def(id).kind, world.pose(id)});
    }
    write_chunk(kBodiesChunk);
    bodies_ = std::move(now);
}

void RecordingWriter::follow_wires(const World& world) {
    if (!wires_.changed(world)) return;
    wires_changed_ = true;
    wires_.put_wires(payload_, world, bodies_of_frame());
    write_chunk(kWiresChunk);
}

void RecordingWriter::follow_lines(const World& world) {
    if (!lines_.changed(world)) return;
    lines_changed_ = true;
    lines_.write_lines(payload_, world, bodies_of_frame());
    write_chunk(kLinesChunk);
}

void RecordingWriter::follow_water(const World& world) {
    const double now = still_water(world);
    if (!std::isfinite(now) || now == water_) return;
    water_ = now;
    payload_.put(now);
    write_chunk(kWaterChunk);
}

void RecordingWriter::follow_outputs(const World& world) {
    if (!outputs_.changed(world)) return;
    outputs_.write_names(payload_, world);
    write_chunk(kOutputNamesChunk);
}

std::vector<BodyId> RecordingWriter::bodies_of_frame() const {
    std::vector<BodyId> out;
    for (const FramedBody& body : bodies_) out.push_back(body.id);
    return out;
}

void RecordingWriter::add_frame(const World& world) {
    if (bodies_changed_) follow_bodies(world);
    follow_wires(world);
    follow_lines(world);
    follow_water(world);
    follow_outputs(world);
    const StepStats& stats = world.stats();
    payload_.put(world.step_count());
    payload_.put(world.time());
    payload_.put(world.state().motion_hash());
    for (const double figure :
         {stats.violation_max, stats.momentum_residual, world.energy().mechanical()})
        payload_.put(in_range(figure));
    for (const FramedBody& body : bodies_)
        write_pose(payload_, world.pose(body.id), body.start, body.kind);
    for (const InteractionId element : elements_)
        payload_.put(to_float(world.alive(element) ? element_tension(world, element) : 0.0));
    write_chunk(kFrameChunk);
    if (wires_changed_) {
        wires_.write_pulls(payload_, world);
        write_chunk(kPullsChunk);
    }
    if (lines_changed_) {
        lines_.write_pulls(payload_, world);
        write_chunk(kLinePullsChunk);
    }
    if (outputs_.count() == 0) return;
    outputs_.write_values(payload_, world);
    write_chunk(kOutputsChunk);
}

void RecordingWriter::add_inputs(std::span<const RecordedInput> changes) {
    if (changes.empty()) return;
    payload_.put(static_cast<std::uint32_t>(changes.size()));
    for (const RecordedInput& change : changes) {
        payload_.put(change.step);
        payload_.put(change.input);
        payload_.put(change.value);
    }
    write_chunk(kInputsChunk);
}

/// Write the definition of the sea whose loads on nodes of wires are omitted, unless the last chunk
/// has this definition.
void RecordingWriter::follow_sea(const World& world) {
    std::shared_ptr<const LineSea> sea = line_sea(world);
    if (sea == sea_) return;
    PutFields{payload_}(*sea);
    write_chunk(kLineSeaChunk);
    sea_ = std::move(sea);
    ++seas_;
}

void RecordingWriter::add_loads(const World& world) {
    if (loads_ == LoadStorage::all) return add_all_loads(world);
    LoadRecord record = world.load_record();
    if (record.repeats && line_sea(world) == nullptr) record = {world.loads(), false};
    if (record.loads.empty() && !record.repeats) return;
    if (record.repeats) follow_sea(world);
    payload_.put(world.step_count() - 1);
    payload_.put(record.repeats ? seas_ - 1 : -1);
    if (record.repeats) {
        const SeaInputs inputs = acting_inputs(world);
        for (const double input : {inputs.waves, inputs.current, inputs.level}) payload_.put(input);
    }
    payload_.put(static_cast<std::uint32_t>(record.loads.size()));
    for (const LoadView& load : record.loads) {
        const bool shared = !load.water.empty() && load.water.data() != load.force.data();
        const unsigned source = load.force.empty()   ? kNoSource
                                : load.water.empty() ? kOtherSource
                                : shared             ? kOtherSource | kWaterSource
                                                     : kWaterSource;
        payload_.put(load.body.index);
        payload_.put(load.body.generation);
        payload_.put(static_cast<std::uint8_t>(load.force.size()));
        payload_.put(static_cast<std::uint8_t>(source));
        for (const auto& numbers : {load.force, load.mass, load.damping, load.stiffness})
            payload_.write_bytes(std::as_bytes(numbers));
        if (shared) payload_.write_bytes(std::as_bytes(load.water));
    }
    write_chunk(kLoadsChunk);
}

void RecordingWriter::add_all_loads(const World& world) {
    const std::vector<LoadView> loads = world.loads();
    if (loads.empty()) return;
    payload_.put(world.step_count() - 1);
    payload_.put(static_cast<std::uint32_t>(loads.size()));
    for (const LoadView& load : loads) {
        payload_.put(load.body.index);
        payload_.put(load.body.generation);
        payload_.put(static_cast<std::uint8_t>(load.force.size()));
        for (const auto& numbers : {load.force, load.mass, load.damping, load.stiffness})
            payload_.write_bytes(std::as_bytes(numbers));
    }
    write_chunk(kLoadsChunk);
}

void RecordingWriter::add_note(std::int64_t step, std::string_view kind,
                               std::span<const std::byte> bytes) {
    payload_.put(step);
    payload_.put_text(kind);
    payload_.write_bytes(bytes);
    write_chunk(kNoteChunk);
}

void RecordingWriter::add_cut(const RecordedCut& cut) {
    payload_.put(cut.step);
    payload_.put(cut.left_out.iterations);
    payload_.put(static_cast<std::uint8_t>(cut.left_out.hasty ? 1 : 0));
    payload_.put(static_cast<std::uint8_t>(cut.cause));
    payload_.put(cut.foreseen);
    payload_.put(cut.left_out.cuts);
    payload_.put(cut.left_out.wires);
    write_chunk(kCutChunk);
}

void RecordingWriter::add_event(const World& world, const Event& event) {
    payload_.put(event.time);
    payload_.put(static_cast<std::uint8_t>(event.kind));
    payload_.put(in_range(event.value));
    payload_.put_text(event_label(world, event));
    write_chunk(kEventChunk);
}

void RecordingWriter::add_branch(std::int64_t from, std::int64_t to) {
    payload_.put(from);
    payload_.put(to);
    write_chunk(kTakeChunk);
}

void RecordingWriter::finish(const World& world, Ending ending) {
    payload_.put(static_cast<std::uint8_t>(ending));
    payload_.put(world.step_count());
    payload_.put(world.state().motion_hash());
    write_chunk(kEndChunk);
    if (std::fflush(out_.get()) != 0) fail();
}

}  // namespace hawser::record
