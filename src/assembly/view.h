// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file view.h
/// Raw view of the model and of the step's arrays for code compiled per instruction set.
///
/// The step solves (paper, eq. (1); λ an impulse; unknown −λ makes the matrix symmetric)
/// ```
///   [ M̃  Gᵀ ] [ v₊ ]   [ a ]      M̃ = M + h θ D + (h²/4) K_g + h C
///   [ G  −Σ ] [ −λ ] = [ c ]      a = M v + h f + gyro + (h²/4) K_g v − h C v − h (1 − θ) D v
/// ```
/// M mass matrix, D drag, θ by model/damping.h, K_g geometric stiffness, C relative-rotation
/// damping (part 4 of docs/methods.md); Σ, c from compliance, damping time and violation (SPOOK).

#include <hawser/interactions.h>

#include "model/arms.h"

#include <cstdint>

namespace hawser::assembly {

/// Doubles of a body's own block, one symmetric 3×3 for each three of its freedoms, and where it
/// begins: at twice its first velocity.
inline constexpr int kBodyBlock = 12;
[[nodiscard, gnu::always_inline]] inline constexpr std::int64_t block_place(
    std::int32_t dof_begin) {
    return std::int64_t{2} * dof_begin;
}
inline constexpr int kGeoSize = 24;   ///< Doubles of one geometric-stiffness record, see geo.h.
inline constexpr int kGeoSwing = 23;  ///< Its last one, which no step writes.
inline constexpr int kGeoLine = 4;    ///< Of them, those between bodies without arms.

inline constexpr int kLossChunk = 64;  ///< Interactions of one call of row_losses().
/// Of View::recall; below it c does not tell ġ.
inline constexpr double kLeastRecall = 1e-2;

/// One contribution to one block of the matrix. Of a compact joint (model/arms.h) `width` is 0,
/// the offsets are those of its record, and `condensed` has the damping in it.
struct Op {
    enum Kind : std::uint8_t {
        body_block,    ///< M + hD of body `id` on the diagonal.
        condensed,     ///< G_aᵀ Σ⁻¹ G_b of interaction `id` (rows: slot a, columns: slot b).
        geometric,     ///< Geometric stiffness and damping of interaction `id` between slots.
        kept_sigma,    ///< −Σ on the diagonal of a kept interaction.
        kept_rows,     ///< G_b: the interaction is eliminated after body slot b.
        kept_columns,  ///< G_aᵀ: the interaction is eliminated before body slot a.
        contact        ///< Block `id` of contacts; a: 1 where its second body has the rows.
    };
    std::int64_t address;
    std::int32_t step, ld;  ///< Distance of rows and of columns, factor::BlockTarget.
    std::int32_t id;
    std::int32_t jac_a,
        jac_b;  ///< Offsets of the slots' columns in the first row; of a body block.
    Kind kind;
    std::uint8_t a, b;
    std::uint8_t dof_a, dof_b, width;
};

/// Friction of a line on a place that it runs over, and what it presses with: the parts of the line
/// before and behind.
struct Capstan {
    std::int32_t friction;  ///< An interaction of one row, on the slide alone.
    std::int32_t body;      ///< The slide.
    std::int32_t entries;   ///< How many of System::capstan_entries are its own.
    double side;            ///< Sign of its force where that slides.
    double was;             ///< That at the solution at hand, 0: it held (solve/runs.h).
};

/// A load of a capstan in the matrix: the equation of its slide, the impulse of the load.
struct CapstanEntry {
    std::int32_t load;  ///< Interaction.
    double factor;      ///< Of its impulse in the bound.
    double value;       ///< Added to the entry.
    std::int64_t address;
    std::int32_t column;      ///< Node whose column holds it.
    bool upper;               ///< It stands in the upper half, transposed.
    std::uint8_t was_active;  ///< Whether the load acted at the solution at hand.
};

/// The same contribution in several lanes of one batch step (factor/batches.h): entry (i, j) of
/// lane l at address + i step + 8 j + l. Lanes not in use repeat a used one with weight 0.
struct LaneOp {
    std::int64_t address;
    std::int32_t step;
    Op::Kind kind;
    std::uint8_t a, b;
    std::uint8_t dof_a, dof_b, width, rows;
    std::uint8_t used;    ///< One bit a lane.
    std::uint8_t turned;  ///< One bit a lane: slots a and b change places, between compact joints.
    std::int32_t to_b;    ///< From slot a's columns to slot b's.
    std::int32_t id[8];
    std::int32_t from[8];  ///< Offsets of what op.kind reads: slot a's columns, record, block.
};

/// One interaction as a body sees it: all that the gather loops need, without detours.
struct Incidence {
    std::int32_t jacobian;   ///< Offset of this body's columns in the first row; of its arm.
    std::int32_t row;        ///< First row.
    std::int32_t geo_force;  ///< GeoPlace::slot() of this body, −1: none or not one of its two.
    /// Offset of its arm's stiffness, −1: none (slot 1 has the force of slot 0, sign changed). Of a
    /// compact joint: the interaction.
    std::int32_t geo_arm;
    std::uint8_t rows;
    std::uint8_t width;  ///< 0: a compact joint (model/arms.h); `slot` is this body's.
    std::uint8_t slot;
};

/// Where the geometric terms of one interaction are. A slot has 2 `dof` doubles: its part of M̃ v
/// for the velocities of the latest loop over rows that had some, and its part of a. Where one
/// slot's part is the other's with the sign changed, only that of slot 0 is kept: between bodies
/// without arms, and of compact joints (model/arms.h), which have three torques of each.
struct GeoPlace {
    std::int32_t record = -1;  ///< Offset of the record, kGeoSize or kGeoLine doubles; −1: none.
    std::int32_t force = 0;    ///< Offset of slot 0; slot 1, if any, follows.
    std::int32_t dof = 6;  ///< 3 between bodies without arms (lumps, scalars), 0 compact, else 6.
    [[nodiscard]] constexpr std::int32_t slot(int b) const {
        return dof == 6 ? force + 12 * b : force;
    }
};

struct View {
    double h, gravity[3];
    double geometric_stiffness, rotation_damping;
    std::int32_t body_count, interaction_count, dof_count;

