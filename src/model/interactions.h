// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file interactions.h
/// All interactions: typed pools of what evaluate() needs, and the rows as flat arrays.
///
/// Indices: `id` counts interactions in the order added. Row r of interaction id is entry
/// row_begin[id] + r of the row arrays. Its Jacobian begins at jac_begin[id]: dense, row-major,
/// `width` = Σ dof(body) wide, or compact where arms[id] (arms.h).

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
    std::size_t stride = 0;       ///< Bytes of one Data.
    base::Array<std::byte> data;  ///< ids.size() Data structs.
};

enum RowFlag : std::uint8_t {
    kRowVelocity = 1,  ///< G v = u.
    kRowGap = 2,       ///< Counts in violation_max.
    kRowDamper = 4,    ///< Its τ is that of a damper, not of the scheme.
    kRowRecoils = 8,   ///< Of a wire that parted: its force is that at the end of the step.
    kRowTurns = 16,    ///< g is a difference of two unit vectors.
};

enum InteractionFlag : std::uint8_t {
    kOneSided = 1,    ///< Only pulls.
    kRange = 2,       ///< Idle while inside its range.
    kBreakable = 4,   ///< Has a finite breaking load.
    kFromLength = 8,  ///< Its compliance is length/EA and follows the length.
    kByInput = 16,    ///< An input drives one of its parameters.
    kCarried = 32,    ///< Touches a body with a prescribed velocity.
    kMotor = 64,      ///< Its force has a range.
    kFriction = 128,  ///< Its force has a bound, and its anchor gives way there.
};

/// No bound: far beyond any force [N].
inline constexpr double kUnbounded = 1e30;

/// Σ at least, or added to it, where it is divided by: what is not to be 1/0 or 0/0 [1/kg].
inline constexpr double kTinySigma = 1e-300;

/// Rows softer than this [m/N] store energy worth counting. What a stiffer one is off by is what
/// steps leave of the turning of its direction.
inline constexpr double kElasticCompliance = 1e-11;
/// A wire element stores energy however stiff it is: of heavy bodies' wires that is much.
[[nodiscard]] constexpr bool holds_energy(double epsilon, double rest_length) noexcept {
    return epsilon > (rest_length > 0.0 ? 0.0 : kElasticCompliance);
}

/// Violation of a row at the half step before the poses, by its speed. A difference of directions
/// stays within 2: a wire that lies folded bends by elements far shorter than they move in a step.
[[nodiscard]] constexpr double half_step_gap(std::uint8_t row_flags, double g, double half,
                                             double speed) noexcept {
    const double back = g - half * speed;
    return row_flags & kRowTurns ? std::clamp(back, -2.0, 2.0) : back;
}

/// Flags of interactions whose force is bounded.
inline constexpr int kBounded = kOneSided | kRange | kMotor | kFriction;

/// What adds to the bound of a row with friction: factor ‖force of the rows‖.
struct Load {
    std::int32_t row_begin = 0, rows = 0;  ///< rows = 0: nothing.
    double factor = 0.0;
};

/// Rows of one interaction at given poses.
struct RowState {
    double g[kMaxInteractionRows];        ///< Violation; wanted speed of a velocity row.
    double rate[kMaxInteractionRows];     ///< ġ from bodies that move.
    double carried[kMaxInteractionRows];  ///< ġ from prescribed velocities.
};

/// A piece of a line as it lies.
struct LineShape {
    Vec3 at[2];                    ///< Where it leaves what holds it, world frame [m].
    double wheel[2] = {0.0, 0.0};  ///< Signed radius at each end [m] (kinds/routes.h).
    Vec3 along;                    ///< Unit vector from the first to the second.
    double longer = 0.0;           ///< Path less the length at rest of now [m].
};

/// Coordinate of a kind that has one (KindInfo::coordinate).
struct Coordinate {
    double value = 0.0;  ///< [m or rad].
    double rate = 0.0;   ///< By the velocities of the bodies [m/s or rad/s].
};

