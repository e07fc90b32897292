// SPDX-License-Identifier: Apache-2.0
#include "observe/outlines.h"
#include "observe/recording.h"
#include "observe/recording_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>

namespace hawser::observe {

namespace {

// The four chunks that must come first, in this order.
constexpr const char* kStartChunks[] = {kSceneChunk, kSettingsChunk, kLayoutChunk, kSnapshotChunk};
constexpr int kStarted = 4;

template <class Enum>
Enum get_enum(ByteReader& in, int count) {
    const auto value = in.get<std::uint8_t>();
    if (value >= count) throw BadBytes("an enumerated value is out of range");
    return static_cast<Enum>(value);
}

std::vector<std::int32_t> get_indices(ByteReader& in, std::size_t limit) {
    std::vector<std::int32_t> out(in.get_count(4));
    for (std::int32_t& index : out) {
        index = in.get<std::int32_t>();
        if (index < 0 || static_cast<std::size_t>(index) >= limit)
            throw BadBytes("an index is out of range");
    }
    return out;
}

Vec3 get_vector(ByteReader& in) {
    const double x = in.get<double>(), y = in.get<double>(), z = in.get<double>();
    return {x, y, z};
}

Frame get_frame_head(ByteReader& in) {
    Frame frame;
    frame.step = in.get<std::int64_t>();
    frame.time = in.get<double>();
    frame.hash = in.get<std::uint64_t>();
    frame.violation_max = in.get<double>();
    frame.momentum_residual = in.get<double>();
    frame.energy = in.get<double>();
    return frame;
}

}  // namespace

int pose_floats(BodyKind kind) noexcept {
    switch (kind) {
        case BodyKind::rigid:
        case BodyKind::kinematic:
            return 7;
        case BodyKind::lump:
            return 3;
        case BodyKind::scalar:
            return 1;
        case BodyKind::fixed:
            return 0;
    }
    return 0;
}

std::vector<bool> cable_interior(const Recording& recording) {
    std::vector<bool> interior(recording.bodies.size(), false);
    for (const RecordedCable& cable : recording.cables)
        for (std::size_t i = 1; i + 1 < cable.nodes.size(); ++i)
            interior[static_cast<std::size_t>(cable.nodes[i])] = true;
    return interior;
}

Recording Recording::open(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary | std::ios::ate);
    if (!in || !std::filesystem::is_regular_file(file))
        throw RecordingError(fmt::format("{}: cannot open the recording", file.string()));
    std::vector<std::byte> bytes(static_cast<std::size_t>(in.tellg()));
    in.seekg(0);
    in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (!in) throw RecordingError(fmt::format("{}: cannot read the recording", file.string()));
    return read(std::move(bytes), file.string());
}

