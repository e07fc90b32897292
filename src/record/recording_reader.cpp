// SPDX-License-Identifier: Apache-2.0
#include <hawser/recording.h>
#include "base/file_kind.h"
#include "record/field_bytes.h"
#include "record/files.h"
#include "record/outlines.h"
#include "record/recording_bytes.h"
#include "record/recording_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace hawser::record {

namespace {

// The four chunks that must come first, in this order.
constexpr const char* kStartChunks[] = {kSceneChunk, kSettingsChunk, kLayoutChunk, kSnapshotChunk};
constexpr int kFirstStageWithState = 4;

Frame get_frame_head(ByteReader& in) {
    Frame frame;
    frame.step = get_step(in, 0);
    frame.time = get_finite(in);
    frame.hash = in.get<std::uint64_t>();
    frame.violation_max = get_finite(in);
    frame.momentum_residual = get_finite(in);
    frame.energy = get_finite(in);
    return frame;
}

}  // namespace

std::vector<bool> cable_interior(const Recording& recording) {
    std::vector<bool> interior = recording.wire_lumps();
    const auto is_lump = [&](std::int32_t body) {
        return recording.bodies[static_cast<std::size_t>(body)].kind == BodyKind::lump;
    };
    for (const RecordedCable& cable : recording.cables) {
        // The cable does not own a hull on which its nodes slide.
        const bool lumps = std::any_of(cable.nodes.begin(), cable.nodes.end(), is_lump);
        for (std::size_t i = 1; i + 1 < cable.nodes.size(); ++i)
            interior[static_cast<std::size_t>(cable.nodes[i])] = !lumps || is_lump(cable.nodes[i]);
    }
    return interior;
}

Recording Recording::open(const std::filesystem::path& file) {
    std::vector<std::byte> bytes;
    if (const std::string fault = read_file(file, bytes); !fault.empty())
        throw RecordingError(fmt::format("{}: the recording: {}", file.string(), fault));
    return read(std::move(bytes), file.string());
}

Recording Recording::read(std::vector<std::byte> bytes, const std::string& name) {
    Recording r;
    r.file = name;
    r.bytes_ = std::move(bytes);  // Spans into the bytes stay valid when the recording moves.
    ByteReader in(r.bytes_);
    if (r.bytes_.size() < sizeof kMagic + 4 ||
        std::memcmp(in.take(sizeof kMagic).data(), kMagic, sizeof kMagic) != 0)
        throw RecordingError(name + ": " +
                             base::file_kind_error_or(as_text(r.bytes_), "a recording", name,
                                                      "not a Hawser recording"));
    const auto version = in.get<std::uint32_t>();
    if (version != kFormatVersion && version != kAllLoadsVersion)
        throw RecordingError(fmt::format("{}: recording format {}, this program reads {} and {}",
                                         name, version, kAllLoadsVersion, kFormatVersion));
    r.format = version;
    int stage = 0;
    try {
        while (in.bytes_left() > 0) {
            if (r.ending != Ending::unknown) throw BadBytes("data follow the end");
            const auto head = in.take(8);
            ByteReader head_in(head.subspan(4));
            const auto payload = in.take(head_in.get<std::uint32_t>());
            if (in.get<std::uint32_t>() != crc32(payload, crc32(head)))
                throw BadBytes("a checksum does not match");
            r.read_chunk({reinterpret_cast<const char*>(head.data()), 4}, payload, stage);
        }
    } catch (const BadBytes& e) {
        r.damage = e.what();
    }
    if (stage < kFirstStageWithState)
        throw RecordingError(fmt::format("{}: the recording's start is incomplete{}{}", name,
                                         r.damage.empty() ? "" : ": ", r.damage));
    if (r.damage.empty() && r.ending == Ending::unknown) r.damage = "the end is missing";
    return r;
}

void Recording::read_chunk(std::string_view kind, std::span<const std::byte> payload, int& stage) {
    ByteReader in(payload);
    if (stage < kFirstStageWithState) {
        if (kind != kStartChunks[stage]) throw BadBytes("chunks are out of order");
        switch (stage) {
            case 0:
                read_scene(in);
                break;
            case 1:
                read_settings(in);
                break;
            case 2:
                read_layout(in);
                break;
            default:
                start_step = get_step(in, 0);
                start_hash = in.get<std::uint64_t>();
                snapshot = in.take(in.bytes_left());
        }
        ++stage;
    } else if (kind == kFrameChunk) {
        add_frame(payload);
    } else if (kind == kInputsChunk) {
        read_inputs(in);
    } else if (kind == kInputNamesChunk) {
        if (!input_names.empty() || !inputs.empty()) throw BadBytes("inputs are named too late");
        input_names.resize(in.get_count(4));
        for (std::string& name : input_names) name = in.get_text();
        if (in.bytes_left() > 0) inner_inputs.resize(input_names.size());
        for (std::size_t i = 0; i < inner_inputs.size(); ++i)
            inner_inputs[i] = in.get<std::uint8_t>() != 0;
        in.expect_end();
    } else if (kind == kOutlineChunk) {
        outlines = get_outlines(in, bodies.size());
        in.expect_end();
    } else if (kind == kChangesChunk) {
        read_changes(in);
    } else if (kind == kLoadsChunk) {
        read_loads(in);
    } else if (kind == kLineSeaChunk) {
        seas.push_back(GetFields{in}.definition<LineSea>());
        in.expect_end();
    } else if (kind == kNoteChunk) {
        read_note(in);
    } else if (kind == kBodiesChunk) {
        read_bodies(in);
    } else if (kind == kWiresChunk) {
        read_wires(in, wires_, false);
    } else if (kind == kPullsChunk) {
        read_pulls(payload, wires_);
    } else if (kind == kLinesChunk) {
        read_wires(in, lines_, true);
    } else if (kind == kLinePullsChunk) {
        read_pulls(payload, lines_);
    } else if (kind == kOutputNamesChunk) {
        read_output_names(in);
    } else if (kind == kOutputsChunk) {
        read_output_values(payload);
    } else if (kind == kWaterChunk) {
        waters_.emplace_back(frames_.size(), get_finite(in));
        in.expect_end();
    } else if (kind == kCutChunk) {
        read_cut(in);
    } else if (kind == kEventChunk) {
        read_event(in);
    } else if (kind == kTakeChunk) {
        read_take(in);
    } else if (kind == kEndChunk) {
        read_end(in);
    }
    // Chunks of other names belong to later additions and are skipped.
}