struct Interactions {
    /// Where one was removed, one of its kind without bodies and rows is left.
    base::Places places;
    std::vector<InteractionDef> def;  ///< As added, defaults filled in.
    std::array<Pool, kInteractionKindCount> pool;
    std::vector<std::int32_t> pool_index;  ///< Of each id in its pool.

    // By interaction.
    base::Array<InteractionKind> kinds;  ///< That of `def`, or of what was there; stays.
    base::Array<std::int32_t> body;      ///< kMaxInteractionBodies an id; −1 behind the last.
    /// By place in `body`: the next place that has the same body, −1: none. Bodies::first_holder
    /// has the first one.
    base::Array<std::int32_t> next_holder;
    base::Array<std::uint8_t> bodies, rows, flags;
    base::Array<std::int32_t> row_begin;
    base::Array<std::int32_t> jac_begin;  ///< Set by the analysis.
    base::Array<std::uint8_t>
        arms;  ///< Set by it: 0, kCompactJacobian or kCompactCondensed, arms.h.
    std::vector<std::int32_t> geo;  ///< Index of the geometric-stiffness record, or −1.
    /// 1; or 0: its rows ask for nothing, and the first has the impulse `held`: slack, inside its
    /// range or parted (0), or a motor or friction at a bound.
    base::Array<double> active;
    base::Array<double> held;       ///< [N s or N m s]; follows λ, not part of the state.
    base::Array<double> low, high;  ///< Bounds of the force, loads apart [N or N m].
    /// Of friction, see kinds/friction.h [m or rad]; of spans, whole turns (kinds/routes.h).
    base::Array<double> anchor;
    std::vector<std::int32_t> load_begin;  ///< First of kMaxFrictionLoads in `loads`, or −1.
    std::vector<Load> loads;
    base::Array<std::uint8_t> parted;  ///< 1 once a line has parted.
    /// Of lines between points: 1/m of the lighter end [1/kg]; 1 while their wire is stepped more
    /// calmly (solve/wires.h), follows the state.
    base::Array<double> lightness, alert;
    // Of rigid joints, see step/completion.h; 0 of all else.
    base::Array<std::uint8_t> coarse;     ///< Steps to come in which its rows are linearised once.
    base::Array<std::uint8_t> repeats;    ///< 1: in a loop in which rows repeat each other.
    base::Array<std::uint8_t> completed;  ///< By this step, see assembly::Completed.
    base::Array<double> swing;     ///< max |arm|/I, constant: h² times force times this is (hω)².
    base::Array<double> power;     ///< Largest driving power [W] of a motor; kUnbounded: none.
    base::Array<double> breaking;  ///< Load at which it parts [N], of what is kBreakable.
    base::Array<double> rest_length;  ///< l₀ of wire elements [m], 0 for all else.
    /// Of elements that drums pay out as they were added, whatever layer there is by now [m]:
    /// analyses see this one, so that they do not depend on when they are made.
    base::Array<double> defined_radius;
    /// A sixth of the mass of wire elements that move as straight pieces (assembly/geo.h) [kg].
    base::Array<double> pair_mass;
    std::vector<std::int32_t> working;    ///< Those through which work enters: motors, driven by an
                                          ///< input, touching a prescribed velocity. Ascending.
    std::vector<std::int32_t> motors;     ///< Those with a force range, ascending.
    std::vector<std::int32_t> frictions;  ///< Those with friction, ascending.
    std::vector<std::int32_t> winches;    ///< Winch stretches whose compliance follows the length.
    std::vector<std::int32_t> spans;      ///< Those that lie on a wheel, ascending.
    std::vector<std::uint8_t> saturated;  ///< 1 a motor: its force is at an end of its range.

