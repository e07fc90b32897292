// SPDX-License-Identifier: Apache-2.0
#include "commands.h"
#include "streams.h"

#include <fmt/format.h>
#include <hawser/hawser.h>
#include <hawser/hydro_files.h>

#include <cstdio>
#include <exception>
#include <new>
#include <sstream>

namespace {

constexpr const char* kFooter = R"(Examples:
  hawser run scenes/pendulum.json
  hawser run scenes/anchor_lines.json --duration 60 --record run.hwr --summary run.json
  hawser plot run.hwr -o pictures
  hawser replay run.hwr
  hawser COMMAND --help

Exit codes: 0 success; 1 wrong option, scene or file, or a report that could not be
printed; 2 a step failed; 3 replay or validation differs; 130 interrupted (Ctrl-C).)";

}  // namespace

namespace hawser::cli {

std::string& command_line() {
    static std::string line = "hawser";
    return line;
}

namespace {

int run_main(int argc, char** argv) {
    CLI::App app{"Hawser: real-time dynamics of ships, cranes, winches and cables", "hawser"};
    app.set_version_flag(
        "--version", fmt::format("hawser {} ({})", hawser::version(), hawser::instruction_set()));
    app.set_help_all_flag("--help-all", "Help of all commands");
    app.footer(kFooter);
    app.require_subcommand(1);
    Command chosen;
    for (int i = 1; i < argc; ++i) command_line() += std::string(" ") + argv[i];
    add_run(app, chosen);
    add_check(app, chosen);
    add_settle(app, chosen);
    add_replay(app, chosen);
    add_plot(app, chosen);
    add_exercise(app, chosen);
    add_controls(app, chosen);
    add_export(app, chosen);
    add_inspect(app, chosen);
    add_figures(app, chosen);
    add_validate(app, chosen);
    add_view(app, chosen);
    add_bench(app, chosen);
    add_study(app, chosen);
    add_stats(app, chosen);
    // CLI11 would only report that a command is required.
    const auto named = [&](const CLI::App* c) { return c->get_name() == argv[1]; };
    if (argc > 1 && argv[1][0] != '-' && app.get_subcommands(named).empty()) {
        fmt::print(stderr, "hawser: there is no command \"{}\"; hawser --help lists them\n",
                   argv[1]);
        return kUsageError;
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        std::ostringstream out, error;
        const int code = app.exit(e, out, error) == 0 ? kOk : kUsageError;
        fmt::print("{}", out.str());
        fmt::print(stderr, "{}", error.str());
        return code;
    }
    hawser::check_environment();
    return chosen();
}

}  // namespace

}  // namespace hawser::cli

int main(int argc, char** argv) {
    using namespace hawser::cli;
    if (const auto code = hawser::serve_coefficients_reader(argc, argv)) return *code;
    open_streams();
    int code = kUsageError;
    try {
        code = run_main(argc, argv);
    } catch (const std::bad_alloc&) {
        std::fputs("hawser: out of memory\n", stderr);
    } catch (const std::exception& e) {
        std::fputs("hawser: ", stderr);
        std::fputs(e.what(), stderr);
        std::fputs("\n", stderr);
    }
    return close_streams(code);
}
