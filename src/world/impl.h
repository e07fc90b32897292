// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file impl.h
/// Data of a World.

#include <hawser/changes.h>
#include <hawser/edits.h>
#include <hawser/world.h>

#include "context/copies.h"
#include "edit/edits.h"
#include "edit/nodes.h"
#include "state/model_undo.h"
#include "step/sleep.h"
#include "step/step.h"
#include "world/gear.h"
#include "world/lookup.h"
#include "world/outputs.h"
#include "world/systems.h"
#include "world/use.h"
#include "world/wire_list.h"

#include <span>
#include <string>
#include <vector>

namespace hawser {

struct WorldImpl final : private world::InputAccess {
    explicit WorldImpl(const WorldDef& def) : ctx(def), material_names{{"default", 0}} {}
    WorldImpl(const WorldImpl&) = delete;
    WorldImpl& operator=(const WorldImpl&) = delete;

    context::StepContext ctx;
    std::vector<BodyDef> body_defs;
    /// BodyDef::group, in order of use; "" is none.
    world::Names groups;
    [[nodiscard]] std::int32_t number_of_group(const std::string& name);
    std::vector<ShapeDef> shape_defs;
    std::vector<InputDef> inputs;  ///< Without a name at vacant indices.
    std::vector<double> input_values;
    base::Slots input_slots;
    std::vector<InputId> input_ids;  ///< Ids of existing inputs, ascending.
    world::Names body_names, interaction_names, input_names, material_names, shape_names;

    /// Return the index of an id.
    /// @throws DefError for an invalid id or a removed object.
    [[nodiscard]] std::size_t index_of(BodyId id) const {
        return world::slot_index_of(id, ctx.model.bodies.slots, context::body_count(ctx.model),
                                    "body");
    }
    [[nodiscard]] std::size_t index_of(InteractionId id) const {
        return world::slot_index_of(id, ctx.model.interactions.slots,
                                    context::interaction_count(ctx.model), "interaction");
    }
    [[nodiscard]] std::size_t index_of(ShapeId id) const {
        return world::slot_index_of(id, ctx.model.collider.slots, ctx.model.collider.count(),
                                    "shape");
    }
    [[nodiscard]] std::size_t index_of(InputId id) const {
        return world::slot_index_of(id, input_slots, input_slots.count(), "input");
    }

    // Ids of existing objects, ascending.
    std::vector<BodyId> body_ids;
    std::vector<InteractionId> interaction_ids;
    std::vector<ShapeId> shape_ids;
    // Make the objects of an empty world from a structure (structure.cpp).
    // @throws DefError, std::bad_alloc.
    void make(World& self, const Structure& from);
    void make_bodies(World& self, const Placed<BodyDef>& from);
    void make_shapes(World& self, const Structure& from);
    void make_interactions(World& self, const Placed<InteractionDef>& from);
    void move_defined(const Structure& from);
    void make_inputs(World& self, const Placed<InputDef>& from);
    void make_wires(const Placed<WirePieces>& from);

    world::WireList wires;
    /// State of a world before several objects are added together.
    struct Mark {
        std::int32_t bodies, interactions, shapes;  ///< Array sizes.
        std::size_t noted;                          ///< Number of entries of context::Edits.
        context::Edited edited;                     ///< Energy of edits (context/ledger.h).
        context::Changed changed;
        bool any_edit, stale;
        BodyId end[2];          ///< Touched bodies …
        std::int32_t quiet[2];  ///< … and the number of steps for which they had been at rest.
    };
    [[nodiscard]] Mark mark(BodyId from, BodyId to) const noexcept;
    void report_wire(const world::Wire& made) const noexcept;
    void take_back(const Mark& before, const world::Wire& made) noexcept;
    [[nodiscard]] WireId store_wire(world::Wire& wire);
    /// Reserve capacity for one more wire and claim its name.
    /// @return the vacant index for the wire; −1: append it.
    /// @throws DefError, std::bad_alloc.
    [[nodiscard]] std::int32_t reserve_wire_slot(const std::string& name);
    WireId put_wire(world::Wire& wire, std::int32_t vacant) noexcept;
    void forget_wire(WireId id) noexcept;
    [[nodiscard]] const world::Wire& wire(WireId id) const;
    // Return the wire of an element, null if it belongs to none. This and the next functions are
    // helpers of insert_node() and remove_node().
    [[nodiscard]] world::Wire* wire_with(InteractionId element) noexcept;
    void update_wire_of(InteractionId element);
    void update_definitions_near(const edit::NodeSurroundings& place) noexcept;
    void follow_inputs(std::int32_t element) noexcept;
    void add_capsule(ShapeId segment, BodyId first, BodyId second, const Vec3& point) noexcept;
    void move_segment(ShapeId segment, std::size_t side, BodyId to) noexcept;
    void join_segments(ShapeId near, ShapeId far) noexcept;
    [[nodiscard]] ShapeId segment_between(std::int32_t a, std::int32_t b) const noexcept;
    void check_node(InteractionId element, double share, double mass) const;
    /// Return the element before a node (side 0) or behind it (side 1).
    [[nodiscard]] InteractionId element_at(BodyId node, std::size_t side) noexcept;
    /// Join a short element at a cut end with the next element, if the node between them can be
    /// removed.
    void join_short_end(World& world, InteractionId end, std::size_t side) noexcept;
    void check_cut_at_node(const std::string& where, edit::NodeSurroundings& place) const;
    [[nodiscard]] bool is_carried(const world::Wire& wire, std::size_t element) const noexcept;
    [[nodiscard]] std::pair<InteractionId, double> cut_outside_carried(const world::Wire& wire,
                                                                       std::size_t node,
                                                                       double s) const noexcept;
    void replace_bend_neighbour(BodyId lump, BodyId from, BodyId to, const Vec3& point) noexcept;
    void remove_folded_bend(std::int32_t bend) noexcept;
    [[nodiscard]] world::Wire& wire_on_guide(InteractionId before, InteractionId behind,
                                             const InteractionDef& element);
    void check_one_line_type(BodyId node, const edit::NodeSurroundings& place) const;
    [[nodiscard]] double bend_stiffness_near(const edit::NodeSurroundings& place,
                                             const world::Wire* wire) const noexcept;
    [[nodiscard]] std::int32_t check_node_removable(BodyId node, edit::NodeSurroundings& place,
                                                    double bend) const;
    [[nodiscard]] std::optional<ShapeDef> next_segment(const edit::NodeSurroundings& place,
                                                       BodyId node, bool first,
                                                       const world::Wire* wire) const;

