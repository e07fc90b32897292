// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file system.h
/// Systems: what acts on a world at the beginning of each step. Controllers, winches, water.
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
/// A world owns its systems. Each step calls them once, in the order in which they were added,
/// before bodies that touch are looked for; a step that is solved again within itself calls them no
/// second time. What a system did belongs to the step: where that fails, the states of systems and
/// their edits go back with the state of the world, and the next call repeats it. Results do not
/// depend on threads as long as a system's own numbers do not.

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
namespace stepper {
class LoadStore;
}

/// What the loads of one body add up to, to be added to. A body's velocity is (v, ω) of its centre
/// of mass in the world frame; matrices are symmetric and hold their lower triangle row by row:
/// (0,0), (1,0), (1,1), (2,0), …
struct BodyLoad {
    int freedom = 0;              ///< Of the body: 6 rigid, 3 lump, 1 scalar, 0 does not move.
    double* force = nullptr;      ///< `freedom` entries [N, N m].
    double* mass = nullptr;       ///< A [kg, kg m, kg m²]: 21, 6 or 1 entries.
    double* damping = nullptr;    ///< D [N s/m, N s, N m s], as many.
    double* stiffness = nullptr;  ///< K [N/m, N, N m], as many.
};
/// Place of entry (row, column), column ≤ row, of such a matrix.
[[nodiscard]] constexpr int triangle(int row, int column) noexcept {
    return row * (row + 1) / 2 + column;
}

/// Loads that systems put on bodies in one step; those of all systems add up, and are apart from
/// applied forces (World::set_force()) and inputs. A load is
/// ```
///     f − A v̇ − D v − K (x − x_k)
/// ```
/// with x_k the pose at which the step begins: f is the force there and then, without what D makes.
/// The step takes A, D and K implicitly, so that no load of them is too large for it, and solves
/// ```
///     (M + A + h θ D + (h²/4) K) v₊ = M v + h f + (A + (h²/4) K − h (1 − θ) D) v + …
/// ```
/// of second order in h (docs/theory/loads.md; θ there). A force f(v) that depends
/// on the velocity otherwise goes in as D = −∂f/∂v and f(v) + D v.
///
/// A, D and K are symmetric and positive semi-definite: a step with others, or with what is not
/// finite, ends with Status::bad_load. Loads on bodies that do not move have no effect. A body with
/// a load stays awake.
///
/// Memory: the first load on a body makes room for it, which later steps keep.
class Loads {
  public:
    explicit Loads(stepper::LoadStore& store) noexcept : store_(store) {}
    Loads(const Loads&) = delete;
    Loads& operator=(const Loads&) = delete;

    /// The load of a body. Good until a body gets its first load. By several threads at once, each
    /// with bodies of its own, for bodies that reserve() has named.
    [[nodiscard]] BodyLoad of(BodyId body) noexcept;
    /// Room for loads on these bodies, so that threads may use of() (Prestep::for_each()).
    void reserve(std::span<const BodyId> bodies) noexcept;

    /// Force at the centre of mass and torque, world frame [N, N m]; scalar: force.x().
    void add_force(BodyId body, const Vec3& force, const Vec3& torque = Vec3::Zero()) noexcept;
    /// Square matrices of up to six rows; of what a body has no freedom for nothing counts. Only
    /// lower triangles are read.
    template <class M>
    void add_mass(BodyId body, const M& a) noexcept {
        add(of(body), a, &BodyLoad::mass);
    }
    template <class M>
    void add_damping(BodyId body, const M& d) noexcept {
        add(of(body), d, &BodyLoad::damping);
    }
    template <class M>
    void add_stiffness(BodyId body, const M& k) noexcept {
        add(of(body), k, &BodyLoad::stiffness);
    }

  private:
    template <class M>
    static void add(const BodyLoad& load, const M& from, double* BodyLoad::* to) noexcept {
        const int n = load.freedom < from.rows() ? load.freedom : static_cast<int>(from.rows());
        for (int i = 0; i < n; ++i)
            for (int j = 0; j <= i; ++j) (load.*to)[triangle(i, j)] += from(i, j);
    }
    stepper::LoadStore& store_;
};

/// A load of the last step as it was taken, for readers.
struct LoadView {
    BodyId body{};
    std::span<const double> force, mass, damping, stiffness;  ///< As in BodyLoad.
    double late = 0.5;  ///< θ: share of D that the velocity after the step sees.
};

