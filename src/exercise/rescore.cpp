// SPDX-License-Identifier: Apache-2.0
/// Compute the score of a recording: replay its motion and read its notes.
#include <hawser/hawser.h>
#include <hawser/repeater.h>

#include "exercise/curves.h"
#include "exercise/notes.h"
#include "exercise/reader.h"
#include "exercise/scorer.h"
#include "record/recorded_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace hawser::exercise {
namespace {

/// State that a mark saves.
struct State {
    Scorer scorer;
    Curves curves;
    std::size_t sample_interval = 1, seen_steps = 0;
    double time = 0.0;  ///< Time of the state [s].
};

class Rescorer {
  public:
    Rescorer(const record::Recording& recording, int threads)
        : recording_(recording), repeater_(recording) {
        while (next_ < notes().size() && notes()[next_].kind != kNoteKind) ++next_;
        if (next_ == notes().size())
            throw record::RecordingError(recording.file + ": no recording of an exercise");
        record::ByteReader in(notes()[next_].bytes);
        if (in.get<std::uint8_t>() != static_cast<std::uint8_t>(NoteKind::begin))
            throw record::BadBytes("its notes of the exercise have no beginning");
        // The scene is that of the recording.
        out_.exercise = parse_exercise(in.get_text(), recording.file + " (exercise)");
        channels_ = list_channels(out_.exercise);
        is_noted_.resize(in.get_count(1));
        for (std::size_t i = 0; i < is_noted_.size(); ++i)
            is_noted_[i] = in.get<std::uint8_t>() != 0;
        if (is_noted_.size() != channels_.size())
            throw record::BadBytes("its notes are of another exercise");
        ++next_;
        scene_ = record::recorded_scene(recording, threads);
    }

    Rescored run() {
        World& world = scene_.world;
        State state{Scorer(out_.exercise, world.settings().step), {}, 1, 0, world.time()};
        state.curves.values.resize(out_.exercise.displays.size());
        state_ = &state;
        if (world.state().motion_hash() != recording_.start_hash)
            report_difference(world, "at the start");
        read_notes_of_step(world);
        const std::size_t frames = recording_.frame_count(), takes = recording_.takes.size();
        const bool ended = recording_.ending != record::Ending::unknown;
        for (std::size_t i = 0; i < frames; ++i) {
            const record::Frame head = recording_.frame_head(i);
            advance(head.step, recording_.take_of(i));
            if (world.state().motion_hash() != head.hash) report_difference(world, "");
        }
        if (ended) advance(recording_.end_step, takes);
        if (ended && world.state().motion_hash() != recording_.end_hash)
            report_difference(world, "");
        out_.result = state.scorer.result();
        out_.curves = std::move(state.curves);
        return std::move(out_);
    }

  private:
    [[nodiscard]] const std::vector<record::RecordedNote>& notes() const {
        return recording_.notes;
    }

    void report_difference(const World& world, const char* where) {
        if (!out_.same) return;
        out_.same = false;
        out_.difference = fmt::format("the state at {:.6g} s is not the recorded one{}{}",
                                      world.time(), *where != '\0' ? ", " : "", where);
    }

    /// Advance to a step of a branch. If the run went back to a saved state, the step count
    /// restarts from that state.
    void advance(std::int64_t to, std::size_t take) {
        World& world = scene_.world;
        const auto behind = [&] { return world.step_count() < to || repeater_.take() < take; };
        while (behind()) {
            repeater_.before_step(world);
            read_notes_of_step(world);  // notes of a branch that was just entered
            if (!behind()) break;
            if (world.step() != Status::ok)
                throw record::RecordingError(fmt::format("{}: the step from {:.6g} s failed: {}",
                                                         recording_.file, world.time(),
                                                         hawser::to_string(world.stats().status)));
            const std::vector<Event> events = world.events().take();
            read_channels(channels_, is_noted_, world, events, false, values_);
            read_values_until(world.step_count());
            state_->time = world.time();
            state_->scorer.after_step(world.time(), values_);
            add_sample(state_->curves, state_->sample_interval, state_->seen_steps, world.time(),
                       values_);
            read_notes_of_step(world);
        }
    }

