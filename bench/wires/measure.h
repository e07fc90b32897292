// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file measure.h
/// Ratio of forces at which a wire around a bollard slips, its creep below that ratio, and the cost
/// of a frame. The same code for all engines.
///
/// A run raises both forces to W within a second, the pull to P = rW within another, and waits. The
/// wire *slips* if the weight accelerates: in the second half of the wait it moves more than twice
/// as far as in the first. A body pulled from rest does (3:1); creep at a constant speed (1:1) does
/// not, and is reported separately. It also slips if it moves farther than 1 cm: a polygon that has
/// started to slip may reach another position and hold again.

#include "rig.h"

#include <functional>
#include <string>
#include <vector>

namespace hawser::bench::wires {

/// A method for a wire around a bollard.
struct WireMethod {
    std::string name;  ///< Name for --engines: all of one engine begin with its name.
    std::string description;
    bool ours = false;
    /// Makes a rig. Null if the method does not have the case, or is not in this build.
    std::function<std::unique_ptr<Rig>(double turns, int substeps)> make;
    /// ln(P/W) at which the search begins. Hawser: where the method's own geometry slips; without
    /// friction 0.
    std::function<double(double turns)> exponent;
    bool in_build = true;
    bool quick = false;  ///< True if part of --quick.
};

/// Return all methods, Hawser first.
[[nodiscard]] std::vector<WireMethod> methods();

struct WirePlan {
    double wait = 4.0;         ///< In a run that checks for slipping [s].
    double creep = 10.0;       ///< Duration of the creep run [s].
    double own_width = 1e-5;   ///< Width in ln(P/W) at the end of the search, for Hawser.
    double peer_width = 1e-3;  ///< The same for peers.
    int max_substeps = 64;
    int substeps = 0;      ///< Substeps of peers; 0: the least number that holds.
    double budget = 60.0;  ///< CPU time of the search of one method in one case [s].
};

struct WireFigures {
    std::string method, settings;
    double turns = 0.0;
    bool ours = false;
    bool has_case = false;        ///< False if the engine does not have the case.
    bool holds = false;           ///< True if it holds at e^{μθ/2}, without friction at 1.
    std::string reason_unusable;  ///< Reason if it does not.
    int substeps = 0;        ///< Least of 1, 2, 4, 8, … with which it holds; otherwise the last one
                             ///< tried.
    double ratio = 0.0;      ///< P/W at which it slips.
    double width = 0.0;      ///< Relative width of the search's last interval.
    double error = 0.0;      ///< ratio/e^{μθ} − 1.
    double own_error = 0.0;  ///< Hawser: closed form of the geometry over e^{μθ}, minus 1.
    double creep = 0.0;      ///< Displacement of the weight in WirePlan::creep at 0.99 ratio [m].
    double creep_seconds = 0.0;  ///< Simulated part of it, until the weight was lost.
    double gap = 0.0;            ///< Largest gap of the creep run [m].
    double ms = 0.0;             ///< Median CPU time of the frames of the creep run [ms].
};

[[nodiscard]] WireFigures measure(const WireMethod& method, double turns, const WirePlan& plan);

}  // namespace hawser::bench::wires
