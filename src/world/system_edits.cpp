// SPDX-License-Identifier: Apache-2.0
/// Edits that systems ask for: the step that they begin ends, the edits are made, and it is taken
/// again with what the systems did.
#include <hawser/world.h>

#include "context/context.h"
#include "world/impl.h"

#include <algorithm>
#include <exception>
#include <new>
#include <optional>
#include <string>
#include <vector>

namespace hawser {
namespace world {

void Systems::keep_deed(const stepper::StepContext& ctx) {
    keep_states(deed_.states);
    deed_.inputs.clear();
    for (const InputDoor::Before& before : set_)
        deed_.inputs.emplace_back(door_.id_of(before.input), before.asked);
    deed_.told = told_;
    deed_.loads.clear();
    for (const LoadView& load : ctx.state.loads.view()) {
        Deed::Load& one = deed_.loads.emplace_back();
        one.body = load.body;
        for (const auto& part : {load.force, load.mass, load.damping, load.stiffness})
            one.numbers.insert(one.numbers.end(), part.begin(), part.end());
    }
    deed_.known = true;
}

/// Inputs and loads of what has gone since go with it.
void Systems::repeat_deed(stepper::StepContext& ctx) {
    take_states(deed_.states);
    told_ = deed_.told;
    for (const auto& [id, value] : deed_.inputs) {
        InputDoor::Before before;
        if (door_.set_untold(id, value, before)) set_.push_back(before);
    }
    Loads loads(ctx.state.loads);
    ctx.state.loads.begin_system(0);
    for (const Deed::Load& load : deed_.loads) {
        if (!ctx.model.bodies.places.names(load.body)) continue;
        const BodyLoad to = loads.of(load.body);
        const auto n = static_cast<std::size_t>(to.freedom), entries = n * (n + 1) / 2;
        if (load.numbers.size() != n + 3 * entries) continue;
        const double* from = load.numbers.data();
        std::copy_n(from, n, to.force);
        std::copy_n(from + n, entries, to.mass);
        std::copy_n(from + n + entries, entries, to.damping);
        std::copy_n(from + n + 2 * entries, entries, to.stiffness);
    }
    if (ctx.state.loads.touched())
        (void)ctx.state.loads.fault(ctx.pool);  // which found nothing before
}

void Systems::before_step(World& world) noexcept {
    NodeEdits nodes(world);
    editing_ = true;
    for (const auto& system : list_) system->before_step(nodes);
    editing_ = false;
}

void Systems::forget() noexcept {
    queue_.clear();
    deed_.known = false;
}

Status Systems::make_edits(World& world, World* trial) noexcept {
    const auto refuse = [&](std::string_view system, const char* what) {
        bad = {};
        bad.system = system;
        bad.of_edit = true;
        try {
            edit_fault_ = what;
            bad.reason = edit_fault_.c_str();
        } catch (const std::bad_alloc&) {
            bad.reason = "it asked for an edit that the world refuses";
        }
        forget();
        return Status::bad_edit;
    };
    try {
        if (trial != nullptr) {
            std::string fault;
            if (const std::string_view system = queue_.try_all(*trial, fault); !system.empty())
                return refuse(system, fault.c_str());
        }
        while (queue_.left() > 0) {
            const std::string_view system = queue_.next_system();
            try {
                queue_.make_next(world);
            } catch (const DefError& error) {
                return refuse(system, error.what());
            }
        }
    } catch (const std::exception&) {
        return Status::out_of_memory;
    }
    return Status::ok;
}

}  // namespace world

BodyId NodeEdits::insert_node(InteractionId element, double share, double mass) noexcept {
    try {
        return world_.insert_node(element, share, mass);
    } catch (const std::exception&) {
        return {};  // all or nothing; whoever asked may ask again
    }
}

bool NodeEdits::remove_node(BodyId node, double bend) noexcept {
    try {
        return world_.remove_node(node, bend);
    } catch (const std::exception&) {
        return false;
    }
}

/// The definitions and poses that there are, for trying what may be refused.
World World::Impl::definitions() const {
    World out(ctx.model.def);
    out.impl_->make(out, structure());
    for (const BodyId id : body_ids) {
        const double* x = &ctx.model.bodies.x[3 * at(id.index)];
        const double* q = &ctx.model.bodies.q[4 * at(id.index)];
        out.set_pose(id, {Vec3(x[0], x[1], x[2]), Quat(q[0], q[1], q[2], q[3])});
    }
    return out;
}

Status World::Impl::make_edits(World& world) noexcept {
    std::optional<World> trial;
    try {
        if (systems.needs_trial()) trial.emplace(definitions());
    } catch (const std::exception&) {
        return Status::out_of_memory;
    }
    return systems.make_edits(world, trial ? &*trial : nullptr);
}

namespace {

template <class Id>
bool has(const std::vector<Id>& list, Id id) {
    return std::find(list.begin(), list.end(), id) != list.end();
}

[[noreturn]] void refuse_held_by(std::string_view system, const char* what, std::int32_t index,
                                 const std::string& name) {
    throw DefError("system '" + std::string(system) + "' holds the " + what + " " +
                   (name.empty() ? std::to_string(index) : "'" + name + "'") +
                   ", or what would go with it; remove the system first");
}

}  // namespace

void World::Impl::refuse_held(BodyId id, InteractionId stays) const {
    systems.each_held([&](std::string_view system, const HoldTable& held) {
        const auto on = [&](InteractionId i) {
            if (!ctx.model.interactions.places.names(i) || i == stays) return false;
            const InteractionDef& def = ctx.model.interactions.def[at(i.index)];
            return std::find(def.body.begin(), def.body.end(), id) != def.body.end();
        };
        const auto of = [&](ShapeId s) {
            return ctx.model.collider.places.names(s) &&
                   (shape_defs[at(s.index)].body == id || shape_defs[at(s.index)].body_b == id);
        };
        const auto drives = [&](InputId k) {
            if (!input_places.names(k)) return false;
            const InputDef& def = inputs[at(k.index)];
            return def.body == id || (def.interaction.valid() && on(def.interaction));
        };
        if (has(held.bodies, id) ||
            std::any_of(held.interactions.begin(), held.interactions.end(), on) ||
            std::any_of(held.shapes.begin(), held.shapes.end(), of) ||
            std::any_of(held.inputs.begin(), held.inputs.end(), drives))
            refuse_held_by(system, "body", id.index, body_defs[at(id.index)].name);
    });
}

void World::Impl::refuse_held(InteractionId id) const {
    systems.each_held([&](std::string_view system, const HoldTable& held) {
        const auto drives = [&](InputId k) {
            return input_places.names(k) && inputs[at(k.index)].interaction == id;
        };
        if (has(held.interactions, id) ||
            std::any_of(held.inputs.begin(), held.inputs.end(), drives))
            refuse_held_by(system, "interaction", id.index,
                           ctx.model.interactions.def[at(id.index)].name);
    });
}

void World::Impl::refuse_held(ShapeId id) const {
    systems.each_held([&](std::string_view system, const HoldTable& held) {
        if (has(held.shapes, id))
            refuse_held_by(system, "shape", id.index, shape_defs[at(id.index)].name);
    });
}

void World::Impl::refuse_held(InputId id) const {
    systems.each_held([&](std::string_view system, const HoldTable& held) {
        if (has(held.inputs, id))
            refuse_held_by(system, "input", id.index, inputs[at(id.index)].name);
    });
}

}  // namespace hawser
