// SPDX-License-Identifier: Apache-2.0
/// @file
/// Subcommands of hawser-bench. Each takes its own arguments, argv[0] being its name, and returns
/// the exit code of the program. To add one: declare it here, add a line to the table in main.cpp.
#pragma once

namespace hawser::bench {

/// Time whole steps of a scene at several scales.
int step_command(int argc, char** argv);

/// Time factorisation and solution of a scene's matrix against libraries.
int factor_command(int argc, char** argv);

/// Our factorisation beside what the processor can do.
int roofline_command(int argc, char** argv);

/// Time whole steps of a million rigid links.
int links_command(int argc, char** argv);

/// Compare the methods for contacts with friction.
int friction_command(int argc, char** argv);

/// Parts and orders beside those of METIS, Scotch and AMD.
int partition_command(int argc, char** argv);
/// Keep to a budget while the load of a scene doubles.
int deadline_command(int argc, char** argv);
/// Compare splits with exact coupling.
int coupling_command(int argc, char** argv);

/// Compare state hashes between numbers of threads, and after restoring.
int hashes_command(int argc, char** argv);

/// Run random mechanisms, and judge those that end ok.
int random_command(int argc, char** argv);

/// Clients of `hawser view`, and what they cost the run.
int view_command(int argc, char** argv);

/// What it costs a client to read a world.
int interface_command(int argc, char** argv);

/// What waves, hulls and their memory cost.
int sea_command(int argc, char** argv);

/// What it costs to add and remove while a world runs.
int edits_command(int argc, char** argv);

/// Compare engines on the scenes of peers/scenes.h.
int peers_command(int argc, char** argv);

/// Compare engines on a wire round a post.
int wires_command(int argc, char** argv);

}  // namespace hawser::bench
