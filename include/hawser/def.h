// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file def.h
/// Definitions of bodies, inputs and settings of a World, and the exceptions of its set-up.
///
/// A definition is a struct with defaults; its members may be set by name (`{.mass = 5.0}`). A
/// World copies it, so that later changes of the struct have no effect.

#include <hawser/id.h>
#include <hawser/math.h>

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

namespace hawser {

/// Exception for an invalid definition or id. Its message reports the field, its value and the
/// remedy.
class DefError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Resource that WorldDef limits: contact points and pairs of close shapes (max_contacts), or
/// memory (max_memory).
enum class Bound : std::uint8_t { none, contacts, pairs, memory };

/// Limit of a resource that a step or call would exceed.
struct BoundMet {
    Bound bound = Bound::none;  ///< Exceeded resource.
    double value = 0.0;         ///< Required amount [contact points, pairs of shapes or bytes].
    double limit = 0.0;         ///< Permitted amount, in the unit of `value`.
};
/// Return one sentence with the resource, the value and the remedy; "" for Bound::none.
[[nodiscard]] std::string to_string(const BoundMet& met);

/// Exception if a world would exceed a limit of its definition. Its message is to_string() of the
/// BoundMet.
class LimitError : public std::runtime_error {
  public:
    explicit LimitError(const BoundMet& met) : std::runtime_error(to_string(met)), met_(met) {}
    /// Return the exceeded limit.
    [[nodiscard]] const BoundMet& met() const noexcept { return met_; }

  private:
    BoundMet met_;
};

/// Exception for an invalid environment variable. Its message reports name, value and remedy.
class EnvironmentError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Exception if a second thread uses a world, or if a world is changed within its own step. The
/// call has no effect. Remedy: use a world from one thread at a time.
class UseError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Exception if the operating system provides too few worker threads. Its message reports how many
/// started and the remedy. No thread is left running.
class ThreadError : public std::runtime_error {
  public:
    ThreadError(int wanted, int started, const std::string& reason);
    /// Return the number of requested worker threads, WorldDef::threads − 1.
    [[nodiscard]] int wanted() const noexcept { return wanted_; }
    /// Return the number of worker threads that started.
    [[nodiscard]] int started() const noexcept { return started_; }

