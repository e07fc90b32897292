// SPDX-License-Identifier: Apache-2.0
#include "golden/outputs.h"

#include "golden/stable_text.h"

#include <fmt/format.h>
#include <png.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <cstdlib>

namespace hawser::golden {

namespace {

using hawser::test::Outcome;
using hawser::test::read_text;

const std::filesystem::path kOutputs = "tests/golden/outputs";

}  // namespace

void check_output(const std::string& name, const std::string& text) {
    const std::filesystem::path file = kOutputs / name;
    if (std::getenv("HAWSER_WRITE_GOLDEN") != nullptr) {
        std::filesystem::create_directories(kOutputs);
        return write_text(file, text);
    }
    ASSERT_TRUE(std::filesystem::exists(file)) << file << ": run scripts/write_golden.sh";
    // Drawings have two decimals.
    const NumberTolerance tolerance =
        name.ends_with(".svg") ? NumberTolerance{0.0, 0.02} : NumberTolerance{};
    const std::string differences = compare_texts(read_text(file), text, tolerance);
    EXPECT_TRUE(differences.empty())
        << file.string() << " (-) and the output (+) differ:\n"
        << differences << "If this change is meant, run scripts/write_golden.sh.";
}

void Outputs::SetUp() {
    folder_ = std::filesystem::path(testing::TempDir()) / fmt::format("hawser_golden_{}", getpid());
    std::filesystem::create_directories(folder_);
}

void Outputs::TearDown() { std::filesystem::remove_all(folder_); }

void Outputs::run(const std::vector<std::string>& arguments) {
    const Outcome outcome = hawser::test::run_program(arguments, -1.0, {"HAWSER_ISA=sse2"});
    std::string line = "$ hawser";
    for (const std::string& argument : arguments) line += " " + argument;
    log_ += line + "\n" + outcome.out;
    const std::string err = stable_text(outcome.err, folder_);  // Without progress.
    if (!err.empty()) log_ += "--- standard error\n" + err;
    log_ += fmt::format("--- exit code {}\n\n", outcome.code);
}

void Outputs::check_log(const std::string& name) {
    check_output(name + ".txt", stable_text(log_, folder_));
}

void Outputs::check_file(const std::string& file, const std::string& name) {
    ASSERT_TRUE(std::filesystem::exists(out(file))) << file << " was not written:\n" << log_;
    const std::string text = read_text(out(file));
    check_output(name,
                 name.ends_with(".json") ? stable_json(text, folder_) : stable_text(text, folder_));
}

}  // namespace hawser::golden