/// A number of a system that others set or read by name.
struct SystemSignal {
    std::string system;       ///< System::name().
    std::string name;         ///< Unique in the system.
    std::string unit;         ///< SI.
    double* value = nullptr;  ///< The system's own; lives as long as the system.
    bool input = false;       ///< It may be set, within the range.
    double min = -1e300, max = 1e300;
};

/// Takes the signals of a system.
class SignalTable {
  public:
    SignalTable(std::string system, std::vector<SystemSignal>& out)
        : system_(std::move(system)), out_(out) {}
    /// A number that may be set between steps. It belongs to the state: visit_state() has to visit
    /// it.
    void input(std::string name, std::string unit, double& value, double min, double max) {
        out_.push_back({system_, std::move(name), std::move(unit), &value, true, min, max});
    }
    /// A number to be read.
    void output(std::string name, std::string unit, double& value) {
        out_.push_back({system_, std::move(name), std::move(unit), &value});
    }

  private:
    std::string system_;
    std::vector<SystemSignal>& out_;
};

/// Additions and removals that systems ask for in one step. They are done in the order in which
/// they were asked for, once all systems have acted: the step that begins has them, the systems see
/// them in the next one. A recording keeps them as those that are made between steps.
///
/// What add_…() returns stands for what will be there: later edits of the same step may name it,
/// nothing else may. Ids of things that are there already mean themselves.
///
/// All or none: where the world refuses one, the step ends with Status::bad_edit. Whatever a step
/// fails for, edits that were made are undone with the rest of the step (World::step()).
/// Memory: each edit takes some, and several in one step are first tried in a copy of the
/// definitions.
class Edits {
  public:
    /// What stands behind it.
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
    /// An element of a wire parts, as World::part() has it.
    void part(InteractionId id) noexcept { hands_.part(id); }

  private:
    Hands& hands_;
};

/// Takes what a system cannot do without (System::holds()).
class HoldTable {
  public:
    void hold(BodyId id) { bodies.push_back(id); }
    void hold(InteractionId id) { interactions.push_back(id); }
    void hold(ShapeId id) { shapes.push_back(id); }
    void hold(InputId id) { inputs.push_back(id); }

    std::vector<BodyId> bodies;
    std::vector<InteractionId> interactions;
    std::vector<ShapeId> shapes;
    std::vector<InputId> inputs;
};

/// What a system sees of the step that begins, and may do to it.
class Prestep {
  public:
    /// What stands behind it.
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
    /// last step. Functions that would change it or throw are not for a system.
    const World& world;
    const double time;         ///< Where the step begins [s].
    const double step;         ///< h [s].
    const std::int64_t count;  ///< Steps taken so far.
    Edits edits;               ///< What is to come and to go.

    /// Set an input of the world, as World::set_input() does between steps: clamped to its range.
    /// Not finite, or an input that is not there: the step ends with Status::bad_load.
    void set_input(InputId id, double value) noexcept { hands_.set_input(id, value); }
    /// Something has happened, which readers of World::events_since() are to know: an event of
    /// `time`, once the step is good.
    void tell(EventKind kind, BodyId body, double value) noexcept {
        hands_.tell(kind, body, {}, value);
    }
    void tell(EventKind kind, InteractionId interaction, double value) noexcept {
        hands_.tell(kind, {}, interaction, value);
    }
    /// f(i) for i in [0, n), each once, on the threads of the world: for loads on many bodies. Each
    /// i writes what is its own, so that nothing depends on threads. f must not throw.
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

/// Nodes of wires that come and go before a step begins (System::before_step()). Unlike Edits they
/// are made at once: loads and inputs of the step meet the wire as it is then. They are undone if
/// the step fails. Recordings keep them.
class NodeEdits {
  public:
    /// What stands behind it.
    class Hands {
      public:
        /// Before the first edit of a step: copy the state to which a failed step returns.
        /// @return false: no memory.
        virtual bool begin() noexcept = 0;
        /// An edit has failed for want of memory: the step fails.
        virtual void out_of_memory() noexcept = 0;
        /// Report an event of the step.
        virtual void tell(const Event& event) noexcept = 0;

