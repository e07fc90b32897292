// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file coupling_measure.h
/// Couplings that hawser-bench coupling compares, and runs of scenes with them.

#include <hawser/scene.h>

#include "verify/coupling.h"

#include <array>
#include <string>
#include <vector>

namespace hawser::bench::split {

struct Mode {
    Coupling coupling;
    Predictor predictor;
    [[nodiscard]] std::string name() const;
};

inline constexpr std::array<Mode, 7> kModes{{
    {Coupling::exact, Predictor::hold},
    {Coupling::kinematic, Predictor::hold},
    {Coupling::kinematic, Predictor::forces},
    {Coupling::kinematic, Predictor::clique},
    {Coupling::compliant, Predictor::hold},
    {Coupling::compliant, Predictor::forces},
    {Coupling::compliant, Predictor::clique},
}};

struct CouplingOptions {
    std::vector<std::string> scenes{"bench/scenes/frozen/anchor_lines.json",
                                    "bench/scenes/frozen/anchor_contact.json",
                                    "scenes/heavy_hook.json", "scenes/tow_zigzag.json"};
    std::vector<int> threads{1, 2};
    int parts = 4, steps = 120, rounds = 24;
    bool stiffness = true;
    double stiffness_seconds = 10.0;  ///< Time limit of the search of one mode [s].
    bool quick = false;
    std::string json;
};

/// Load a scene with equal cuts for every split: those of the partitioner, or stretches of equal
/// length if it finds none.
[[nodiscard]] scene::Scene load_split(const std::string& file, const Mode& mode, int parts,
                                      int threads);

struct Quality {
    verify::CouplingFigures figures;
    double time_of_loss = -1.0;  ///< Time at which a step failed or diverged [s]; −1: none.
    double energy_drift = 0.0, energy_exchanged = 0.0;  ///< [J]
    int islands = 0, cuts = 0;
    [[nodiscard]] bool failed_or_diverged() const noexcept { return time_of_loss >= 0.0; }
};

/// Compare every step with an exact one from the same state.
[[nodiscard]] Quality measure_quality(World& world, int steps);

/// Times of steps, in turns with those of other worlds.
struct Timed {
    World world;
    std::vector<double> wall{}, cpu{};  ///< [ms]
    bool failed_or_diverged = false;
    void run(int steps);
};

}  // namespace hawser::bench::split
