// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file cuts_data.h
/// Ghost bodies, duplicated interactions and cuts (cuts.h).

#include <hawser/def.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace hawser::split {
struct Clique;
}  // namespace hawser::split

namespace hawser::context {

/// A ghost body: `body` is the ghost, `of` the original.
struct GhostBody {
    std::int32_t body, of;
};

/// Rows at the original of a ghost body: slot `slot` of interaction `id`.
struct Pull {
    std::int32_t ghost, id, slot;  ///< Ghost body, as index in Cuts::ghosts; interaction and slot.
};

/// A cut interaction. Its duplicates are the interactions [first, first + sides).
struct Cut {
    std::int32_t id, first, sides;
    bool open;            ///< True if the cut is active, see open_cuts().
    int interface = 0;    ///< Bit of Degradation::cuts that requests it.
    double defect = 0.0;  ///< Norm of the sum of the impulses on its bodies in the last step [N s].
    /// Maximum of |G v₊ + Σλ − c| over its rows, λ the mean [m/s or rad/s].
    double residual = 0.0;
};

struct Cuts {
    std::vector<std::int32_t> group;              ///< Part of each body of the user.
    std::vector<Coupling> coupling;               ///< Coupling of each interaction of the user.
    std::int32_t bodies = -1, interactions = -1;  ///< Counts of the user; −1: there are no cuts.
    bool grouped = false;                         ///< True if there are bodies of several groups.
    std::vector<Cut> list;                        ///< Ascending by id.
    std::vector<GhostBody> ghosts;                ///< Ghost bodies, ascending by body.
    std::vector<Pull> pulls;         ///< Pulls of predictor forces, ascending by ghost body.
    std::vector<std::int32_t> of;    ///< Original interaction of each duplicate.
    std::vector<double> touch;       ///< Packed like v: Jᵀλ of contacts in the last step [N s].
    std::vector<std::int32_t> part;  ///< Scratch: union-find over bodies.
    std::shared_ptr<split::Clique> clique;  ///< Data of predictor clique, see clique.h.
    int interfaces = 0;       ///< Number of pairs of groups with a cut of Coupling::deadline.
    std::uint64_t asked = 0;  ///< Requested interfaces; active if possible. Part of the state.
};

}  // namespace hawser::context
