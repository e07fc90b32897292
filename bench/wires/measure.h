// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file measure.h
/// Ratio of forces at which a wire around a post slips, creep below that ratio, and time of a
/// frame. One code for all engines.
///
/// A run raises both forces to W within a second, the pull to P = rW within another, and waits. The
/// wire *slips* if the weight accelerates: its displacement in the second half of the wait is more
/// than twice that in the first. A body pulled from rest has 3:1, steady creep 1:1. It also slips
/// if the displacement exceeds 1 cm, since a polygon that has begun to slip may stop in another
/// position. Slower steady motion is creep and is reported separately.

#include "rig.h"

#include <functional>
#include <string>
#include <vector>

namespace hawser::bench::wires {

/// A method for a wire around a post.
struct WireMethod {
    std::string name;  ///< Name for --engines: all of one engine begin with its name.
    std::string description;
    bool ours = false;
    /// Null if it does not support the case or is not in this build.
    std::function<std::unique_ptr<Rig>(double turns, int substeps)> make;
    /// ln(P/W) at the start of the search. Ours: the ratio at which the geometry of the method
    /// slips; without friction 0.
    std::function<double(double turns)> exponent;
    bool in_build = true;
    bool quick = false;  ///< In --quick.
};

/// All methods, ours first.
[[nodiscard]] std::vector<WireMethod> methods();

struct WirePlan {
    double wait = 4.0;         ///< Duration of the wait in a run for slip [s].
    double creep = 10.0;       ///< [s]
    double own_width = 1e-5;   ///< Width of ln(P/W) at the end of the search, ours.
    double peer_width = 1e-3;  ///< Peers'.
    int max_substeps = 64;
    int substeps = 0;      ///< Substeps of peers; 0: the minimum that holds.
    double budget = 60.0;  ///< CPU time of the search of one method in one case [s].
};

struct WireFigures {
    std::string method, settings;
    double turns = 0.0;
    bool ours = false;
    bool has_case = false;  ///< False: the engine does not have the case.
    bool holds = false;     ///< It stands at e^{μθ/2}, without friction at 1.
    std::string why_not;    ///< Reason if it does not.
    int substeps = 0;    ///< Minimum of 1, 2, 4, 8, … with which it holds; else the last one tried.
    double ratio = 0.0;  ///< P/W at which it slips.
    double width = 0.0;  ///< Relative width of the search's last interval.
    double error = 0.0;  ///< ratio/e^{μθ} − 1.
    double own_error = 0.0;      ///< Ours: the closed form of the geometry /e^{μθ} − 1.
    double creep = 0.0;          ///< Way of the weight in WirePlan::creep at 0.99 ratio [m].
    double creep_seconds = 0.0;  ///< Simulated duration, up to the loss of the wire.
    double gap = 0.0;            ///< Largest of the creep run [m].
    double ms = 0.0;             ///< Median CPU time of the frames of the creep run [ms].
};

[[nodiscard]] WireFigures measure(const WireMethod& method, double turns, const WirePlan& plan);

}  // namespace hawser::bench::wires
