// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file measure.h
/// At which ratio of forces a wire round a post slips, how far it creeps below that, and what a
/// frame costs. One code for all engines.
///
/// A run brings both forces up to W within a second, the pull up to P = rW within another, and
/// waits. It *slips* where the weight speeds up: it comes in the second half of the wait more than
/// twice as far as in the first, as what is pulled from rest does (3:1). It also slips where it
/// comes farther than 1 cm, since a polygon that has begun to slip may lie elsewhere and hold
/// again. What creeps slower than that at a steady speed (1:1) does not slip; how far it creeps is
/// told beside it.

#include "rig.h"

#include <functional>
#include <string>
#include <vector>

namespace hawser::bench::wires {

/// A way to lay a wire round a post.
struct WireMethod {
    std::string name;  ///< As --engines takes it: all of one engine begin with its name.
    std::string description;
    bool ours = false;
    /// Null where it does not have the case, or is not in this build.
    std::function<std::unique_ptr<Rig>(double turns, int substeps)> make;
    /// ln(P/W) at which the search begins: of ours where the method's own geometry slips; without
    /// friction 0.
    std::function<double(double turns)> exponent;
    bool in_build = true;
    bool quick = false;  ///< In --quick.
};

/// All methods, ours first.
[[nodiscard]] std::vector<WireMethod> methods();

struct WirePlan {
    double wait = 4.0;         ///< In a run that looks whether it slips [s].
    double creep = 10.0;       ///< [s]
    double own_width = 1e-5;   ///< Of ln(P/W) at the end of the search, ours.
    double peer_width = 1e-3;  ///< Peers'.
    int max_substeps = 64;
    int substeps = 0;      ///< Of peers; 0: the least that holds.
    double budget = 60.0;  ///< CPU time of the search of one method in one case [s].
};

struct WireFigures {
    std::string method, settings;
    double turns = 0.0;
    bool ours = false;
    bool has_case = false;   ///< False: the engine does not have the case.
    bool holds = false;      ///< It stands at e^{μθ/2}, without friction at 1.
    std::string why_not;     ///< Where it does not.
    int substeps = 0;        ///< Least of 1, 2, 4, 8, … with which it holds; the last one tried.
    double ratio = 0.0;      ///< P/W at which it slips.
    double width = 0.0;      ///< Relative width of the search's last interval.
    double error = 0.0;      ///< ratio/e^{μθ} − 1.
    double own_error = 0.0;  ///< Ours: the closed form of the geometry /e^{μθ} − 1.
    double creep = 0.0;      ///< Way of the weight in WirePlan::creep at 0.99 ratio [m].
    double creep_seconds = 0.0;  ///< Of them that were run, until it was lost.
    double gap = 0.0;            ///< Largest of the creep run [m].
    double ms = 0.0;             ///< Median CPU time of the frames of the creep run [ms].
};

[[nodiscard]] WireFigures measure(const WireMethod& method, double turns, const WirePlan& plan);

}  // namespace hawser::bench::wires