    // Bodies, see model/bodies.h.
    const std::uint8_t* kind;
    const std::uint8_t* dof;
    const std::int32_t* dof_begin;
    double* x;
    double* q;
    double* r;
    double* v;
    /// Packed like v: where the solution for v₊ starts, see model/bodies.h. Null for evaluate()
    /// where it starts at 0.
    double* v_start;
    /// Packed like v: v₊ as expected, 2 v − v₋ of the velocities of the last two steps, also where
    /// no solution starts there.
    const double* v_ahead;
    const double* v_fixed;
    const double* v_before;  ///< What v_fixed was at the last half step.
    double* spin_free;       ///< 3 a body: ω₊ without torque, world frame.
    double* spin_change;     ///< 3 a body: ω₊ − spin_free of the last step, body frame.
    double* spin_momentum;   ///< 3 a body: what of `a` comes of the body's spin, world frame.
    double* spin_next;       ///< 3 a body: the same about a later solution.
    /// By body, 1: its spin's equation is solved as it is, not about the last step
    /// (step/completion.h).
    const std::uint8_t* turning;
    const double* mass;
    const double* inertia;
    const double* inv_inertia;
    const double* principal;
    const double* force;
    /// 6 a body: its drag on the velocity after the step, and before it. [N s/m, N m s]
    const double* drag_after;
    const double* drag_before;
    const std::uint8_t* weight;
    double* body_block;  ///< See block_place().
    double* a;           ///< Packed like v: right-hand side of the momentum rows.
    double* v_new;       ///< Packed like v: the solution v₊.
    double* momentum;    ///< Packed like v: a − M̃ v₊ + Gᵀλ at the latest body_norms(), or null.

    // Interactions, see model/interactions.h.
    const std::int32_t* body;
    const std::uint8_t* bodies;
    const std::uint8_t* rows;
    const std::uint8_t* flags;
    const std::int32_t* row_begin;
    const std::int32_t* jac_begin;
    const std::uint8_t* arms;  ///< model::Interactions::arms.
    /// By interaction, 1: all its bodies are lumps, none so near the end that vector loads leave
    /// the arrays.
    const std::uint8_t* among_lumps;
    const GeoPlace* geo;
    double* active;
    const double* held;  ///< By interaction: impulse of its first row while idle.
    const std::uint8_t* parted;
    /// By interaction between points: 1/m of the lighter end [1/kg], and 1 where its wire gained
    /// energy lately, else 0 (assembly/geo.h).
    const double* lightness;
    const double* alert;
    const std::uint8_t* completed;  ///< By interaction, see model::Interactions.
    const double* swing;            ///< By interaction, see model::Interactions.
    const double* rest_length;      ///< l₀ of wire elements [m], 0 for all else.
    /// By interaction: a sixth of the mass of an element between lumps that moves as a straight
    /// piece (assembly/geo.h), else 0 [kg]; once it has parted it is none. Null: there is none.
    const double* pair_mass;
    const double* epsilon;
    const double* upsilon;
    const double* recall;
    const double* sigma;
    const double* inv_sigma;
    const std::uint8_t* row_flags;
    double* g;
    double* c;
    double* c_next;  ///< By row: c about a later solution, of completed ones.
    double* rate;    ///< By row: ġ at the step's start, of completed ones.
    double* residual;
    double* lambda;
    double* multiplier;  ///< By row: λ + Σ⁻¹ residual where condensed, 0 where idle.
    double* force_of_row;
    double* jacobian;
    double* geo_record;  ///< See GeoPlace.
    double* geo_force;   ///< See GeoPlace.

