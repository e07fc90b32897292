// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file system.h
/// Systems: components that act on a world at the start of each step, such as controllers, winches,
/// water.
///
/// ```cpp
/// struct Wind final : hawser::System {
///     hawser::BodyId sail;
///     double speed = 10.0, gain = 40.0;                                  // [m/s], [N s²/m²]
///     std::string_view name() const noexcept override { return "wind"; }
///     void prestep(hawser::Prestep& now, hawser::Loads& loads) noexcept override {
///         const double past = speed - now.world.velocity(sail).linear.x();
///         loads.add_force(sail, {gain * past * std::abs(past), 0, 0});
///     }
///     void signals(hawser::SignalTable& table) override {
///         table.input("speed", "m/s", speed, 0.0, 100.0);
///     }
/// };
/// Wind& wind = static_cast<Wind&>(world.add_system(std::make_unique<Wind>()));
/// ```
/// A world owns its systems. Each step calls System::prestep() of each once, in the order of
/// addition, before collision detection. A step that is solved again internally does not call them
/// again. The actions of a system belong to the step. If the step fails, the states of systems and
/// their edits are undone with the state of the world. The next call of World::step() repeats them.
/// Results do not depend on the number of threads, unless the code of a system does.

#include <hawser/def.h>
#include <hawser/id.h>
#include <hawser/interactions.h>
#include <hawser/math.h>
#include <hawser/shapes.h>
#include <hawser/state_visitor.h>
#include <hawser/stats.h>
#include <hawser/wire.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace hawser {

class World;
struct Guide;
struct GuideDef;
namespace assembly {
class LoadStore;
}
namespace marine {
class SeaSystem;
}

/// Sum of the loads on one body, to which systems add. Entries are in the order of the velocity:
/// (v, ω) of the centre of mass in the world frame. Matrices are symmetric and stored as lower
/// triangles row by row: (0,0), (1,0), (1,1), (2,0), …
struct BodyLoad {
    int freedom = 0;            ///< Degrees of freedom: 6 rigid, 3 lumped mass, 1 scalar, 0 fixed.
    double* force = nullptr;    ///< Force f, `freedom` entries [N, N m].
    double* mass = nullptr;     ///< Added mass A, 21, 6 or 1 entries [kg, kg m, kg m²].
    double* damping = nullptr;  ///< Damping D, as many entries as A [N s/m, N s, N m s].
    double* stiffness = nullptr;  ///< Stiffness K, as many entries as A [N/m, N, N m].
};
/// Return the index of entry (row, column), column ≤ row, of a symmetric matrix stored by rows of
/// its lower triangle.
[[nodiscard]] constexpr int triangle(int row, int column) noexcept {
    return row * (row + 1) / 2 + column;
}

/// Loads of systems on bodies in one step. Loads of all systems add up. They are separate from
/// applied forces (World::set_force()) and inputs. A load has a force f, an added mass A, a damping
/// D and a stiffness K:
/// ```
///     f − A v̇ − D v − K (x − x_k)
/// ```
/// Here x_k is the pose at the start of the step; f is the force at that time without the term D v.
/// The step treats A, D and K implicitly, so that they may be arbitrarily large. It solves:
/// ```
///     (M + A + h θ D + (h²/4) K) v₊ = M v + h f + (A + (h²/4) K − h (1 − θ) D) v + …
/// ```
/// The solution is of second order in h (θ: docs/theory/loads.md). For a force f(v)
/// of another form use D = −∂f/∂v and f(v) + D v.
///
/// A, D and K are symmetric and positive semi-definite. A step with other matrices, or with values
/// that are not finite, ends with Status::bad_load. Loads on fixed bodies have no effect. A body
/// with a load stays awake.
///
/// Memory: the first load on a body allocates, and later steps reuse it.
class Loads {
  public:
    explicit Loads(assembly::LoadStore& store) noexcept : store_(store) {}
    Loads(const Loads&) = delete;
    Loads& operator=(const Loads&) = delete;

