// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file cuts_data.h
/// Images, copies and cuts (cuts.h).

#include <hawser/def.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace hawser::stepper {

struct Clique;

/// A body as other sides see it. `body` is the image, `of` the body.
struct Image {
    std::int32_t body, of;
};

/// Rows at the body of an image: slot `slot` of interaction `id`.
struct Pull {
    std::int32_t image, id, slot;  ///< `image`: index in Cuts::images.
};

/// A cut interaction, whose copies are the interactions [first, first + sides).
struct Cut {
    std::int32_t id, first, sides;
    bool open;              ///< In force, see open_cuts().
    int interface = 0;      ///< Which bit of Degradation::cuts asks for it.
    double defect = 0.0;    ///< ‖Σ of the impulses on its bodies‖ in the last step [N s].
    double residual = 0.0;  ///< max |G v₊ + Σλ − c| there, λ the mean [m/s or rad/s].
};

struct Cuts {
    std::vector<std::int32_t> group;              ///< By body of the user: its part.
    std::vector<Coupling> coupling;               ///< By interaction of the user.
    std::int32_t bodies = -1, interactions = -1;  ///< Of the user; −1: there are no cuts.
    bool grouped = false;                         ///< Bodies of more than one group.
    std::vector<Cut> list;                        ///< Ascending by id.
    std::vector<Image> images;                    ///< Ascending by body.
    std::vector<Pull> pulls;                      ///< Ascending by image; of predictor forces.
    std::vector<std::int32_t> of;                 ///< By copy: the interaction that it stands for.
    std::vector<double> touch;       ///< Packed like v: Jᵀλ of contacts in the last step [N s].
    std::vector<std::int32_t> part;  ///< Scratch: union-find over bodies.
    std::shared_ptr<Clique> clique;  ///< Of predictor clique, see clique.h.
    int interfaces = 0;              ///< Pairs of groups with a cut of Coupling::deadline.
    std::uint64_t asked = 0;         ///< Of these, in force if they can be. Part of the state.
};

}  // namespace hawser::stepper
