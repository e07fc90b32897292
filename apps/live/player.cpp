// SPDX-License-Identifier: Apache-2.0
#include "live/player.h"

#include "live/event_reports.h"
#include "live/scene_text.h"
#include "record/commands.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

namespace hawser::live {

Player::Player(const record::Recording& recording, Hub& hub, Debriefing debriefing)
    : recording_(recording),
      hub_(hub),
      out_(hub),
      debriefing_(std::move(debriefing)),
      scene_(recording) {
    out_.scene(text_of(scene_.json()));
    send_timeline();
    if (!debriefing_.text.empty()) out_.exercise(Json::parse(debriefing_.text));
    send_state();
    publish();
}

void Player::send_timeline() {
    constexpr std::size_t kMaxTimelineEntries = 4096;
    Json events = Json::array(), inputs = Json::array(), takes = Json::array();
    for (const record::RecordedNote& note : recording_.notes) {
        if (note.kind != record::kDoneNote || events.size() >= kMaxTimelineEntries) continue;
        const std::string text = record::text_of(note);
        events.push_back({{"time", static_cast<double>(note.step) * recording_.settings.step},
                          {"kind", "command"},
                          {"name", text},
                          {"value", 0.0},
                          {"words", text}});
    }
    // Rare events have priority for marks on the time line.
    for (const bool often : {false, true})
        for (const record::RecordedEvent& event : recording_.events) {
            const bool frequent = event.kind == EventKind::slack || event.kind == EventKind::taut;
            if (frequent != often || events.size() >= kMaxTimelineEntries) continue;
            events.push_back({{"time", event.time},
                              {"kind", to_string(event.kind)},
                              {"name", event.where},
                              {"value", event.value},
                              {"words", event_words(event.where, event.kind, event.value)}});
        }
    for (const record::RecordedInput& input : recording_.inputs) {
        const auto place = static_cast<std::size_t>(input.input);
        if (inputs.size() < kMaxTimelineEntries && place < recording_.input_names.size() &&
            !record::is_inner_input(recording_, place))
            inputs.push_back({static_cast<double>(input.step) * recording_.settings.step,
                              recording_.input_names[place], input.value});
    }
    for (const record::RecordedTake& take : recording_.takes)
        takes.push_back({static_cast<double>(take.from) * recording_.settings.step,
                         static_cast<double>(take.to) * recording_.settings.step});
    out_.timeline({{"type", "timeline"}, {"events", events}, {"inputs", inputs}, {"takes", takes}});
}

void Player::send_state() {
    double first = recording_.frame_head(0).time, last = first;
    for (std::size_t f = 0; f < recording_.frame_count(); ++f) {
        const double time = recording_.frame_head(f).time;
        first = std::min(first, time);
        last = std::max(last, time);
    }
    out_.state({{"type", "state"},
                {"paused", playing_.paused()},
                {"rate", playing_.rate()},
                {"time", recording_.frame_head(frame_).time},
                {"restore_points", Json::array()},
                {"range", {first, last}},
                {"recording", nullptr},
                {"clients", hub_.clients.load(std::memory_order_relaxed)},
                {"failure", nullptr}});
    (void)out_.flush();
}

std::size_t Player::frame_at(double time) const {
    constexpr double kTimeTolerance = 1e-9;  // times go through text
    const auto& takes = recording_.takes;
    for (std::size_t t = takes.size() + 1; t-- > 0;) {
        const std::size_t begin = t == 0 ? 0 : takes[t - 1].frames;
        std::size_t low = begin,
                    high = t < takes.size() ? takes[t].frames : recording_.frame_count();
        if (low == high || recording_.frame_head(low).time > time + kTimeTolerance) continue;
        while (high - low > 1) {
            const std::size_t mid = low + (high - low) / 2;
            (recording_.frame_head(mid).time <= time + kTimeTolerance ? low : high) = mid;
        }
        return low;
    }
    return 0;
}

double Player::gap() const {
    if (frame_ + 1 >= recording_.frame_count()) return recording_.settings.step;
    const double gap = recording_.frame_head(frame_ + 1).time - recording_.frame_head(frame_).time;
    return gap > 0.0 ? gap : recording_.settings.step;  // start of a branch
}

void Player::publish() {
    if (!out_.flush()) return;
    const auto flags = static_cast<std::uint16_t>(playing_.paused() ? kPaused : 0);
    scene_.write(frame_, flags, ++number_, hub_.frames.back());
    hub_.frames.publish();
    hub_.wake();
    playing_.note_shown();
    changed_ = false;
}

void Player::perform(const Command& command) {
    changed_ = true;
    const std::size_t last = recording_.frame_count() - 1;
    switch (command.kind) {
        case CommandKind::resume:
            if (frame_ == last) frame_ = 0;  // from the beginning
            [[fallthrough]];
        case CommandKind::pause:
        case CommandKind::step:
        case CommandKind::rate:
            playing_.perform(command);
            break;
        case CommandKind::seek:
            frame_ = frame_at(command.value);
            playing_.forget_steps();
            playing_.begin_clock();
            break;
        case CommandKind::left:
        case CommandKind::none:
            return;
        case CommandKind::report:
            if (!debriefing_.report)
                throw DefError("this is no recording of an exercise: no report");
            out_.report(command, debriefing_.report(std::string(command.name.view())));
            return;
        case CommandKind::pick:
            throw DefError("a recording has poses and tensions alone, which frames show");
        default:
            throw DefError("a recording cannot be changed");
    }
    out_.answer(command);
    send_state();
}

void Player::perform_commands() {
    Command command;
    while (hub_.commands.pop(command)) {
        try {
            perform(command);
        } catch (const DefError& refused) {
            out_.reject(command, refused.what());
        }
    }
}

void Player::advance() {
    perform_commands();
    const int clients = hub_.clients.load(std::memory_order_relaxed);
    if (clients != clients_) {
        clients_ = clients;
        send_state();
    }
    if (playing_.is_running() && !changed_) {
        playing_.record_step(gap());
        if (frame_ + 1 < recording_.frame_count()) ++frame_;
        if (playing_.count_step()) send_state();
        if (frame_ + 1 == recording_.frame_count() && !playing_.paused()) {
            playing_.pause();
            send_state();
        }
        return publish();
    }
    if (changed_ || playing_.is_frame_due()) publish();
}

void Player::run(const std::function<bool()>& stop) {
    playing_.begin_clock();
    while (!stop()) {
        advance();
        playing_.wait([this] {
            perform_commands();
            return changed_;
        });
    }
}

}  // namespace hawser::live
