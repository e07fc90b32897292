// SPDX-License-Identifier: Apache-2.0
/// Commands of the Python package: `hawser study` and `hawser stats`.
#include "commands.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace hawser::cli {
namespace {

constexpr const char* kStudyFooter = R"(Examples:
  hawser study studies/moored_barge.json -o out/barge --jobs 2
  hawser study studies/moored_barge.json -o out/barge --dask tcp://127.0.0.1:8786
  hawser study --help-python       # all options

Runs the cases of a study file by the Python package (docs/studies.md): python3 -m hawser study.
HAWSER_PYTHON names another interpreter. Stored runs are not repeated.

Exit codes: 0 all runs good, 1 wrong option or study, 2 a run is not good, 130 interrupted.)";

constexpr const char* kStatsFooter = R"(Examples:
  hawser stats run.csv --from 60
  hawser stats run.hwr --hours 3

Prints mean, standard deviation, extremes, mean period and the most probable maximum of each column
of a table (hawser run --csv), or of the tensions of a recording. Runs python3 -m hawser stats
(docs/statistics.md); HAWSER_PYTHON names another interpreter.

Exit codes: 0 printed, 1 wrong option or file.)";

/// Add the package in the build folder of this program to Python's search path, if that folder
/// exists.
void add_package_path() {
    std::error_code error;
    const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
    const std::filesystem::path folder = self.parent_path().parent_path() / "python";
    if (error || !std::filesystem::exists(folder / "hawser")) return;
    const char* user_paths = std::getenv("PYTHONPATH");
    const std::string paths =
        folder.string() +
        (user_paths != nullptr && *user_paths != '\0' ? ":" + std::string(user_paths) : "");
    (void)setenv("PYTHONPATH", paths.c_str(), 1);
}

int run_python(const char* name, const std::vector<std::string>& arguments) {
    add_package_path();
    const char* user_python = std::getenv("HAWSER_PYTHON");
    std::string python =
        user_python != nullptr && *user_python != '\0' ? user_python : "/usr/bin/python3";
    std::vector<std::string> words{python, "-m", "hawser", name};
    for (const std::string& argument : arguments)
        words.push_back(argument == "--help-python" ? "--help" : argument);
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    for (const int ignored : {SIGPIPE, SIGXFSZ})
        std::signal(ignored, SIG_DFL);  // signals that streams.h ignores
    execvp(python.c_str(), argv.data());
    throw std::runtime_error(fmt::format("{}: cannot run: {}", python, std::strerror(errno)));
}

void add_python(CLI::App& app, Command& chosen, const char* name, const char* text,
                const char* footer) {
    CLI::App* command = app.add_subcommand(name, text);
    command->footer(footer);
    command->prefix_command();
    command->callback([&chosen, command, name] {
        chosen = [name, arguments = command->remaining()] { return run_python(name, arguments); };
    });
}

}  // namespace

void add_study(CLI::App& app, Command& chosen) {
    add_python(app, chosen, "study", "Run many cases of a scene, on processes or a cluster",
               kStudyFooter);
}

void add_stats(CLI::App& app, Command& chosen) {
    add_python(app, chosen, "stats", "Print statistics of a table or recording", kStatsFooter);
}

}  // namespace hawser::cli
