// SPDX-License-Identifier: Apache-2.0
/// Edits that systems request. The current step ends, the edits are made, and the step is repeated
/// with the recorded actions of the systems.
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

void Systems::save_action(const context::StepContext& ctx) {
    save_states_to(pending_action_.states);
    pending_action_.inputs.clear();
    for (const InputAccess::Before& before : set_)
        pending_action_.inputs.emplace_back(input_access_.id_of(before.input), before.asked);
    pending_action_.reported = reported_;
    pending_action_.loads.clear();
    for (const LoadView& load : ctx.state.loads.view()) {
        SystemAction::Load& one = pending_action_.loads.emplace_back();
        one.body = load.body;
        for (const auto& part : {load.force, load.mass, load.damping, load.stiffness})
            one.numbers.insert(one.numbers.end(), part.begin(), part.end());
    }
    pending_action_.is_known = true;
}

/// Repeat the recorded actions of the systems. Inputs and loads of removed objects are dropped.
void Systems::repeat_action(context::StepContext& ctx) {
    restore_states(pending_action_.states);
    reported_ = pending_action_.reported;
    for (const auto& [id, value] : pending_action_.inputs) {
        InputAccess::Before before;
        if (input_access_.set_unreported(id, value, before)) set_.push_back(before);
    }
    Loads loads(ctx.state.loads);
    ctx.state.loads.begin_system(0);
    for (const SystemAction::Load& load : pending_action_.loads) {
        if (!ctx.model.bodies.slots.names(load.body)) continue;
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
        (void)ctx.state.loads.fault(ctx.pool);  // which found no fault before
}

/// Access of a system through its NodeEdits.
class Systems::NodeEditAccess final : public NodeEdits::Hands {
  public:
    NodeEditAccess(Systems& of, double time) : systems_(of), time_(time) {}
    bool begin() noexcept override {
        if (failed_) return false;
        if (!systems_.input_access_.begin_edits()) failed_ = true;
        return !failed_;
    }
    void out_of_memory() noexcept override { failed_ = true; }
    void tell(const Event& event) noexcept override {
        try {
            systems_.reported_.push_back(event);
            systems_.reported_.back().time = time_;
        } catch (const std::bad_alloc&) {
            failed_ = true;
        }
    }
    [[nodiscard]] bool failed() const noexcept { return failed_; }

  private:
    Systems& systems_;
    double time_;
    bool failed_ = false;
};

Status Systems::begin_step(World& world) noexcept {
    bad = {};
    reported_.clear();
    discard_actions();
    begun_valid_ = false;
    try {
        save_states_to(step_start_states_);
    } catch (const std::bad_alloc&) {
        return Status::out_of_memory;
    }
    begun_valid_ = true;
    NodeEditAccess hands(*this, world.time());
    NodeEdits nodes(world, hands);
    editing_ = true;
    for (const auto& system : list_) system->before_step(nodes);
    editing_ = false;
    return hands.failed() ? Status::out_of_memory : Status::ok;
}

void Systems::undo_step() noexcept {
    if (begun_valid_) restore_states(step_start_states_);
    reported_.clear();
    discard_actions();
}

void Systems::discard_actions() noexcept {
    queue_.clear();
    pending_action_.is_known = false;
}

Status Systems::make_edits(World& world) noexcept {
    const auto throw_def_error = [&](std::string_view system, const char* what) {
        bad = {};
        bad.system = system;
        bad.of_edit = true;
        try {
            edit_fault_ = what;
            bad.reason = edit_fault_.c_str();
        } catch (const std::bad_alloc&) {
            bad.reason = "it requested an edit that the world rejects";
        }
        discard_actions();
        return Status::bad_edit;
    };
    try {
        while (queue_.left() > 0) {
            const std::string_view system = queue_.next_system();
            try {
                queue_.make_next(world);
            } catch (const DefError& error) {
                return throw_def_error(system, error.what());
            }
        }
    } catch (const std::exception&) {
        return Status::out_of_memory;
    }
    return Status::ok;
}

}  // namespace world

