// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file notes.h
/// What a recording keeps of an exercise beside the motion (notes of the kind "exercise").
///
/// A note is an u8 kind and its fields: 0 `begin`: text of the document, u32 number of channels and
/// an u8 of each, 1: its values are noted, since a world without the systems of the scene cannot
/// give them. 1 `values`, after a step: u32 number, and of each that changed u32 channel, f64.
/// 2 `fault`: u8 begins, text name, text by whom. 3 `mark`, 4 `back`: i32 number. 5 `end`: text
/// why, u8 failed. 6 `asked`: text role, text input, f64.

#include <hawser/exercise.h>

#include "exercise/scorer.h"
#include "record/bytes.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace hawser::exercise {

inline constexpr std::string_view kNoteKind = "exercise";

enum class NoteKind : std::uint8_t { begin, values, fault, mark, back, end, asked };

/// Writes notes into the recording of a session.
class NoteWriter {
  public:
    explicit NoteWriter(Session& session) : session_(session) {}
    void begin(const Exercise& exercise, const std::vector<bool>& noted);
    /// Those that changed since the last call, of channels that are noted.
    void values(const std::vector<bool>& noted, std::span<const double> values);
    void fault(bool begins, std::string_view name, std::string_view by);
    void number(NoteKind kind, std::int32_t number);
    void end(std::string_view why, bool failed);
    void asked(std::string_view role, std::string_view input, double value);

  private:
    void start(NoteKind kind);
    void send();
    Session& session_;
    record::ByteWriter bytes_;
    std::vector<double> last_;
};

/// Channels that a world without systems cannot give: outputs of systems, and events of systems.
[[nodiscard]] std::vector<bool> noted_channels(const std::vector<Channel>& channels,
                                               const World& world);

/// Values of channels after a step. @param all  Whether those of systems are there too; else their
/// entries in `out` stay as they are.
void read_channels(const std::vector<Channel>& channels, const std::vector<bool>& noted,
                   const World& world, std::span<const Event> events, bool all,
                   std::vector<double>& out);

}  // namespace hawser::exercise