    /// Return the load of a body. The pointers are valid until another body gets its first load.
    /// After reserve(), several threads may call this function for different bodies.
    [[nodiscard]] BodyLoad of(BodyId body) noexcept;
    /// Allocate the loads of these bodies, so that threads may use of() (Prestep::for_each()).
    void reserve(std::span<const BodyId> bodies) noexcept;

    /// Add a force at the centre of mass and a torque, world frame [N, N m]; scalar bodies use
    /// force.x().
    void add_force(BodyId body, const Vec3& force, const Vec3& torque = Vec3::Zero()) noexcept;
    /// Add an added mass A, a square matrix with up to six rows, in the order of the velocity. Only
    /// its lower triangle is read. Rows beyond the degrees of freedom of the body are ignored.
    template <class M>
    void add_mass(BodyId body, const M& a) noexcept {
        add(of(body), a, &BodyLoad::mass);
    }
    /// Add a damping D, in the form of add_mass().
    template <class M>
    void add_damping(BodyId body, const M& d) noexcept {
        add(of(body), d, &BodyLoad::damping);
    }
    /// Add a stiffness K, in the form of add_mass().
    template <class M>
    void add_stiffness(BodyId body, const M& k) noexcept {
        add(of(body), k, &BodyLoad::stiffness);
    }

  private:
    friend class marine::SeaSystem;
    /// Mark the following loads of the present system: true if a replay can compute them again from
    /// state, time and definition (LoadRecord).
    void repeat(bool repeatable) noexcept;

    template <class M>
    static void add(const BodyLoad& load, const M& from, double* BodyLoad::* to) noexcept {
        const int n = load.freedom < from.rows() ? load.freedom : static_cast<int>(from.rows());
        for (int i = 0; i < n; ++i)
            for (int j = 0; j <= i; ++j) (load.*to)[triangle(i, j)] += from(i, j);
    }
    assembly::LoadStore& store_;
};

/// Load on a body in the last step, World::loads().
struct LoadView {
    BodyId body{};                                            ///< Body that is loaded.
    std::span<const double> force, mass, damping, stiffness;  ///< Entries as in BodyLoad.
    double late = 0.5;  ///< Weight θ of the velocity after the step in the damping term [1].
    /// Part of the load that water exerts (System::is_water()): force, mass, damping, stiffness in
    /// sequence. It is the whole load if only water loads the body. Empty: none.
    std::span<const double> water{};
};

/// Loads of the last step that a recording must store, World::load_record(). A replay computes the
/// other loads again.
struct LoadRecord {
    /// Loads by body. Empty spans: the body had no load in the step, and a replay must not compute
    /// one for it.
    std::vector<LoadView> loads;
    /// True: loads of the sea on nodes of wires are omitted, because a replay computes them
    /// (line_sea.h). A node is listed nevertheless if another load acts on it, or if an input of
    /// one of its elements was set after the sea had acted.
    bool repeats = false;
};

/// Signal: a value of a system that other code sets or reads by name.
struct SystemSignal {
    std::string system;                ///< Name of the system.
    std::string name;                  ///< Name of the signal, unique in the system.
    std::string unit;                  ///< SI unit; "1" or "": none.
    double* value = nullptr;           ///< Value; owned by the system, valid while it lives.
    bool input = false;                ///< True: may be set, within `min` to `max`.
    double min = -1e300, max = 1e300;  ///< Range of an input [unit].
};

/// Collects the signals of a system.
class SignalTable {
  public:
    SignalTable(std::string system, std::vector<SystemSignal>& out)
        : system_(std::move(system)), out_(out) {}
    /// Add an input: a value that may be set between steps. It is part of the state, so that
    /// visit_state() must visit it.
    /// @param value  Variable of the system; it must live as long as the system.
    void input(std::string name, std::string unit, double& value, double min, double max) {
        out_.push_back({system_, std::move(name), std::move(unit), &value, true, min, max});
    }
    /// Add an output: a value that other code may read.
    void output(std::string name, std::string unit, double& value) {
        out_.push_back({system_, std::move(name), std::move(unit), &value});
    }

