// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file view.h
/// Raw view of the model and of the arrays of a step, for code compiled per instruction set.
///
/// The step solves eq. (1) of the paper. λ is an impulse; the unknown −λ makes the matrix
/// symmetric.
/// ```
///   [ M̃  Gᵀ ] [ v₊ ]   [ a ]      M̃ = M + h θ D + (h²/4) K_g + h C
///   [ G  −Σ ] [ −λ ] = [ c ]      a = M v + h f + gyro + (h²/4) K_g v − h C v − h (1 − θ) D v
/// ```
/// M mass matrix, D drag, θ by model/damping.h, K_g geometric stiffness, C relative-rotation
/// damping (docs/theory/stiffness.md). The values Σ and c follow from compliance, damping time and
/// violation (SPOOK).

#include <hawser/interactions.h>

#include "model/arms.h"

#include <cstdint>

namespace hawser::assembly {

/// Doubles of the diagonal block of a body: one symmetric 3×3 matrix per three degrees of freedom.
/// The block starts at twice the offset of its first velocity.
inline constexpr int kBodyBlock = 12;
[[nodiscard, gnu::always_inline]] inline constexpr std::int64_t block_offset(
    std::int32_t dof_begin) {
    return std::int64_t{2} * dof_begin;
}
inline constexpr int kGeoSize = 24;       ///< Doubles of one geometric-stiffness record, see geo.h.
inline constexpr int kGeoVibration = 23;  ///< Last entry of a record, which no step writes.
inline constexpr int kGeoLine = 4;        ///< Entries of a record between bodies without arms.

inline constexpr int kLossChunk = 64;  ///< Interactions per call of row_losses().
/// Lower bound of View::recall, below which ġ cannot be derived from c.
inline constexpr double kMinRecall = 1e-2;

/// One contribution to one block of the matrix. For a compact joint (model/arms.h) `width` is 0,
/// the offsets are those of its record, and `condensed` includes the damping.
struct Op {
    enum Kind : std::uint8_t {
        body_block,    ///< M + hD of body `id` on the diagonal.
        condensed,     ///< G_aᵀ Σ⁻¹ G_b of interaction `id` (rows: slot a, columns: slot b).
        geometric,     ///< Geometric stiffness and damping of interaction `id` between slots.
        kept_sigma,    ///< −Σ on the diagonal of a kept interaction.
        kept_rows,     ///< G_b: the interaction is eliminated after body slot b.
        kept_columns,  ///< G_aᵀ: the interaction is eliminated before body slot a.
        contact        ///< Block `id` of contacts; a: 1 if its second body has the rows.
    };
    std::int64_t address;
    std::int32_t step, ld;  ///< Distance of rows and of columns, factor::BlockTarget.
    std::int32_t id;
    std::int32_t jac_a,
        jac_b;  ///< Offsets of the columns of the slots in the first row; offset of a body block.
    Kind kind;
    std::uint8_t a, b;
    std::uint8_t dof_a, dof_b, width;
};

/// Friction of a line at a turning point. The normal force follows from the parts of the line
/// before and behind.
struct Capstan {
    std::int32_t friction;  ///< An interaction of one row, on the slide alone.
    std::int32_t body;      ///< Body of the slide.
    std::int32_t entries;   ///< Number of its entries in System::capstan_entries.
    double side;            ///< Sign of its force while sliding.
    double was;             ///< Sign at the present solution; 0: sticking (solve/runs.h).
};

/// A load of a capstan in the matrix: equation of its slide, impulse of the load.
struct CapstanEntry {
    std::int32_t load;  ///< Interaction that is the load.
    double factor;      ///< Factor of its impulse in the bound.
    double value;       ///< Value added to the entry.
    std::int64_t address;
    std::int32_t column;      ///< Node whose column contains the entry.
    bool upper;               ///< True if the entry is in the upper half, transposed.
    std::uint8_t was_active;  ///< 1 if the load was active at the present solution.
};

/// The same contribution in several lanes of one batch step (factor/batches.h). Entry (i, j) of
/// lane l is at address + i step + 8 j + l. Unused lanes repeat a used one with weight 0.
struct LaneOp {
    std::int64_t address;
    std::int32_t step;
    Op::Kind kind;
    std::uint8_t a, b;
    std::uint8_t dof_a, dof_b, width, rows;
    std::uint8_t used;  ///< One bit per lane.
    /// One bit per lane: slots a and b are exchanged, between compact joints.
    std::uint8_t turned;
    std::int32_t to_b;  ///< Offset from the columns of slot a to those of slot b.
    std::int32_t id[8];
    std::int32_t from[8];  ///< Offsets of the input of op.kind: columns of slot a, record, block.
};

/// One interaction of a body: all data that the gather loops need, without indirection.
struct Incidence {
    /// Offset of the columns of this body in the first row; offset of its arm.
    std::int32_t jacobian;
    std::int32_t row;  ///< First row.
    /// GeoSlot::slot() of this body; −1: none, or not one of the first two bodies.
    std::int32_t geo_force;
    /// Offset of the stiffness of its arm; −1: none (slot 1 has the negative force of slot 0). For
    /// a compact joint: the interaction.
    std::int32_t geo_arm;
    std::uint8_t rows;
    std::uint8_t width;  ///< 0: a compact joint (model/arms.h); `slot` is the slot of this body.
    std::uint8_t slot;
};

/// Location of the geometric terms of one interaction. A slot has 2 `dof` doubles: its parts of M̃
/// v and of a. The velocities v are those of the latest loop over rows with nonzero velocities. If
/// the part of one slot is the negative of the other, only slot 0 is stored. This is the case
/// between bodies without arms, and for compact joints (model/arms.h), which have three torques of
/// each.
struct GeoSlot {
    std::int32_t record = -1;  ///< Offset of the record, kGeoSize or kGeoLine doubles; −1: none.
    std::int32_t force = 0;    ///< Offset of slot 0; slot 1, if any, follows.
    std::int32_t dof =
        6;  ///< 3 between bodies without arms (point masses, scalars), 0 compact, else 6.
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
    /// Packed like v: initial values of the solution for v₊, see model/bodies.h. Null in evaluate()
    /// if the solution starts at 0.
    double* v_start;
    /// Packed like v: expected v₊ = 2 v − v₋ from the velocities of the last two steps, even if no
    /// solution starts there.
    const double* v_ahead;
    const double* v_fixed;
    const double* v_before;  ///< v_fixed at the last half step.
    double* spin_free;       ///< 3 per body: ω₊ without torque, world frame.
    double* spin_change;     ///< 3 per body: ω₊ − spin_free of the last step, body frame.
    double* spin_momentum;   ///< 3 per body: part of `a` from the spin of the body, world frame.
    double* spin_next;       ///< 3 per body: spin_momentum linearised about a later solution.
    /// By body, 1: the equation of its spin is solved at the end of the step, not linearised about
    /// the last step (step/completion.h).
    const std::uint8_t* turning;
    const double* mass;
    const double* inertia;
    const double* inv_inertia;
    const double* principal;
    const double* force;
    /// 6 per body: drag on the velocity after and before the step [N s/m, N m s].
    const double* drag_after;
    const double* drag_before;
    const std::uint8_t* weight;
    double* body_block;  ///< See block_offset().
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
    /// By interaction, 1: all its bodies are point masses, and vector loads stay within the arrays.
    const std::uint8_t* among_nodes;
    const GeoSlot* geo;
    double* active;
    const double* held;  ///< By interaction: impulse of its first row while inactive.
    double* low;         ///< By interaction, see model::Interactions. Evaluation writes ranges.
    double* high;
    std::uint8_t* upper;
    const std::uint8_t* parted;
    /// By interaction between points: 1/m of the lighter end [1/kg]; 1 if its wire gained energy
    /// recently, else 0 (assembly/geo.h).
    const double* lightness;
    const double* flagged;
    const std::uint8_t* completed;  ///< By interaction, see model::Interactions.
    const double* vibration;        ///< By interaction, see model::Interactions.
    const double* rest_length;      ///< l₀ of wire elements [m], 0 for others.
    /// By interaction: one sixth of the mass of an element between point masses that moves as a
    /// straight piece (assembly/geo.h) [kg]; 0 for others and for broken elements. Null: there are
    /// none.
    const double* pair_mass;
    const double* epsilon;
    const double* upsilon;
    const double* recall;
    const double* sigma;
    const double* inv_sigma;
    const std::uint8_t* row_flags;
    double* g;
    double* c;
    double* c_next;  ///< By row: c of completed rows, linearised about a later solution.
    double* rate;    ///< By row: ġ of completed rows at the start of the step.
    double* residual;
    double* lambda;
    double* multiplier;  ///< By row: λ + Σ⁻¹ residual if condensed, 0 if inactive.
    double* force_of_row;
    double* jacobian;
    double* geo_record;  ///< See GeoSlot.
    double* geo_force;   ///< See GeoSlot.

