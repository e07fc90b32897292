// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file cuts.h
/// Splits: interactions between parts that each part solves for on its own.
///
/// A cut interaction is left out of the system. In its place stand *copies*, one for each side: the
/// same rows, in which the bodies of the other sides are *images*, bodies without freedom that are
/// where those bodies are and move at a velocity v̄ that a predictor gives.
/// ```
///    a ── b ══ c ── d          a ── b ══ c̄      b̄ ══ c ── d
///       cut: ══                one island        another one
/// ```
/// So a matrix of independent parts comes about without code of its own in the analysis, the
/// factorisation, the friction solver or the schedule. After the solve a cut has as many
/// multipliers as sides; readers see their mean. docs/methods.md, 10 has the theory.
///
/// Images and copies stand behind all other bodies and interactions: the model of the user is the
/// front of the arrays.

#include <hawser/def.h>
#include <hawser/stats.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace hawser::stepper {

struct StepContext;
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

/// Bodies and interactions without images and copies.
[[nodiscard]] std::int32_t body_count(const StepContext& ctx) noexcept;
[[nodiscard]] std::int32_t interaction_count(const StepContext& ctx) noexcept;
/// Rows without those of copies; those of empty places count.
[[nodiscard]] std::int32_t user_rows(const StepContext& ctx) noexcept;
/// The interaction that reports events of this one: itself; of the first copy its original, of the
/// others none (−1).
[[nodiscard]] std::int32_t speaker(const StepContext& ctx, std::int32_t id) noexcept;
/// The interaction that a copy stands for; else itself.
[[nodiscard]] std::int32_t original(const StepContext& ctx, std::int32_t id) noexcept;
/// Whether an interaction is one that can be cut: no drive, friction, range or winch, nor what
/// loads friction.
[[nodiscard]] bool can_cut(const StepContext& ctx, std::int32_t id) noexcept;

/// Whether there are images and copies, or would be after prepare().
[[nodiscard]] bool may_have_cuts(const StepContext& ctx) noexcept;

/// Images and copies for the groups and couplings there are. @throws std::bad_alloc.
void make_cuts(StepContext& ctx);
/// Take them away, as must be done before bodies or interactions are added.
void drop_cuts(StepContext& ctx);
/// Which cuts are in force: those whose sides hold to each other in no other way. Contacts and what
/// cannot be cut make two groups one part. To be called before the system is analysed.
/// @return whether others are than before.
bool open_cuts(StepContext& ctx);

/// Have these interfaces in force, see Degradation::cuts, and analyse if that changes a cut.
[[nodiscard]] Status ask_for_cuts(StepContext& ctx, std::uint64_t interfaces) noexcept;

/// Interfaces with a cut of Coupling::deadline in force.
[[nodiscard]] std::uint64_t open_interfaces(const StepContext& ctx) noexcept;

/// Before rows are assembled: images where their bodies are, at the velocities predicted.
void predict(StepContext& ctx) noexcept;
/// Impulses of contacts in the last step, by body, for predictors.
void keep_touch(StepContext& ctx) noexcept;
/// After the solve, before bodies move: multipliers for readers, and what the cuts left open.
void finish_cuts(StepContext& ctx) noexcept;
/// Multipliers of copies become those of what they stand for.
void follow_cuts(StepContext& ctx) noexcept;
/// Images where their bodies are.
void place_images(StepContext& ctx) noexcept;
/// A line parted; if it is cut, with all copies.
void part_all(StepContext& ctx, std::int32_t id) noexcept;

}  // namespace hawser::stepper
