// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file event_input.h
/// Describe the source of events in words: inputs whose requested value was out of range, lines,
/// bodies.

#include <hawser/hawser.h>
#include "record/scene_info.h"
#include "record/wire_place.h"

#include <cstddef>
#include <string>

namespace hawser::record {

/// Return the name of an event's input. For an input of a system, as "winch.mode", Event::input is
/// −2 minus its index in World::system_signals(). Return "" if the event has no input or the input
/// was removed.
[[nodiscard]] inline std::string input_label(const World& world, const Event& event) {
    if (event.input.valid())
        return world.alive(event.input) ? world.input_def(event.input).name : std::string();
    const auto signals = world.system_signals();
    const int place = -2 - event.input.index;
    if (place < 0 || static_cast<std::size_t>(place) >= signals.size()) return {};
    const SystemSignal& signal = signals[static_cast<std::size_t>(place)];
    return signal.system + "." + signal.name;
}

/// Return the source of an event: its input; for a line that breaks the position along its wire;
/// else the result of place_label().
[[nodiscard]] inline std::string event_label(const World& world, const Event& event) {
    if (std::string input = input_label(world, event); !input.empty()) return input;
    if (event.kind == EventKind::line_break && event.interaction.valid())
        return parted_label(world, event.interaction);
    return place_label(world, event.interaction, event.body);
}

}  // namespace hawser::record
