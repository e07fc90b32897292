// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file repeated_contacts.h
/// Compute the contact forces of a recording by replay: recordings do not contain them.

#include <hawser/repeater.h>
#include <hawser/scene.h>

#include "export/export.h"

#include <cstddef>
#include <vector>

namespace hawser::cli {

class RepeatedContacts {
  public:
    RepeatedContacts(const record::Recording& recording, int threads);
    /// Repeat the recording up to a frame, which must not precede the frame of the last call.
    /// @param index  Index of the frame in the recording; branches before it are repeated, too.
    /// @throws record::RecordingError if a step fails, or reaches another state than the recorded
    /// one.
    const exporting::ContactForces& at(const record::Frame& frame, std::size_t index);

  private:
    const record::Recording& recording_;
    scene::Scene scene_;
    record::Repeater repeater_;
    std::vector<ContactView> contacts_;
    exporting::ContactForces out_;
};

}  // namespace hawser::cli
