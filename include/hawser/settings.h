// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file settings.h
/// The settings of a world as a list: what checks, scene files, documents and the identity of
/// snapshots know of a member of WorldDef is said here once.
///
/// To add a setting: a member of WorldDef with its default, and an entry of the list in
/// src/world/settings.cpp. Nothing else has to know it, apart from what uses it.

#include <hawser/def.h>

#include <cstdint>
#include <span>
#include <string_view>

namespace hawser {

/// What the value of a setting is.
enum class SettingType : std::uint8_t { number, integer, boolean, word, vector };

/// One member of WorldDef. Ranges hold for each component of a vector.
struct SettingInfo {
    const char* name = "";  ///< Of the member, and in scene files.
    SettingType type = SettingType::number;
    double min = 0.0, max = 0.0;           ///< Range, both included [unit].
    const char* unit = "";                 ///< SI; "": none.
    const char* what = "";                 ///< In words, for messages: "a time".
    std::span<const char* const> words{};  ///< Of type word: those of the values 0, 1, …
    /// Worlds that differ in it give different states: a snapshot of one is refused by the other.
    /// False for limits, form and threads, which change how a state is come to.
    bool identity = false;
    bool in_scenes = true;      ///< Key of "settings"; the others are the program's options.
    const char* fallback = "";  ///< Default as documents say it, where that is not the number.
    const char* doc = "";       ///< What it does, in one or two sentences.
    double (*get)(const WorldDef&, int component) = nullptr;
    void (*set)(WorldDef&, int component, double value) = nullptr;
};

/// All settings, in the order of documents.
[[nodiscard]] std::span<const SettingInfo> setting_infos() noexcept;
/// Null where no setting has that name.
[[nodiscard]] const SettingInfo* find_setting(std::string_view name) noexcept;

}  // namespace hawser
