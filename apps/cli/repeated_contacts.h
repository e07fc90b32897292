// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file repeated_contacts.h
/// Contact forces of a recording, from repeating it: recordings do not hold them.

#include <hawser/repeater.h>
#include <hawser/scene.h>

#include "export/export.h"

#include <cstddef>
#include <vector>

namespace hawser::cli {

class RepeatedContacts {
  public:
    RepeatedContacts(const record::Recording& recording, int threads);
    /// Steps on to a frame, which is not before the last one asked for. @throws
    /// record::RecordingError where a step fails, or comes to another state than the recorded one.
    /// @param index  Of the frame in the recording, whose takes before it are repeated as well.
    const exporting::ContactForces& at(const record::Frame& frame, std::size_t index);

  private:
    const record::Recording& recording_;
    scene::Scene scene_;
    record::Repeater repeater_;
    std::vector<ContactView> contacts_;
    exporting::ContactForces out_;
};

}  // namespace hawser::cli
