// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file event_input.h
/// Where events are, in words: inputs that were asked for more than their range, lines, bodies.

#include <hawser/hawser.h>
#include "record/scene_info.h"
#include "record/wire_place.h"

#include <cstddef>
#include <string>

namespace hawser::record {

/// The input that an event tells of, of a system as "winch.mode": Event::input is then −2 less its
/// place in World::system_signals(). "": of none, or of one that is no more.
[[nodiscard]] inline std::string input_label(const World& world, const Event& event) {
    if (event.input.valid())
        return world.alive(event.input) ? world.input_def(event.input).name : std::string();
    const auto signals = world.system_signals();
    const int place = -2 - event.input.index;
    if (place < 0 || static_cast<std::size_t>(place) >= signals.size()) return {};
    const SystemSignal& signal = signals[static_cast<std::size_t>(place)];
    return signal.system + "." + signal.name;
}

/// Where an event is: its input; of a line that parts, where along its wire; else as place_label()
/// has it.
[[nodiscard]] inline std::string event_label(const World& world, const Event& event) {
    if (std::string input = input_label(world, event); !input.empty()) return input;
    if (event.kind == EventKind::line_break && event.interaction.valid())
        return parted_label(world, event.interaction);
    return place_label(world, event.interaction, event.body);
}

}  // namespace hawser::record