    // Wires that are cut, joined and released (wire_cuts.cpp, wire_joins.cpp, wire_ends.cpp).
    std::vector<world::GearInUse> gear;
    [[nodiscard]] WireId id_of(const world::Wire& wire) const noexcept {
        return wires.slots.id<WireId>(static_cast<std::int32_t>(&wire - wires.wires.data()));
    }
    void split_wire_at_node(const edit::NodeSurroundings& place, BodyId end) noexcept;
    void divide_load(BodyId from, BodyId to, double share) noexcept;
    void update_definition(BodyId lump) noexcept;
    void reverse_chain(std::span<const std::int32_t> chain) noexcept;
    [[nodiscard]] world::FreeEnd free_end(BodyId lump) const;
    [[nodiscard]] world::FreeEnd free_end(WireId id, int end) const;
    [[nodiscard]] Joint splice(World& world, BodyId a, BodyId b);
    [[nodiscard]] Joint hold(World& world, BodyId a, BodyId b, const Vec3& point,
                             const JoinDef& def);
    [[nodiscard]] Joint add_joining_plate(World& world, BodyId a, BodyId b, const JoinDef& def);
    [[nodiscard]] InteractionDef make_link(const World& world, BodyId a, BodyId b,
                                           const Vec3& point, const JoinDef& def) const;
    void add_gear_mass(BodyId lump, double mass) noexcept;
    void open_gear(InteractionId element, BodyId lump);
    void free_node(World& world, InteractionId element, std::size_t side);

    Removed removed;  ///< Objects of the last removal.
    void forget_removal() noexcept;
    void reserve_removal();
    [[nodiscard]] const Removed& sorted_removal() noexcept;
    void remove(BodyId id) noexcept;
    void remove(InteractionId id) noexcept;
    /// Store a complete, checked definition as a new interaction. Its name has been claimed and
    /// capacity reserved.
    InteractionId store_interaction(InteractionDef&& whole) noexcept;
    void remove(ShapeId id) noexcept;
    void remove(InputId id) noexcept;
    /// Check that no system refers to an object, or to objects that would be removed with it.
    /// @param stays  Interaction on the body that is not removed with it; invalid: all are removed.
    /// @throws DefError
    void check_not_needed(BodyId id, InteractionId stays = {}) const;
    void check_not_needed(InteractionId id) const;
    void check_not_needed(ShapeId id) const;
    void check_not_needed(InputId id) const;

    ChangeListener* listener = nullptr;
    /// Suspends the listener, for calls within a reported call.
    class SilencedListener {
      public:
        explicit SilencedListener(WorldImpl& impl) noexcept
            : impl_(impl), listener_(impl.listener) {
            impl.listener = nullptr;
        }
        ~SilencedListener() { impl_.listener = listener_; }
        SilencedListener(const SilencedListener&) = delete;
        SilencedListener& operator=(const SilencedListener&) = delete;

      private:
        WorldImpl& impl_;
        ChangeListener* listener_;
    };
    world::Systems systems{*this};
    /// Apply the edits that systems requested to this world.
    /// @return ok, bad_edit or out_of_memory.
    [[nodiscard]] Status make_edits(World& world) noexcept;
    [[nodiscard]] Structure structure() const;

