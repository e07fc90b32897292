// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file step_seaway.h
/// Step a scene whose hulls are forced like in a seaway, for hawser-bench step --seaway.

#include <string>
#include <vector>

namespace hawser::bench {

/// Sines that act on a hull. Each has the period and phase of its hull.
struct HullForcing {
    std::string name;    ///< Body, or body in its copies: "NAME", "NAME/hull", "sK_NAME", …
    double period;       ///< [s]
    double heave;        ///< Force along z [N].
    double roll, pitch;  ///< Moments about x and y [N m].
};

struct SeawayOptions {
    std::string scene, json, csv;
    double amplitude = 1.0, phase = 0.7, seconds = 60.0;
    int threads = 1;
    std::vector<HullForcing> hulls;  ///< Empty: default_hulls().
};

/// Return the forcing of the hulls of the anchor handling site.
[[nodiscard]] std::vector<HullForcing> default_hulls();

/// Formula of the forcing, for help texts.
extern const char* const kSeawayFormula;

/// Run the scene and print the distribution of its costs. @return exit code of the program: 1 if a
/// step failed or is not certified.
int run_seaway(const SeawayOptions& options);

}  // namespace hawser::bench
