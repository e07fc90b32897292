// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file outputs.h
/// Runs the program and compares its outputs with the files in tests/golden/outputs. The
/// environment variable HAWSER_BIN_DIR names the folder of the program.

#include "cli/program.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace hawser::golden {

using hawser::test::write_text;

/// Fixture with a folder of its own for the files that the program writes.
class Outputs : public testing::Test {
  protected:
    void SetUp() override;
    void TearDown() override;

    /// Return the path of a file in the folder.
    [[nodiscard]] std::string out(const std::string& file) const { return folder_ / file; }
    /// Run the program with SSE2 and append its command line, outputs and exit code to the log.
    void run(const std::vector<std::string>& arguments);
    /// Compare the log with the file `name`.txt.
    void check_log(const std::string& name);
    /// Compare a file of the folder with the file `name`. Its ending tells its kind: .json, .svg,
    /// or any other text.
    void check_file(const std::string& file, const std::string& name);
    /// Append the size of a picture and projections of its pixels to the log.
    void add_picture(const std::string& file);
    /// Append the header of a .vtp file and projections of its binary arrays to the log.
    void add_vtp(const std::string& file);
    /// Append the document of a .glb file and projections of its accessors to the log.
    void add_glb(const std::string& file);

    std::string log_;

  private:
    std::filesystem::path folder_;
};

/// Compare a text with the file `name` in tests/golden/outputs. Write it to that file instead if
/// the environment has HAWSER_WRITE_GOLDEN.
void check_output(const std::string& name, const std::string& text);

}  // namespace hawser::golden
