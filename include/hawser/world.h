// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file world.h
/// The world: bodies, interactions, and the step that moves them. Wires, saved states, events, the
/// solver and splits have facets (facet.h).
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
/// Set-up functions throw DefError, as does every function for an invalid id. step() does not
/// throw. A function that throws any exception leaves the world unchanged, and so does a failed
/// step. A retry gives the same bits as without the failure. An unknown name gives an invalid id.
/// One thread at a time uses a world: a second one that changes it or steps is rejected (UseError,
/// Status::in_use). Different worlds are independent. Bodies, interactions, shapes and inputs may
/// be added and removed between steps. The next step repairs its analysis, and bodies near an edit
/// wake. Velocities of later additions are used without a staggered start. Energy of edits counts
/// as edited (Energy).

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

class World : public OldWorld {
  public:
    /// Create a world.
    /// @throws DefError on a value out of range, ThreadError if the worker threads cannot be
    ///        started, EnvironmentError (see check_environment()), std::bad_alloc.
    explicit World(const WorldDef& def = {});
    ~World();                 ///< In a forked child: attempt.h.
    World(World&&) noexcept;  ///< The source may be destroyed or assigned to: attempt.h.
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
    /// Add several, all or none. A load with a factor but no interaction belongs to the first one.
    /// @param ids  As many as definitions.
    /// @throws DefError.
    void add_interactions(std::span<const InteractionDef> defs, std::span<InteractionId> ids);
    /// Add a typed definition of joints.h or lines.h; see there for the result.
    template <class Def>
    auto add(const Def& def) {
        const Attempt attempt(*this);
        return define(*this, def);
    }
    /// Add an input.
    /// @throws DefError if the parameter cannot be driven or the name is in use.
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
    /// their inputs. Friction loaded by one of these stays, without that load.
    /// @return the removed objects; valid until the next removal.
    /// @throws DefError, std::bad_alloc; without changes.
    const Removed& remove_body(BodyId id);
    /// Remove an interaction, with the inputs that drive it …
    const Removed& remove_interaction(InteractionId id);
    const Removed& remove_shape(ShapeId id);  ///< … a shape …
    const Removed& remove_input(InputId id);  ///< … or an input, whose last value remains.
    // Objects that a system holds (System::holds()) are not removed.
    // @throws DefError with its name.
    /// Set the listener for all further changes, see changes.h; null: none. It must outlive the
    /// world or be reset. A twin() has none.
    void set_change_listener(ChangeListener* listener) noexcept;
    /// Analyse now instead of in the first step. @throws std::bad_alloc, LimitError.
    void prepare();

    // --- Systems (system.h) ---------------------------------------------------------------
    /// Add a system, which acts from the next step on after the others, with outputs
    /// "system.signal".
    /// @return the same system, now owned by the world.
    /// @throws DefError on an empty name or one in use, signals with empty or equal names, or the
    ///        method `pgs` or `split`.
    System& add_system(std::unique_ptr<System> system);
    /// Remove a system.
    /// @return the system with its state.
    /// @throws DefError if it does not belong to this world.
    std::unique_ptr<System> remove_system(const System& system);
    [[nodiscard]] int system_count() const noexcept;
    [[nodiscard]] System& system(int index);  ///< In the order in which they act. @throws DefError.
    [[nodiscard]] System* find_system(std::string_view name) noexcept;  ///< Null: none.
    [[nodiscard]] const System* find_system(std::string_view name) const noexcept;
    /// Return the inputs and outputs of all systems.
    [[nodiscard]] std::span<const SystemSignal> system_signals() const noexcept;
    /// Return the value of "system.name".
    /// @throws DefError if there is none, with the nearest name.
    [[nodiscard]] double system_signal(std::string_view name) const;
    /// Set a signal, clamped to its range, with an event.
    /// @throws DefError on an unknown input or a value that is not finite.
    void set_system_signal(std::string_view name, double value);
    /// Return the loads of systems in the last or failed step, by body; valid until the next step.
    [[nodiscard]] std::vector<LoadView> loads() const;
    /// Return the loads of the last step for a recording; valid until the next step.
    [[nodiscard]] LoadRecord load_record() const;
    /// Return the reason of the last Status::bad_load or bad_edit.
    [[nodiscard]] const BadLoad& bad_load() const noexcept;