    // By row.
    base::Array<double> defined;         ///< ε as defined, whatever length a line has by now.
    base::Array<double> epsilon, tau;    ///< ε, τ (γ, – for velocity rows).
    base::Array<double> mobility;        ///< W = G M⁻¹ Gᵀ of dampers at the last analysis, or 0.
    base::Array<double> upsilon;         ///< Υ, hawser/row_constants.h; 0 for velocity rows.
    base::Array<double> recall;          ///< 1 − 4τ(1 − θ)/h: share of ġ in c/Υ. Scheme's τ: θ = 1.
    base::Array<double> sigma;           ///< Σ, at least bare_sigma() and least_sigma.
    base::Array<double> least_sigma;     ///< What a cut row needs, soften_sides(); else 0.
    base::Array<double> inv_sigma;       ///< 1/Σ where condensed, else 0.
    base::Array<double> g, c, residual;  ///< Violation, right-hand side, c − G v − Σλ.
    base::Array<double> lambda;          ///< Impulse [N s or N m s].
    base::Array<double> multiplier;      ///< Scratch of the solve: λ + Σ⁻¹ residual.
    base::Array<double> force;           ///< λ/h of the last step, for readers.
    base::Array<std::uint8_t> row_flags;

    base::Array<double> jacobian;
    std::int32_t row_count = 0, geo_count = 0;

