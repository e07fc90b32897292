// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file world.h
/// World: bodies, interactions, and the step that moves them.
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
/// *Time*. The scheme is staggered: at time() = t, poses belong to t and velocities to t − h/2,
/// with the step h. See docs/theory/step.md.
///
/// *Facets*. Wires, states, events, the solver and splits have objects of their own, such as
/// World::wires() (facet.h).
///
/// *Errors*. Set-up functions, and every function with an invalid id, throw DefError. step() does
/// not throw. A function that throws leaves the world unchanged, and so does a failed step; a retry
/// gives the same bits as without the failure. A search for an unknown name returns an invalid id.
///
/// *Threads*. One thread at a time may use a world. A second one that changes it or steps is
/// rejected (UseError, Status::in_use). Different worlds are independent.
///
/// *Edits*. Bodies, interactions, shapes and inputs may be added and removed between steps. The
/// next step repairs its analysis, and bodies near an edit wake. Velocities of bodies that are
/// added later belong to time() − h/2 already (no staggered start). Energy of edits counts as
/// edited (Energy).

#include <hawser/attempt.h>
#include <hawser/def.h>
#include <hawser/edits.h>
#include <hawser/id.h>
#include <hawser/interactions.h>
#include <hawser/machine.h>
#include <hawser/math.h>
#include <hawser/old_world.h>
#include <hawser/outputs.h>
#include <hawser/shapes.h>
#include <hawser/stats.h>
#include <hawser/system.h>
#include <hawser/world_events.h>
#include <hawser/world_solver.h>
#include <hawser/world_state.h>
#include <hawser/world_wires.h>

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

class ChangeListener;   // changes.h
class WorldSplits;      // experimental/splits.h
class WorldSplitsView;  // experimental/splits.h

/// A system of bodies with its solver.
class World : public OldWorld {
  public:
    /// Create a world.
    /// @throws DefError on a value out of range, ThreadError if the worker threads cannot be
    ///        started, EnvironmentError (see check_environment()), std::bad_alloc.
    explicit World(const WorldDef& def = {});
    ~World();  ///< Ends the worker threads. A forked child has none and does not wait.
    World(World&&) noexcept;  ///< The source may then only be destroyed or assigned to.
    World& operator=(World&&) noexcept;
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    // --- Facets (facet.h) -----------------------------------------------------------------
    /// Return the wires: add, cut, join, spool; nodes, length, tension (world_wires.h).
    [[nodiscard]] WorldWires wires() noexcept { return WorldWires(*this); }
    [[nodiscard]] WorldWiresView wires() const noexcept { return WorldWiresView(*this); }
    /// Return the dynamic state: save, restore, hash, arrays of poses (world_state.h).
    [[nodiscard]] WorldState state() noexcept { return WorldState(*this); }
    [[nodiscard]] WorldStateView state() const noexcept { return WorldStateView(*this); }
    /// Return the events (world_events.h).
    [[nodiscard]] WorldEvents events() noexcept { return WorldEvents(*this); }
    [[nodiscard]] WorldEventsView events() const noexcept { return WorldEventsView(*this); }
    /// Return the solver: matrix, rows, trace, memory (world_solver.h).
    [[nodiscard]] WorldSolver solver() noexcept { return WorldSolver(*this); }
    [[nodiscard]] WorldSolverView solver() const noexcept { return WorldSolverView(*this); }
    /// Return the splits: groups, couplings, cuts. Experimental; include
    /// <hawser/experimental/splits.h>.
    [[nodiscard]] WorldSplits splits() noexcept;
    [[nodiscard]] WorldSplitsView splits() const noexcept;

