// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file commands.h
/// The commands of the program and their exit codes (docs/cli.md).

#include <CLI/CLI.hpp>

#include <functional>
#include <string>

namespace hawser::cli {

inline constexpr int kOk = 0;
inline constexpr int kUsageError = 1;  ///< Wrong option, scene or file.
inline constexpr int kFailed = 2;      ///< A step did not succeed.
inline constexpr int kMismatch = 3;    ///< Replay or validation differs.
inline constexpr int kInterrupted = 130;

/// Function that main() calls after the command line was read; returns the exit code.
using Command = std::function<int()>;

/// Return the command line as typed, with the program's name without folder. main() sets it.
/// Written files contain it as their origin.
[[nodiscard]] std::string& command_line();

inline constexpr int kMostThreads = 256;  ///< Limit of WorldDef::threads.

/// Return a validator of an option. Its message states the expected values.
[[nodiscard]] CLI::Validator positive();
[[nodiscard]] CLI::Validator not_negative();
[[nodiscard]] CLI::Validator finite();

void add_run(CLI::App& app, Command& chosen);
void add_check(CLI::App& app, Command& chosen);
void add_settle(CLI::App& app, Command& chosen);
void add_replay(CLI::App& app, Command& chosen);
void add_plot(CLI::App& app, Command& chosen);
void add_controls(CLI::App& app, Command& chosen);
void add_exercise(CLI::App& app, Command& chosen);
void add_export(CLI::App& app, Command& chosen);
void add_inspect(CLI::App& app, Command& chosen);
void add_figures(CLI::App& app, Command& chosen);
void add_validate(CLI::App& app, Command& chosen);
void add_view(CLI::App& app, Command& chosen);
void add_bench(CLI::App& app, Command& chosen);
void add_study(CLI::App& app, Command& chosen);
void add_stats(CLI::App& app, Command& chosen);

}  // namespace hawser::cli
