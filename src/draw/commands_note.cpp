// SPDX-License-Identifier: Apache-2.0
#include "draw/commands_note.h"

#include "record/commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>

namespace hawser::draw {

namespace {

constexpr std::size_t kMaxMarkedMoments = 6;  // Largest number of marked moments with set inputs.
constexpr std::size_t kMaxDone = 12;     // Largest number of marked moments with other actions.
constexpr std::size_t kMaxInMoment = 8;  // Largest number of changes listed for one moment.

struct Moment {
    std::vector<std::string> actions, set;

    static void add_unique(std::vector<std::string>& to, std::string text) {
        // List a change once if a branch after a restored state repeats it.
        if (std::find(to.begin(), to.end(), text) == to.end()) to.push_back(std::move(text));
    }
    static std::string joined_with_commas(const std::vector<std::string>& texts) {
        std::string out;
        for (std::size_t i = 0; i < std::min(kMaxInMoment, texts.size()); ++i)
            out += (i > 0 ? ", " : "") + texts[i];
        return out;
    }
};

std::string input_name(const record::Recording& recording, std::int32_t input) {
    const auto i = static_cast<std::size_t>(input);
    return i < recording.input_names.size() ? recording.input_names[i]
                                            : fmt::format("input {}", input);
}

void add_inputs(const record::Recording& recording, std::map<std::int64_t, Moment>& moments) {
    // Last value of each input: setting the same value again is no command.
    std::map<std::int32_t, double> last;
    for (const record::RecordedInput& change : recording.inputs) {
        const double before = std::exchange(last[change.input], change.value);
        if (change.value == before) continue;
        if (record::is_inner_input(recording, static_cast<std::size_t>(change.input))) continue;
        Moment::add_unique(
            moments[change.step].set,
            fmt::format("{} {:.4g}", input_name(recording, change.input), change.value));
    }
}

}  // namespace

std::vector<Command> list_commands_by_time(const record::Recording& recording) {
    std::map<std::int64_t, Moment> moments;
    add_inputs(recording, moments);
    for (const record::RecordedNote& note : recording.notes) {
        const bool is_action = note.kind == record::kDoneNote;
        if (!is_action && note.kind != record::kSetNote) continue;
        Moment& moment = moments[note.step];
        Moment::add_unique(is_action ? moment.actions : moment.set, record::text_of(note));
    }
    std::vector<Command> out;
    std::size_t set = 0, actions = 0, more = 0;
    for (const auto& [step, moment] : moments) {
        const bool marked =
            moment.actions.empty() ? set++ < kMaxMarkedMoments : actions++ < kMaxDone;
        if (!marked) {
            ++more;
            continue;
        }
        out.push_back({static_cast<double>(step) * recording.settings.step,
                       Moment::joined_with_commas(moment.set),
                       Moment::joined_with_commas(moment.actions)});
    }
    if (more > 0) {
        std::string& text = out.back().text.empty() ? out.back().actions : out.back().text;
        text += fmt::format("; {} later changes are not marked", more);
    }
    return out;
}

void mark_commands(Drawing& drawing, const Axes& axes, const std::vector<Command>& commands) {
    for (std::size_t i = 0; i < commands.size(); ++i) {
        if (commands[i].time < axes.x.low || commands[i].time > axes.x.high) continue;
        const double x = axes.at(commands[i].time, axes.y.low).x;
        drawing.line({x, axes.frame.y}, {x, axes.frame.bottom()}, kSoft, 0.9, {3.0, 4.0});
        drawing.add(Text{.at = {x, axes.frame.y - 4},
                         .text = fmt::format("{}", static_cast<char>('A' + i)),
                         .size = 11.0,
                         .anchor = Anchor::middle,
                         .bold = true,
                         .color = kSoft});
    }
}

namespace {

std::string command_text(const Command& c) {
    if (c.text.empty()) return c.actions;
    return c.actions + (c.actions.empty() ? "" : "; ") + "inputs set, " + c.text;
}

}  // namespace

void list_commands(Drawing& drawing, Point at, const std::vector<Command>& commands) {
    for (std::size_t i = 0; i < commands.size(); ++i)
        drawing.text({at.x, at.y + kCommandLine * static_cast<double>(i)},
                     fmt::format("{}  {:.4g} s: {}", static_cast<char>('A' + i), commands[i].time,
                                 command_text(commands[i])),
                     12.0, Anchor::start, kSoft);
}

}  // namespace hawser::draw
