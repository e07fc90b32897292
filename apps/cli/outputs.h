// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file outputs.h
/// Check the files that a command reads and writes before any is opened.

#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace hawser::cli {

struct NamedFile {
    std::string what;  ///< Name for the user: "--record", "the scene".
    std::string file;
};

/// Check that each output can be written, and is neither an input nor another output, because a run
/// overwrites it. Empty names are skipped. @throws std::runtime_error that names file and options.
void check_outputs(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs);

/// Write a whole file under a temporary name and rename it. @throws std::runtime_error that begins
/// with the file.
void write_output(const std::string& file, const std::string& text, const char* what);

/// A file that the destructor removes.
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

/// Return the file for the recording of a run with a report; "": none. It is `record`, or, if
/// `record` is empty, a temporary file beside the report, because the pictures of the report need a
/// recording. `temporary` removes this file later.
[[nodiscard]] inline std::string recording_for(const std::string& record, const std::string& report,
                                               TemporaryFile& temporary) {
    if (!record.empty() || report.empty()) return record;
    temporary.path = report + ".hwr.part";
    return temporary.path.string();
}

}  // namespace hawser::cli