    // --- Set-up -------------------------------------------------------------------------
    /// Add a body.
    /// @throws DefError on a duplicate name, a mass or inertia that is not positive definite, a
    ///        value that is not finite.
    BodyId add_body(const BodyDef& def);
    /// Add an interaction.
    /// @throws DefError on unknown bodies, no moving body, a parameter missing or out of range.
    InteractionId add_interaction(const InteractionDef& def);
    /// Add several interactions, all or none. A friction load with a factor but without an
    /// interaction refers to the first of them.
    /// @param ids  Receives the ids; as many as definitions.
    /// @throws DefError as add_interaction().
    void add_interactions(std::span<const InteractionDef> defs, std::span<InteractionId> ids);
    /// Add a typed definition, such as HingeDef, GuideDef or SeaDef: all of its parts or none. The
    /// result is that of the function define() in the header of the definition.
    template <class Def>
    auto add(const Def& def) {
        const Attempt attempt(*this);
        return define(*this, def);
    }
    /// Add an input.
    /// @throws DefError if an input cannot drive the parameter (ParamInfo::input), or if the name
    /// is
    ///        in use.
    InputId add_input(const InputDef& def);
    /// Add a material.
    /// @throws DefError on a name in use, a value out of range.
    MaterialId add_material(const MaterialDef& def);
    /// Add a pair of materials, which replaces an earlier pair of the same two.
    /// @throws DefError on an unknown material, a value out of range.
    void add_material_pair(const MaterialPairDef& def);
    /// Add a shape.
    /// @throws DefError on a body that cannot have such a shape, sizes out of range, a name in use,
    ///        vertices that span no volume.
    ShapeId add_shape(const ShapeDef& def);
    /// Remove a body with its interactions, its shapes, the segments of wires that end at it, and
    /// their inputs. Friction loaded by a removed interaction remains, without that load.
    /// @return the removed objects; valid until the next removal.
    /// @throws DefError if a system needs one of them (System::holds()), with the system's name
    /// @throws std::bad_alloc
    const Removed& remove_body(BodyId id);
    /// Remove an interaction and the inputs that drive it. Result and exceptions as remove_body().
    const Removed& remove_interaction(InteractionId id);
    /// Remove a shape. Result and exceptions as remove_body().
    const Removed& remove_shape(ShapeId id);
    /// Remove an input. Its last value remains in effect. Result and exceptions as remove_body().
    const Removed& remove_input(InputId id);
    /// Set the listener for all further changes (changes.h); null: none. It must outlive the world
    /// or be reset. A twin() has no listener.
    void set_change_listener(ChangeListener* listener) noexcept;
    /// Analyse the model now instead of in the first step.
    /// @throws std::bad_alloc, LimitError.
    void prepare();

    // --- Systems (system.h) ---------------------------------------------------------------
    /// Add a system. It acts from the next step on, after the systems added before. Each of its
    /// signals becomes an output "system.signal".
    /// @return the added system, now owned by the world.
    /// @throws DefError on an empty name or one in use, signals with empty or equal names, or the
    ///        method `pgs` or `split`.
    System& add_system(std::unique_ptr<System> system);
    /// Remove a system.
    /// @return the system with its state.
    /// @throws DefError if it does not belong to this world.
    std::unique_ptr<System> remove_system(const System& system);
    [[nodiscard]] int system_count() const noexcept;  ///< Number of systems.
    /// Return a system by its index in the order in which systems act.
    /// @throws DefError if the index is out of range.
    [[nodiscard]] System& system(int index);
    /// Return the system with this name; null: none.
    [[nodiscard]] System* find_system(std::string_view name) noexcept;
    [[nodiscard]] const System* find_system(std::string_view name) const noexcept;
    /// Return the signals (inputs and outputs) of all systems.
    [[nodiscard]] std::span<const SystemSignal> system_signals() const noexcept;
    /// Return the value of a signal, in its unit.
    /// @param name  "system.signal".
    /// @throws DefError if the signal does not exist, with the nearest name.
    [[nodiscard]] double system_signal(std::string_view name) const;
    /// Set an input signal. A value outside its range is clamped, with the event `input_clamped`.
    /// @param name  "system.signal".
    /// @throws DefError on an unknown input or a value that is not finite.
    void set_system_signal(std::string_view name, double value);
    /// Return the loads of systems on each body in the last step, also in a failed one. Valid until
    /// the next step.
    [[nodiscard]] std::vector<LoadView> loads() const;
    /// Return the loads of the last step that a recording must store; valid until the next step.
    [[nodiscard]] LoadRecord load_record() const;
    /// Return the reason of the last Status::bad_load or Status::bad_edit.
    [[nodiscard]] const BadLoad& bad_load() const noexcept;

