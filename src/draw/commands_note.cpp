// SPDX-License-Identifier: Apache-2.0
#include "draw/commands_note.h"

#include <fmt/format.h>

#include <algorithm>

namespace hawser::draw {

namespace {

constexpr std::size_t kMost = 6;          // Moments listed.
constexpr std::size_t kMostInMoment = 8;  // Changes listed in one of them.

std::string input_name(const record::Recording& recording, std::int32_t input) {
    const auto i = static_cast<std::size_t>(input);
    return i < recording.input_names.size() ? recording.input_names[i]
                                            : fmt::format("input {}", input);
}

}  // namespace

std::vector<Command> commands_of(const record::Recording& recording) {
    // What an input was set to last: repeating a value is no command.
    std::vector<std::pair<std::int32_t, double>> last;
    std::vector<Command> out;
    std::size_t more = 0, in_moment = 0;
    std::int64_t step = -1;
    for (const record::RecordedInput& change : recording.inputs) {
        const auto known = std::find_if(last.begin(), last.end(),
                                        [&](const auto& l) { return l.first == change.input; });
        const double before = known == last.end() ? 0.0 : known->second;
        if (known == last.end())
            last.emplace_back(change.input, change.value);
        else
            known->second = change.value;
        if (change.value == before) continue;
        if (change.step != step) {
            step = change.step;
            in_moment = 0;
            if (out.size() == kMost) ++more;
            if (out.size() < kMost)
                out.push_back({static_cast<double>(step) * recording.settings.step, ""});
        }
        if (more > 0 || ++in_moment > kMostInMoment) continue;
        std::string& text = out.back().text;
        if (!text.empty()) text += ", ";
        text += fmt::format("{} {:.4g}", input_name(recording, change.input), change.value);
    }
    if (more > 0) out.back().text += fmt::format("; {} later changes are not marked", more);
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

void list_commands(Drawing& drawing, Point at, const std::vector<Command>& commands) {
    for (std::size_t i = 0; i < commands.size(); ++i)
        drawing.text({at.x, at.y + kCommandLine * static_cast<double>(i)},
                     fmt::format("{}  {:.4g} s: inputs set, {}", static_cast<char>('A' + i),
                                 commands[i].time, commands[i].text),
                     12.0, Anchor::start, kSoft);
}

}  // namespace hawser::draw
