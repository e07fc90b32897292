// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file csv.h
/// Results over time as comma-separated values: tensions at both ends of every cable,
/// position and Euler angles of the plotted bodies, then the outputs that the world has. What is
/// removed later leaves "nan" in its columns; what is added has none.

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
    /// Writes the line of names. @throws std::runtime_error when the file cannot be written.
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
    /// Of a cable: a wire, whose elements come and go, or a row of links.
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
