// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file world.h
/// The world: bodies, interactions, and the step that moves them.
///
/// ```cpp
/// hawser::World world({.step = 1.0 / 60.0});
/// auto ground = world.add_body({.name = "ground", .kind = hawser::BodyKind::fixed});
/// auto bob = world.add_body({.name = "bob", .kind = hawser::BodyKind::lump,
///                            .position = {1, 0, 0}, .mass = 1.0});
/// world.add(hawser::DistanceDef{.a = ground, .b = bob});
/// while (world.time() < 10.0)
///     if (world.step() != hawser::Status::ok) break;
/// ```
/// Set-up functions throw DefError, as does every function that is given an id of nothing; step()
/// does not throw. A function that throws, std::bad_alloc or anything else, leaves the world as it
/// was; so does a step that fails, and what is tried again gives the same bits as if nothing had
/// failed. A name that is not found gives an invalid id. A world is used by one thread at a time: a
/// second one that changes it or steps is refused (UseError, Status::in_use). Different worlds are
/// independent. Bodies, interactions, shapes and inputs may be added and removed between steps; the
/// next step repairs its analysis, and what an edit touches wakes. Velocities given to what is
/// added later are used as they are; energy that comes and goes counts as edited (Energy).

#include <hawser/attempt.h>
#include <hawser/def.h>
#include <hawser/edits.h>
#include <hawser/id.h>
#include <hawser/interactions.h>
#include <hawser/machine.h>
#include <hawser/math.h>
#include <hawser/outputs.h>
#include <hawser/shapes.h>
#include <hawser/state.h>
#include <hawser/stats.h>
#include <hawser/system.h>
#include <hawser/wire.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hawser {

struct SystemView;        // inspect.h
struct PartitionView;     // partition.h
struct PartitionRequest;  // partition.h
struct TraceView;         // trace.h
struct CutView;           // inspect.h
struct RowsView;          // inspect.h
struct Structure;         // structure.h
class ChangeListener;     // changes.h

class World {
  public:
    /// @throws DefError on a value out of range, ThreadError where the worker threads cannot be
    ///         started, EnvironmentError (see check_environment()), std::bad_alloc.
    explicit World(const WorldDef& def = {});
    ~World();                 ///< In a forked child: attempt.h.
    World(World&&) noexcept;  ///< What is left may be destroyed or assigned to: attempt.h.
    World& operator=(World&&) noexcept;
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    // --- Set-up -------------------------------------------------------------------------
    /// @throws DefError on a duplicate name, a mass or inertia that is not positive definite,
    ///         a value that is not finite.
    BodyId add_body(const BodyDef& def);
    /// @throws DefError on unknown bodies, no moving body, a parameter missing or out of range.
    InteractionId add_interaction(const InteractionDef& def);
    /// Several, all or none. A load with a factor but no interaction is of the first of them.
    /// @param ids  As many as there are definitions. @throws DefError.
    void add_interactions(std::span<const InteractionDef> defs, std::span<InteractionId> ids);
    /// A typed definition of joints.h or lines.h; what it returns stands there.
    template <class Def>
    auto add(const Def& def) {
        const Attempt attempt(*this);
        return define(*this, def);
    }
    /// @throws DefError when the parameter cannot be driven or the name is taken.
    InputId add_input(const InputDef& def);
    /// @throws DefError on a name that is taken, a value out of range.
    MaterialId add_material(const MaterialDef& def);
    /// A later pair of the same two materials replaces the first. @throws DefError on an unknown
    /// material, a value out of range.
    void add_material_pair(const MaterialPairDef& def);
    /// @throws DefError on a body that cannot have such a shape, sizes out of range, a name that is
    ///         taken, vertices that span no volume.
    ShapeId add_shape(const ShapeDef& def);
    /// Take away a body, and all that hangs on it: its interactions, its shapes, the segments of
    /// wires that end at it, what drives these. Friction that one of these loads stays, without
    /// that load. Nothing is removed where this throws.
    /// @return What went; valid until the next removal. @throws DefError, std::bad_alloc.
    const Removed& remove_body(BodyId id);
    /// The same for an interaction, with the inputs that drive it …
    const Removed& remove_interaction(InteractionId id);
    const Removed& remove_shape(ShapeId id);  ///< … a shape …
    const Removed& remove_input(InputId id);  ///< … and an input: what it set stays as it is.
    // What a system holds (System::holds()) is not removed: @throws DefError that names it.
    /// Whoever is told of all that is done from now on, see changes.h; null: nobody. It has to
    /// outlive the world, or be taken away. A twin() has none.
    void set_change_listener(ChangeListener* listener) noexcept;
    /// Analyse now instead of in the first step. @throws std::bad_alloc, LimitError.
    void prepare();

