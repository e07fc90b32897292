// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file run_notes.h
/// Write the signals and operations of a run, other than inputs of the world, to a recording, for
/// pictures.

#include <hawser/timeline.h>
#include <hawser/world.h>
#include "record/recording_writer.h"

#include <map>
#include <span>
#include <string>

namespace hawser::session {

class RunNotes {
  public:
    /// Discard the last written values of all signals. Call after a change of the recording or of
    /// the state.
    void clear() noexcept { reported_.clear(); }
    /// Write the new value of a signal. Do nothing if the same value was written last.
    void signal(const World& world, record::RecordingWriter& to, const std::string& name,
                double value);
    /// Write the operations that the timeline performed last to the recording.
    void operations(const World& world, record::RecordingWriter& to,
                    std::span<const scene::Operation> done);

  private:
    std::map<std::string, double> reported_;  ///< Signals and their values.
};

}  // namespace hawser::session
