// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file capstans.h
/// Lines that run over bollards, pins and sheaves: their friction, with its bound in the matrix.
///
/// At a place that a line turns round by an angle δ, T₁ and T₂ are its tensions before and behind,
/// λ₁, λ₂ = −h T₁, −h T₂ the multipliers of its spans (model/kinds/routes.h), q̇ what runs through
/// and F the friction on it:
/// ```
///     m q̇₊ − m q̇ = h (T₂ − T₁) + h F,   |F| ≤ F₀ + k (T₁ + T₂),   k = tanh(μδ/2)
/// ```
/// While it slides one way, with σ the sign of F, and m next to nothing, T₁ (1 − σk) = T₂ (1 + σk),
/// or T₁/T₂ = e^{σμδ}: Euler's and Eytelwein's ratio exactly, however a circle is divided into
/// places.
///
/// **In the matrix.** As a bound that follows its loads an iteration behind (bounds.h), F makes
/// itself up by a share k, and rows of places by nearly all of themselves. Here F is what it is as
/// a function of λ₁, λ₂: the slide's equation gets −σ k more of each, with no counterpart in the
/// equations of the spans,
/// ```
///            q̇      −λ₁      −λ₂
///     q̇  [   m     1 − σk  −1 − σk ]
///     λ₁ [   1      −Σ₁            ]       k < 1: signs stay as they are.
///     λ₂ [  −1               −Σ₂   ]
/// ```
/// so that fronts above it are factored as L D U (factor/unsymmetric.h). With slides eliminated
/// before the multipliers, which the order does since they have few neighbours, what is left of a
/// run of places is tridiagonal in the tensions, with negative entries beside a positive diagonal
/// and columns that each sum up to W + Σ: an M-matrix, and no pivot turns, whatever slides. In a
/// run between two bodies that pull each other over it a pivot may; it is used as it is, and
/// refinement shows what it cost.
///
/// **Which slide.** By the active set of bounds.h: a place that holds and would have to hold more
/// begins to slide, one that slides the other way begins to hold. In a run one that begins to slide
/// loads the next; runs.h finds all at once.

#include "context/context.h"

namespace hawser::stepper {

/// Of the bound: impulses on a slide below it are rounding. With slides a millionth of what pulls,
/// they are speeds of 1e-11 m/s.
inline constexpr double kCapstanNoise = 1e-14;
/// Of the largest impulse of a run: speeds of its slides are differences of its impulses over next
/// to no mass, and their rounding is passed on from place to place. Below so much a place that
/// slides the wrong way does so by rounding, though its own tensions be small.
inline constexpr double kCapstanRounding = 1e-15;
/// Of the bound: a place that holds does not begin to slide for so much more. Behind places that
/// have slid all are left at their bounds.
inline constexpr double kCapstanAtBound = 1e-10;

/// Which way capstans slide where a step begins, by hold_bounds(): nothing is known from before.
void begin_capstans(Model& model) noexcept;

/// Impulses of sliding capstans without their loads: what a solution from λ = 0 begins with.
void release_capstans(Model& model, const Newton& newton) noexcept;

/// Impulses of sliding capstans by their loads as they are at hand. After each change of λ, before
/// momentum is balanced.
void follow_capstans(Model& model, const Newton& newton, const assembly::View& v) noexcept;

/// What goes into the matrix, by the statuses at hand. @return whether anything does.
[[nodiscard]] bool couple_capstans(Model& model) noexcept;

/// Whether the bound of this friction is in the matrix.
[[nodiscard]] bool is_capstan(const Model& model, std::int32_t friction) noexcept;

}  // namespace hawser::stepper