    // Incidence: pairs (interaction, slot) of a body.
    const std::int32_t* incident_begin;
    const Incidence* incident;
    /// By body: number of bodies from it on that are links of one chain, see System.
    const std::uint8_t* links;

    // Contacts, see contact_rows.h; null in a world without shapes.
    const double* contact_block;
    const std::uint8_t* contact_block_used;
    const double* contact_impulse;  ///< Packed like v: Jᵀλ of all contacts.

    /// By body: offset in `coupling` of the lower triangle of a 6×6 block from loads of systems
    /// that couples translations and rotations; −1: none. Null: no body has one.
    const std::int32_t* coupled;
    const double* coupling;

    // Permuted vector of the solver.
    const std::int32_t* body_offset;         ///< By body; −1 without degrees of freedom.
    const std::int32_t* interaction_offset;  ///< By interaction; −1 if condensed.
    double* solution;
};

/// Return μ of an interaction [kg], see View::pair_mass.
[[nodiscard, gnu::always_inline]] inline double pair_mass_of(const View& view,
                                                             std::int32_t id) noexcept {
    return view.pair_mass == nullptr || view.parted[id] != 0 ? 0.0 : view.pair_mass[id];
}

/// Return the packed rows of interaction `id`, in the buffer `buffer` if it is a compact joint.
[[nodiscard, gnu::always_inline]] inline const double* packed_rows(
    const View& view, std::int32_t id, double (&buffer)[model::kArmBufferSize]) noexcept {
    return model::packed_rows(view.jacobian + view.jac_begin[id], view.arms[id] != 0, buffer);
}

/// Add the right-hand side of one row, G v = c, to the solver's vector, without the other rows of
/// its interaction.
/// @param jac  Packed row.
/// @return the next row.
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
    double finite = 0.0;   ///< Sum of all values: not finite if any value is not.
};

