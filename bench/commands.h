// SPDX-License-Identifier: Apache-2.0
/// @file
/// Subcommands of hawser-bench. Each takes its own arguments, with its name as argv[0], and returns
/// the exit code of the program. To add one, declare it here and add a line to the table in
/// main.cpp.
#pragma once

namespace hawser::bench {

/// Time whole steps of a scene at several scales.
int step_command(int argc, char** argv);

/// Time the steps of an exercise relative to a scene at rest.
int exercise_command(int argc, char** argv);

/// Time factorisation and solution of a scene's matrix against libraries.
int factor_command(int argc, char** argv);

/// Compare Hawser's factorisation with the limits of the processor.
int roofline_command(int argc, char** argv);

/// Time whole steps of a million rigid links.
int links_command(int argc, char** argv);

/// Compare the methods for contacts with friction.
int friction_command(int argc, char** argv);

/// Compare parts and orders with those of METIS, Scotch and AMD.
int partition_command(int argc, char** argv);
/// Keep to a budget while the load of a scene doubles.
int deadline_command(int argc, char** argv);
/// Compare splits with exact coupling.
int coupling_command(int argc, char** argv);

/// Compare state hashes between numbers of threads, and after restoring.
int hashes_command(int argc, char** argv);

/// Run random mechanisms, and check those that end ok.
int random_command(int argc, char** argv);

/// Measure clients of `hawser view` and their cost to the run.
int view_command(int argc, char** argv);

/// Time a client's calls that read a world.
int interface_command(int argc, char** argv);

/// Time waves, hulls and their memory.
int sea_command(int argc, char** argv);

/// Time additions and removals in a running world.
int edits_command(int argc, char** argv);

/// Compare engines on the scenes of peers/scenes.h.
int peers_command(int argc, char** argv);

/// Compare engines on a wire around a bollard.
int wires_command(int argc, char** argv);

}  // namespace hawser::bench
