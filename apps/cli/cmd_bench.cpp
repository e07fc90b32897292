// SPDX-License-Identifier: Apache-2.0
#include "commands.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <memory>
#include <stdexcept>

namespace hawser::cli {

namespace {

constexpr const char* kBenchFooter = R"(Examples:
  hawser bench peers --json peers.json
  hawser bench --help-bench        # the help of hawser-bench

Passes its arguments to the program hawser-bench in the folder of this program, which links
the other engines. The exit code is that of hawser-bench.)";

int bench(std::vector<std::string> arguments) {
    std::error_code error;
    const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
    const std::filesystem::path program = self.parent_path() / "hawser-bench";
    if (error || !std::filesystem::exists(program))
        throw std::runtime_error(
            fmt::format("{}: not found; build it with -DHAWSER_BENCH=ON", program.string()));
    std::string name = program.string();
    std::vector<char*> argv{name.data()};
    for (std::string& argument : arguments) {
        if (argument == "--help-bench") argument = "--help";
        argv.push_back(argument.data());
    }
    argv.push_back(nullptr);
    for (const int ignored : {SIGPIPE, SIGXFSZ})
        std::signal(ignored, SIG_DFL);  // signals that streams.h ignores
    execv(name.c_str(), argv.data());
    throw std::runtime_error(fmt::format("{}: cannot run: {}", name, std::strerror(errno)));
}

}  // namespace

void add_bench(CLI::App& app, Command& chosen) {
    CLI::App* command =
        app.add_subcommand("bench", "Measure speed compared with libraries and engines");
    command->footer(kBenchFooter);
    command->prefix_command();
    command->callback([&chosen, command] {
        chosen = [arguments = command->remaining()] { return bench(arguments); };
    });
}

}  // namespace hawser::cli