void Recording::read_scene(ByteReader in) {
    scene_hash = in.get<std::uint64_t>();
    scene_name = in.get_text();
    scene_path = in.get_text();
    scene_text = in.get_text();
    in.expect_end();
}

std::size_t Recording::frame_size() const noexcept {
    return kFrameHeadBytes + 4 * (layouts_.back().floats + static_cast<std::size_t>(element_count));
}

const Recording::Layout& Recording::layout_of(std::size_t frame) const {
    const auto behind =
        std::upper_bound(layouts_.begin(), layouts_.end(), frame,
                         [](std::size_t f, const Layout& l) { return f < l.first_frame; });
    return *std::prev(behind);
}

void Recording::read_cut(ByteReader in) {
    RecordedCut cut;
    cut.step = get_step(in, 0);
    cut.left_out.iterations = in.get<std::int32_t>();
    if (in.bytes_left() > 0) {  // not in recordings of earlier versions
        cut.left_out.hasty = in.get<std::uint8_t>() != 0;
        cut.cause = get_enum<DegradedBy>(in, kDegradedByCount);
        cut.foreseen = get_finite(in);
        cut.left_out.cuts = in.get<std::uint64_t>();
    }
    if (in.bytes_left() > 0) cut.left_out.wires = in.get<std::int32_t>();  // nor these
    in.expect_end();
    if (!cut.left_out.any() || cut.left_out.iterations < 0 || cut.left_out.wires < 0)
        throw BadBytes("a cut leaves nothing out");
    add_cut(cut);
}

void Recording::read_event(ByteReader in) {
    RecordedEvent event;
    event.time = get_finite(in);
    event.kind = get_enum<EventKind>(in, kEventKindCount);
    event.value = get_finite(in);
    event.where = in.get_text();
    in.expect_end();
    events.push_back(std::move(event));
}

/// Read the end of the recorded run. It is at the last frame or less than a stride behind it; a
/// replay steps to it.
void Recording::read_end(ByteReader in) {
    const auto how = get_enum<Ending>(in, static_cast<int>(Ending::unknown));
    end_step = get_step(in, 0);
    end_hash = in.get<std::uint64_t>();
    in.expect_end();
    check_gap(end_step, false);
    ending = how;
}

void Recording::add_frame(std::span<const std::byte> payload) {
    if (payload.size() != frame_size())
        throw BadBytes("a frame does not have the size of the scene");
    ByteReader in(payload);
    const Frame head = get_frame_head(in);
    check_gap(head.step, true);
    // The world's clock counts steps.
    const double time = static_cast<double>(head.step) * settings.step;
    if (!(std::abs(head.time - time) <= 1e-9 * (1.0 + time)))
        throw BadBytes("the time of a frame is not that of its step");
    check_floats(in);
    frames_.push_back(payload);
}

/// Check the poses and tensions of a frame for add_frame().
void Recording::check_floats(ByteReader in) const {
    for (const std::int32_t index : layouts_.back().bodies) {
        const int floats = pose_floats(bodies[static_cast<std::size_t>(index)].kind);
        for (int k = 0; k < std::min(3, floats); ++k) (void)get_finite<float>(in);
        if (floats == 7) check_unit(get_quaternion<float>(in), 1e-3);
    }
    for (std::int32_t k = 0; k < element_count; ++k) (void)get_finite<float>(in);
}

Frame Recording::frame_head(std::size_t index) const {
    ByteReader in(frames_.at(index));
    return get_frame_head(in);
}

Frame Recording::frame(std::size_t index) const {
    ByteReader in(frames_.at(index));
    Frame frame = get_frame_head(in);
    for (const RecordedBody& body : bodies) frame.poses.push_back(body.start);
    frame.there.resize(bodies.size());
    for (const std::int32_t body_index : layout_of(index).bodies) {
        const auto b = static_cast<std::size_t>(body_index);
        const RecordedBody& body = bodies[b];
        Pose& pose = frame.poses[b];
        frame.there[b] = true;
        const int floats = pose_floats(body.kind);
        for (int k = 0; k < std::min(3, floats); ++k) pose.position[k] += in.get<float>();
        if (floats == 7) {
            pose.orientation = get_quaternion<float>(in);
        }
    }
    frame.tensions.resize(static_cast<std::size_t>(element_count));
    for (float& tension : frame.tensions) tension = in.get<float>();
    find_wires(index, frame);
    const auto water = std::upper_bound(waters_.begin(), waters_.end(), index,
                                        [](std::size_t f, const auto& w) { return f < w.first; });
    if (water != waters_.begin()) frame.water = std::prev(water)->second;
    return frame;
}

}  // namespace hawser::record
