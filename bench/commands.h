// SPDX-License-Identifier: Apache-2.0
/// @file
/// Subcommands of hawser-bench. Each parses its own arguments, with its name in argv[0], and
/// returns the exit code of the program. To add one: declare it here, add a line to the table in
/// main.cpp.
#pragma once

namespace hawser::bench {

/// Time whole steps of a scene at several scales.
int step_command(int argc, char** argv);

/// Time factorisation and solution of a scene's matrix against libraries.
int factor_command(int argc, char** argv);

/// Compare the factorisation with the limits of the processor.
int roofline_command(int argc, char** argv);

/// Time whole steps of a million rigid links.
int links_command(int argc, char** argv);

/// Compare the methods for contacts with friction.
int friction_command(int argc, char** argv);

/// Compare parts and orders with those of METIS, Scotch and AMD.
int partition_command(int argc, char** argv);
/// Keep a budget while the load of a scene doubles.
int deadline_command(int argc, char** argv);
/// Compare splits with exact coupling.
int coupling_command(int argc, char** argv);

/// Compare state hashes between numbers of threads, and after restoring.
int hashes_command(int argc, char** argv);

/// Run random mechanisms, and check the runs that end ok.
int random_command(int argc, char** argv);

/// Measure clients of `hawser view` and their cost for the run.
int view_command(int argc, char** argv);

/// Measure the time in which a client reads a world.
int interface_command(int argc, char** argv);

/// Measure the time of waves, hulls and their memory.
int sea_command(int argc, char** argv);

/// Measure the time of adding and removing objects while a world runs.
int edits_command(int argc, char** argv);

/// Compare engines on the scenes of peers/scenes.h.
int peers_command(int argc, char** argv);

/// Compare engines on a wire around a post.
int wires_command(int argc, char** argv);

}  // namespace hawser::bench