    // --- Systems (system.h) ---------------------------------------------------------------
    /// It acts from the next step on, after those there are, with outputs "system.signal". @return
    /// the same, which the world owns now. @throws DefError on a name that is empty or taken, on
    /// signals without or with equal names, and where the method is `pgs` or `split`.
    System& add_system(std::unique_ptr<System> system);
    /// It acts no more. @return it, with its state. @throws DefError where it is not of this world.
    std::unique_ptr<System> remove_system(const System& system);
    [[nodiscard]] int system_count() const noexcept;
    [[nodiscard]] System& system(int index);  ///< In the order in which they act. @throws DefError.
    [[nodiscard]] System* find_system(std::string_view name) noexcept;  ///< Null: there is none.
    [[nodiscard]] const System* find_system(std::string_view name) const noexcept;
    /// Inputs and outputs of all systems.
    [[nodiscard]] std::span<const SystemSignal> system_signals() const noexcept;
    /// By "system.name". @throws DefError where there is none, with the nearest name.
    [[nodiscard]] double system_signal(std::string_view name) const;
    /// Clamped to its range, with an event. @throws DefError: no such input, or it is not finite.
    void set_system_signal(std::string_view name, double value);
    /// Loads of systems in the last step, or the one that failed, by body; good until the next.
    [[nodiscard]] std::vector<LoadView> loads() const;
    /// Of the last step that ended with Status::bad_load or bad_edit.
    [[nodiscard]] const BadLoad& bad_load() const noexcept;

    // --- Stepping -----------------------------------------------------------------------
    /// Advance by WorldDef::step. Where the status is not ok the state is the last good one.
    Status step() noexcept;
    /// End the step under way between parts of the factorisation or of the collisions, or else the
    /// next one where it begins: with Status::cancelled and the last good state. Only an analysis
    /// is not left in the middle. Another thread or a signal handler may call it: it sets a flag.
    void cancel() noexcept;
    [[nodiscard]] double time() const noexcept;  ///< [s].
    [[nodiscard]] std::int64_t step_count() const noexcept;
    [[nodiscard]] const StepStats& stats() const noexcept;
    [[nodiscard]] Energy energy() const noexcept;  ///< Of the state; zeros before prepare().
    /// Worst of all states since the start or the last restore(), the present one included; of a
    /// step that was refused as diverged the state that it came to.
    [[nodiscard]] Verdict verdict() const noexcept;
    /// The next step leaves out just this, and WorldDef's budgets are ignored in it: repeats what
    /// StepStats::degradation reported. Nothing (the default) takes it back. Iterations below 0: 0.
    void degrade_next_step(const Degradation& degradation) noexcept;
    [[nodiscard]] int coarsening() const noexcept;  ///< Degradation::wires of the step to come.
    /// FNV-1a 64 over poses, velocities, multipliers, time, inputs, and the name of the
    /// instruction set in use. Equal for any number of threads and after save/restore.
    [[nodiscard]] std::uint64_t state_hash() const noexcept;
    /// The same without the states of systems: equal in a replay, which repeats what they did.
    [[nodiscard]] std::uint64_t motion_hash() const noexcept;
    /// Events since the last call, oldest first; keeps the newest 16,384 of slack and of taut each,
    /// and 4,096 of any other kind.
    [[nodiscard]] std::vector<Event> take_events();
    /// Events from a reader's cursor on, oldest first; it moves behind them. For several readers,
    /// and beside take_events(). 0 begins with the oldest kept. @param out  What it held goes.
    /// @return how many were forgotten since the cursor.
    std::uint64_t events_since(std::uint64_t& cursor, std::vector<Event>& out) const;
    /// Events so far: where a reader begins that wants none of them.
    [[nodiscard]] std::uint64_t event_cursor() const noexcept;
    /// How many of a kind there were, the first and the worst; taking events changes nothing of it.
    [[nodiscard]] EventExtremes event_extremes(EventKind kind) const noexcept;

