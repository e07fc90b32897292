// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file clique.h
/// The central system of a split: the bodies at cuts and those that interact with them, solved
/// exactly before the parts are, with every other body held at its last velocity. Its velocities
/// are what the sides of a cut take for each other's. That is our reading of the paper's "clique
/// system". On chains of lumps with damped rows it is the only predictor that is stable however
/// stiff the cut; on chains of rigid links it is not stable (docs/methods.md, 10).
///
/// Contacts and friction in joints act in it with their impulses of the last step.

#include "context/context.h"
#include "context/cuts_data.h"

#include <vector>

namespace hawser::stepper {

struct Clique {
    explicit Clique(const WorldDef& def) : ctx(def) {}

    StepContext ctx;                        ///< Of its own bodies and interactions.
    std::vector<std::int32_t> body;         ///< By body in it: that of the world.
    std::vector<std::int32_t> local;        ///< By body of the world: in it, −1: not.
    std::vector<std::uint8_t> member;       ///< By body in it: 1 solved for, 0 held.
    std::vector<std::int32_t> interaction;  ///< By interaction in it: that of the world.
    /// Slots (interaction, slot, body in it) of friction that acts as a force.
    struct Pull {
        std::int32_t id, slot, body;
    };
    std::vector<Pull> pulls;
};

/// For the cuts there are. @throws std::bad_alloc.
void make_clique(Model& model);
/// Analyse it at the poses of the world. @throws std::bad_alloc.
void analyse_clique(Model& model);
/// Solve it. @return false: failed; the images' velocities are as they were.
bool solve_clique(Model& model, const State& state) noexcept;

}  // namespace hawser::stepper
