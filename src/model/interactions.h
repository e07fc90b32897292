// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file interactions.h
/// Store all interactions: typed pools with the data of evaluate(), and the rows as flat arrays.
///
/// Indices: `id` counts interactions in the order added. Row r of interaction id is entry
/// row_begin[id] + r of the row arrays. Its Jacobian begins at jac_begin[id]. It is dense,
/// row-major and `width` = Σ dof(body) wide, or compact if arms[id] is set (arms.h).

#include <hawser/interactions.h>

#include "base/memory.h"
#include "base/places.h"
#include "model/bodies.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace hawser::model {

/// Interactions of one kind.
struct Pool {
    base::Array<std::int32_t> ids;
    std::size_t stride = 0;       ///< Size of one Data [bytes].
    base::Array<std::byte> data;  ///< Data structs, ids.size() of them.
};

enum RowFlag : std::uint8_t {
    kRowVelocity = 1,  ///< Velocity row: G v = u.
    kRowGap = 2,       ///< Counts in violation_max.
    kRowDamper = 4,    ///< τ is that of a damper, not of the scheme.
    kRowRecoils = 8,   ///< Row of a recoiling wire: its force is that at the end of the step.
    kRowTurns = 16,    ///< g is a difference of two unit vectors.
    kRowJoint = 32,    ///< Row of a joint, without those of `distance` (share_damping.cpp).
    /// Row of a compliant joint that a step may complete, set by the analysis. Its half-step
    /// violation is the mean of the violations at two poses (step/completion.h).
    kRowSecant = 64,
};

enum InteractionFlag : std::uint8_t {
    kOneSided = 1,    ///< Only pulls.
    kRange = 2,       ///< Inactive while inside its range.
    kBreakable = 4,   ///< Has a finite breaking load.
    kFromLength = 8,  ///< Compliance is length/EA and follows the length.
    kByInput = 16,    ///< An input drives one of its parameters.
    kCarried = 32,    ///< Acts on a body with a prescribed velocity.
    kMotor = 64,      ///< Its force has a range.
    kFriction = 128,  ///< Its force has a bound, at which its anchor slides.
};

/// Bound that no force reaches [N].
inline constexpr double kUnbounded = 1e30;

/// Lower limit of Σ, or addend, in divisions: prevents 1/0 and 0/0 [1/kg].
inline constexpr double kTinySigma = 1e-300;

/// Compliance [m/N] above which the elastic energy of a row counts. The violation of a stiffer row
/// is an error from the rotation of its direction within steps.
inline constexpr double kElasticCompliance = 1e-11;
/// True if a row stores elastic energy. A wire element does for any stiffness, because the energy
/// of a wire with heavy bodies is large.
[[nodiscard]] constexpr bool holds_energy(double epsilon, double rest_length) noexcept {
    return epsilon > (rest_length > 0.0 ? 0.0 : kElasticCompliance);
}

/// Return the violation of a row half a step before the poses, extrapolated by its rate of change.
/// A difference of directions is clamped to 2: elements of a folded wire may be far shorter than
/// their motion in a step.
[[nodiscard]] constexpr double half_step_gap(std::uint8_t row_flags, double g, double half,
                                             double speed) noexcept {
    const double back = g - half * speed;
    return row_flags & kRowTurns ? std::clamp(back, -2.0, 2.0) : back;
}

/// Width up to which a range holds its coordinate like a joint [m or rad].
inline constexpr double kNoWidth = 1e-9;

/// Return the distance of a coordinate outside its range [m or rad]: negative below, positive
/// above, 0 inside.
/// @param low, high  Distances from the lower and to the upper end, negative beyond an end.
/// @param shift  Displacement of the coordinate.
[[nodiscard]] constexpr double range_gap(double low, double high, double shift) noexcept {
    const double above = shift - high, below = shift + low;
    return above > 0.0 ? above : below < 0.0 ? below : 0.0;
}

/// Flags of interactions with a bounded force.
inline constexpr int kBounded = kOneSided | kRange | kMotor | kFriction;

