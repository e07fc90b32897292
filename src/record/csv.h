// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file csv.h
/// Write results over time as comma-separated values. Columns: tensions at both ends of every
/// cable, positions and Euler angles of the plotted bodies, then the outputs of the world. Columns
/// of removed objects contain "nan" from then on; added objects have no columns.

#include "record/scene_info.h"

#include <hawser/hawser.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace hawser::record {

class CsvWriter {
  public:
    /// Write the line of names. @throws std::runtime_error if the file cannot be written.
    CsvWriter(const std::filesystem::path& file, const SceneInfo& scene, const World& world);
    void add_row(const World& world);
    void finish();

  private:
    struct CloseFile {
        void operator()(std::FILE* f) const { std::fclose(f); }
    };
    void write();

    std::filesystem::path file_;
    std::unique_ptr<std::FILE, CloseFile> out_;
    /// Ends of a cable. A cable is a wire, whose elements may be added and removed, or a row of
    /// links.
    struct Ends {
        WireId wire;
        InteractionId first, last;
    };

    std::vector<Ends> ends_;
    std::vector<BodyId> bodies_;
    std::vector<OutputId> outputs_;
    std::string line_;
};

}  // namespace hawser::record
