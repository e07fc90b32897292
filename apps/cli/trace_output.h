// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file trace_output.h
/// `--trace`: activities of the threads of a run, as a file for trace viewers and as a picture.

#include <hawser/hawser.h>

#include <CLI/CLI.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace hawser::cli {

struct TraceOptions {
    std::vector<std::string> files;  ///< *.json: the last steps; *.svg: one of them.
    std::int64_t steps = 20;         ///< Largest number of steps in a *.json.
    std::int64_t step = 0;           ///< Step of the picture; 0: the one of median duration.

    void add_to(CLI::App& command);
    /// Start tracing. @throws std::bad_alloc.
    void start(World& world) const;
    /// Write the requested trace files. @return lines for the report; empty if no file was
    /// requested.
    [[nodiscard]] std::string finish(const World& world, const std::string& scene) const;
};

}  // namespace hawser::cli
