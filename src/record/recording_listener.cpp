// SPDX-License-Identifier: Apache-2.0
#include "record/recording_listener.h"

#include <new>
#include <span>

namespace hawser::record {

RecordingListener::RecordingListener(RecordingWriter& writer, World& world) noexcept
    : writer_(writer), world_(world), inputs_(world.input_count()), last_step_(world.step_count()) {
    world.set_change_listener(this);
}

RecordingListener::~RecordingListener() { world_.set_change_listener(nullptr); }

void RecordingListener::set(InputId id, double value) noexcept {
    // A later input has no name in the recording, or the index of a removed one.
    if (id.generation != 0 || id.index >= inputs_) return ChangeBytes::set(id, value);
    try {
        set_.push_back({{world_.step_count(), id.index, value}, bytes().size()});
    } catch (const std::bad_alloc&) {
        lost();
    }
}

std::size_t RecordingListener::mark() noexcept {
    failed_before_ = failed();
    return set_.size() + bytes().size();
}

void RecordingListener::undone(std::size_t mark) noexcept {
    // Inputs and changes are one sequence: input i is its element i + set_[i].bytes.
    std::size_t kept = 0;
    while (kept < set_.size() && kept + set_[kept].bytes < mark) ++kept;
    set_.resize(kept);
    ChangeBytes::undone(mark - kept);
    if (!failed_before_) forget_failure();
}

void RecordingListener::detached(InteractionId element, int end) noexcept {
    double mass = 0.0;
    for (int i = 0; i < world_.system_count(); ++i) mass += world_.system(i).carried_mass(element);
    mass > 0.0 ? detached_with_mass(element, end, mass) : ChangeBytes::detached(element, end);
}

/// Store a restored state in a separate chunk, at the step of the world before the restore. A
/// replay first rebuilds the world of the start, and then applies this chunk.
template <class F>
void RecordingListener::begin_branch(F&& reported) noexcept {
    const std::int64_t before = last_step_;
    try {
        flush(before);
        reported();
        flush(before);
        if (before != last_step_) writer_.add_branch(before, last_step_);
    } catch (const std::bad_alloc&) {
        lost();
    } catch (const std::exception&) {
        fault_ = std::current_exception();
    }
}

void RecordingListener::restored(std::span<const std::byte>) noexcept {
    begin_branch([&] { ChangeBytes::restored(world_.state().save_motion()); });
}
void RecordingListener::restored(const Structure& made_of, std::span<const std::byte>) noexcept {
    begin_branch([&] { ChangeBytes::restored(made_of, world_.state().save_motion()); });
}

void RecordingListener::flush() { flush(world_.step_count()); }

void RecordingListener::flush(std::int64_t step) {
    if (fault_) std::rethrow_exception(fault_);
    writer_.check_complete(*this);
    const std::span<const std::byte> all = bytes();
    std::size_t written = 0;
    for (std::size_t i = 0; i < set_.size();) {
        const std::size_t before = set_[i].bytes;
        writer_.add_changes(step, all.subspan(written, before - written), bodies_changed());
        written = before;
        run_.clear();
        for (; i < set_.size() && set_[i].bytes == before; ++i) run_.push_back(set_[i].input);
        writer_.add_inputs(run_);
    }
    writer_.add_changes(step, all.subspan(written), bodies_changed());
    set_.clear();
    clear();
    last_step_ = world_.step_count();
}

}  // namespace hawser::record