    // --- Inputs and applied forces --------------------------------------------------------
    [[nodiscard]] int input_count() const noexcept;                  ///< Places, as body_count().
    [[nodiscard]] std::span<const InputId> inputs() const noexcept;  ///< As bodies().
    [[nodiscard]] const InputDef& input_def(InputId id) const;
    [[nodiscard]] InputId find_input(std::string_view name) const noexcept;
    [[nodiscard]] double input(InputId id) const;  ///< Value last set, or that of the definition.
    /// Clamped to the range, with an event. @throws DefError outside that of what is driven.
    void set_input(InputId id, double value);
    /// Replace the applied force [N] and torque [N m], world frame. Forces of inputs and loads of
    /// systems are accounts of their own: all three add up. @throws DefError when not finite or
    /// above 1e300, as add_body() does.
    void set_force(BodyId body, const Vec3& force, const Vec3& torque);

    // --- Outputs (outputs.h) ----------------------------------------------------------------
    /// @throws DefError on a name that is taken, a target that is not there or has no such number.
    OutputId add_output(const OutputDef& def);
    /// Its value is NaN from now on, and its place goes to the next output that is added.
    /// @throws DefError on an id of nothing, or on a signal, which goes with its system.
    void remove_output(OutputId id);
    [[nodiscard]] bool alive(OutputId id) const noexcept;
    [[nodiscard]] int output_count() const noexcept;  ///< Places, as body_count().
    [[nodiscard]] std::span<const OutputId> output_ids() const noexcept;  ///< As bodies().
    [[nodiscard]] const OutputDef& output_def(OutputId id) const;  ///< With component and unit.
    [[nodiscard]] OutputId find_output(std::string_view name) const noexcept;
    [[nodiscard]] double output(OutputId id) const;  ///< Its value now, in SI units.
    /// All, by place, of the last good step or of what was set since; valid until one is added. NaN
    /// where what it is taken from, or the output itself, has been removed.
    [[nodiscard]] std::span<const double> outputs() const noexcept;

    // --- Bodies ---------------------------------------------------------------------------
    [[nodiscard]] StateView state() const noexcept;  ///< All bodies without a copy: state.h.
    /// Places of bodies: ids have an index below it. Where a body was removed one is empty.
    [[nodiscard]] int body_count() const noexcept;
    /// Of all bodies there are, ascending; valid until one is added or removed.
    [[nodiscard]] std::span<const BodyId> bodies() const noexcept;
    /// Whether an id names something: it was added here, and has not been removed.
    [[nodiscard]] bool alive(BodyId id) const noexcept;
    [[nodiscard]] bool alive(InteractionId id) const noexcept;
    [[nodiscard]] bool alive(ShapeId id) const noexcept;
    [[nodiscard]] bool alive(InputId id) const noexcept;
    /// As added, but for the group and the applied force and torque, which are those of now.
    [[nodiscard]] const BodyDef& body_def(BodyId id) const;
    [[nodiscard]] BodyId find_body(std::string_view name) const noexcept;
    [[nodiscard]] Pose pose(BodyId id) const;       ///< At time().
    [[nodiscard]] Twist velocity(BodyId id) const;  ///< At time() − h/2 (the scheme is staggered).
    [[nodiscard]] Twist predicted_velocity(BodyId id) const;  ///< 2 v − v of the step before.
    /// Move a body between steps; multipliers are kept. Velocity is used as it is (no staggering).
    /// @throws DefError as add_body() does: a position not finite or beyond 1e7 m, an orientation
    /// far from length 1, a speed not finite or beyond 1e5, a velocity for a fixed body.
    void set_pose(BodyId id, const Pose& pose);
    void set_velocity(BodyId id, const Twist& twist);
    /// Whether it sleeps (WorldDef::sleep_after). Its velocity is then that of its last step.
    [[nodiscard]] bool asleep(BodyId id) const;
    /// Wake it, and all that it holds to, in the next step; a fixed or kinematic body: all there
    /// are. All that changes a body, its forces or what acts on it wakes it anyhow.
    void wake(BodyId id);
    /// World position of a point given in the body's frame, from its centre of mass [m].
    [[nodiscard]] Vec3 world_point(BodyId id, const Vec3& local) const;
    [[nodiscard]] Vec3 local_point(BodyId id, const Vec3& point) const;  ///< The other way [m].

