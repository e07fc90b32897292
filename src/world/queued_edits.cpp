// SPDX-License-Identifier: Apache-2.0
#include "world/queued_edits.h"

#include <hawser/world.h>

#include "base/index.h"

#include <cstdint>
#include <exception>
#include <new>
#include <string>

namespace hawser::world {
namespace {

/// Return the id of the object for which a placeholder id was issued, or the id itself if it is no
/// placeholder.
template <class Id>
Id real_id(Id id, const std::vector<Id>& made) {
    if (id.index >= -1) return id;
    const std::size_t k = at(-2 - id.index);
    if (k >= made.size())
        throw DefError(
            "an id refers to an object that is added later, or was added in another step; add it "
            "first, and find it by its name in later steps");
    return made[k];
}

}  // namespace

template <class T>
bool QueuedEdits::queue_edit(const T& edit) noexcept {
    try {
        list_.push_back({edit, system_});
        return true;
    } catch (const std::bad_alloc&) {
        out_of_memory_ = true;
        return false;
    }
}

BodyId QueuedEdits::add(const BodyDef& def) noexcept {
    return queue_edit(def) ? BodyId{-2 - bodies_++} : BodyId{};
}
InteractionId QueuedEdits::add(const InteractionDef& def) noexcept {
    return queue_edit(def) ? InteractionId{-2 - interactions_++} : InteractionId{};
}
ShapeId QueuedEdits::add(const ShapeDef& def) noexcept {
    return queue_edit(def) ? ShapeId{-2 - shapes_++} : ShapeId{};
}
WireId QueuedEdits::add(const WireDef& def) noexcept {
    return queue_edit(def) ? WireId{-2 - wires_++} : WireId{};
}

void QueuedEdits::clear() noexcept {
    list_.clear();
    added_ids_ = {};
    done_ = 0;
    bodies_ = interactions_ = shapes_ = wires_ = 0;
    out_of_memory_ = false;
}

namespace {

/// Makes one edit in a world, with the results of the edits before it.
template <class Made, class Part>
struct Maker {
    World& world;
    Made& made;

    void operator()(const BodyDef& def) const {
        made.bodies.reserve(made.bodies.size() + 1);
        made.bodies.push_back(world.add_body(def));
    }
    void operator()(InteractionDef def) const {
        for (BodyId& body : def.body) body = real_id(body, made.bodies);
        for (FrictionLoad& load : def.load)
            load.interaction = real_id(load.interaction, made.interactions);
        made.interactions.reserve(made.interactions.size() + 1);
        made.interactions.push_back(world.add_interaction(def));
    }
    void operator()(ShapeDef def) const {
        def.body = real_id(def.body, made.bodies);
        def.body_b = real_id(def.body_b, made.bodies);
        made.shapes.reserve(made.shapes.size() + 1);
        made.shapes.push_back(world.add_shape(def));
    }
    void operator()(WireDef def) const {
        def.from = real_id(def.from, made.bodies);
        def.to = real_id(def.to, made.bodies);
        made.wires.reserve(made.wires.size() + 1);
        made.wires.push_back(world.wires().add(def));
    }
    void operator()(BodyId id) const { (void)world.remove_body(real_id(id, made.bodies)); }
    void operator()(InteractionId id) const {
        (void)world.remove_interaction(real_id(id, made.interactions));
    }
    void operator()(ShapeId id) const { (void)world.remove_shape(real_id(id, made.shapes)); }
    void operator()(WireId id) const { (void)world.wires().remove(real_id(id, made.wires)); }
    void operator()(Part part) const { world.wires().part(real_id(part.id, made.interactions)); }
};

}  // namespace

void QueuedEdits::make(const Edit& edit, World& world, Made& made) {
    std::visit(Maker<Made, Part>{world, made}, edit);
}

void QueuedEdits::make_next(World& world) {
    make(list_[done_].edit, world, added_ids_);
    ++done_;
}

}  // namespace hawser::world