    // --- Stepping -----------------------------------------------------------------------
    /// Advance the world by WorldDef::step.
    /// @return ok; any other status: the step failed, and the world keeps the state before it.
    Status step() noexcept;
    /// Cancel the current step, or the next one if none is running. It returns Status::cancelled,
    /// and the state before it remains. The step ends between two parts of the factorisation or of
    /// collision detection; an analysis is completed first. Other threads and signal handlers may
    /// call this function: it sets a flag.
    void cancel() noexcept;
    [[nodiscard]] double time() const noexcept;              ///< Simulated time [s].
    [[nodiscard]] std::int64_t step_count() const noexcept;  ///< Number of completed steps.
    [[nodiscard]] const StepStats& stats() const noexcept;   ///< Figures of the last step.
    [[nodiscard]] Energy energy() const noexcept;  ///< Energy of the state; zeros before prepare().
    /// Return the result of the monitors: the worst over all states since the start or the last
    /// restore(). It includes the present state, or the rejected state of a diverged step.
    [[nodiscard]] Verdict verdict() const noexcept;

    // --- Inputs and applied forces --------------------------------------------------------
    [[nodiscard]] int input_count() const noexcept;  ///< Number of indices, as body_count().
    [[nodiscard]] std::span<const InputId> inputs() const noexcept;  ///< All ids, as bodies().
    [[nodiscard]] const InputDef& input_def(InputId id) const;       ///< Definition as added.
    /// Return the input with this name; invalid: none.
    [[nodiscard]] InputId find_input(std::string_view name) const noexcept;
    /// Return the value of an input: the last one set. Initially it is the value of the driven
    /// parameter, or 0 for a force or torque.
    [[nodiscard]] double input(InputId id) const;
    /// Set an input. A value outside InputDef::min to max is clamped, with the event
    /// `input_clamped`.
    /// @throws DefError if the value is outside the range of the driven parameter.
    void set_input(InputId id, double value);
    /// Replace the applied force [N] and torque [N m] of a body (BodyDef::force, torque), world
    /// frame. Forces of inputs and loads of systems are separate; all three add up.
    /// @throws DefError if a component is not finite or above 1e300, as add_body().
    void set_force(BodyId body, const Vec3& force, const Vec3& torque);

    // --- Outputs (outputs.h) ----------------------------------------------------------------
    /// Add an output.
    /// @throws DefError on a name in use, a target that does not exist or has no such value.
    OutputId add_output(const OutputDef& def);
    /// Remove an output: its value is NaN, and the next added output gets its index.
    /// @throws DefError on an invalid id, or on a signal, which is removed with its system.
    void remove_output(OutputId id);
    [[nodiscard]] bool alive(OutputId id) const noexcept;  ///< True if the output exists.
    [[nodiscard]] int output_count() const noexcept;       ///< Number of indices, as body_count().
    [[nodiscard]] std::span<const OutputId> output_ids() const noexcept;  ///< All ids, as bodies().
    /// Return the definition with component and unit filled in.
    [[nodiscard]] const OutputDef& output_def(OutputId id) const;
    /// Return the output with this name; invalid: none.
    [[nodiscard]] OutputId find_output(std::string_view name) const noexcept;
    [[nodiscard]] double output(OutputId id) const;  ///< Present value, in SI units.
    /// Return the values of all outputs by index, after the last good step or later changes. Valid
    /// until an addition. NaN if the output or its source has been removed.
    [[nodiscard]] std::span<const double> outputs() const noexcept;

