// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file newton_data.h
/// Scratch of the solve for contacts and bounded rows.

#include "nonsmooth/anderson.h"
#include "nonsmooth/block_chain.h"
#include "nonsmooth/box.h"
#include "nonsmooth/cone.h"
#include "nonsmooth/gmres.h"
#include "nonsmooth/resistance.h"
#include "nonsmooth/tridiagonal.h"

#include <array>
#include <cstdint>
#include <vector>

namespace hawser::context {

/// Fraction θ of the mobility W in ρ of contacts and rows during the convex phase of iterations
/// (contact/convex_phase.h).
inline constexpr double kConvexFraction = 0.1;

/// First row of an interaction with a bounded force, see bounds.h.
struct BoundedRow {
    double lambda = 0.0, r = 0.0;
};

/// Scratch of the solve for contacts and bounded rows, see newton.h.
/// Scratch of solve/runs.cpp: a place that a line runs over, and a part between two of them.
struct RunPoint {
    double mass, free, hold, sigma;  ///< m, ẇ without forces, and c and Σ of its friction.
    double before, behind;           ///< Entries of the two parts' rows.
    double low, high, fraction[2];   ///< Bounds, and weights of the parts' impulses in them.
    double w0, w1, w2;               ///< w = w0 + w1 λ of the part before + w2 λ of the one behind.
    double speed;                    ///< w.
    std::int32_t side, was;  ///< 0: holds; otherwise the sign of its force. was: in the solution.
};
struct RunPart {
    std::int32_t id, row;
    double lambda, softness, asked;  ///< (W + Σ) λ + entries × w = asked.
    double diagonal, upper, right;
    bool pulls, was, one_sided;
};

/// Pulling elements at one node, as indices in System::bounded.
struct NodeElements {
    std::int32_t count = 0;                       ///< Elements.
    std::int32_t attached = 0;                    ///< Interactions of all kinds.
    std::array<std::int32_t, 2> element{-1, -1};  ///< The first two.
};

/// Chains of elements between nodes, and scratch of solve/wire_bounds.cpp.
struct WireChains {
    std::vector<std::int32_t> begin;    ///< By chain: offset in `element`; and the end.
    std::vector<std::int32_t> element;  ///< Indices in System::bounded, chain by chain.
    /// By entry of `element`: node shared with the next; −1: none.
    std::vector<std::int32_t> lump;
    /// By body: chain and index of a node that only elements of one chain hold, else −1. Node i of
    /// a chain is at the first end of its element i, the last one at the second end.
    std::vector<std::int32_t> chain_of, node_of;
    std::vector<nonsmooth::ChainRow> rows;     ///< Rows of the chain being solved.
    std::vector<std::array<double, 9>> block;  ///< By body: stiffness of its contacts [kg].
    std::vector<NodeElements> lumps;           ///< By body, during the search for chains.
    std::vector<std::uint8_t> listed;          ///< By bounded row, while chains are found.
};

/// Scratch of contact/wire_newton.cpp: an element, and a contact, of the wire being settled.
struct WireElement {
    std::int32_t id, index;  ///< Interaction, and its index in System::bounded.
    double g[2][3];          ///< Columns of its row at its two nodes; 0 if fixed.
    double sigma, mobility;
    BoundedRow from, to;
    bool active;
};
struct WireContact {
    std::int32_t contact;
    std::int32_t node[4];  ///< By slot: node of the wire, −1: fixed.
    nonsmooth::Cone cone;  ///< At the end of an iteration.
    double from[6];        ///< u and λ at the start of the iteration.
    nonsmooth::Law law;
    std::uint8_t changes;
};
struct WireNewton {
    std::vector<nonsmooth::ChainBlock> stiffness, matrix;  ///< By node.
    std::vector<WireElement> elements;
    std::vector<WireContact> contacts;
    std::vector<std::int32_t> begin;    ///< By chain: offset in `contact`; and the end.
    std::vector<std::int32_t> contact;  ///< Contacts, chain by chain.
    std::int32_t nodes = 0;             ///< Number of nodes of the current wire.
    bool convex = false;
};

struct Newton {
    std::vector<double> v, lambda;         ///< v₊, λ at the start of an iteration.
    std::vector<double> contact;           ///< u and λ there, six a contact, then six a resistance.
    std::vector<BoundedRow> row, row_end;  ///< Start and end of an iteration.
    std::vector<std::uint8_t> on_scalar;   ///< 1: a bounded row with a scalar body.
    double bound_time = 0.0;           ///< Time for which bounds of forces act, see bounds.h [s].
    std::vector<std::int32_t> loaded;  ///< Friction whose bound moves with a load, see bounds.h.
    nonsmooth::Anderson follow;        ///< Acceleration of the impulses of `loaded`.
    std::vector<RunPoint> run_points;
    std::vector<RunPart> run_parts;
    WireChains chains;
    WireNewton wire;
    std::vector<nonsmooth::Law> laws;   ///< Law of each contact about the iterate.
    std::vector<std::uint8_t> changes;  ///< By contact: changes of state in these iterations.
    /// Iterations are in their convex phase (contact/convex_phase.h).
    bool convex = false;
    std::vector<nonsmooth::ResistanceLaw> turns;  ///< Law of each resistance about the iterate.
    nonsmooth::Gmres gmres;
    std::vector<double> x, u;              ///< Three a contact, then three a resistance.
    std::vector<nonsmooth::Bound> bounds;  ///< Three a contact, of method pivoting.
    std::vector<nonsmooth::Touch> touch;   ///< One a contact, of method split.
    std::vector<double> limit;  ///< Limit of friction, one per contact, of method pivoting [N s].
    /// See gauss_seidel.h: inverse masses of bodies; G M⁻¹ Gᵀ of rows, J M⁻¹ Jᵀ of contacts [1/kg].
    std::vector<double> inverse_mass, row_mobility, mobility;
    /// The best iterate with the present statuses of lines, if a later one was worse: v₊, λ, and u
    /// and λ of contacts; its merit, see newton.cpp [J].
    std::vector<double> best_v, best_lambda, best_contact;
    double best = 0.0;
    std::int32_t iterations = 0;
    bool switch_after_step = false;  ///< True if requesting rows switch after the step.
    /// True if the last iterate is a part of a step, with unknown residuals.
    bool shortened = false;
};

}  // namespace hawser::context
