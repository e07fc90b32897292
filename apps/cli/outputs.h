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

/// Return the file to which a run with a report is recorded; "": none. It is `record`. If that is
/// empty, it is a file beside the report that `temporary` removes later, because pictures need a
/// recording.
[[nodiscard]] inline std::string recording_for(const std::string& record, const std::string& report,
                                               TemporaryFile& temporary) {
    if (!record.empty() || report.empty()) return record;
    temporary.path = report + ".hwr.part";
    return temporary.path.string();
}

}  // namespace hawser::cli
