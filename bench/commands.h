// SPDX-License-Identifier: Apache-2.0
/// @file
/// Subcommands of hawser-bench. Each takes its own arguments, argv[0] being its name, and returns
/// the exit code of the program. To add one: declare it here, add a line to the table in main.cpp.
#pragma once

namespace hawser::bench {

/// Compare engines on heavy_hook, tow_zigzag and mooring.
int peers_command(int argc, char** argv);

}  // namespace hawser::bench
