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
    /// Step to a frame, which must not precede the last requested one. @throws
    /// record::RecordingError if a step fails, or reaches another state than the recorded one.
    /// @param index  Index of the frame in the recording; branches before it are repeated, too.
    const exporting::ContactForces& at(const record::Frame& frame, std::size_t index);

  private:
    const record::Recording& recording_;
    scene::Scene scene_;
    record::Repeater repeater_;
    std::vector<ContactView> contacts_;
    exporting::ContactForces out_;
};

}  // namespace hawser::cli
