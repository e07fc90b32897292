// SPDX-License-Identifier: Apache-2.0
/// Compile the helper of tests/cli that runs the program into this executable.
#include "cli/program.cpp"  // NOLINT(bugprone-suspicious-include)
