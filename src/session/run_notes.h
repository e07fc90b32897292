// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file run_notes.h
/// Tells a recording what a run has been told beside inputs of the world, for pictures.

#include <hawser/timeline.h>
#include <hawser/world.h>
#include "record/recording_writer.h"

#include <map>
#include <span>
#include <string>

namespace hawser::session {

class RunNotes {
  public:
    /// Another recording, or another state: what signals have is not known.
    void clear() noexcept { told_.clear(); }
    /// A signal that has been set to a value; nothing where it has been told so.
    void signal(const World& world, record::RecordingWriter& to, const std::string& name,
                double value);
    /// What a timeline has just done.
    void operations(const World& world, record::RecordingWriter& to,
                    std::span<const scene::Operation> done);

  private:
    std::map<std::string, double> told_;  ///< Signals and their values.
};

}  // namespace hawser::session
