// SPDX-License-Identifier: Apache-2.0
/// Read settings, bodies and cables, which precede the first frame of a recording.
#include <hawser/recording.h>
#include "record/recording_bytes.h"
#include "record/recording_format.h"

namespace hawser::record {

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

void Recording::read_settings(ByteReader in) {
    settings.step = in.get<double>();
    settings.form = get_enum<Form>(in, 3);
    settings.threads = in.get<std::int32_t>();
    settings.stride = in.get<std::int32_t>();
    settings.instruction_set = in.get_text();
    settings.version = in.get_text();
    settings.processor = in.get_text();
    in.expect_end();
    if (!(settings.step > 0.0) || !(settings.step <= kMaxStep))
        throw BadBytes("the time step is not positive");
    if (settings.stride < 1 || settings.stride > kMaxStride)
        throw BadBytes("the steps between frames are out of range");
    if (settings.threads < 1) throw BadBytes("the number of threads is not positive");
}

namespace {

RecordedBody get_body(ByteReader& in) {
    RecordedBody body;
    body.name = in.get_text();
    body.kind = get_enum<BodyKind>(in, 5);
    body.half_size = get_vector(in);
    body.start.position = get_vector(in);
    body.start.orientation = get_quaternion<double>(in);
    check_unit(body.start.orientation, 1e-6);
    return body;
}

}  // namespace

void Recording::read_bodies(ByteReader in) {
    Layout next;
    next.first_frame = frames_.size();
    const std::vector<std::int32_t> before = layouts_.back().bodies;
    next.bodies.resize(in.get_count(4));
    std::int32_t last = -1;
    for (std::int32_t& index : next.bodies) {
        const auto stays = in.get<std::int32_t>();
        if (stays < -1 || (stays >= 0 && stays <= last) ||
            (stays >= 0 && static_cast<std::size_t>(stays) >= before.size()))
            throw BadBytes("an index is out of range");
        if (stays >= 0) last = stays;
        index = stays >= 0 ? before[static_cast<std::size_t>(stays)]
                           : static_cast<std::int32_t>(bodies.size());
        if (stays < 0) bodies.push_back(get_body(in));
        next.floats +=
            static_cast<std::size_t>(pose_floats(bodies[static_cast<std::size_t>(index)].kind));
    }
    in.expect_end();
    layouts_.push_back(std::move(next));
}

void Recording::read_layout(ByteReader in) {
    // Smallest entries: a body has a name length, a kind and 10 numbers; a cable two name
    // lengths, 3 numbers, 2 points and 2 counts.
    bodies.resize(in.get_count(4 + 1 + 80));
    Layout layout;
    for (RecordedBody& body : bodies) {
        layout.bodies.push_back(static_cast<std::int32_t>(layout.bodies.size()));
        body = get_body(in);
        layout.floats += static_cast<std::size_t>(pose_floats(body.kind));
    }
    layouts_.push_back(std::move(layout));
    start_bodies = bodies.size();
    cables.resize(in.get_count(8 + 24 + 4 + 48 + 4));
    std::uint64_t elements = 0;
    for (RecordedCable& cable : cables) {
        cable.name = in.get_text();
        cable.line_type = in.get_text();
        cable.EA = get_finite(in);
        cable.breaking_load = get_finite(in);
        cable.length = get_finite(in);
        cable.nodes = get_indices(in, bodies.size());
        for (Vec3& end : cable.end) end = get_vector(in);
        const auto count = in.get<std::uint32_t>();
        cable.first_element = static_cast<std::int32_t>(elements);
        // Elements lie between two nodes; an end that is attached to the world adds one.
        if (count > cable.nodes.size() + 1) throw BadBytes("more elements than nodes");
        cable.elements = static_cast<std::int32_t>(count);
        elements += count;
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
}

/// Read a note. Steps may decrease after a restored state; the reader of the notes handles that.
void Recording::read_note(ByteReader in) {
    RecordedNote note;
    note.step = get_step(in, 0);
    note.kind = in.get_text();
    note.bytes = in.take(in.bytes_left());
    notes.push_back(std::move(note));
}

}  // namespace hawser::record
