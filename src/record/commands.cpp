// SPDX-License-Identifier: Apache-2.0
#include "record/commands.h"

#include <fmt/format.h>

#include <algorithm>

namespace hawser::record {

std::string text_of(const RecordedNote& note) {
    return {reinterpret_cast<const char*>(note.bytes.data()), note.bytes.size()};
}

bool is_inner_input(const Recording& recording, std::size_t place) {
    return place < recording.inner_inputs.size() && recording.inner_inputs[place];
}

bool is_inner_input(const World& world, std::string_view name) {
    const auto signals = world.system_signals();
    return std::any_of(signals.begin(), signals.end(), [&](const SystemSignal& s) {
        return name.size() > s.system.size() && name.starts_with(s.system) &&
               name[s.system.size()] == '/';
    });
}

std::vector<std::string> signal_words(const World& world, const SystemSignal& signal) {
    if (signal.name != "mode") return {};
    const auto signals = world.system_signals();
    const auto has = [&](std::string_view name) {
        return std::any_of(signals.begin(), signals.end(), [&](const SystemSignal& s) {
            return s.input && s.system == signal.system && s.name == name;
        });
    };
    if (!has("speed") || !has("tension") || !has("brake") || !has("clutch")) return {};
    // Mode heave exists with a compensation.
    const auto modes = winch_modes();
    std::vector<std::string> words{modes.begin(), modes.end()};
    words.resize(std::min(words.size(), static_cast<std::size_t>(signal.max) + 1));
    return words;
}

std::string signal_text(const World& world, std::string_view name, double value, bool& words) {
    words = false;
    for (const SystemSignal& s : world.system_signals()) {
        if (!s.input || s.system + "." + s.name != name) continue;
        const std::vector<std::string> all = signal_words(world, s);
        words = value >= 0.0 && value < static_cast<double>(all.size());
        return words ? fmt::format("{} {}", name, all[static_cast<std::size_t>(value)])
                     : fmt::format("{} {:.4g}", name, value);
    }
    return {};
}

}  // namespace hawser::record
