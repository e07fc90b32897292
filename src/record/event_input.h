// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file event_input.h
/// Describe the source of events in words: inputs whose requested value was out of range, lines,
/// bodies.

#include <hawser/hawser.h>
#include "record/scene_info.h"
#include "record/wire_position.h"

#include <cstddef>
#include <string>

namespace hawser::record {

/// Return the name of an event's input or signal ("winch.mode"); "" if it has none or the input was
/// removed.
[[nodiscard]] inline std::string input_label(const World& world, const Event& event) {
    if (event.input.valid())
        return world.alive(event.input) ? world.input_def(event.input).name : std::string();
    const auto signals = world.system_signals();
    if (event.signal < 0 || static_cast<std::size_t>(event.signal) >= signals.size()) return {};
    const SystemSignal& signal = signals[static_cast<std::size_t>(event.signal)];
    return signal.system + "." + signal.name;
}

/// Return the label of an event's source: its input; for a broken line the position along its wire;
/// otherwise the result of position_label().
[[nodiscard]] inline std::string event_label(const World& world, const Event& event) {
    if (std::string input = input_label(world, event); !input.empty()) return input;
    if (event.kind == EventKind::line_break && event.interaction.valid())
        return broken_label(world, event.interaction);
    return position_label(world, event.interaction, event.body);
}

}  // namespace hawser::record
