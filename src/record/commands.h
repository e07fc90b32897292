// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file commands.h
/// What is commanded in a run beside inputs of the scene, as recordings keep it for pictures.

#include <hawser/hawser.h>
#include <hawser/recording.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace hawser::record {

/// Kinds of notes (RecordedNote) whose bytes are a text: what was done to the world, "cut tow at
/// 120 m", and a signal of a system that was set, "winch.speed 0.5".
inline constexpr char kDoneNote[] = "done";
inline constexpr char kSetNote[] = "set";

/// The text of such a note.
[[nodiscard]] std::string text_of(const RecordedNote& note);

/// Whether an input of a recording, by its place, is a part of a system, which drives it.
[[nodiscard]] bool is_inner_input(const Recording& recording, std::size_t place);

/// Whether an input is a part of a system, which drives it: its name begins with the system's, as
/// "winch/motor/speed" of a winch.
[[nodiscard]] bool is_inner_input(const World& world, std::string_view name);

/// Words of a winch's mode, in the order of WinchMode; nothing of other signals.
[[nodiscard]] std::vector<std::string> signal_words(const World& world, const SystemSignal& signal);

/// A value that a signal has been given, "winch.speed 0.5" or "winch.mode render"; "" where there
/// is no such signal. @param words  Set to whether the value has a word.
[[nodiscard]] std::string signal_text(const World& world, std::string_view name, double value,
                                      bool& words);

}  // namespace hawser::record