    [[nodiscard]] int count() const noexcept { return static_cast<int>(def.size()); }
    [[nodiscard]] InteractionId id(int index) const noexcept {
        return places.id<InteractionId>(index);
    }
    /// Whether nothing is at a place any more.
    [[nodiscard]] bool gone(int id) const noexcept {
        return bodies[static_cast<std::size_t>(id)] == 0;
    }
    /// So that add(), append() and remove() of one of this kind, given an rvalue, do not throw.
    /// @throws std::bad_alloc.
    void make_room(InteractionKind kind);
    /// First empty place of a kind, −1: none.
    [[nodiscard]] int place_for(InteractionKind kind) const noexcept {
        return places.find_vacant(
            [&](std::int32_t p) { return def[static_cast<std::size_t>(p)].kind == kind; });
    }
    /// Add one, at the first empty place of its kind, else behind all others; `filled` is checked
    /// and complete. Row constants depend on h. @return its place.
    int add(InteractionDef filled, Bodies& bodies_in, double h);
    /// Add one behind all others.
    int append(InteractionDef filled, Bodies& bodies_in, double h);
    /// A place for one of a kind behind all others, with nothing there; for the caller to vacate.
    void append_empty(InteractionKind kind);
    /// What presses on friction, of interactions that there are.
    void set_loads(int id, const std::array<FrictionLoad, kMaxFrictionLoads>& loads_in);
    /// What is left at its place has no bodies and no rows. Friction that it loads is free of it.
    void remove(int id, Bodies& bodies_in) noexcept;
    /// Take away those from `kept` on, none of which drives, rubs or winds up a line.
    void truncate(int kept, Bodies& bodies_in);
    /// Υ and recall of a row, after its compliance or mobility changed; its Σ has to follow.
    void share_damping(std::size_t row, bool wire, double h) noexcept;
    /// Σ by ε and Υ alone (hawser/row_constants.h), without the floors that an analysis adds.
    [[nodiscard]] double bare_sigma(std::size_t row, double h) const noexcept;
    /// Σ over that which the row has when its wire does not recoil.
    [[nodiscard]] double recoil_share(std::size_t row, bool wire, double h) const noexcept;
    /// The rows of a wire's element begin or cease to recoil (share_damping()).
    void recoil(int id, bool recoils, double h) noexcept;
    /// Υ, recall, Σ and 1/Σ of a row with a violation whose compliance, not 0, changed after the
    /// analysis. Σ stays at least `least_sigma`, and a kept row stays kept. @param wire  Whether it
    /// is of a wire element.
    void follow_compliance(std::size_t row, bool wire, double h) noexcept;
    /// A copy of an interaction follows its parameters.
    void mirror(int copy, int original, const Bodies& bodies_in, double h) noexcept;
    /// An input is going to drive a parameter.
    void mark_driven(int id);
    /// No input does any more.
    void unmark_driven(int id) noexcept;
    /// Rebuild the pool entry, and a compliance of length/EA, after a parameter changed.
    void refresh(int id, const Bodies& bodies_in, double h) noexcept;
    /// Where friction holds on. [m or rad]
    void set_anchor(int id, double coordinate) noexcept;
    /// Another body in a slot; what depends on the kinds of its bodies must stay true. The system
    /// has to be analysed anew.
    void rewire(int id, std::size_t slot, BodyId to, Bodies& bodies_in) noexcept;
    /// f(id, slot) for all that hold a body, in no order. One that has it twice comes twice. f may
    /// rewire to the body that is there.
    template <class F>
    void for_each_holder(int body_in, const Bodies& bodies_in, F&& f) const {
        for (std::int32_t p = bodies_in.first_holder[static_cast<std::size_t>(body_in)]; p >= 0;
             p = next_holder[static_cast<std::size_t>(p)])
            f(p / kSlots, static_cast<std::size_t>(p % kSlots));
    }
    /// Mass of a wire element [kg], see pair_mass; nothing of a kind that has none.
    void set_mass(int id, double mass) noexcept;
    /// Unstretched length of a wound element by its drum or slide [m]; of a span it may be
    /// negative.
    [[nodiscard]] double wound_length(int id, const Bodies& bodies_in) const noexcept;
    /// Compliance and length of a wire element at its present rest length, which a drum pays out.
    void follow_length(int id, const Bodies& bodies_in, double h) noexcept;
    /// @param v  Packed velocities, null: the bodies' own.
    [[nodiscard]] RowState row_state(int id, const Bodies& bodies_in,
                                     const double* v = nullptr) const noexcept;
    /// Of an element, or of a part of a line that runs over places (KindTrait kPulls).
    [[nodiscard]] LineShape line_shape(int id, const Bodies& bodies_in) const noexcept;
    /// Angle past its mark by which a span lies on the wheel at each end, but for whole turns
    /// [rad].
    [[nodiscard]] std::array<double, 2> wheel_angles(int id,
                                                     const Bodies& bodies_in) const noexcept;
    /// The same with them.
    [[nodiscard]] std::array<double, 2> wrapped(int id, const Bodies& bodies_in) const noexcept;
    /// Count the turns that those angles have made. @param before  wheel_angles() before bodies
    /// moved or were replaced, by less than half a turn.
    void follow_turns(int id, const std::array<double, 2>& before,
                      const Bodies& bodies_in) noexcept;
    /// That of the hinge, way or scalar body that it holds, limits, drives or rubs; zeros of a kind
    /// that has none.
    [[nodiscard]] Coordinate coordinate(int id, const Bodies& bodies_in) const noexcept;
    /// Gᵀλ on the body of one slot, force then torque, added to `out` (6 entries).
    void add_impulse(int id, int slot, const Bodies& bodies_in, const double* impulse,
                     double* out) const noexcept;
    /// Elastic energy at the half-step position [J].
    [[nodiscard]] double elastic(int id, const Bodies& bodies_in, double h) const noexcept;
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    static constexpr auto kSlots = static_cast<std::int32_t>(kMaxInteractionBodies);
    void grow(InteractionKind kind);
    /// Enter what is in a place of `body` with those that hold it; take it away.
    void link(std::size_t place, Bodies& bodies_in) noexcept;
    void unlink(std::size_t place, Bodies& bodies_in) noexcept;
    /// Everything of one whose place there is.
    void write(int id, InteractionDef filled, Bodies& bodies_in, double h);
    void write_rows(int id, const Bodies& bodies_in, double h);
    void enlist(int id, const Bodies& bodies_in);
    void write_data(int id) noexcept;
    /// f<K>(rows) for the rows at the present poses.
    template <class F>
    void evaluated(int id, const Bodies& bodies_in, F&& f) const noexcept;
    void write_loads(int id);
    void set_range(int id) noexcept;
};

/// Whether a step may solve the rows of an interaction at the step's end (step/completion.h):
/// it is a joint or rod that no input moves, rigid and damped by default, or a spring with a damper
/// that the step does not resolve at the poses of the last analysis.
[[nodiscard]] bool may_complete(const Interactions& in, int id, double h) noexcept;

/// Whether a kind allows that.
[[nodiscard]] bool kind_completes(InteractionKind kind) noexcept;
/// Whether its kind and inputs allow that, whatever its rows are.
[[nodiscard]] bool may_ever_complete(const Interactions& in, int id) noexcept;

/// Fill in the defaults that a kind takes from the initial poses.
void complete(InteractionDef& def, const Vec3* positions, double distance);

}  // namespace hawser::model