/// Contribution to the bound of a row with friction: factor ‖force of the rows‖.
struct Load {
    std::int32_t row_begin = 0, rows = 0;  ///< rows = 0: none.
    double factor = 0.0;
};

/// State of the rows of one interaction at given poses.
struct RowState {
    double g[kMaxInteractionRows];        ///< Violation; for a velocity row its target speed.
    double rate[kMaxInteractionRows];     ///< ġ from moving bodies.
    double carried[kMaxInteractionRows];  ///< ġ from prescribed velocities.
};

/// Shape of a piece of a line.
struct LineShape {
    Vec3 at[2];                    ///< Points where it leaves its holders, world frame [m].
    double wheel[2] = {0.0, 0.0};  ///< Signed wheel radius at each end [m] (kinds/routes.h).
    Vec3 along;                    ///< Unit vector from the first to the second end.
    double longer = 0.0;           ///< Elongation: path minus the present rest length [m].
};

/// Coordinate of a kind that has one (KindInfo::coordinate).
struct Coordinate {
    double value = 0.0;  ///< Value [m or rad].
    double rate = 0.0;   ///< Rate from the velocities of the bodies [m/s or rad/s].
};

struct Interactions {
    /// Slots; a removed interaction leaves one of its kind without bodies and rows.
    base::Slots slots;
    std::vector<InteractionDef> def;  ///< Definitions as added, with defaults filled in.
    std::array<Pool, kInteractionKindCount> pool;
    std::vector<std::int32_t> pool_index;  ///< Index of each interaction in its pool.

    // Arrays by interaction.
    base::Array<InteractionKind> kinds;  ///< Kind of `def`; constant for a slot, also an empty one.
    /// Bodies, kMaxInteractionBodies entries per interaction; −1 behind the last.
    base::Array<std::int32_t> body;
    /// By index in `body`: the next index with the same body, −1: none. Bodies::first_holder has
    /// the first one.
    base::Array<std::int32_t> next_holder;
    base::Array<std::uint8_t> bodies, rows, flags;
    base::Array<std::int32_t> row_begin;
    base::Array<std::int32_t> jac_begin;  ///< Offset in `jacobian`, set by the analysis.
    base::Array<std::uint8_t>
        arms;  ///< 0, kCompactJacobian or kCompactCondensed (arms.h), set by the analysis.
    std::vector<std::int32_t> geo;  ///< Index of the geometric-stiffness record, or −1.
    /// 1: the rows are active. 0: inactive; the first row applies the fixed impulse `held`.
    /// Inactive are slack or broken lines and ranges inside their limits (`held` = 0), and motors
    /// or friction at a bound.
    base::Array<double> active;
    /// Fixed impulse of the first row [N s or N m s]; follows λ, not part of the state.
    base::Array<double> held;
    /// Bounds of the force without loads [N or N m]. A range stores the distances of its coordinate
    /// from the lower and to the upper end at the poses of the last evaluation, negative beyond an
    /// end, kUnbounded without an end [m or rad].
    base::Array<double> low, high;
    /// 1: the row of a range refers to its upper end, 0: to its lower end. Set by evaluation.
    base::Array<std::uint8_t> upper;
    /// Anchor of friction [m or rad], see kinds/friction.h; for spans the packed whole turns
    /// (kinds/routes.h).
    base::Array<double> anchor;
    /// First of kMaxFrictionLoads entries in `loads`, or −1.
    std::vector<std::int32_t> load_begin;
    std::vector<Load> loads;
    base::Array<std::uint8_t> parted;  ///< 1 if the line is broken.
    /// `lightness`: 1/m of the lighter end of a line between points [1/kg]. `flagged`: 1 while its
    /// wire is flagged and damped (solve/wires.h); derived from the state.
    base::Array<double> lightness, flagged;
    // Rigid joints only, see step/completion.h; 0 for all others.
    base::Array<std::uint8_t> coarse;   ///< Number of coming steps with one linearisation.
    base::Array<std::uint8_t> repeats;  ///< 1: in a loop with redundant rows.
    /// Result of the end-of-step iteration in this step, see assembly::Completed.
    base::Array<std::uint8_t> completed;
    /// Constant max |arm|/I; its product with h² and the force is (hω)² of the oscillation about
    /// the joint.
    base::Array<double> vibration;
    base::Array<double> power;        ///< Largest driving power of a motor [W]; kUnbounded: none.
    base::Array<double> breaking;     ///< Breaking load [N], if kBreakable is set.
    base::Array<double> rest_length;  ///< Rest length l₀ of wire elements [m], 0 for others.
    /// Radius of elements that drums pay out, as added and independent of the present layer [m].
    /// Analyses use this value, so that they do not depend on their time.
    base::Array<double> defined_radius;
    /// A sixth of the mass of wire elements that move as straight pieces (assembly/geo.h) [kg].
    base::Array<double> pair_mass;
    /// Interactions through which work enters, ascending: motors, those driven by an input, those
    /// on a body with a prescribed velocity.
    std::vector<std::int32_t> working;
    std::vector<std::int32_t> motors;     ///< Interactions with a force range, ascending.
    std::vector<std::int32_t> frictions;  ///< Interactions with friction, ascending.
    /// Winch stretches whose compliance follows the length, ascending.
    std::vector<std::int32_t> winches;
    std::vector<std::int32_t> spans;      ///< Interactions that lie on a wheel, ascending.
    std::vector<std::uint8_t> saturated;  ///< By motor: 1 if its force is at an end of its range.