Recording Recording::read(std::vector<std::byte> bytes, const std::string& name) {
    Recording r;
    r.file = name;
    r.bytes_ = std::move(bytes);  // Spans into it stay valid when the recording moves.
    ByteReader in(r.bytes_);
    if (r.bytes_.size() < sizeof kMagic + 4 ||
        std::memcmp(in.take(sizeof kMagic).data(), kMagic, sizeof kMagic) != 0)
        throw RecordingError(name + ": not a Hawser recording");
    const auto version = in.get<std::uint32_t>();
    if (version != kFormatVersion)
        throw RecordingError(fmt::format("{}: recording format {}, this program reads {}", name,
                                         version, kFormatVersion));
    int stage = 0;
    try {
        while (in.left() > 0) {
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
    if (stage < kStarted)
        throw RecordingError(fmt::format("{}: the recording's start is incomplete{}{}", name,
                                         r.damage.empty() ? "" : ": ", r.damage));
    if (r.damage.empty() && r.ending == Ending::unknown) r.damage = "the end is missing";
    return r;
}

void Recording::read_chunk(std::string_view kind, std::span<const std::byte> payload, int& stage) {
    ByteReader in(payload);
    if (stage < kStarted) {
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
                start_step = in.get<std::int64_t>();
                start_hash = in.get<std::uint64_t>();
                snapshot = in.take(in.left());
        }
        ++stage;
    } else if (kind == kFrameChunk) {
        add_frame(payload);
    } else if (kind == kInputsChunk) {
        read_inputs(in);
    } else if (kind == kInputNamesChunk) {
        input_names.resize(in.get_count(4));
        for (std::string& name : input_names) name = in.get_text();
        in.expect_end();
    } else if (kind == kOutlineChunk) {
        outlines = get_outlines(in, bodies.size());
        in.expect_end();
    } else if (kind == kCutChunk) {
        RecordedCut cut;
        cut.step = in.get<std::int64_t>();
        cut.left_out.iterations = in.get<std::int32_t>();
        if (in.left() > 0) {  // not in recordings of earlier versions
            cut.left_out.hasty = in.get<std::uint8_t>() != 0;
            cut.cause = get_enum<DegradedBy>(in, kDegradedByCount);
            cut.foreseen = in.get<double>();
            cut.left_out.cuts = in.get<std::uint64_t>();
        }
        in.expect_end();
        if (!cut.left_out.any() || (!cuts.empty() && cut.step <= cuts.back().step))
            throw BadBytes("cuts are not in the order of time");
        cuts.push_back(cut);
    } else if (kind == kEventChunk) {
        RecordedEvent event;
        event.time = in.get<double>();
        event.kind = get_enum<EventKind>(in, kEventKindCount);
        event.value = in.get<double>();
        event.where = in.get_text();
        in.expect_end();
        events.push_back(std::move(event));
    } else if (kind == kEndChunk) {
        const auto how = get_enum<Ending>(in, static_cast<int>(Ending::unknown));
        end_step = in.get<std::int64_t>();
        end_hash = in.get<std::uint64_t>();
        in.expect_end();
        ending = how;
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

void Recording::read_settings(ByteReader in) {
    settings.step = in.get<double>();
    settings.form = get_enum<Form>(in, 3);
    settings.threads = in.get<std::int32_t>();
    settings.stride = in.get<std::int32_t>();
    settings.instruction_set = in.get_text();
    settings.version = in.get_text();
    settings.processor = in.get_text();
    in.expect_end();
    if (!(settings.step > 0.0) || !std::isfinite(settings.step))
        throw BadBytes("the time step is not positive");
}

void Recording::read_layout(ByteReader in) {
    // Smallest entries: a body has a name length, a kind and 10 numbers; a cable two name
    // lengths, 3 numbers, 2 points and 2 counts.
    bodies.resize(in.get_count(4 + 1 + 80));
    std::size_t floats = 0;
    for (RecordedBody& body : bodies) {
        body.name = in.get_text();
        body.kind = get_enum<BodyKind>(in, 5);
        body.half_size = get_vector(in);
        body.start.position = get_vector(in);
        const double w = in.get<double>();
        const Vec3 q = get_vector(in);
        body.start.orientation = Quat(w, q.x(), q.y(), q.z());
        floats += static_cast<std::size_t>(pose_floats(body.kind));
    }
    cables.resize(in.get_count(8 + 24 + 4 + 48 + 4));
    std::uint64_t elements = 0;
    for (RecordedCable& cable : cables) {
        cable.name = in.get_text();
        cable.line_type = in.get_text();
        cable.EA = in.get<double>();
        cable.breaking_load = in.get<double>();
        cable.length = in.get<double>();
        cable.nodes = get_indices(in, bodies.size());
        for (Vec3& end : cable.end) end = get_vector(in);
        const auto count = in.get<std::uint32_t>();
        cable.first_element = static_cast<std::int32_t>(elements);
        cable.elements = static_cast<std::int32_t>(count & 0x7FFFFFFFu);
        elements += count;
        if (elements > kMaxChunk / 4) throw BadBytes("too many elements");
    }
    plot_cables = get_indices(in, cables.size());
    plot_bodies = get_indices(in, bodies.size());
    joints.resize(in.get_count(2 * (4 + 24)));
    for (RecordedJoint& joint : joints) {
        for (int k = 0; k < 2; ++k) {
            joint.body[k] = in.get<std::int32_t>();
            joint.point[k] = get_vector(in);
            if (joint.body[k] < 0 || static_cast<std::size_t>(joint.body[k]) >= bodies.size())
                throw BadBytes("an index is out of range");
        }
    }
    in.expect_end();
    element_count = static_cast<std::int32_t>(elements);
    frame_size_ = kFrameHeadBytes + 4 * (floats + static_cast<std::size_t>(elements));
}

void Recording::read_inputs(ByteReader in) {
    std::vector<RecordedInput> changes(in.get_count(20));
    for (RecordedInput& change : changes) {
        change.step = in.get<std::int64_t>();
        change.input = in.get<std::int32_t>();
        change.value = in.get<double>();
    }
    in.expect_end();
    inputs.insert(inputs.end(), changes.begin(), changes.end());
}

void Recording::add_frame(std::span<const std::byte> payload) {
    if (payload.size() != frame_size_)
        throw BadBytes("a frame does not have the size of the scene");
    ByteReader in(payload);
    const Frame head = get_frame_head(in);
    if (!std::isfinite(head.time) || head.step < start_step ||
        (!frames_.empty() && head.step <= frame_head(frames_.size() - 1).step))
        throw BadBytes("frames are not in the order of time");
    frames_.push_back(payload);
}

Frame Recording::frame_head(std::size_t index) const {
    ByteReader in(frames_.at(index));
    return get_frame_head(in);
}

Frame Recording::frame(std::size_t index) const {
    ByteReader in(frames_.at(index));
    Frame frame = get_frame_head(in);
    frame.poses.reserve(bodies.size());
    for (const RecordedBody& body : bodies) {
        Pose pose = body.start;
        const int floats = pose_floats(body.kind);
        for (int k = 0; k < std::min(3, floats); ++k) pose.position[k] += in.get<float>();
        if (floats == 7) {
            const double w = in.get<float>(), x = in.get<float>(), y = in.get<float>(),
                         z = in.get<float>();
            pose.orientation = Quat(w, x, y, z);
        }
        frame.poses.push_back(pose);
    }
    frame.tensions.resize(static_cast<std::size_t>(element_count));
    for (float& tension : frame.tensions) tension = in.get<float>();
    return frame;
}

}  // namespace hawser::observe