  private:
    std::string system_;
    std::vector<SystemSignal>& out_;
};

/// Additions and removals that systems request in one step. The world makes them in the order of
/// the requests, after all systems have acted. The current step includes them; systems can read the
/// new objects in the next step. A recording stores them like edits between steps.
///
/// The id returned by add_…() is a placeholder. Only later edits of the same step may use it. Ids
/// of existing objects keep their meaning.
///
/// All edits of a step are made, or none: if the world rejects one, the step ends with
/// Status::bad_edit. If a step fails for any reason, its edits are undone (World::step()). Memory:
/// each edit allocates, and several in one step are first tried in a copy of the definitions.
class Edits {
  public:
    /// Implementation interface.
    class Hands {
      public:
        virtual BodyId add(const BodyDef& def) noexcept = 0;
        virtual InteractionId add(const InteractionDef& def) noexcept = 0;
        virtual ShapeId add(const ShapeDef& def) noexcept = 0;
        virtual WireId add(const WireDef& def) noexcept = 0;
        virtual void remove(BodyId id) noexcept = 0;
        virtual void remove(InteractionId id) noexcept = 0;
        virtual void remove(ShapeId id) noexcept = 0;
        virtual void remove(WireId id) noexcept = 0;
        virtual void part(InteractionId id) noexcept = 0;

      protected:
        ~Hands() = default;
    };
    explicit Edits(Hands& by) noexcept : hands_(by) {}

    BodyId add_body(const BodyDef& def) noexcept { return hands_.add(def); }
    InteractionId add_interaction(const InteractionDef& def) noexcept { return hands_.add(def); }
    ShapeId add_shape(const ShapeDef& def) noexcept { return hands_.add(def); }
    WireId add_wire(const WireDef& def) noexcept { return hands_.add(def); }
    void remove_body(BodyId id) noexcept { hands_.remove(id); }
    void remove_interaction(InteractionId id) noexcept { hands_.remove(id); }
    void remove_shape(ShapeId id) noexcept { hands_.remove(id); }
    void remove_wire(WireId id) noexcept { hands_.remove(id); }
    /// Break an element of a wire, like WorldWires::part().
    void part(InteractionId id) noexcept { hands_.part(id); }

  private:
    Hands& hands_;
};

/// List of the objects that a system needs and that must not be removed (System::holds()).
class HoldTable {
  public:
    /// Add an object that the system refers to, and that must not be removed.
    void hold(BodyId id) { bodies.push_back(id); }
    void hold(InteractionId id) { interactions.push_back(id); }
    void hold(ShapeId id) { shapes.push_back(id); }
    void hold(InputId id) { inputs.push_back(id); }

    std::vector<BodyId> bodies;
    std::vector<InteractionId> interactions;
    std::vector<ShapeId> shapes;
    std::vector<InputId> inputs;
};

/// Access of a system to the step that begins: the world for reading, inputs, edits and events.
class Prestep {
  public:
    /// Implementation interface.
    class Hands {
      public:
        virtual ~Hands() = default;
        virtual void set_input(InputId id, double value) noexcept = 0;
        virtual void run(int count, void (*task)(void* context, int index) noexcept,
                         void* context) noexcept = 0;
        virtual void tell(EventKind kind, BodyId body, InteractionId interaction,
                          double value) noexcept = 0;
    };
    Prestep(const World& of, double at, double h, std::int64_t so_far, Hands& by,
            Edits::Hands& editor) noexcept
        : world(of), time(at), step(h), count(so_far), edits(editor), hands_(by) {}

