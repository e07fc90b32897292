// SPDX-License-Identifier: Apache-2.0
#include <hawser/settings.h>

#include "scene/format.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace hawser::scene {

using namespace make;

namespace {

ShapePtr shape_of(const SettingInfo& s) {
    switch (s.type) {
        case SettingType::word:
            return word(s.what, {s.words.begin(), s.words.end()});
        case SettingType::boolean:
            return boolean(s.what);
        case SettingType::integer:
            return integer(s.what, s.min, std::min(s.max, largest_scene_value(s)));
        case SettingType::vector:
            return list(s.what, number("a number", s.min, s.max), 3, 3);
        case SettingType::number:
            break;
    }
    return number(s.what, s.min, s.max);
}

std::string default_text(const SettingInfo& s) {
    if (s.fallback[0] != 0) return s.fallback;
    const double value = std::min(s.get(WorldDef{}, 0), largest_scene_value(s));
    switch (s.type) {
        case SettingType::word:
            return s.words[static_cast<std::size_t>(value)];
        case SettingType::boolean:
            return value != 0.0 ? "true" : "false";
        case SettingType::integer:
            return fmt::format("{:.0f}", value);
        default:
            return fmt::format("{}", value);
    }
}

}  // namespace

double largest_scene_value(const SettingInfo& setting) {
    const std::string_view name = setting.name;
    return name == "max_bodies"         ? static_cast<double>(kMaxElements)
           : name == "max_interactions" ? 2.0 * static_cast<double>(kMaxElements)
                                        : std::numeric_limits<double>::infinity();
}

ShapePtr settings_shape() {
    std::vector<Field> fields;
    for (const SettingInfo& s : setting_infos()) {
        if (!s.in_scenes) continue;
        fields.push_back({s.name, shape_of(s), false, default_text(s), s.unit, s.doc});
        if (std::string_view(s.name) == "step")
            fields.push_back({"duration", positive("a time", 1e7), false, "10", "s",
                              "Simulated time of a run."});
    }
    return object("settings", "settings", "How the scene is simulated.", std::move(fields));
}

}  // namespace hawser::scene
