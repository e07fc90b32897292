// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file def.h
/// Plain definition structs with defaults and units, and the error of the set-up interface.

#include <hawser/id.h>
#include <hawser/math.h>

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

namespace hawser {

/// A definition that the world refuses; what() says which field, its value and the remedy.
class DefError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// What a world may not grow beyond, see WorldDef.
enum class Bound : std::uint8_t { none, contacts, pairs, memory };

/// A bound that something would have exceeded.
struct BoundMet {
    Bound bound = Bound::none;
    double value = 0.0;  ///< What was needed [contact points, pairs of shapes or bytes].
    double limit = 0.0;  ///< What was allowed, in the unit of `value`.
};
/// One sentence with the bound, the value and the remedy; "" for none.
[[nodiscard]] std::string to_string(const BoundMet& met);

/// A world would exceed a bound of its definition; what() is to_string() of it.
class LimitError : public std::runtime_error {
  public:
    explicit LimitError(const BoundMet& met) : std::runtime_error(to_string(met)), met_(met) {}
    [[nodiscard]] const BoundMet& met() const noexcept { return met_; }

  private:
    BoundMet met_;
};

/// A variable of the environment that makes no sense; what() says which, its value and the remedy.
class EnvironmentError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// A world is changed while it is in use: by a second thread, or from within its own step. What
/// was asked for has not been done; let one thread at a time use a world.
class UseError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// The system does not give a world its worker threads; what() says how many started and the
/// remedy. None is left running.
class ThreadError : public std::runtime_error {
  public:
    ThreadError(int wanted, int started, const std::string& reason);
    /// Besides the calling thread: WorldDef::threads − 1.
    [[nodiscard]] int wanted() const noexcept { return wanted_; }
    [[nodiscard]] int started() const noexcept { return started_; }