    /// The world before the step: poses at `time`, velocities half a step earlier, forces of the
    /// last step. Systems must not call functions that change it or throw.
    const World& world;
    const double time;         ///< Start of the step [s].
    const double step;         ///< h [s].
    const std::int64_t count;  ///< Number of steps taken.
    Edits edits;               ///< Additions and removals.

    /// Set an input of the world, clamped to its range, as World::set_input(). A value that is not
    /// finite, or an unknown input, ends the step with Status::bad_load.
    void set_input(InputId id, double value) noexcept { hands_.set_input(id, value); }
    /// Send an event of a body or interaction at `time`. Readers (WorldEvents::since()) receive it
    /// after the step has succeeded.
    void tell(EventKind kind, BodyId body, double value) noexcept {
        hands_.tell(kind, body, {}, value);
    }
    void tell(EventKind kind, InteractionId interaction, double value) noexcept {
        hands_.tell(kind, {}, interaction, value);
    }
    /// Call f(i) for each i from 0 to n − 1 once, on the threads of the world, for example to
    /// compute loads on many bodies. f must not throw. Results do not depend on threads if f(i)
    /// writes only data of i.
    template <class F>
    void for_each(int n, F&& f) noexcept {
        using Body = std::remove_reference_t<F>;
        hands_.run(
            n, [](void* c, int i) noexcept { (*static_cast<Body*>(c))(i); },
            const_cast<std::remove_const_t<Body>*>(&f));
    }

  private:
    Hands& hands_;
};

/// Edits of the nodes of wires before a step begins (System::before_step()). Unlike Edits they are
/// made at once, before the loads and inputs of the step. They are undone if the step fails.
/// Recordings store them.
class NodeEdits {
  public:
    /// Implementation interface.
    class Hands {
      public:
        /// Save the state to which a failed step returns, before the first edit of a step.
        /// @return false if allocation fails.
        virtual bool begin() noexcept = 0;
        /// Report that an edit failed for lack of memory: the step fails.
        virtual void out_of_memory() noexcept = 0;
        /// Send an event. Readers of the world receive it after the step has succeeded.
        virtual void tell(const Event& event) noexcept = 0;

      protected:
        ~Hands() = default;
    };
    NodeEdits(World& of, Hands& by) noexcept : world(of), world_(of), hands_(by) {}
    const World& world;  ///< World after the last step and the edits made before.
    /// Insert a node as WorldWires::insert_node().
    /// @return the node; invalid: the insertion was rejected, or allocation failed.
    BodyId insert_node(InteractionId element, double share, double mass = kDefault) noexcept;
    /// Remove a node as WorldWires::remove_node().
    /// @return true if it was removed.
    bool remove_node(BodyId node, double bend = 0.05) noexcept;
    /// Divide an element at a turning point (guide.h), and add the input NAME/friction/force.
    /// @param def  Definition of the guide; its defaults are filled in.
    /// @param speed  Speed of the wire through the guide [m/s].
    /// @param out  Receives the objects of the guide.
    /// @param material  Receives the material lengths of both parts [m].
    /// @return true if it was divided; false: rejected, or allocation failed.
    bool lay_over(GuideDef& def, double speed, Guide& out, double (&material)[2]) noexcept;
    /// Unite the parts of a guide to one element, as WorldWires::disengage().
    /// @param element  Definition of the element.
    /// @return the element; invalid: rejected, or allocation failed.
    InteractionId lift_off(const Guide& guide, const InteractionDef& element) noexcept;
    /// Move the contact point along the axis of the wheel, as WorldWires::move_along().
    /// @return true if it moved.
    bool move_along(const Guide& guide, double along, double fed) noexcept;
    /// Send an event at the start of the step. Readers receive it after the step has succeeded.
    void tell(EventKind kind, InteractionId interaction, double value) noexcept;
    /// Report that allocation failed while the system chose its edits. The step then ends with
    /// Status::out_of_memory.
    void out_of_memory() noexcept { hands_.out_of_memory(); }

  private:
    World& world_;
    Hands& hands_;
};