    // Arrays by row.
    base::Array<double> defined;  ///< ε as defined, independent of the present length of a line.
    base::Array<double> epsilon, tau;  ///< ε and τ; for velocity rows γ and unused.
    /// Mobility W = G M⁻¹ Gᵀ of dampers and compliant joints at the last analysis, or 0.
    base::Array<double> mobility;
    base::Array<double> upsilon;  ///< Υ, see hawser/row_constants.h; 0 for velocity rows.
    /// Factor 1 − 4τ(1 − θ)/h of ġ in c/Υ. For τ of the scheme: θ = 1.
    base::Array<double> recall;
    base::Array<double> sigma;  ///< Σ, at least sigma_without_floor() and min_sigma.
    /// Lower bound of Σ of a cut row, see soften_sides(); else 0.
    base::Array<double> min_sigma;
    base::Array<double> inv_sigma;       ///< 1/Σ if condensed, else 0.
    base::Array<double> g, c, residual;  ///< Violation, right-hand side, residual c − G v − Σλ.
    base::Array<double> lambda;          ///< Impulse λ [N s or N m s].
    base::Array<double> multiplier;      ///< Scratch of the solve: λ + Σ⁻¹ residual.
    base::Array<double> force;           ///< Force λ/h of the last step, for readers.
    base::Array<std::uint8_t> row_flags;

    base::Array<double> jacobian;
    std::int32_t row_count = 0, geo_count = 0;