BodyId NodeEdits::insert_node(InteractionId element, double share, double mass) noexcept {
    if (!hands_.begin()) return {};
    try {
        return world_.wires().insert_node(element, share, mass);
    } catch (const std::bad_alloc&) {
        hands_.out_of_memory();
        return {};
    } catch (const std::exception&) {
        return {};
    }
}

bool NodeEdits::remove_node(BodyId node, double bend) noexcept {
    if (!hands_.begin()) return false;
    try {
        return world_.wires().remove_node(node, bend);
    } catch (const std::bad_alloc&) {
        hands_.out_of_memory();
        return false;
    } catch (const std::exception&) {
        return false;
    }
}

void NodeEdits::tell(EventKind kind, InteractionId interaction, double value) noexcept {
    Event event;
    event.kind = kind;
    event.interaction = interaction;
    event.value = value;
    hands_.tell(event);
}

Status WorldImpl::make_edits(World& world) noexcept {
    if (!begin_edits()) return Status::out_of_memory;
    try {
        ctx.state.events.hold_back(systems.queued());
    } catch (const std::bad_alloc&) {
        return Status::out_of_memory;
    }
    return systems.make_edits(world);
}

namespace {

template <class Id>
bool list_contains(const std::vector<Id>& list, Id id) {
    return std::find(list.begin(), list.end(), id) != list.end();
}

[[noreturn]] void throw_needed_error(std::string_view system, const char* what, std::int32_t index,
                                     const std::string& name) {
    throw DefError("system '" + std::string(system) + "' holds the " + what + " " +
                   (name.empty() ? std::to_string(index) : "'" + name + "'") +
                   ", or an object that would be removed with it; remove the system first");
}

}  // namespace

void WorldImpl::check_not_needed(BodyId id, InteractionId stays) const {
    systems.for_each_hold_table([&](std::string_view system, const HoldTable& held) {
        const auto on = [&](InteractionId i) {
            if (!ctx.model.interactions.slots.names(i) || i == stays) return false;
            const InteractionDef& def = ctx.model.interactions.def[at(i.index)];
            return std::find(def.body.begin(), def.body.end(), id) != def.body.end();
        };
        const auto of = [&](ShapeId s) {
            return ctx.model.collider.slots.names(s) &&
                   (shape_defs[at(s.index)].body == id || shape_defs[at(s.index)].body_b == id);
        };
        const auto drives = [&](InputId k) {
            if (!input_slots.names(k)) return false;
            const InputDef& def = inputs[at(k.index)];
            return def.body == id || (def.interaction.valid() && on(def.interaction));
        };
        if (list_contains(held.bodies, id) ||
            std::any_of(held.interactions.begin(), held.interactions.end(), on) ||
            std::any_of(held.shapes.begin(), held.shapes.end(), of) ||
            std::any_of(held.inputs.begin(), held.inputs.end(), drives))
            throw_needed_error(system, "body", id.index, body_defs[at(id.index)].name);
    });
}

void WorldImpl::check_not_needed(InteractionId id) const {
    systems.for_each_hold_table([&](std::string_view system, const HoldTable& held) {
        const auto drives = [&](InputId k) {
            return input_slots.names(k) && inputs[at(k.index)].interaction == id;
        };
        if (list_contains(held.interactions, id) ||
            std::any_of(held.inputs.begin(), held.inputs.end(), drives))
            throw_needed_error(system, "interaction", id.index,
                               ctx.model.interactions.def[at(id.index)].name);
    });
}

void WorldImpl::check_not_needed(ShapeId id) const {
    systems.for_each_hold_table([&](std::string_view system, const HoldTable& held) {
        if (list_contains(held.shapes, id))
            throw_needed_error(system, "shape", id.index, shape_defs[at(id.index)].name);
    });
}

void WorldImpl::check_not_needed(InputId id) const {
    systems.for_each_hold_table([&](std::string_view system, const HoldTable& held) {
        if (list_contains(held.inputs, id))
            throw_needed_error(system, "input", id.index, inputs[at(id.index)].name);
    });
}

}  // namespace hawser