    // --- Stepping -----------------------------------------------------------------------
    /// Advance by WorldDef::step. If the status is not ok the state is the last good one.
    Status step() noexcept;
    /// Cancel the current step between parts of the factorisation or of the collisions, or else the
    /// next one at its start: Status::cancelled, with the last good state. An analysis is completed
    /// first. Other threads and signal handlers may call it: it sets a flag.
    void cancel() noexcept;
    [[nodiscard]] double time() const noexcept;  ///< [s].
    [[nodiscard]] std::int64_t step_count() const noexcept;
    [[nodiscard]] const StepStats& stats() const noexcept;
    [[nodiscard]] Energy energy() const noexcept;  ///< Energy of the state; zeros before prepare().
    /// Return the worst result over all states since the start or the last restore(). It includes
    /// the present state, or the rejected state of a diverged step.
    [[nodiscard]] Verdict verdict() const noexcept;

    // --- Inputs and applied forces --------------------------------------------------------
    [[nodiscard]] int input_count() const noexcept;                  ///< Indices, as body_count().
    [[nodiscard]] std::span<const InputId> inputs() const noexcept;  ///< As bodies().
    [[nodiscard]] const InputDef& input_def(InputId id) const;
    [[nodiscard]] InputId find_input(std::string_view name) const noexcept;
    [[nodiscard]] double input(InputId id) const;  ///< Last value set, or that of the definition.
    /// Set an input, clamped to its range, with an event.
    /// @throws DefError outside the range of the driven parameter.
    void set_input(InputId id, double value);
    /// Replace the applied force [N] and torque [N m], world frame. Forces of inputs and loads of
    /// systems are separate; all three add up.
    /// @throws DefError if not finite or above 1e300, as add_body().
    void set_force(BodyId body, const Vec3& force, const Vec3& torque);

    // --- Outputs (outputs.h) ----------------------------------------------------------------
    /// Add an output.
    /// @throws DefError on a name in use, a target that does not exist or has no such value.
    OutputId add_output(const OutputDef& def);
    /// Remove an output: its value is NaN, and the next added output gets its index.
    /// @throws DefError on an invalid id, or on a signal, which is removed with its system.
    void remove_output(OutputId id);
    [[nodiscard]] bool alive(OutputId id) const noexcept;
    [[nodiscard]] int output_count() const noexcept;  ///< Indices, as body_count().
    [[nodiscard]] std::span<const OutputId> output_ids() const noexcept;  ///< As bodies().
    [[nodiscard]] const OutputDef& output_def(OutputId id) const;  ///< With component and unit.
    [[nodiscard]] OutputId find_output(std::string_view name) const noexcept;
    [[nodiscard]] double output(OutputId id) const;  ///< Its value now, in SI units.
    /// Return all values, by index, of the last good step or later changes; valid until an
    /// addition. NaN if the output or its source has been removed.
    [[nodiscard]] std::span<const double> outputs() const noexcept;

    // --- Bodies ---------------------------------------------------------------------------
    /// Return the number of indices of bodies, including vacant ones after removals.
    [[nodiscard]] int body_count() const noexcept;
    /// Return the ids of all bodies, ascending; valid until an addition or removal.
    [[nodiscard]] std::span<const BodyId> bodies() const noexcept;
    /// Return true if an id names an existing object of this world.
    [[nodiscard]] bool alive(BodyId id) const noexcept;
    [[nodiscard]] bool alive(InteractionId id) const noexcept;
    [[nodiscard]] bool alive(ShapeId id) const noexcept;
    [[nodiscard]] bool alive(InputId id) const noexcept;
    [[nodiscard]] bool alive(WireId id) const noexcept;
    /// Return the definition as added, with the present group and applied force and torque.
    [[nodiscard]] const BodyDef& body_def(BodyId id) const;
    [[nodiscard]] BodyId find_body(std::string_view name) const noexcept;
    [[nodiscard]] Pose pose(BodyId id) const;       ///< At time().
    [[nodiscard]] Twist velocity(BodyId id) const;  ///< At time() − h/2 (the scheme is staggered).
    [[nodiscard]] Twist predicted_velocity(BodyId id) const;  ///< 2 v − v of the previous step.
    /// Move a body between steps; multipliers are kept. The velocity is used without a staggered
    /// start.
    /// @throws DefError like add_body(): if the position is not finite or beyond 1e7 m, if the
    ///        length of the orientation is far from 1. Also if the speed is not finite or beyond
    ///        1e5, or if a fixed body gets a velocity.
    void set_pose(BodyId id, const Pose& pose);
    void set_velocity(BodyId id, const Twist& twist);
    /// Return true if it sleeps (WorldDef::sleep_after). Its velocity is then that of its last
    /// step.
    [[nodiscard]] bool asleep(BodyId id) const;
    /// Wake a body and its island in the next step; a fixed or kinematic body wakes all. Changes of
    /// a body, its forces or its interactions wake it anyway.
    void wake(BodyId id);
    /// Return the world position of a point in the body's frame, from its centre of mass [m].
    [[nodiscard]] Vec3 world_point(BodyId id, const Vec3& local) const;
    [[nodiscard]] Vec3 local_point(BodyId id, const Vec3& point) const;  ///< The inverse [m].