  private:
    int wanted_, started_;
};

/// Kind of a body, by its degrees of freedom.
enum class BodyKind : std::uint8_t {
    rigid,      ///< Rigid body, 6 degrees of freedom.
    lump,       ///< Lumped mass, 3 degrees of freedom, such as a node of a wire.
    scalar,     ///< Scalar body, 1 degree of freedom, such as a drum; coordinate in position.x().
    fixed,      ///< Body at rest in the world, 0 degrees of freedom.
    kinematic,  ///< Moves with its prescribed velocity under any load, 0 degrees of freedom.
};

/// Definition of a body. World::add_body() copies it.
struct BodyDef {
    std::string name{};               ///< Unique name in the world, or empty.
    BodyKind kind = BodyKind::rigid;  ///< Kind of the body.
    Vec3 position{0.0, 0.0, 0.0};     ///< Centre of mass, world frame [m]; scalar: x() [m or rad].
    Quat orientation = Quat::Identity();  ///< Rotation from body to world frame; normalised on
                                          ///< entry.
    /// Velocity of the centre of mass at time 0, world frame [m/s]; scalar: x() [m/s or rad/s].
    /// Kinematic: prescribed until World::set_velocity() changes it.
    Vec3 velocity{0.0, 0.0, 0.0};
    /// Angular velocity at time 0, world frame [rad/s]. Kinematic: prescribed until
    /// World::set_velocity().
    Vec3 angular_velocity{0.0, 0.0, 0.0};
    double mass = 0.0;            ///< Mass [kg]; scalar: [kg] or [kg m²]. > 0 if the body moves.
    Mat3 inertia = Mat3::Zero();  ///< Inertia about the centre of mass, body frame [kg m²].
    /// Constant applied force at the centre of mass, world frame [N]; scalar: x() [N or N m].
    Vec3 force{0.0, 0.0, 0.0};
    Vec3 torque{0.0, 0.0, 0.0};           ///< Constant applied torque, world frame [N m].
    Vec3 linear_damping{0.0, 0.0, 0.0};   ///< Linear drag along the body's axes [N s/m], ≥ 0.
    Vec3 angular_damping{0.0, 0.0, 0.0};  ///< Angular drag about the body's axes [N m s], ≥ 0.
    bool gravity = true;                  ///< False: weightless, such as drums.
    Vec3 half_size{0.0, 0.0, 0.0};        ///< Half sizes of the box in pictures [m]; zero: a point.
    /// Name of the group (part of a split) that the body belongs to. If WorldDef::coupling is not
    /// exact, interactions between different groups are cut. "": the unnamed group, or, with
    /// WorldDef::parts > 0, a group that the world chooses.
    std::string group{};
};

/// Form of the linear equations of a step that is factored. All forms give the same velocities to
/// rounding. Source: eq. (1) of C. Lacoursière, F. Nordfeldth, M. Linde, "A partitioning method for
/// parallelization of large systems in realtime".
enum class Form : std::uint8_t {
    automatic,  ///< For each interaction: condensed if numerically safe, else saddle.
    saddle,     ///< All rows stay in the matrix, with their multipliers as unknowns.
    condensed,  ///< Rows with compliance > 0 are eliminated first, into the blocks of the bodies.
};

/// Method for contacts with dry friction. Methods except `newton` serve comparison
/// (docs/nonsmooth.md).
enum class Nonsmooth : std::uint8_t {
    newton,    ///< Exact friction disk; semismooth Newton method over all rows.
    pivoting,  ///< Box friction along two axes; block principal pivoting with bounds of earlier
               ///< passes.
    split,     ///< Joints and normals direct, then projected Gauss-Seidel sweeps over the tangents.
    pgs,     ///< Projected Gauss-Seidel for every row. Geometric stiffness and rotation damping are
             ///< off, because they couple bodies outside the rows.
    convex,  ///< Associated cone: sliding causes dilation along the normal.
};

/// Coupling of an interaction between two parts (docs/theory/splits.md). Splits except `exact` are
/// those of the paper, for comparison.
enum class Coupling : std::uint8_t {
    exact,      ///< Solved in the global system: one multiplier for all its bodies.
    kinematic,  ///< Each side solves it with a prescribed velocity of the other side.
    compliant,  ///< Kinematic, with the compliance that stability requires.
    deadline,   ///< Exact; compliant if a deadline requires it (docs/theory/deadlines.md).
};

/// Predicted velocity of the other side of a cut.
enum class Predictor : std::uint8_t {
    hold,    ///< Velocity of the last step.
    forces,  ///< Velocity and forces of the last step: v + h M⁻¹ f.
    clique,  ///< Velocity from a first solution of the bodies at cuts and their neighbours, with
             ///< all other bodies fixed.
};

/// Reaction to a step whose state fails the monitors (docs/limits.md).
enum class OnDiverged : std::uint8_t {
    stop,  ///< Reject the step: Status::diverged; the state before it is kept.
    warn,  ///< Accept the step and report an event.
};

/// Settings of a world; constant after its creation. Values out of range are rejected.
struct WorldDef {
    double step = 1.0 / 60.0;          ///< Time step h [s], 1e-7 to 1.
    Vec3 gravity{0.0, 0.0, -9.81};     ///< Gravity, world frame [m/s²], each component up to 1e4.
    Form form = Form::automatic;       ///< Form of the equations.
    double geometric_stiffness = 1.0;  ///< Scale of the conservative geometric stiffness K_g [1], 0
                                       ///< (off) to 100.
    /// Scale k_b of the numerical damping of relative rotation in joints [1], 0 (off) to 100. It
    /// acts on bodies that oscillate faster than the step resolves: links of a chain
    /// (docs/theory/stiffness.md).
    double rotation_damping = 0.1;
    bool staggered_start = true;  ///< True: v₀ is the velocity at t = −h/2, which makes the scheme
                                  ///< second order.
    /// Relative residual of the contact laws below which the contacts of a step count as solved
    /// [1], 1e-12 to 1.
    double contact_tolerance = 1e-6;
    /// Largest number of iterations of one attempt to solve the contacts of a step, 1 to 1000. If
    /// they do not suffice, Newton's method restarts: first with softer tangents, then with
    /// symmetric iterations.
    int contact_iterations = 60;
    Nonsmooth nonsmooth = Nonsmooth::newton;  ///< Method for contacts with friction.
    int nonsmooth_sweeps = 50;  ///< Sweeps per step of `split` and `pgs`, 1 to 100,000.
    /// Coupling of interactions between groups (BodyDef::group). WorldSplits::set_coupling() sets
    /// the coupling of a single interaction. A coupling other than exact requires sleep_after 0.
    Coupling coupling = Coupling::exact;
    Predictor predictor = Predictor::hold;  ///< Predictor of couplings other than exact.
    /// Number of automatic groups if a coupling is not exact, 0 to 4096; 0: groups by hand only.
    /// The world assigns bodies without a group (BodyDef::group) so that the cuts cost least. Costs
    /// follow from the model in the first step, and from forces and velocities after about ten
    /// steps (docs/partition.md).
    int parts = 0;
    /// Number of steps between updates of the automatic groups, 0 to 1,000,000; 0: the groups of
    /// the first step remain. Each update moves at most one cut (docs/partition.md).
    int regroup_every = 60;
    /// Residual of the step's linear equations above which a solution is refined, 1e-13 to 1e-6.
    /// Momentum rows: relative to the momentum [1]; other rows: [m/s or rad/s].
    double solution_tolerance = 1e-10;
    /// Number of these refinements, 0 to 4; 0: none. Up to two more if the residual stays above
    /// 1e-11.
    int refinements = 1;
    int threads = 1;  ///< Number of threads, 1 to 256. Results are independent of it.
    /// Limit of the solver's CPU time in the slowest thread of a step [s]; 0: none. Only the method
    /// newton has a budget. If the next iteration for contacts would exceed it, the best iterate is
    /// projected (StepStats::cut); at least one iteration is made. A replay reproduces the step
    /// only with StepStats::degradation.
    double budget = 0.0;
    /// The same limit by the work of factorisations and substitutions [flop]; 0: none.
    /// Reproducible without StepStats::degradation.
    double budget_work = 0.0;
    /// Distance below which two shapes get a contact before they touch [m], 1e-6 to 10.
    /// Recommended: the distance of a fall from rest in one step, ½ to 1 g h², 3 mm at 60 Hz.
    double contact_margin = 0.02;
    /// Time below sleep_speed after which an island sleeps [s]; 0: never. Sleeping islands are left
    /// out of steps until they are disturbed (docs/theory/sleep.md).
    double sleep_after = 0.0;
    /// Speed below which a body is at rest [m/s], 0 to 1: √(2T/m), T its kinetic energy.
    double sleep_speed = 1e-4;
    OnDiverged on_diverged = OnDiverged::stop;  ///< Reaction to a failed state.
    std::int32_t max_bodies = 4'000'000;  ///< Limit of the number of bodies; more are rejected.
    std::int32_t max_interactions = 8'000'000;  ///< Limit of the number of interactions; more are
                                                ///< rejected.
    /// Limit of the number of contact points of a step, 1 to 1e9; points that do not touch yet
    /// count. The limit of close pairs of shapes is eight times as large. A step that exceeds
    /// either ends with Status::over_bound.
    std::int32_t max_contacts = 400'000;
    /// Limit of the memory of state, solver and contacts [bytes], 1e6 to 1e15. The memory of a
    /// factorisation follows from its structure and is checked before allocation. World::prepare()
    /// and other analyses throw LimitError; a step returns Status::over_bound.
    double max_memory = 16e9;
};

/// Definition of an input: a named value that may be changed between steps within a range. It
/// drives a parameter of an interaction, or a force on a body. World::add_input() copies the
/// definition.
struct InputDef {
    std::string name{};           ///< Unique name among inputs. Required.
    InteractionId interaction{};  ///< Interaction whose parameter is driven; invalid: set `body`.
    std::string param{};          ///< Name of the parameter; ParamInfo::input must be true.
    BodyId body{};                ///< Body that gets a force or torque; invalid: set `interaction`.
    int component = 0;   ///< Component with `body`: 0-2 force x, y, z [N]; 3-5 torque [N m].
    double min = -1e30;  ///< Lower limit, in the driven unit; smaller values are clamped, with an
                         ///< event.
    double max = 1e30;   ///< Upper limit, in the driven unit; larger values are clamped, with an
                         ///< event.
    /// True (with a rigid `body`): force or torque in the body frame, which turns with it. False:
    /// world frame. Forces of inputs, World::set_force() and systems add up.
    bool local = false;
    std::string unit{};    ///< Unit label; "": the driven unit. Values are always in SI units.
    std::string group{};   ///< Heading under which a client shows it; free text.
    double nominal = 0.0;  ///< Usual magnitude, for scales and controls, in `unit`; 0: unknown.
    /// Value to which a control returns when the user releases it; none: it keeps its value.
    /// Clients apply it; the world only stores it.
    std::optional<double> spring{};
};

}  // namespace hawser
