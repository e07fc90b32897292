// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file event_input.h
/// Which input was asked for more than its range.

#include <hawser/hawser.h>

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

}  // namespace hawser::record