    // --- Interactions -----------------------------------------------------------------------
    [[nodiscard]] int interaction_count() const noexcept;  ///< Indices, as body_count().
    [[nodiscard]] std::span<const InteractionId> interactions() const noexcept;  ///< As bodies().
    /// Return the definition with defaults filled in.
    [[nodiscard]] const InteractionDef& interaction_def(InteractionId id) const;
    [[nodiscard]] InteractionId find_interaction(std::string_view name) const noexcept;
    /// Return the force of each row in the last step, along Gᵀ [N or N m]; zero before the first.
    /// Rows 0-2 of ball, hinge, universal and lock are the force on body 1 in world axes. A line in
    /// tension has f < 0: tension = −force(id)[0].
    [[nodiscard]] std::span<const double> force(InteractionId id) const;
    /// Return the coordinate of an interaction whose kind has one (KindInfo::coordinate). Hinges:
    /// the angle of frame 1 relative to frame 0 about z, −π to π [rad], 0 if their x axes agree.
    /// Sliders: the distance of point 1 along z of frame 0 [m]. Scalar bodies: the position.
    /// Limits, drives and friction of a joint have the same coordinate.
    /// @throws DefError.
    [[nodiscard]] double coordinate(InteractionId id) const;
    [[nodiscard]] double speed(InteractionId id) const;  ///< Its rate, at time() − h/2.
    /// Return the force of a motor in the last step, positive if it increases the coordinate [N or
    /// N m].
    [[nodiscard]] double motor_force(InteractionId id) const;
    /// Return the violation g of each row at the present poses [m or rad]; 0 for velocity rows.
    [[nodiscard]] std::array<double, kMaxInteractionRows> violation(InteractionId id) const;
    [[nodiscard]] bool intact(InteractionId id) const;  ///< False after an element has broken.

    // --- Shapes and contacts ----------------------------------------------------------------
    /// Return the number of materials with the default one, which is the first.
    [[nodiscard]] int material_count() const noexcept;
    [[nodiscard]] const MaterialDef& material_def(MaterialId id) const;
    [[nodiscard]] MaterialId find_material(std::string_view name) const noexcept;
    /// Return the pairs as added, in that order.
    [[nodiscard]] std::span<const MaterialPairDef> material_pairs() const noexcept;
    [[nodiscard]] int shape_count() const noexcept;                  ///< Indices, as body_count().
    [[nodiscard]] std::span<const ShapeId> shapes() const noexcept;  ///< As bodies().
    [[nodiscard]] const ShapeDef& shape_def(ShapeId id) const;       ///< As added.
    [[nodiscard]] ShapeId find_shape(std::string_view name) const noexcept;
    /// Return contact points with overlap (gap < 0) at the present poses, ascending by their
    /// shapes, without a step or changes. Forces follow from overlap and contact stiffness; laws
    /// are zeros.
    /// @throws std::bad_alloc, LimitError; DefError if a body with a shape is beyond 1e100 m.
    [[nodiscard]] std::vector<ContactView> overlaps() const;
    /// Return the contact points of the last step, ascending by their shapes, sleeping ones last,
    /// with near ones without touch. Empty before the first step and after restore().
    [[nodiscard]] std::vector<ContactView> contacts() const;
    void contacts(std::vector<ContactView>& out) const;  ///< In the caller's buffer.
    /// List the shapes that pressed on one in the last step, one per contact; also after restore().
    void pressing(ShapeId id, std::vector<ShapeId>& out) const;
    /// Set 1 at indices of bodies whose segment touched or was near (contact_margin) something in
    /// the last step; also after restore(). Contents of `out` are replaced.
    /// @throws std::bad_alloc.
    void touching(std::vector<std::uint8_t>& out) const;

    // --- Copies and settings ----------------------------------------------------------------
    /// Return a world with the same definitions and state, for comparing one step with another.
    /// @param coupling  Coupling of all interactions; none: as in this world.
    /// @throws DefError as set-up functions.
    [[nodiscard]] World twin(std::optional<Coupling> coupling = std::nullopt) const;
    [[nodiscard]] const WorldDef& settings() const noexcept;  ///< As given, with later changes.

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
