// SPDX-License-Identifier: Apache-2.0
#include <hawser/settings.h>

#include "scene/description.h"
#include "scene/format.h"

#include <algorithm>

namespace hawser::scene {
namespace {

double component(const Json& value, const SettingInfo& setting, int i) {
    switch (setting.type) {
        case SettingType::word: {
            const auto word = value.get<std::string>();
            const auto at = std::find(setting.words.begin(), setting.words.end(), word);
            return static_cast<double>(at - setting.words.begin());
        }
        case SettingType::boolean:
            return value.get<bool>() ? 1.0 : 0.0;
        case SettingType::vector:
            return value[static_cast<std::size_t>(i)].get<double>();
        default:
            return value.get<double>();
    }
}

}  // namespace

void read_settings(Description& out, const Json& root) {
    const Json settings = root.value("settings", Json::object());
    WorldDef& def = out.settings;
    for (const SettingInfo& s : setting_infos()) {
        if (!s.in_scenes) continue;
        for (int i = 0; i < (s.type == SettingType::vector ? 3 : 1); ++i) {
            const double usual = std::min(s.get(def, i), largest_scene_value(s));
            s.set(def, i, settings.contains(s.name) ? component(settings[s.name], s, i) : usual);
        }
    }
    if (settings.contains("parts")) out.parts = def.parts;
    out.duration = number_or(settings, "duration", out.duration);
    out.copies = root.contains("repeat") ? root["repeat"].value("copies", std::size_t{1}) : 1;
    const Json defaults = root.value("defaults", Json::object());
    out.default_compliance = number_or(defaults, "compliance", kDefault);
    out.default_damping_time = number_or(defaults, "damping_time", kDefault);
}

}  // namespace hawser::scene