    // Write the saved state (snapshot.cpp). The next functions restore it (restore.cpp,
    // structure.cpp) or copy the state of another world (cuts.cpp).
    void write_saved(std::vector<std::byte>& out, bool with_systems);
    void restore_saved_bytes(World& self, std::span<const std::byte> bytes, bool variant);
    void restore_saved(World& self, std::span<const std::byte> bytes, bool variant);
    static void restore(World& self, const Structure& made_of, std::span<const std::byte> bytes);
    void copy_from(const WorldImpl& other);

    /// A force input along world axes, ascending. The force on a body is the user's (BodyDef::force
    /// and torque) plus the values of these inputs in this order.
    struct ForceInput {
        std::int32_t body, component, input;
        friend constexpr auto operator<=>(const ForceInput&, const ForceInput&) = default;
    };
    std::vector<ForceInput> force_inputs;
    void add_up_force(BodyId body, int component) noexcept;
    [[nodiscard]] double user_force(std::size_t body, int component) const noexcept;
    /// Remove the forces of inputs from the bodies for a snapshot. The next function adds them
    /// again. After reading a snapshot, bodies have the user forces only.
    void remove_user_forces() noexcept;
    void add_up_forces() noexcept;
    void set_user_forces() noexcept;  ///< Restore user forces from the definitions.
    void add_user_forces() noexcept;

    /// Inputs with forces in the frame of their body, in the order added. During a step the body's
    /// six previous forces are stored for each of them.
    std::vector<std::int32_t> local_inputs;
    std::vector<double> forces_before;
    void rotate_forces() noexcept override;
    void unrotate_forces() noexcept override;

    /// Definitions, ids and names before the first edit of a system within a step.
    struct StepUndo {
        bool holds = false;  ///< True if the members below are saved.
        state::ModelUndo model;
        std::vector<BodyDef> body_defs;
        std::vector<ShapeDef> shape_defs;
        std::vector<InputDef> inputs;
        std::vector<double> input_values;
        base::Slots input_slots;
        std::vector<InputId> input_ids;
        world::Names groups, body_names, interaction_names, input_names, material_names,
            shape_names;
        std::vector<BodyId> body_ids;
        std::vector<InteractionId> interaction_ids;
        std::vector<ShapeId> shape_ids;
        std::vector<world::Wire> wires;
        base::Slots wire_slots;
        world::Names wire_names;
        std::vector<WireId> wire_ids;
        std::vector<world::GearInUse> gear;
        std::vector<ForceInput> force_inputs;
        std::vector<std::int32_t> local_inputs;
    };
    StepUndo undo;     ///< Undo data of the step; the memory is kept between steps.
    StepUndo attempt;  ///< Undo data of an Attempt.
    /// Return true if a rejected call with several edits is undone as a whole (Attempt). In a step,
    /// edits of a system undo their own additions instead, except with cuts.
    [[nodiscard]] bool undoes_as_whole() const noexcept {
        return context::has_cuts(ctx.model) || !systems.edits_allowed();
    }
    /// Save the state for undo.
    /// @throws std::bad_alloc.
    void save_for_undo(StepUndo& u) const;
    void restore_undo(StepUndo& u) noexcept;
    /// Undo all changes of a failed step and the edits of its systems.
    /// @param mark  Mark of the listener at the start of the step.
    void undo_step(std::size_t mark) noexcept;
    [[nodiscard]] Status run_step() noexcept;

    /// Scratch of save(), so that a second call allocates nothing.
    factor::KeptAnalysis saved_analysis;
    world::Outputs outputs;
    world::Use use;

    void apply_input(std::size_t index, double value);
    /// Return the current value of the quantity that an input sets. It differs from the value of
    /// the input if another call has set the quantity since.
    [[nodiscard]] double applied(const InputDef& input) const;
    /// Wake the body or the bodies of the interaction that an input changes.
    void disturb(const InputDef& input) noexcept;

  private:
    // Set an input. This and the next functions are calls of systems within a step
    // (world/systems.h).
    bool set(InputId id, double value, Before& before) noexcept override;
    bool set_unreported(InputId id, double value, Before& before) noexcept override {
        const SilencedListener silenced(*this);
        return set(id, value, before);
    }
    [[nodiscard]] bool leaves_empty_range(std::int32_t input) const noexcept override;
    [[nodiscard]] InputId id_of(std::int32_t input) const noexcept override {
        return input_slots.id<InputId>(input);
    }
    void take_back(const Before& before) noexcept override;
    void tell(const Before& before) noexcept override;
    [[nodiscard]] bool begin_edits() noexcept override;
    [[nodiscard]] std::size_t count() const noexcept override { return inputs.size(); }
};

inline WorldImpl& Facet::impl(const World& world) noexcept { return *world.impl_; }
inline WorldImpl& Facet::impl() const noexcept { return *world_->impl_; }

}  // namespace hawser