    // --- Bodies ---------------------------------------------------------------------------
    /// Return the number of indices of bodies, that is the size of arrays by body. Indices of
    /// removed bodies count, too.
    [[nodiscard]] int body_count() const noexcept;
    /// Return the ids of all existing bodies, ascending; valid until an addition or removal.
    [[nodiscard]] std::span<const BodyId> bodies() const noexcept;
    /// Return true if the object of an id exists in this world.
    [[nodiscard]] bool alive(BodyId id) const noexcept;
    [[nodiscard]] bool alive(InteractionId id) const noexcept;
    [[nodiscard]] bool alive(ShapeId id) const noexcept;
    [[nodiscard]] bool alive(InputId id) const noexcept;
    [[nodiscard]] bool alive(WireId id) const noexcept;
    /// Return the definition as added, with the present group and applied force and torque.
    [[nodiscard]] const BodyDef& body_def(BodyId id) const;
    /// Return the body with this name; invalid: none.
    [[nodiscard]] BodyId find_body(std::string_view name) const noexcept;
    [[nodiscard]] Pose pose(BodyId id) const;       ///< Pose at time(), world frame.
    [[nodiscard]] Twist velocity(BodyId id) const;  ///< Velocity at time() − h/2, world frame.
    /// Return the velocity extrapolated to time() + h/2, 2 v_k − v_{k−1} of the last two steps. For
    /// a fixed or kinematic body: velocity().
    [[nodiscard]] Twist predicted_velocity(BodyId id) const;
    /// Set the pose of a body between steps. Multipliers of its interactions remain, as start
    /// values of the next step.
    /// @throws DefError if the position is not finite or beyond 1e7 m, or if the length of the
    ///        quaternion is far from 1.
    void set_pose(BodyId id, const Pose& pose);
    /// Set the velocity of a body at time() − h/2 (no staggered start), or the prescribed velocity
    /// of a kinematic body.
    /// @throws DefError if the speed is not finite or beyond 1e5, or if a fixed body gets a
    /// velocity.
    void set_velocity(BodyId id, const Twist& twist);
    /// Return true if the body sleeps (WorldDef::sleep_after). Its velocity is then that of its
    /// last step before it slept.
    [[nodiscard]] bool asleep(BodyId id) const;
    /// Wake a body and its island in the next step; a fixed or kinematic body wakes all islands.
    /// Changes of a body, its forces or its interactions wake it without this call.
    void wake(BodyId id);
    /// Return the position in the world frame of a point given in a body's frame [m].
    /// @param local  Point from the centre of mass [m].
    [[nodiscard]] Vec3 world_point(BodyId id, const Vec3& local) const;
    /// Return the position in a body's frame, from its centre of mass, of a point in the world
    /// frame [m].
    [[nodiscard]] Vec3 local_point(BodyId id, const Vec3& point) const;

    // --- Interactions -----------------------------------------------------------------------
    [[nodiscard]] int interaction_count() const noexcept;  ///< Number of indices, as body_count().
    /// Return the ids of all interactions, as bodies().
    [[nodiscard]] std::span<const InteractionId> interactions() const noexcept;
    /// Return the definition with defaults filled in.
    [[nodiscard]] const InteractionDef& interaction_def(InteractionId id) const;
    /// Return the interaction with this name; invalid: none.
    [[nodiscard]] InteractionId find_interaction(std::string_view name) const noexcept;
    /// Return the force of each row in the last step, along Gᵀ [N or N m]; zero before the first.
    /// Rows 0-2 of ball, hinge, universal and lock are the force on body 1 in world axes. A line in
    /// tension has f < 0: tension = −force(id)[0].
    [[nodiscard]] std::span<const double> force(InteractionId id) const;
    /// Return the coordinate of an interaction whose kind has one (KindInfo::coordinate). Hinges:
    /// the angle of frame 1 relative to frame 0 about z, −π to π [rad], 0 if their x axes agree.
    /// Sliders: the distance of point 1 from point 0 along z of frame 0 [m]. Scalar bodies: the
    /// position [m or rad]. Limits, motors and friction of a joint have the same coordinate.
    /// @throws DefError if the kind has no coordinate.
    [[nodiscard]] double coordinate(InteractionId id) const;
    /// Return the rate of coordinate() at time() − h/2 [m/s or rad/s].
    [[nodiscard]] double speed(InteractionId id) const;
    /// Return the force of a motor in the last step, positive if it increases the coordinate [N or
    /// N m].
    [[nodiscard]] double motor_force(InteractionId id) const;
    /// Return the violation g of each row at the present poses [m or rad]; 0 for velocity rows.
    [[nodiscard]] std::array<double, kMaxInteractionRows> violation(InteractionId id) const;
    /// Return true unless the interaction is an element of a line that has broken.
    [[nodiscard]] bool intact(InteractionId id) const;

