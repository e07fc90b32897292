// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file notes.h
/// Write and read the data of an exercise in a recording, beyond the motion (notes of the kind
/// "exercise").
///
/// A note is an u8 kind and its fields:
/// 1. Kind 0 `begin`: text of the document, u32 number of channels, and one u8 for each channel.
/// The u8 is 1 if the values are noted because a world without the systems of the scene cannot
/// compute them.
/// 2. Kind 1 `values`, after a step: u32 number of changed channels, then u32 channel and f64 value
/// of each.
/// 3. Kind 2 `fault`: u8 begins, text name, text by whom.
/// 4. Kinds 3 `mark` and 4 `back`: i32 number.
/// 5. Kind 5 `end`: text reason, u8 failed.
/// 6. Kind 6 `asked`: text role, text input, f64 value.

#include <hawser/exercise.h>

#include "exercise/scorer.h"
#include "record/bytes.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace hawser::exercise {

inline constexpr std::string_view kNoteKind = "exercise";

enum class NoteKind : std::uint8_t { begin, values, fault, mark, back, end, asked };

/// Writer of notes to the recording of a session.
class NoteWriter {
  public:
    explicit NoteWriter(Session& session) : session_(session) {}
    void begin(const Exercise& exercise, const std::vector<bool>& noted);
    /// Write the values of the noted channels that have changed since the last call.
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

/// Return which channels a world without systems cannot compute: outputs and events of systems.
[[nodiscard]] std::vector<bool> noted_channels(const std::vector<Channel>& channels,
                                               const World& world);

/// Read the values of channels after a step. @param all  True if the world has the systems; else
/// the entries of noted channels in `out` are unchanged.
void read_channels(const std::vector<Channel>& channels, const std::vector<bool>& noted,
                   const World& world, std::span<const Event> events, bool all,
                   std::vector<double>& out);

}  // namespace hawser::exercise
