// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file commands.h
/// Texts of the commands of a run, other than inputs of the scene, as recordings store them for
/// pictures.

#include <hawser/hawser.h>
#include <hawser/recording.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace hawser::record {

/// Kinds of notes (RecordedNote) whose bytes are a text. "done": a change of the world, "cut tow at
/// 120 m". "set": a signal of a system with its value, "winch.speed 0.5".
inline constexpr char kDoneNote[] = "done";
inline constexpr char kSetNote[] = "set";

/// Return the text of a note that a recording stores.
[[nodiscard]] std::string text_of(const RecordedNote& note);

/// True if a system drives the input at index `place` of a recording as a part of its own.
[[nodiscard]] bool is_inner_input(const Recording& recording, std::size_t place);

/// True if an input is part of a system, which sets it. Its name then begins with the system's
/// name, as "winch/motor/speed" of a winch.
[[nodiscard]] bool is_inner_input(const World& world, std::string_view name);

/// Return the words of a winch's mode, in the order of WinchMode. Return an empty list for other
/// signals.
[[nodiscard]] std::vector<std::string> signal_words(const World& world, const SystemSignal& signal);

/// Return the text of a signal and its new value, such as "winch.speed 0.5" or "winch.mode render";
/// "" for an unknown signal. @param words  Set to true if the value has a word, else to false.
[[nodiscard]] std::string signal_text(const World& world, std::string_view name, double value,
                                      bool& words);

}  // namespace hawser::record