    // --- Interactions -----------------------------------------------------------------------
    [[nodiscard]] int interaction_count() const noexcept;  ///< Places, as body_count().
    [[nodiscard]] std::span<const InteractionId> interactions() const noexcept;  ///< As bodies().
    /// Defaults filled in.
    [[nodiscard]] const InteractionDef& interaction_def(InteractionId id) const;
    [[nodiscard]] InteractionId find_interaction(std::string_view name) const noexcept;
    /// Force of each row in the last step, along Gᵀ [N or N m]; zero before the first. Rows 0-2
    /// of ball, hinge, universal and lock are the force on body 1 in the world's axes. A line in
    /// tension has f < 0: tension = −force(id)[0].
    [[nodiscard]] std::span<const double> force(InteractionId id) const;
    /// Of a kind that has one (KindInfo::coordinate): angle of frame 1 against frame 0 about z, −π
    /// to π [rad], from where their x axes agree; way of point 1 along z of frame 0 [m]; position
    /// of a scalar body. Joints agree with what limits, drives or rubs them. @throws DefError.
    [[nodiscard]] double coordinate(InteractionId id) const;
    [[nodiscard]] double speed(InteractionId id) const;  ///< Its rate, at time() − h/2.
    /// Of a motor in the last step, positive where it pushes the coordinate up [N or N m].
    [[nodiscard]] double motor_force(InteractionId id) const;
    /// Violation g of each row at the current poses [m or rad]; 0 for velocity rows.
    [[nodiscard]] std::array<double, kMaxInteractionRows> violation(InteractionId id) const;
    [[nodiscard]] RowsView rows(InteractionId id) const;  ///< At the present poses, see inspect.h.
    [[nodiscard]] bool intact(InteractionId id) const;    ///< False once an element has parted.
    /// Whether the last step solved its rows where the step ends, not linearised
    /// (docs/theory/joints.md).
    [[nodiscard]] bool completed(InteractionId id) const;
    /// Force of each row that the geometric stiffness of the last step was taken with [N or N m]:
    /// force() before that step, or a larger one of a joint where the step was solved again
    /// (StepStats::restiffened). Zero before the first step, and behind its rows.
    [[nodiscard]] std::array<double, kMaxInteractionRows> stiffness_force(InteractionId id) const;
    /// Steps to come in which the swings of an element's wire are damped more, since it would have
    /// gained energy (StepStats::wire_repeats); 0: none, or no element of a wire.
    [[nodiscard]] int wire_alert(InteractionId id) const;

