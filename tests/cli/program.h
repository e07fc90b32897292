// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file program.h
/// Run the program hawser and return its output and exit code.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace hawser::test {

struct Outcome {
    int code = -1;  ///< Exit code; −signal if a signal ended it.
    std::string out, err;
};

/// Return the program under test. @throws std::runtime_error if HAWSER_BIN_DIR does not name it.
[[nodiscard]] std::filesystem::path program_file();

/// Run the program.
/// @param interrupt_after  Send SIGINT this many seconds after the first output; negative: never.
/// @param environment      Environment entries "NAME=value", added to the present ones.
[[nodiscard]] Outcome run_program(const std::vector<std::string>& arguments,
                                  double interrupt_after = -1.0,
                                  const std::vector<std::string>& environment = {});

/// Return an empty folder of this test.
[[nodiscard]] std::filesystem::path test_folder();

[[nodiscard]] std::string read_text(const std::filesystem::path& file);
void write_text(const std::filesystem::path& file, const std::string& text);

/// Overwrite one byte.
void damage(const std::filesystem::path& file, std::size_t at);

}  // namespace hawser::test
