// SPDX-License-Identifier: Apache-2.0
#include "session/run_notes.h"

#include "record/commands.h"

namespace hawser::session {
namespace {

void put(const World& world, record::RecordingWriter& to, const char* kind,
         const std::string& text) {
    to.add_note(world.step_count(), kind, std::as_bytes(std::span(text)));
}

}  // namespace

void RunNotes::signal(const World& world, record::RecordingWriter& to, const std::string& name,
                      double value) {
    const auto [known, fresh] = reported_.try_emplace(name, value);
    if (!fresh && known->second == value) return;
    known->second = value;
    bool words = false;
    const std::string text = record::signal_text(world, name, value, words);
    // A mode that changes is an event, a speed is not.
    if (!text.empty()) put(world, to, words ? record::kDoneNote : record::kSetNote, text);
}

void RunNotes::operations(const World& world, record::RecordingWriter& to,
                          std::span<const scene::Operation> done) {
    for (const scene::Operation& one : done) {
        if (one.kind != scene::OperationKind::set)
            put(world, to, record::kDoneNote, scene::to_string(one));
        for (const auto& [name, value] : one.set) signal(world, to, name, value);
    }
}

}  // namespace hawser::session