      protected:
        ~Hands() = default;
    };
    NodeEdits(World& of, Hands& by) noexcept : world(of), world_(of), hands_(by) {}
    const World& world;  ///< As the last step left it, and earlier edits.
    /// As World::insert_node(). @return the lump; invalid: the world refused it, or has no memory.
    BodyId insert_node(InteractionId element, double share, double mass = kDefault) noexcept;
    /// As World::remove_node(). @return whether it went.
    bool remove_node(BodyId node, double bend = 0.05) noexcept;
    /// An element comes to lie on what it touches (guide.h), running by `speed` [m/s]; with the
    /// input NAME/friction/force. @param def  Defaults are filled in. @param material  Of the parts
    /// [m]. @return false: refused, or no memory.
    bool lay_over(GuideDef& def, double speed, Guide& out, double (&material)[2]) noexcept;
    /// As World::lift_off(). @return invalid: refused, or no memory.
    InteractionId lift_off(const Guide& guide, const InteractionDef& element) noexcept;
    /// As World::move_along(). @return whether it went.
    bool move_along(const Guide& guide, double along, double fed) noexcept;
    /// Report an event of the time at which the step begins, once the step is good.
    void tell(EventKind kind, InteractionId interaction, double value) noexcept;
    /// The system has no memory to choose its edits: the step ends with Status::out_of_memory.
    void out_of_memory() noexcept { hands_.out_of_memory(); }

  private:
    World& world_;
    Hands& hands_;
};

/// Acts on a world at the beginning of each step.
class System {
  public:
    System() = default;
    virtual ~System() = default;
    System(const System&) = delete;
    System& operator=(const System&) = delete;

    /// Unique among the systems of a world; stays the same.
    [[nodiscard]] virtual std::string_view name() const noexcept = 0;
    /// Once a step. Allocates nothing once it is warm.
    virtual void prestep(Prestep& now, Loads& loads) noexcept = 0;
    /// Before a step begins, in the same order; prestep() of all of them follows.
    virtual void before_step(NodeEdits& nodes) noexcept { static_cast<void>(nodes); }
    /// All numbers that later steps depend on, in a fixed order and number: they are saved,
    /// restored, hashed, copied to twins, and taken back where a step fails.
    virtual void visit_state(StateVisitor& visitor) { static_cast<void>(visitor); }
    /// Check a state that visit_state() has read from a snapshot, before anything acts on it: a
    /// right checksum does not make sense of the numbers. Check indices, flags, enums, counts of
    /// loops, and ids, which have to be alive where they are used. The world checks by itself that
    /// numbers are finite and up to 1e300, and inputs among the signals within their ranges.
    /// @param world  Has its bodies and interactions, but not yet their restored poses.
    virtual void check_state(const World& world, StateRules& rules) const {
        static_cast<void>(world);
        static_cast<void>(rules);
    }
    /// Numbers with names for others. Asked for once, when it is added.
    virtual void signals(SignalTable& table) { static_cast<void>(table); }
    /// What must not be removed while it acts: World::remove_body() and its like refuse it,
    /// whatever else it hangs on included. Asked for at each removal.
    virtual void holds(HoldTable& table) const { static_cast<void>(table); }
    /// Mass of an element of a wire whose ends it loads with half each, as lumps have that of
    /// others (WinchDef::element) [kg]; 0: it does not; below 0: a drum has hauled in more than
    /// there was, and the account is the system's all the same. What goes on as another element
    /// takes it over.
    [[nodiscard]] virtual double carried_mass(InteractionId element) const noexcept {
        static_cast<void>(element);
        return 0.0;
    }
    /// Line that a drum of this system has paid out of an element in the state that there is, from
    /// the start on, also what has become elements of its own since (OutputKind::drum) [m];
    /// negative: hauled in. kDefault: it keeps no account of this element.
    [[nodiscard]] virtual double paid_out(const World& world,
                                          InteractionId element) const noexcept {
        static_cast<void>(world);
        static_cast<void>(element);
        return kDefault;
    }
    /// Whether its loads are those of water (Energy::water); stays the same.
    [[nodiscard]] virtual bool is_water() const noexcept { return false; }
    /// Whether a higher level of World::coarsening() would have it leave out more.
    [[nodiscard]] virtual bool coarsens() const noexcept { return false; }
    /// Another one with the same definition, for World::twin(), which then copies the state; null:
    /// a world with this system has no twin.
    [[nodiscard]] virtual std::unique_ptr<System> clone() const { return nullptr; }
};

/// Why a step ended with Status::bad_load or Status::bad_edit; empty: no reason.
struct BadLoad {
    std::string_view system{};  ///< Its name, while it lives.
    BodyId body{};              ///< On which; invalid: no body of the world.
    InputId input{};            ///< Or what it wanted to set, where that is valid.
    bool of_input = false;      ///< The value or id of an input, not a load.
    bool of_edit = false;       ///< An addition or removal, which `reason` says all of.
    const char* reason = "";    ///< What is wrong, in words; good until the next step.
};
/// In a sentence with system, body and remedy. @param world  In which it happened.
[[nodiscard]] std::string to_string(const BadLoad& load, const World& world);

}  // namespace hawser