    // --- Shapes and contacts ----------------------------------------------------------------
    /// Return the number of materials, including the default material, which is the first.
    [[nodiscard]] int material_count() const noexcept;
    [[nodiscard]] const MaterialDef& material_def(MaterialId id) const;  ///< Definition as added.
    /// Return the material with this name; invalid: none.
    [[nodiscard]] MaterialId find_material(std::string_view name) const noexcept;
    /// Return the pairs of materials in the order of their addition.
    [[nodiscard]] std::span<const MaterialPairDef> material_pairs() const noexcept;
    [[nodiscard]] int shape_count() const noexcept;  ///< Number of indices, as body_count().
    [[nodiscard]] std::span<const ShapeId> shapes() const noexcept;  ///< All ids, as bodies().
    [[nodiscard]] const ShapeDef& shape_def(ShapeId id) const;       ///< Definition as added.
    /// Return the shape with this name; invalid: none.
    [[nodiscard]] ShapeId find_shape(std::string_view name) const noexcept;
    /// Compute the contact points with overlap (gap < 0) at the present poses, ascending by their
    /// shapes. The world is not changed, and no step is needed. Forces follow from overlap and
    /// contact stiffness; the members for verification are zeros.
    /// @throws std::bad_alloc, LimitError; DefError if a body with a shape is beyond 1e100 m.
    [[nodiscard]] std::vector<ContactView> overlaps() const;
    /// Return the contact points of the last step, including those that do not touch yet. They are
    /// ascending by their shapes; contacts of sleeping bodies are last. Empty before the first step
    /// and after restore().
    [[nodiscard]] std::vector<ContactView> contacts() const;
    void contacts(std::vector<ContactView>& out) const;  ///< The same, in the caller's buffer.
    /// List the shapes that pressed on a shape in the last step, one entry per contact point. Also
    /// valid after restore().
    /// @param out  Its contents are replaced.
    void pressing(ShapeId id, std::vector<ShapeId>& out) const;
    /// List the bodies whose segment had a contact point in the last step, touching or nearer than
    /// contact_margin. Also valid after restore().
    /// @param out  Its contents are replaced: 1 at the indices of these bodies, else 0.
    /// @throws std::bad_alloc.
    void touching(std::vector<std::uint8_t>& out) const;

    // --- Copies and settings ----------------------------------------------------------------
    /// Return another world with equal definitions and state, for example to compare two couplings.
    /// @param coupling  Coupling of all interactions; none: as in this world.
    /// @throws DefError if a system cannot be copied (System::clone()), or as set-up functions.
    [[nodiscard]] World twin(std::optional<Coupling> coupling = std::nullopt) const;
    /// Return the settings as given, with later changes (WorldSplits::follow_groups()).
    [[nodiscard]] const WorldDef& settings() const noexcept;

  private:
    friend class Attempt;
    friend class Facet;
    friend struct WorldImpl;
    void evaluate_outputs() const noexcept;
    using Impl = WorldImpl;
    Owned<WorldImpl> impl_;
};

inline WorldWires::WorldWires(World& world) noexcept : WorldWiresView(world) {}
inline WorldState::WorldState(World& world) noexcept : WorldStateView(world) {}
inline WorldEvents::WorldEvents(World& world) noexcept : WorldEventsView(world) {}
inline WorldSolver::WorldSolver(World& world) noexcept : WorldSolverView(world) {}

}  // namespace hawser