    // Incidence: which (interaction, slot) pairs touch a body.
    const std::int32_t* incident_begin;
    const Incidence* incident;
    const std::uint8_t* links;  ///< By body: so many from it on are links of one chain, see System.

    // Contacts, see contact_rows.h; null in a world without shapes.
    const double* contact_block;
    const std::uint8_t* contact_block_used;
    const double* contact_impulse;  ///< Packed like v: Jᵀλ of all contacts.

    /// By body, place in `coupling` of the lower triangle of a 6×6 block that loads of systems put
    /// on it and that couples translations and rotations; −1: none. Null: no body has one.
    const std::int32_t* coupled;
    const double* coupling;

    // The permuted vector of the solver.
    const std::int32_t* body_offset;         ///< By body; −1 without freedom.
    const std::int32_t* interaction_offset;  ///< By interaction; −1 when condensed.
    double* solution;
};

/// μ of an interaction [kg], see View::pair_mass.
[[nodiscard, gnu::always_inline]] inline double pair_mass_of(const View& view,
                                                             std::int32_t id) noexcept {
    return view.pair_mass == nullptr || view.parted[id] != 0 ? 0.0 : view.pair_mass[id];
}

/// The rows of interaction `id`, packed, in `room` if it is a compact joint.
[[nodiscard, gnu::always_inline]] inline const double* packed_rows(
    const View& view, std::int32_t id, double (&room)[model::kArmRoom]) noexcept {
    return model::packed_rows(view.jacobian + view.jac_begin[id], view.arms[id] != 0, room);
}

/// Add a row G v = c, and nothing else of its interaction, to the right-hand side in the solver's
/// vector. @param jac  The packed row. @return the next one.
inline const double* ask_of_row(const View& v, std::int32_t id, int row, const double* jac,
                                double c) noexcept {
    const std::int32_t kept = v.interaction_offset[id];
    if (kept >= 0) v.solution[kept + row] = c;
    const double push = kept >= 0 ? 0.0 : c * v.inv_sigma[v.row_begin[id] + row];
    for (int b = 0; b < v.bodies[id]; ++b) {
        const std::int32_t body = v.body[kMaxInteractionBodies * id + b];
        for (int j = 0; j < v.dof[body]; ++j) v.solution[v.body_offset[body] + j] += push * *jac++;
    }
    return jac;
}

/// Norms that the step reports; merged in index order.
struct Norms {
    double momentum = 0.0;    ///< Σ rᵀM⁻¹r.
    double impulse = 0.0;     ///< Σ (a − M v)ᵀM⁻¹(a − M v).
    double constraint = 0.0;  ///< max |residual|.
    double gap = 0.0;         ///< max |g| of translational constraint rows [m].
    std::int32_t gap_id = -1;
    double stretch = 0.0;  ///< max |g + ε f| / length over wire elements.
    double work = 0.0;     ///< h f·(v + v₊)/2 of applied forces and torques [J].
    double drag = 0.0;     ///< h (θ v₊ + (1 − θ) v)ᵀ D (v + v₊)/2 [J].
    double finite = 0.0;   ///< Sum of everything: not finite if anything is not.
};

/// See solve/wires.h [J].
struct LineGain {
    double gain = 0.0, exchanged = 0.0, noise = 0.0;
    double unbooked = 0.0;  ///< Lost beyond what row_losses() counts.
};

/// Energies of bodies, added up [J], and which of them turns fastest.
struct BodyEnergies {
    double before = 0.0, after = 0.0;   ///< Kinetic, at the present pose, of two velocities.
    double half_way = 0.0, pose = 0.0;  ///< Of gravity, half a step back and at the pose.
    double turn = 0.0;                  ///< Largest square of an angular velocity [rad²/s²].
    std::int32_t turn_body = -1;
};

/// How far a solution is from the equations at the step's end, see step/completion.h.
struct Turning {
    double change = 0.0;  ///< Largest change of a right-hand side [m/s or rad/s].
    double gap = 0.0;     ///< Largest violation at the end of the step [m or rad].
    double spin = 0.0;    ///< Largest spin of a turning body [rad/s].
    /// Larger of both; what is not a number stays.
    void add(const Turning& other) noexcept {
        if (!(other.change <= change)) change = other.change;
        if (!(other.gap <= gap)) gap = other.gap;
        if (!(other.spin <= spin)) spin = other.spin;
    }
};

/// Interactions whose rows a step solves at its end, beside 0: all others (step/completion.h).
enum Completed : std::uint8_t { kRigid = 1, kStiffDamper = 2 };

}  // namespace hawser::assembly
