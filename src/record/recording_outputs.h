// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file recording_outputs.h
/// Outputs of a world in a recording. A chunk ONAM has the names and units of the outputs from a
/// frame on. A chunk OUTP after each later frame has their values.

#include "record/bytes.h"

#include <hawser/outputs.h>
#include <hawser/world.h>

#include <cstddef>
#include <vector>

namespace hawser::record {

/// Detects additions and removals of a world's outputs.
class OutputFollower {
  public:
    /// True if the outputs changed since the last call. First call: true if there are any.
    [[nodiscard]] bool changed(const World& world);
    /// Number of outputs at the last call of changed().
    [[nodiscard]] std::size_t count() const noexcept { return outputs_.size(); }
    /// Write the contents of ONAM.
    void write_names(ByteWriter& out, const World& world) const;
    /// Write the contents of OUTP.
    void write_values(ByteWriter& out, const World& world) const;

  private:
    std::vector<OutputId> outputs_;
};

}  // namespace hawser::record