/// Energy gains of lines, see solve/wires.h [J].
struct LineGain {
    double gain = 0.0, exchanged = 0.0, noise = 0.0;
    double unbooked = 0.0;  ///< Loss beyond that of row_losses().
};

/// Sums of energies of bodies [J], and the fastest rotation.
struct BodyEnergies {
    double before = 0.0, after = 0.0;  ///< Kinetic energies of two velocities at the present pose.
    /// Potential energy of gravity half a step before, and at the present pose.
    double half_way = 0.0, pose = 0.0;
    double turn = 0.0;  ///< Largest squared angular velocity [rad²/s²].
    std::int32_t turn_body = -1;
};

/// Error of a solution in the equations at the end of the step, see step/completion.h.
struct Turning {
    double change = 0.0;  ///< Largest change of a right-hand side [m/s or rad/s].
    double gap = 0.0;     ///< Largest violation at the end of the step [m or rad].
    double spin = 0.0;    ///< Largest spin of a turning body [rad/s].
    /// Set each value to the larger of both; NaN is kept.
    void add(const Turning& other) noexcept {
        if (!(other.change <= change)) change = other.change;
        if (!(other.gap <= gap)) gap = other.gap;
        if (!(other.spin <= spin)) spin = other.spin;
    }
};

/// Interactions whose rows are solved at the end of a step; 0 for all others (step/completion.h).
/// A compliant joint has a row with a compliance above 0.
enum Completed : std::uint8_t { kRigid = 1, kCompliant = 2 };

}  // namespace hawser::assembly