/// Base class of a component that acts on a world at the start of each step.
class System {
  public:
    System() = default;
    virtual ~System() = default;
    System(const System&) = delete;
    System& operator=(const System&) = delete;

    /// Return the name of the system: constant, and unique among the systems of a world.
    [[nodiscard]] virtual std::string_view name() const noexcept = 0;
    /// Apply loads, inputs and edits in a step. Allocate nothing after warm-up.
    virtual void prestep(Prestep& now, Loads& loads) noexcept = 0;
    /// Insert and remove nodes before a step begins. All systems are called, in the order of
    /// addition, before the first prestep().
    virtual void before_step(NodeEdits& nodes) noexcept { static_cast<void>(nodes); }
    /// Visit all values that later steps depend on, in a fixed order and number. They are saved,
    /// restored, hashed, copied to twins, and undone if a step fails.
    virtual void visit_state(StateVisitor& visitor) { static_cast<void>(visitor); }
    /// Check a state that visit_state() has read from a snapshot, before its first use. Check
    /// indices, flags, enums, loop counts, and that used ids are alive: a valid checksum does not
    /// prove valid values. The world itself checks that numbers are finite and at most 1e300, and
    /// that inputs are within their ranges.
    /// @param world  World with its bodies and interactions, but without their restored poses.
    /// @param rules  Receives the faults.
    virtual void check_state(const World& world, StateRules& rules) const {
        static_cast<void>(world);
        static_cast<void>(rules);
    }
    /// Add the signals of the system to a table. Called once, when the system is added.
    virtual void signals(SignalTable& table) { static_cast<void>(table); }
    /// List the objects that must not be removed while the system acts. World::remove_body() and
    /// similar functions reject their removal, also as objects attached to a removed one. Called at
    /// each removal.
    virtual void holds(HoldTable& table) const { static_cast<void>(table); }
    /// Return the mass of a wire's element that this system applies as a load [kg]: half at each
    /// end, as nodes carry that of other elements (WinchDef::element). 0: none. Negative: a drum
    /// has hauled in more than the element had. Another element may take over the mass.
    [[nodiscard]] virtual double carried_mass(InteractionId element) const noexcept {
        static_cast<void>(element);
        return 0.0;
    }
    /// Return the length that a drum of this system has paid out of an element since the start [m].
    /// It includes parts that have become elements (OutputKind::drum). Negative: hauled in.
    /// kDefault: this system does not count it.
    [[nodiscard]] virtual double paid_out(const World& world,
                                          InteractionId element) const noexcept {
        static_cast<void>(world);
        static_cast<void>(element);
        return kDefault;
    }
    /// Return true if the loads of the system are those of water and count in Energy::water. The
    /// result must be constant.
    [[nodiscard]] virtual bool is_water() const noexcept { return false; }
    /// Return true if the system would save more work at a higher level of
    /// WorldSolver::coarsening().
    [[nodiscard]] virtual bool coarsens() const noexcept { return false; }
    /// Return a new system with the same definition, for World::twin(), which then copies the
    /// state. Null: a world with this system cannot have a twin.
    [[nodiscard]] virtual std::unique_ptr<System> clone() const { return nullptr; }
};

/// Reason why a step ended with Status::bad_load or Status::bad_edit.
struct BadLoad {
    std::string_view system{};  ///< Name of the system; valid while the system lives. "": no fault.
    BodyId body{};              ///< Body of a rejected load; invalid: no body of the world.
    InputId input{};            ///< Input of a rejected value; invalid: no input of the world.
    bool of_input = false;      ///< True: an input was rejected; false: a load or an edit.
    bool of_edit = false;     ///< True: an addition or removal was rejected; `reason` has details.
    const char* reason = "";  ///< Reason in words; valid until the next step.
};
/// Return a sentence with the system, the body and the remedy.
/// @param world  World of the failed step.
[[nodiscard]] std::string to_string(const BadLoad& load, const World& world);

}  // namespace hawser
