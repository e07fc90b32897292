// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file clique.h
/// Solve the central system of a split, the predictor of cuts. Its members are the bodies at cuts
/// and the bodies that interact with them. It is solved exactly before the parts, with every other
/// body at its last velocity. Each side of a cut uses its velocities for the bodies of the other
/// side. This is our interpretation of the paper's "clique system".
///
/// On chains of nodes with damped rows it is the only predictor that is stable for any stiffness of
/// the cut. On chains of rigid links it is not stable (docs/theory/splits.md).
///
/// Contacts and friction in joints act in it with their impulses of the last step.

#include "context/context.h"
#include "context/cuts_data.h"

#include <vector>

namespace hawser::split {

struct Clique {
    explicit Clique(const WorldDef& def) : ctx(def) {}

    context::StepContext ctx;         ///< Data of its own bodies and interactions.
    std::vector<std::int32_t> body;   ///< Body of the world, by body of the clique.
    std::vector<std::int32_t> local;  ///< Body of the clique by body of the world, −1: none.
    /// By body of the clique: 1 solved for, 0 prescribed velocity.
    std::vector<std::uint8_t> member;
    /// Interaction of the world, by interaction of the clique.
    std::vector<std::int32_t> interaction;
    /// Friction that acts as a force: interaction, its slot, body of the clique.
    struct Pull {
        std::int32_t id, slot, body;
    };
    std::vector<Pull> pulls;
};

/// Build the clique of the present cuts: a small system of the bodies at cuts and their neighbours.
/// @throws std::bad_alloc.
void make_clique(context::Model& model);
/// Analyse the clique at the poses of the world. @throws std::bad_alloc.
void analyse_clique(context::Model& model);
/// Solve the clique. @return false if it failed; the velocities of ghost bodies are then unchanged.
bool solve_clique(context::Model& model, const context::State& state) noexcept;

}  // namespace hawser::split