    // --- Wires (wire.h) ---------------------------------------------------------------------
    /// Lumps, elements, bends, segments; all or nothing. @throws DefError on what cannot be.
    WireId add_wire(const WireDef& def);
    /// Elements that are there, end to end, become a wire that does not own them. @throws DefError
    WireId adopt_wire(const std::string& name, std::span<const InteractionId> elements,
                      const WireTrim& trim = {});
    void set_mass(BodyId lump, double mass);  ///< [kg]; drag and applied force follow: wire.h.
    /// The first (0) or last (1) element of a wire becomes one that a drum pays out: length +
    /// radius (coordinate − that of now). Loads of friction by it end, and lumps' halves of its
    /// mass. @throws DefError where it is wound up, gone or parted, or the drum no scalar body.
    InteractionId wind_up(WireId id, int end, BodyId drum, double radius);
    /// An element becomes two, of kind end_span, about a place (guide.h); they become one again.
    std::array<InteractionId, 2> lay_over(InteractionId element, InteractionDef before,
                                          const InteractionDef& behind);
    InteractionId lift_off(InteractionId before, InteractionId behind, InteractionDef element);
    bool move_along(InteractionId before, InteractionId behind, double along, double fed);
    /// Where a piece of a line leaves its first two bodies, of a wheel its tangent point [m].
    [[nodiscard]] std::array<Vec3, 2> ends(InteractionId id) const;
    /// By how much it lies farther round the wheel at each than when defined, turns included [rad].
    [[nodiscard]] std::array<double, 2> wrapped(InteractionId id) const;
    const Removed& remove_wire(WireId id);  ///< With what add_wire() made; as remove_body().
    [[nodiscard]] std::span<const WireId> wires() const noexcept;  ///< As bodies().
    [[nodiscard]] bool alive(WireId id) const noexcept;
    [[nodiscard]] WireId find_wire(std::string_view name) const noexcept;
    [[nodiscard]] const std::string& wire_name(WireId id) const;
    /// From end to end, bodies that hold it included; what is gone is still named (alive()).
    [[nodiscard]] std::span<const BodyId> nodes(WireId id) const;
    [[nodiscard]] std::span<const InteractionId> elements(WireId id) const;
    [[nodiscard]] double length(WireId id) const;  ///< Unstretched, as drums have it now [m].
    /// In the last step, at s from 0 to length() [N]; 0: slack, parted. @throws DefError beyond.
    [[nodiscard]] double tension(WireId id, double s) const;
    /// An element parts, with an event; what it held counts as damped (Energy).
    void part(WireId id, double s);
    void part(InteractionId id);  ///< Once. @throws DefError where it is no element.
    BodyId insert_node(InteractionId element, double share, double mass = kDefault);  ///< wire.h.
    bool remove_node(BodyId node, double bend = 0.05);  ///< @return whether it went.
    [[nodiscard]] WireId wire_of(InteractionId element) const noexcept;  ///< Invalid: of none.
    WireId cut(WireId id, double s);  ///< Cut, join, attach, let go: wire.h. @throws DefError
    WireId cut(InteractionId element, double share);
    Joint join(WireId a, int end_a, WireId b, int end_b, const JoinDef& def = {});
    Joint attach(WireId id, int end, BodyId body, const Vec3& point, const JoinDef& def = {});
    Joint join(BodyId a, BodyId b, const Vec3& point, const JoinDef& def);
    void detach(WireId id, int end);
    void detach(InteractionId element, int end);
    void release(InteractionId hook);  ///< @throws DefError where it is no pelican hook.

    // --- Cuts (docs/theory/splits.md) ---------------------------------------------------------
    /// Group of a body from the next step on (BodyDef::group).
    void set_group(BodyId id, const std::string& group);
    /// Groups of all bodies by hand, from partition() for cuts of the present state: "part 0",
    /// "part 1", … Groups that follow the state end. @param parts  1, which ends groups, to 4096.
    void set_groups(int parts);
    /// From the next step on the world makes groups itself, of all bodies that have none by hand,
    /// and follows the state with them: WorldDef::parts and regroup_every. @param parts  0 to 4096;
    /// 0 ends it: groups are those by hand. @param every  0 to 1,000,000 steps. With the parts
    /// there are, groups stay as they are. @throws DefError.
    void follow_groups(int parts, int every = 60);
    /// Number of the group of each body, −1: it does not move, or has no group where the world
    /// makes none. Groups by hand come first where it does. Analyses if need be.
    [[nodiscard]] std::vector<std::int32_t> groups() const;
    /// How an interaction couples bodies of different groups, from the next step on; at first
    /// WorldDef::coupling. Joints and lines can be cut, not what drives, rubs or limits.
    void set_coupling(InteractionId id, Coupling coupling);
    [[nodiscard]] Coupling coupling(InteractionId id) const;
    /// Interactions that are cut, ascending. Analyses if need be.
    [[nodiscard]] std::vector<CutView> cuts() const;
    /// A world of the same definitions in the same state, for measuring one step against another.
    /// @param coupling  Of all interactions; none: as here. @throws DefError as set-up functions.
    [[nodiscard]] World twin(std::optional<Coupling> coupling = std::nullopt) const;
    /// Take the state of such a world. @throws DefError where definitions differ.
    void copy_state(const World& other);

