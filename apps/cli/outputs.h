// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file outputs.h
/// Files that a command reads and writes, looked at before anything is opened.

#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace hawser::cli {

struct NamedFile {
    std::string what;  ///< As the user knows it: "--record", "the scene".
    std::string file;
};

/// Each output can be written, none is an input or another output: a file that a run has begun to
/// write over is gone. Those without a name are left out.
/// @throws std::runtime_error that names file and options.
void check_outputs(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs);

/// Write a whole file beside and rename it. @throws std::runtime_error that begins with the file.
void write_output(const std::string& file, const std::string& text, const char* what);

/// A file that goes when it is no longer needed.
struct TemporaryFile {
    std::filesystem::path path;
    TemporaryFile() = default;
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile() {
        std::error_code ignored;
        if (!path.empty()) std::filesystem::remove(path, ignored);
    }
};

/// Where a run with a report is recorded: `record`, else a file beside the report that goes with
/// `temporary`, since pictures come from recordings; "": nowhere.
[[nodiscard]] inline std::string recording_for(const std::string& record, const std::string& report,
                                               TemporaryFile& temporary) {
    if (!record.empty() || report.empty()) return record;
    temporary.path = report + ".hwr.part";
    return temporary.path.string();
}

}  // namespace hawser::cli
