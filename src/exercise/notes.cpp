// SPDX-License-Identifier: Apache-2.0
#include "exercise/notes.h"

#include <hawser/hawser.h>
#include <hawser/vessel.h>

#include "record/scene_info.h"

#include <bit>

namespace hawser::exercise {
namespace {

/// True if the solver sends events of this kind, so that a replay reproduces them. Systems send the
/// other kinds.
bool of_solver(EventKind kind) {
    switch (kind) {
        case EventKind::line_break:
        case EventKind::slack:
        case EventKind::taut:
        case EventKind::saturation:
        case EventKind::range:
        case EventKind::warning:
        case EventKind::cut:
        case EventKind::join:
        case EventKind::detach:
            return true;
        default:
            return false;
    }
}

}  // namespace

void NoteWriter::start(NoteKind kind) {
    bytes_.clear();
    bytes_.put(static_cast<std::uint8_t>(kind));
}
void NoteWriter::send() { session_.note(kNoteKind, bytes_.bytes()); }

void NoteWriter::begin(const Exercise& exercise, const std::vector<bool>& noted) {
    start(NoteKind::begin);
    bytes_.put_text(exercise.text);
    bytes_.put(static_cast<std::uint32_t>(noted.size()));
    for (const bool one : noted) bytes_.put(static_cast<std::uint8_t>(one ? 1 : 0));
    last_.assign(noted.size(), std::numeric_limits<double>::infinity());
    send();
}

void NoteWriter::values(const std::vector<bool>& noted, std::span<const double> values) {
    start(NoteKind::values);
    std::uint32_t count = 0;
    const auto changed = [&](std::size_t i) {
        return noted[i] &&
               std::bit_cast<std::uint64_t>(values[i]) != std::bit_cast<std::uint64_t>(last_[i]);
    };
    for (std::size_t i = 0; i < noted.size(); ++i) count += changed(i) ? 1 : 0;
    if (count == 0) return;
    bytes_.put(count);
    for (std::size_t i = 0; i < noted.size(); ++i) {
        if (!changed(i)) continue;
        bytes_.put(static_cast<std::uint32_t>(i));
        bytes_.put(values[i]);
        last_[i] = values[i];
    }
    send();
}

void NoteWriter::fault(bool begins, std::string_view name, std::string_view by) {
    start(NoteKind::fault);
    bytes_.put(static_cast<std::uint8_t>(begins ? 1 : 0));
    bytes_.put_text(name);
    bytes_.put_text(by);
    send();
}

void NoteWriter::number(NoteKind kind, std::int32_t number) {
    start(kind);
    bytes_.put(number);
    send();
}

void NoteWriter::end(std::string_view why, bool failed) {
    start(NoteKind::end);
    bytes_.put_text(why);
    bytes_.put(static_cast<std::uint8_t>(failed ? 1 : 0));
    send();
}

void NoteWriter::asked(std::string_view role, std::string_view input, double value) {
    start(NoteKind::asked);
    bytes_.put_text(role);
    bytes_.put_text(input);
    bytes_.put(value);
    send();
}

std::vector<bool> noted_channels(const std::vector<Channel>& channels, const World& world) {
    std::vector<bool> out;
    for (const Channel& c : channels) {
        if (c.output.empty()) {
            // Actuators of vessels report their limits as motors do.
            out.push_back(!of_solver(c.event) ||
                          (c.event == EventKind::saturation && !vessels_of(world).empty()));
            continue;
        }
        const OutputId id = world.find_output(c.output);
        const OutputKind kind = world.output_def(id).kind;
        // Measured times are not reproducible either. The paid-out length of a drum is a state of
        // its winch.
        out.push_back(kind == OutputKind::signal || kind == OutputKind::statistic ||
                      kind == OutputKind::drum);
    }
    return out;
}

void read_channels(const std::vector<Channel>& channels, const std::vector<bool>& noted,
                   const World& world, std::span<const Event> events, bool all,
                   std::vector<double>& out) {
    out.resize(channels.size(), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < channels.size(); ++i) {
        if (noted[i] && !all) continue;
        if (const Channel& c = channels[i]; !c.output.empty()) {
            const OutputId id = world.find_output(c.output);
            out[i] = id.valid() ? world.output(id) : std::numeric_limits<double>::quiet_NaN();
        } else {
            out[i] = 0.0;
            for (const Event& e : events)
                if (e.kind == c.event &&
                    (c.of.empty() ||
                     record::position_label(world, e.interaction, e.body).starts_with(c.of)))
                    out[i] += 1.0;
        }
    }
}

}  // namespace hawser::exercise