    // --- Shapes and contacts ----------------------------------------------------------------
    /// Materials, the default one included, which is the first.
    [[nodiscard]] int material_count() const noexcept;
    [[nodiscard]] const MaterialDef& material_def(MaterialId id) const;
    [[nodiscard]] MaterialId find_material(std::string_view name) const noexcept;
    /// As added, in that order.
    [[nodiscard]] std::span<const MaterialPairDef> material_pairs() const noexcept;
    [[nodiscard]] int shape_count() const noexcept;                  ///< Places, as body_count().
    [[nodiscard]] std::span<const ShapeId> shapes() const noexcept;  ///< As bodies().
    [[nodiscard]] const ShapeDef& shape_def(ShapeId id) const;       ///< As added.
    [[nodiscard]] ShapeId find_shape(std::string_view name) const noexcept;
    /// Contact points at the present poses whose shapes overlap (gap < 0), ascending by their
    /// shapes. Takes no step and changes none. Forces are what the overlap and the stiffness of the
    /// contact give; laws are zeros. @throws std::bad_alloc, LimitError; DefError where a body with
    /// a shape is beyond 1e100 m.
    [[nodiscard]] std::vector<ContactView> overlaps() const;
    /// Contact points of the last step, ascending by their shapes, those that sleep last; those
    /// that are near without touching included. Empty before the first step and after restore().
    [[nodiscard]] std::vector<ContactView> contacts() const;
    void contacts(std::vector<ContactView>& out) const;  ///< In the caller's memory instead.
    /// Shapes that pressed on one then, one for each contact; also known after restore().
    void pressing(ShapeId id, std::vector<ShapeId>& out) const;
    /// 1 at places of bodies between which a segment touched something then, or was near it
    /// (contact_margin); also known after restore(). What `out` held goes. @throws std::bad_alloc.
    void touching(std::vector<std::uint8_t>& out) const;

    // --- Save and restore -------------------------------------------------------------------
    /// The whole dynamic state, warm start included. Restoring it in a world built from the
    /// same definitions continues bit for bit. Parameters are not part of it, apart from those
    /// that inputs drive.
    [[nodiscard]] std::vector<std::byte> save() const;
    void save(std::vector<std::byte>& out) const;  ///< In the caller's memory; what it held goes.
    [[nodiscard]] std::vector<std::byte> save_motion() const;  ///< Without states of systems.
    /// @throws std::bad_alloc, LimitError; DefError when the bytes are damaged or belong to another
    /// world: other pieces, step or parameters (any mass, length, stiffness, …; names, form and
    /// threads may differ). The state is then unchanged.
    void restore(std::span<const std::byte> bytes);
    void restore_variant(std::span<const std::byte> bytes);  ///< Parameters and forces may differ.
    /// What it is made of, and with a state of it, into a world of the same set-up: structure.h.
    [[nodiscard]] Structure structure() const;
    void restore(const Structure& made_of, std::span<const std::byte> bytes);  ///< All or nothing.
    [[nodiscard]] std::uint64_t identity() const;  ///< Equal: a state of one fits the other.

    // --- Inspection -------------------------------------------------------------------------
    [[nodiscard]] const WorldDef& settings() const noexcept;
    [[nodiscard]] SystemView inspect() const;  ///< See inspect.h.
    /// Parts of about equal cost of the present state, see partition.h. @throws DefError on a
    /// request that makes no sense.
    [[nodiscard]] PartitionView partition(const PartitionRequest& request) const;
    [[nodiscard]] std::size_t memory_bytes() const noexcept;  ///< Held by state and solver.

    /// From the next step on record what each thread does and when, up to so many spans of each
    /// thread (some thousand bodies: a few hundred a step); 0 ends it. What was recorded before is
    /// dropped. @throws DefError above 2^28, std::bad_alloc; the trace that there is then goes on.
    void start_trace(std::size_t spans);
    [[nodiscard]] TraceView trace(std::int64_t steps = 1'000'000) const;  ///< The last steps kept.

  private:
    friend class Attempt;
    void take_saved(std::span<const std::byte> bytes, bool variant = false);
    void restore_saved(std::span<const std::byte> bytes, bool variant);
    void copy_from(const World& other);
    void write_saved(std::vector<std::byte>& out, bool systems) const;
    void regroup_all(int parts);
    void evaluate_outputs() const noexcept;
    struct Impl;
    Owned<Impl> impl_;
};

}  // namespace hawser
