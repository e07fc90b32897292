// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file impl.h
/// What a World owns.

#include <hawser/changes.h>
#include <hawser/edits.h>
#include <hawser/world.h>

#include "access/copies.h"
#include "step/edits.h"
#include "step/sleep.h"
#include "step/step.h"
#include "world/lookup.h"
#include "world/outputs.h"
#include "world/systems.h"
#include "world/use.h"
#include "world/wire_list.h"

#include <string>
#include <vector>

namespace hawser {

struct World::Impl final : private world::InputDoor {
    explicit Impl(const WorldDef& def) : ctx(def), material_names{{"default", 0}} {}
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    stepper::StepContext ctx;
    std::vector<BodyDef> body_defs;
    /// BodyDef::group, in order of use; "" is none.
    world::Names groups;
    [[nodiscard]] std::int32_t number_of_group(const std::string& name);
    std::vector<ShapeDef> shape_defs;
    std::vector<InputDef> inputs;  ///< Without a name where one was removed.
    std::vector<double> input_values;
    base::Places input_places;
    world::Names body_names, interaction_names, input_names, material_names, shape_names;

    /// Places that ids name. @throws DefError for an id of nothing, or of what has been removed.
    [[nodiscard]] std::size_t place(BodyId id) const {
        return world::place_of(id, ctx.bodies.places, stepper::body_count(ctx), "body");
    }
    [[nodiscard]] std::size_t place(InteractionId id) const {
        return world::place_of(id, ctx.interactions.places, stepper::interaction_count(ctx),
                               "interaction");
    }
    [[nodiscard]] std::size_t place(ShapeId id) const {
        return world::place_of(id, ctx.collider.places, ctx.collider.count(), "shape");
    }
    [[nodiscard]] std::size_t place(InputId id) const {
        return world::place_of(id, input_places, input_places.count(), "input");
    }

    // Of what there is, ascending.
    std::vector<BodyId> body_ids;
    std::vector<InteractionId> interaction_ids;
    std::vector<ShapeId> shape_ids;
    // Of twin().
    void copy_bodies(World& out) const;
    void copy_shapes(World& out) const;
    void copy_interactions(World& out) const;
    void copy_inputs(World& out) const;

    world::WireList wires;
    /// What a world was before several things are added at once.
    struct Mark {
        std::int32_t bodies, interactions, shapes;  ///< Places.
        std::size_t noted;                          ///< Of stepper::Edits.
        double drive;
        bool topology_changed, edited, stale;
        BodyId end[2];          ///< Bodies that are touched …
        std::int32_t quiet[2];  ///< … and for how long they had been at rest.
    };
    [[nodiscard]] Mark mark(BodyId from, BodyId to) const noexcept;
    void tell_of(const world::Wire& made) const noexcept;
    void take_back(const Mark& before, const world::Wire& made) noexcept;
    [[nodiscard]] WireId keep_wire(world::Wire&& wire);
    [[nodiscard]] const world::Wire& wire(WireId id) const;

    Removed removed;  ///< By the last removal.
    void forget_removal() noexcept;
    void reserve_removal();
    [[nodiscard]] const Removed& sorted_removal() noexcept;
    void remove(BodyId id) noexcept;
    void remove(InteractionId id) noexcept;
    void remove(ShapeId id) noexcept;
    void remove(InputId id) noexcept;

    ChangeListener* listener = nullptr;
    /// Nobody is told what a function does within one that is told itself.
    class Untold {
      public:
        explicit Untold(Impl& impl) noexcept : impl_(impl), listener_(impl.listener) {
            impl.listener = nullptr;
        }
        ~Untold() { impl_.listener = listener_; }
        Untold(const Untold&) = delete;
        Untold& operator=(const Untold&) = delete;

      private:
        Impl& impl_;
        ChangeListener* listener_;
    };
    world::Systems systems{*this};

    /// Inputs with forces in the frame of their body, in the order added, and the six forces of
    /// each one's body while a step is taken that has them turned into the world.
    std::vector<std::int32_t> local_inputs;
    std::vector<double> forces_before;
    void turn_forces() noexcept override;
    void unturn_forces() noexcept override;

    factor::KeptAnalysis saved_analysis;  ///< Scratch of save(), so that it needs no memory twice.
    world::Outputs outputs;
    world::Use use;

    void apply_input(std::size_t index, double value);
    /// What acts at present where an input does: its value, unless something else set it since.
    [[nodiscard]] double applied(const InputDef& input) const;
    /// What an input acts on wakes.
    void disturb(const InputDef& input) noexcept;

  private:
    // For systems within a step (world/systems.h).
    bool set(InputId id, double value, Before& before) noexcept override;
    void take_back(const Before& before) noexcept override;
    void tell(const Before& before) noexcept override;
    [[nodiscard]] std::size_t count() const noexcept override { return inputs.size(); }
};

}  // namespace hawser
