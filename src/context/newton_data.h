// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file newton_data.h
/// Scratch of the solve for contacts and bounded rows.

#include "nonsmooth/anderson.h"
#include "nonsmooth/box.h"
#include "nonsmooth/cone.h"
#include "nonsmooth/gmres.h"
#include "nonsmooth/resistance.h"

#include <cstdint>
#include <vector>

namespace hawser::stepper {

/// First row of an interaction with a bounded force, see bounds.h.
struct BoundedRow {
    double lambda = 0.0, r = 0.0;
};

/// Scratch of the solve for contacts and bounded rows, see newton.h.
/// Scratch of solve/runs.cpp: a place that a line runs over, and a part between two of them.
struct RunPlace {
    double mass, free, hold, sigma;  ///< m, ẇ without forces, and c and Σ of its friction.
    double before, behind;           ///< Entries of the two parts' rows.
    double low, high, share[2];      ///< Bounds, and of the parts' impulses in them.
    double w0, w1, w2;               ///< w = w0 + w1 λ of the part before + w2 λ of the one behind.
    double speed;                    ///< w.
    std::int32_t side, was;  ///< 0: it holds; else the sign of its force. was: at the solution.
};
struct RunPart {
    std::int32_t id, row;
    double lambda, softness, asked;  ///< (W + Σ) λ + entries × w = asked.
    double diagonal, upper, right;
    bool pulls, was, one_sided;
};

struct Newton {
    std::vector<double> v, lambda;         ///< v₊, λ where an iteration began.
    std::vector<double> contact;           ///< u and λ there, six a contact, then six a resistance.
    std::vector<BoundedRow> row, row_end;  ///< Where an iteration begins, and ends.
    std::vector<std::uint8_t> on_scalar;   ///< 1 a bounded row one of whose bodies is scalar.
    double bound_time = 0.0;               ///< That bounds of forces act for, see bounds.h [s].
    std::vector<std::int32_t> loaded;  ///< Friction whose bound moves with a load, see bounds.h.
    nonsmooth::Anderson follow;        ///< Acceleration of the impulses of `loaded`.
    std::vector<RunPlace> run_places;
    std::vector<RunPart> run_parts;
    std::vector<nonsmooth::Law> laws;             ///< Of each contact, about the iterate.
    std::vector<nonsmooth::ResistanceLaw> turns;  ///< Of each resistance, about the iterate.
    nonsmooth::Gmres gmres;
    std::vector<double> x, u;              ///< Three a contact, then three a resistance.
    std::vector<nonsmooth::Bound> bounds;  ///< Three a contact, of method pivoting.
    std::vector<nonsmooth::Touch> touch;   ///< One a contact, of method split.
    std::vector<double> limit;  ///< Of friction, one a contact, of method pivoting [N s].
    /// See gauss_seidel.h: of bodies; G M⁻¹ Gᵀ of rows, J M⁻¹ Jᵀ of contacts [1/kg].
    std::vector<double> inverse_mass, row_mobility, mobility;
    /// The best iterate so far with the lines as they are, where a later one was worse: v₊, λ, and
    /// u and λ of contacts; its merit, see newton.cpp [J].
    std::vector<double> best_v, best_lambda, best_contact;
    double best = 0.0;
    std::int32_t iterations = 0;
    bool switch_late = false;  ///< Rows that ask to switch do so after the step.
    bool shortened = false;  ///< The last iterate lies within a step: its residuals are not known.
};

}  // namespace hawser::stepper