    /// Find the next note of the exercise up to a step and read its kind. The first note of a
    /// branch reports that the run went back. That note and later ones wait until the motion has
    /// done the same.
    bool next_note(std::int64_t step, NoteKind& kind, record::ByteReader& in) {
        while (next_ < notes().size() && notes()[next_].kind != kNoteKind) ++next_;
        if (next_ == notes().size() || notes()[next_].step > step) return false;
        in = record::ByteReader(notes()[next_].bytes);
        const auto number = in.get<std::uint8_t>();
        if (number > static_cast<std::uint8_t>(NoteKind::asked))
            throw record::BadBytes("a note of the exercise has no kind");
        kind = static_cast<NoteKind>(number);
        return kind != NoteKind::back || backs_ < repeater_.take();
    }

    void read_values_until(std::int64_t step) {
        record::ByteReader in({});
        NoteKind kind{};
        if (!next_note(step, kind, in) || kind != NoteKind::values) return;
        ++next_;
        const std::size_t count = in.get_count(12);
        for (std::size_t k = 0; k < count; ++k) {
            const auto channel = in.get<std::uint32_t>();
            const auto value = in.get<double>();
            if (channel >= values_.size() || !is_noted_[channel])
                throw record::BadBytes("a note of the exercise names no channel");
            values_[channel] = value;
        }
        in.expect_end();
    }

    void read_notes_of_step(const World& world) {
        record::ByteReader in({});
        for (NoteKind kind{}; next_note(world.step_count(), kind, in); ++next_) {
            switch (kind) {
                case NoteKind::fault:
                    read_fault_note(world, in);
                    break;
                case NoteKind::mark:
                    saved_states_.push_back(*state_);
                    break;
                case NoteKind::back: {
                    const auto mark = in.get<std::int32_t>();
                    if (mark < 0 || static_cast<std::size_t>(mark) >= saved_states_.size())
                        throw record::BadBytes("a note of the exercise names no mark");
                    *state_ = saved_states_[static_cast<std::size_t>(mark)];
                    state_->scorer.restored(state_->time);
                    ++backs_;
                    break;
                }
                case NoteKind::end: {
                    const std::string why = in.get_text();
                    state_->scorer.end(state_->time, why, in.get<std::uint8_t>() != 0);
                    break;
                }
                case NoteKind::asked: {
                    std::string role = in.get_text(), input = in.get_text();
                    const double value = in.get<double>();
                    out_.requests.push_back(
                        {state_->time, std::move(role), std::move(input), value});
                    break;
                }
                case NoteKind::begin:
                case NoteKind::values:
                    break;
            }
        }
    }

    void read_fault_note(const World& world, record::ByteReader& in) {
        const bool begins = in.get<std::uint8_t>() != 0;
        const std::string name = in.get_text(), by = in.get_text();
        const auto& faults = out_.exercise.faults;
        const auto at = std::find_if(faults.begin(), faults.end(),
                                     [&](const Fault& f) { return f.name == name; });
        if (at == faults.end()) throw record::BadBytes("a note of the exercise names no fault");
        if (begins && at->kind == FaultKind::output_frozen)
            if (const OutputId id = world.find_output(at->target); id.valid())
                state_->scorer.freeze_output(at->target, world.output(id));
        state_->scorer.fault(state_->time, *at, by, begins);
    }

    const record::Recording& recording_;
    record::Repeater repeater_;
    scene::Scene scene_;
    Rescored out_;
    std::vector<Channel> channels_;
    std::vector<bool> is_noted_;
    std::vector<double> values_;
    std::vector<State> saved_states_;
    State* state_ = nullptr;
    /// Index of the next note; number of times that the run went back.
    std::size_t next_ = 0, backs_ = 0;
};

}  // namespace

bool is_recorded(const record::Recording& recording) noexcept {
    return std::any_of(recording.notes.begin(), recording.notes.end(),
                       [](const record::RecordedNote& note) { return note.kind == kNoteKind; });
}

Rescored rescore(const record::Recording& recording, int threads) {
    try {
        return Rescorer(recording, threads).run();
    } catch (const record::BadBytes& error) {
        throw record::RecordingError(recording.file + ": " + error.what());
    }
}

}  // namespace hawser::exercise