    [[nodiscard]] int count() const noexcept { return static_cast<int>(def.size()); }
    [[nodiscard]] InteractionId id(int index) const noexcept {
        return slots.id<InteractionId>(index);
    }
    /// True if a slot is empty.
    [[nodiscard]] bool gone(int id) const noexcept {
        return bodies[static_cast<std::size_t>(id)] == 0;
    }
    /// Reserve memory so that add(), append() and remove() of an interaction of this kind do not
    /// throw, if the definition is an rvalue. @throws std::bad_alloc.
    void reserve_more(InteractionKind kind);
    /// Return the first empty slot of a kind, −1: none.
    [[nodiscard]] int vacant_slot_for(InteractionKind kind) const noexcept {
        return slots.find_vacant(
            [&](std::int32_t p) { return def[static_cast<std::size_t>(p)].kind == kind; });
    }
    /// Add an interaction at the first empty slot of its kind, else at the end. `filled` is checked
    /// and complete. Row constants depend on h. @return its slot.
    int add(InteractionDef filled, Bodies& bodies_in, double h);
    /// Add an interaction at the end.
    int append(InteractionDef filled, Bodies& bodies_in, double h);
    /// Append an empty slot of a kind. The caller marks it as vacant.
    void append_empty(InteractionKind kind);
    /// Set the loads of a friction, which are existing interactions.
    void set_loads(int id, const std::array<FrictionLoad, kMaxFrictionLoads>& loads_in);
    /// Remove an interaction. Its slot keeps no bodies and no rows. If it is a load of a friction,
    /// the friction loses this load.
    void remove(int id, Bodies& bodies_in) noexcept;
    /// Remove all interactions with an index ≥ `kept`. None of them may be a motor, a friction or a
    /// winch stretch.
    void truncate(int kept, Bodies& bodies_in);
    /// Compute Υ and recall of a row after its compliance or mobility changed. Update its Σ
    /// afterwards.
    void split_damping(std::size_t row, bool wire, double h) noexcept;
    /// Return Σ from ε and Υ alone (hawser/row_constants.h), without the lower bounds that an
    /// analysis adds.
    [[nodiscard]] double sigma_without_floor(std::size_t row, double h) const noexcept;
    /// Return the ratio of Σ of a row to its Σ without recoil, which is the ratio of the Υ.
    [[nodiscard]] double recoil_fraction(std::size_t row, bool wire, double h) const noexcept;
    /// Start or end the recoil of the rows of a wire element (split_damping()).
    void recoil(int id, bool recoils, double h) noexcept;
    /// Update Υ, recall, Σ and 1/Σ of a row with a violation. Call if its nonzero compliance has
    /// changed since the analysis. The new Σ is at least `min_sigma`; a row with a node of its own
    /// keeps this node. @param wire True for a wire element.
    void update_damping_of_row(std::size_t row, bool wire, double h) noexcept;
    /// Copy the parameters of interaction `original` to its duplicate `copy`.
    void mirror(int copy, int original, const Bodies& bodies_in, double h) noexcept;
    /// Mark an interaction as driven by an input.
    void mark_driven(int id);
    /// Mark an interaction as not driven by inputs.
    void unmark_driven(int id) noexcept;
    /// Rebuild the pool entry, and a compliance of length/EA, after a parameter changed.
    void refresh(int id, const Bodies& bodies_in, double h) noexcept;
    /// Set the anchor coordinate of a friction or span [m or rad].
    void set_anchor(int id, double coordinate) noexcept;
    /// Replace the body in a slot of an interaction. Properties of the interaction that depend on
    /// the kinds of its bodies must stay valid. The system must be analysed again.
    void rewire(int id, std::size_t slot, BodyId to, Bodies& bodies_in) noexcept;
    /// Call f(id, slot) for all interactions that act on a body, in unspecified order. An
    /// interaction that acts on the body twice occurs twice. f may rewire() the slot.
    template <class F>
    void for_each_holder(int body_in, const Bodies& bodies_in, F&& f) const {
        for (std::int32_t p = bodies_in.first_holder[static_cast<std::size_t>(body_in)]; p >= 0;
             p = next_holder[static_cast<std::size_t>(p)])
            f(p / kSlots, static_cast<std::size_t>(p % kSlots));
    }
    /// Set the mass of a wire element [kg], see pair_mass; does nothing if its kind has no mass.
    void set_mass(int id, double mass) noexcept;
    /// Return the unstretched length of an element at a drum or slide [m]. It follows from the
    /// coordinate of the drum or slide, and may be negative for a span.
    [[nodiscard]] double length_at_drum_or_slide(int id, const Bodies& bodies_in) const noexcept;
    /// Set the compliance and length of a wire element at a drum to its present rest length.
    void update_length_at_drum(int id, const Bodies& bodies_in, double h) noexcept;
    /// Evaluate the rows of an interaction.
    /// @param v  Packed velocities; null: those of the bodies.
    [[nodiscard]] RowState row_state(int id, const Bodies& bodies_in,
                                     const double* v = nullptr) const noexcept;
    /// True if the rows of an interaction have the flag kRowSecant.
    [[nodiscard]] bool uses_secants(int id) const noexcept {
        const auto i = static_cast<std::size_t>(id);
        return rows[i] > 0 && (row_flags[static_cast<std::size_t>(row_begin[i])] & kRowSecant) != 0;
    }
    /// Compute d₋ = (g − g(x ⊖ h v))/h of the rows at the present poses, from the velocities of the
    /// last step. @param out  kMaxInteractionRows values [m/s or rad/s].
    void secants_before(int id, const Bodies& bodies_in, double h, double* out) const noexcept;
    /// Compute d₊ = (g(x ⊕ h v) − g)/h of the rows. @param v  Packed velocities.
    void secants_after(int id, const Bodies& bodies_in, const double* v, double h,
                       double* out) const noexcept;
    /// Return the shape of an element, or of a part of a line that runs over turning points
    /// (KindTrait kPulls).
    [[nodiscard]] LineShape line_shape(int id, const Bodies& bodies_in) const noexcept;
    /// Return the angle between the mark and the tangent point of the wheel at each end, modulo
    /// whole turns [rad].
    [[nodiscard]] std::array<double, 2> wheel_angles(int id,
                                                     const Bodies& bodies_in) const noexcept;
    /// Return the angles of wheel_angles() including whole turns [rad].
    [[nodiscard]] std::array<double, 2> wrapped(int id, const Bodies& bodies_in) const noexcept;
    /// Update the number of whole turns in the angles of wheel_angles(). @param before  Angles
    /// before bodies moved or were replaced, by less than half a turn.
    void update_whole_turns(int id, const std::array<double, 2>& before,
                            const Bodies& bodies_in) noexcept;
    /// Return the coordinate of the hinge, slider or scalar body that the interaction holds,
    /// limits, drives or brakes; zeros if its kind has none.
    [[nodiscard]] Coordinate coordinate(int id, const Bodies& bodies_in) const noexcept;
    /// Add Gᵀλ on the body of one slot, force then torque, to `out` (6 entries).
    void add_impulse(int id, int slot, const Bodies& bodies_in, const double* impulse,
                     double* out) const noexcept;
    /// Return the elastic energy at the half-step position [J].
    [[nodiscard]] double elastic(int id, const Bodies& bodies_in, double h) const noexcept;
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    static constexpr auto kSlots = static_cast<std::int32_t>(kMaxInteractionBodies);
    void grow(InteractionKind kind);
    /// Insert the entry `place` of the body table into the list of interactions that act on its
    /// body, or remove it.
    void link(std::size_t place, Bodies& bodies_in) noexcept;
    void unlink(std::size_t place, Bodies& bodies_in) noexcept;
    /// Write all data of an interaction to an existing slot.
    void write(int id, InteractionDef filled, Bodies& bodies_in, double h);
    void write_rows(int id, const Bodies& bodies_in, double h);
    void enlist(int id, const Bodies& bodies_in);
    void write_data(int id) noexcept;
    /// Evaluate the rows at the present poses and call f<K>(rows), where K is the kind.
    template <class F>
    void evaluated(int id, const Bodies& bodies_in, F&& f) const noexcept;
    /// Write the violations at the poses after `time` [s] with packed velocities v, and v_fixed for
    /// bodies with a prescribed velocity.
    void moved_gaps(int id, const Bodies& bodies_in, const double* v, const double* v_fixed,
                    double time, double* gaps) const noexcept;
    void write_loads(int id);
    void set_range(int id) noexcept;
};

/// True if a step may solve the rows of an interaction at its end (step/completion.h). It is a
/// joint or rod that no input moves. Each of its rows is rigid, or has a vibration or damper that
/// the step does not resolve at the poses of the last analysis.
[[nodiscard]] bool may_complete(const Interactions& in, int id, double h) noexcept;

/// True if a kind allows end-of-step constraint iterations.
[[nodiscard]] bool kind_completes(InteractionKind kind) noexcept;
/// True if the kind and the inputs of an interaction allow end-of-step constraint iterations, for
/// any compliance of its rows.
[[nodiscard]] bool may_ever_complete(const Interactions& in, int id) noexcept;
/// True if a row of the interaction has a compliance above 0.
[[nodiscard]] bool is_compliant(const Interactions& in, int id) noexcept;

/// Set the defaults that a kind derives from the initial poses.
void complete(InteractionDef& def, const Vec3* positions, double distance);

}  // namespace hawser::model
