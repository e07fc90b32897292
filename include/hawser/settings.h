// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file settings.h
/// Table of the settings of a world: one entry for each member of WorldDef, with unit, range and
/// description. Checks, scene files, documents and the identity of snapshots read it.
///
/// To add a setting, add a member of WorldDef with its default, and an entry in
/// src/world/settings.cpp. Other code needs no change, except code that uses the setting.

#include <hawser/def.h>

#include <cstdint>
#include <span>
#include <string_view>

namespace hawser {

/// Type of a setting's value. A `word` is a name of an enumerator, a `vector` has three components.
enum class SettingType : std::uint8_t { number, integer, boolean, word, vector };

/// Description of one member of WorldDef. Ranges apply to each component of a vector.
struct SettingInfo {
    const char* name = "";                   ///< Name of the member and of the key in scene files.
    SettingType type = SettingType::number;  ///< Type of the value.
    double min = 0.0, max = 0.0;             ///< Range, ends included [unit].
    const char* unit = "";                   ///< SI unit; "": none.
    const char* what = "";                   ///< Noun for messages, such as "a time".
    std::span<const char* const> words{};    ///< Type word: names of the values 0, 1, ….
    /// True: worlds with different values produce different states, and reject each other's
    /// snapshots. False for limits, form and threads, which change only the computation of a state.
    bool identity = false;
    bool in_scenes = true;      ///< True: key of "settings" in scene files. False: an option of
                                ///< programs.
    const char* fallback = "";  ///< Text of the default in documents; "": the number itself.
    const char* doc = "";       ///< Description, one or two sentences.
    /// Return a component of the value. Scalars have component 0.
    double (*get)(const WorldDef&, int component) = nullptr;
    /// Set a component of the value.
    void (*set)(WorldDef&, int component, double value) = nullptr;
};

/// Return all settings in the order of the documents.
[[nodiscard]] std::span<const SettingInfo> setting_infos() noexcept;
/// Return the setting with this name, or nullptr.
[[nodiscard]] const SettingInfo* find_setting(std::string_view name) noexcept;

}  // namespace hawser