  private:
    int wanted_, started_;
};

enum class BodyKind : std::uint8_t {
    rigid,      ///< 6 degrees of freedom.
    lump,       ///< 3: a point mass, such as a wire node.
    scalar,     ///< 1: a drum or spool; coordinate in position.x().
    fixed,      ///< 0: part of the world.
    kinematic,  ///< 0: moves with its prescribed velocity, whatever pulls at it.
};

/// One body.
struct BodyDef {
    std::string name{};  ///< Unique in the world, or empty.
    BodyKind kind = BodyKind::rigid;
    Vec3 position{0.0, 0.0, 0.0};         ///< Centre of mass [m]; scalar: x() [m or rad].
    Quat orientation = Quat::Identity();  ///< Body to world; normalised on entry.
    /// At time 0, of the centre of mass, world frame [m/s]; scalar: x() [m/s or rad/s];
    /// kinematic: prescribed until World::set_velocity() changes it.
    Vec3 velocity{0.0, 0.0, 0.0};
    /// At time 0, world frame [rad/s]; kinematic: prescribed, until World::set_velocity().
    Vec3 angular_velocity{0.0, 0.0, 0.0};
    double mass = 0.0;            ///< [kg]; scalar: [kg] or [kg m²]. Positive if it moves.
    Mat3 inertia = Mat3::Zero();  ///< About the centre of mass, body frame [kg m²].
    /// Constant applied force, world frame, at the centre of mass [N]; scalar: x() [N or N m].
    Vec3 force{0.0, 0.0, 0.0};
    Vec3 torque{0.0, 0.0, 0.0};           ///< Constant applied torque, world frame [N m].
    Vec3 linear_damping{0.0, 0.0, 0.0};   ///< Drag along the body's axes [N s/m], ≥ 0.
    Vec3 angular_damping{0.0, 0.0, 0.0};  ///< Drag about the body's axes [N m s], ≥ 0.
    bool gravity = true;                  ///< False: weightless (floating at rest, drums).
    Vec3 half_size{0.0, 0.0, 0.0};        ///< Box for pictures only [m]; zero: a point.
    /// Part that it belongs to; "": the one without a name. Where WorldDef::coupling is not exact,
    /// interactions between bodies of different groups are cut.
    std::string group{};
};

/// Which form of the time step's equations to factor: eq. (1) of C. Lacoursière, F. Nordfeldth,
/// M. Linde, "A partitioning method for parallelization of large systems in realtime". Velocities
/// agree to round-off.
enum class Form : std::uint8_t {
    automatic,  ///< Per interaction: condensed where that is numerically safe, else kept.
    saddle,     ///< Every interaction kept as rows with multipliers.
    condensed,  ///< Every row with compliance > 0 eliminated first into the bodies' blocks.
};

/// How contacts with dry friction are solved. All but `newton` are there to be compared with it
/// (docs/nonsmooth.md).
enum class Nonsmooth : std::uint8_t {
    newton,    ///< Exact disk friction, semismooth Newton method over all rows at once.
    pivoting,  ///< Box friction along two axes, block principal pivoting; bounds of earlier passes.
    split,     ///< Joints and normals direct, then sweeps over tangents: projected Gauss-Seidel.
    pgs,       ///< Projected Gauss-Seidel for every row. Geometric stiffness and rotation damping
               ///< are then off: they couple bodies beside the rows.
    convex,    ///< Associated cone: what slides also lifts.
};

/// How an interaction between two parts couples them: docs/methods.md, 10. All but `exact` are the
/// splits of the paper, there to be compared with it.
enum class Coupling : std::uint8_t {
    exact,      ///< Solved for with all else: one multiplier for all its bodies.
    kinematic,  ///< Each side solves for it as if the other side moved at a velocity given.
    compliant,  ///< Kinematic, with a compliance as large as stability needs.
    deadline,   ///< Exact; compliant in steps in which a deadline asks for it: docs/methods.md, 11.
};

/// The velocity of the other side that a cut assumes.
enum class Predictor : std::uint8_t {
    hold,    ///< That of the last step.
    forces,  ///< From the last step's velocity and forces: v + h M⁻¹ f.
    clique,  ///< Of a solve of the bodies at cuts and their neighbours first, all others held.
};

/// What a step does whose state its judges find to be wrong (docs/limits.md).
enum class OnDiverged : std::uint8_t {
    stop,  ///< It is refused: Status::diverged, and the state before stays.
    warn,  ///< It counts, with an event.
};

/// Settings of a world; fixed once it has been created. The world refuses values out of range.
struct WorldDef {
    double step = 1.0 / 60.0;       ///< Time step h [s], 1e-7 to 1.
    Vec3 gravity{0.0, 0.0, -9.81};  ///< World frame [m/s²], each component up to 1e4.
    Form form = Form::automatic;
    double geometric_stiffness = 1.0;  ///< Scale of the conservative K_g terms, 0 (off) to 100.
    /// k_b, 0 (off) to 100: numerical damping of the relative rotation in joints whose bodies
    /// swing faster than the step resolves, such as links of a chain (docs/methods.md, 4).
    double rotation_damping = 0.1;
    bool staggered_start = true;  ///< v₀ taken at t = −h/2, which makes the scheme second order.
    /// Relative residual at which the contacts of a step count as solved, 1e-12 to 1.
    double contact_tolerance = 1e-6;
    /// Most iterations of an attempt, 1-1000; Newton's method, where they do not suffice, starts
    /// again: through softer tangents, then with iterations that are symmetric.
    int contact_iterations = 60;
    Nonsmooth nonsmooth = Nonsmooth::newton;
    int nonsmooth_sweeps = 50;  ///< Sweeps a step of `split` and `pgs`, 1 to 100,000.
    /// Of interactions between groups (BodyDef::group); World::set_coupling() chooses for one.
    /// Other than exact, sleep_after must be 0.
    Coupling coupling = Coupling::exact;
    Predictor predictor = Predictor::hold;  ///< For coupling other than exact.
    /// Parts that the world makes itself where some coupling is not exact, 0 to 4096: bodies
    /// without a group of their own (BodyDef::group) get one, cut where that costs least, from the
    /// model in the first step and by weights of the state after some ten. 0: none, groups by hand
    /// only.
    int parts = 0;
    /// Steps after which these groups are looked at again, 0 to 1,000,000; 0: they stay as the
    /// first step had them. At most one cut moves each time (docs/partition.md).
    int regroup_every = 60;
    /// Residual of the saddle system above which a solution is refined, 1e-13 to 1e-6: relative of
    /// momentum, of rows in m/s or rad/s.
    double solution_tolerance = 1e-10;
    /// Such refinements, 0-4; up to two more where the residual is above 1e-11 still. 0: none.
    int refinements = 1;
    int threads = 1;  ///< Worker threads, 1-256; results do not depend on it.
    /// Limits of a step's solve for contacts, 0: none. Where the next iteration would exceed one,
    /// the best iterate is projected (StepStats::cut). At least one iteration is made. For method
    /// newton only.
    /// Solver CPU time of the slowest thread [s]; repeatable with StepStats::degradation only.
    double budget = 0.0;
    double budget_work = 0.0;  ///< Flops of factorisations and substitutions; repeatable.
    /// Shapes closer than this are in contact before they touch [m], 1e-6 to 10. It is to cover
    /// what a shape moves within a step from rest: ½ to 1 g h², 3 mm at 60 Hz.
    double contact_margin = 0.02;
    /// Islands whose bodies have been slower than sleep_speed for this long [s] sleep: they are
    /// left out of the step until something disturbs them. 0: never. docs/methods.md, 9.
    double sleep_after = 0.0;
    /// Speed [m/s] below which a body is at rest: √(2T/m), T its kinetic energy. 0 to 1.
    double sleep_speed = 1e-4;
    OnDiverged on_diverged = OnDiverged::stop;
    std::int32_t max_bodies = 4'000'000;        ///< Refuse to grow beyond this.
    std::int32_t max_interactions = 8'000'000;  ///< Refuse to grow beyond this.
    /// Contact points of a step, those near without touching included; 1 to 1e9. A step that would
    /// have more ends with Status::over_bound, as does one with eight times as many pairs of shapes
    /// near each other.
    std::int32_t max_contacts = 400'000;
    /// Memory [bytes] that state, solver and contacts may take, 1e6 to 1e15. What the factorisation
    /// takes is known from its structure, and is refused before it is asked for: by LimitError from
    /// World::prepare() and whatever else analyses, by Status::over_bound from a step.
    double max_memory = 16e9;
};

/// A number that may be changed between steps by name, within a range.
struct InputDef {
    std::string name{};           ///< Unique among inputs. Required.
    InteractionId interaction{};  ///< Interaction whose parameter is driven, or …
    std::string param{};          ///< … name of a parameter with ParamInfo::input set.
    BodyId body{};                ///< … body with a force (0-2) or torque (3-5) of this input.
    int component = 0;            ///< 0-2 force x, y, z [N]; 3-5 torque [N m]; with `body` only.
    double min = -1e30;           ///< Values are clamped to the range, with an event …
    double max = 1e30;            ///< … in the unit of what is driven.
    /// With `body`, whose forces of all inputs, of World::set_force() and of systems add up, and
    /// are 0 at first: the force or torque is in the frame of the body, a rigid one, with which it
    /// turns from step to step, instead of in the world's.
    bool local = false;
    std::string unit{};    ///< "": that of what is driven. A label; values are in SI units.
    std::string group{};   ///< Free text: under which heading a client shows it.
    double nominal = 0.0;  ///< Usual size, for scales and levers, in the unit; 0: not known.
    /// Value that a lever goes home to when it is let go; none: it stays where it is. The world
    /// only keeps it: a client acts on it.
    std::optional<double> spring{};
};

}  // namespace hawser
