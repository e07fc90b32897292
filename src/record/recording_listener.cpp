// SPDX-License-Identifier: Apache-2.0
#include "record/recording_listener.h"

#include <span>

namespace hawser::record {

RecordingListener::RecordingListener(RecordingWriter& writer, World& world) noexcept
    : writer_(writer), world_(world), inputs_(world.input_count()), now_(world.step_count()) {
    world.set_change_listener(this);
}

RecordingListener::~RecordingListener() { world_.set_change_listener(nullptr); }

void RecordingListener::set(InputId id, double value) noexcept {
    // One that came later has no name in the recording, or a place that another one had.
    if (id.generation != 0 || id.index >= inputs_) return ChangeBytes::set(id, value);
    try {
        flush();
        const RecordedInput input{world_.step_count(), id.index, value};
        writer_.add_inputs(std::span(&input, 1));
    } catch (const std::exception&) {
        fault_ = std::current_exception();
    }
}

/// A state has been restored: it belongs to the step at which the world was before.
void RecordingListener::begin_take() noexcept {
    try {
        const std::int64_t before = now_, now = world_.step_count();
        flush(before);
        if (before != now) writer_.add_take(before, now);
    } catch (const std::exception&) {
        fault_ = std::current_exception();
    }
}

void RecordingListener::restored(std::span<const std::byte>) noexcept {
    try {
        ChangeBytes::restored(world_.save_motion());
        begin_take();
    } catch (const std::exception&) {
        lost();
    }
}
void RecordingListener::restored(const Structure& made_of, std::span<const std::byte>) noexcept {
    try {
        ChangeBytes::restored(made_of, world_.save_motion());
        begin_take();
    } catch (const std::exception&) {
        lost();
    }
}

void RecordingListener::flush() { flush(world_.step_count()); }

void RecordingListener::flush(std::int64_t step) {
    if (fault_) std::rethrow_exception(fault_);
    writer_.add_changes(step, *this);
    clear();
    now_ = world_.step_count();
}

}  // namespace hawser::record
