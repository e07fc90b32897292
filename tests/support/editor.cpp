// SPDX-License-Identifier: Apache-2.0
#include "support/editor.h"

#include "support/yard.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace hawser::test {
namespace {

constexpr std::size_t kMaxBodies = 60, kMaxInteractions = 80;
constexpr int kMaxSystems = 4;
constexpr double kFar = 30.0;  ///< Distance beyond which no new joints are made [m].

}  // namespace

Editor::Editor(std::uint64_t seed, std::vector<World*> worlds)
    : random_(seed), worlds_(std::move(worlds)) {
    floor_ = add(BodyDef{.name = "floor", .kind = BodyKind::fixed});
    add(ShapeDef{.kind = ShapeKind::plane, .body = floor_});
    for (int i = 0; i < 8; ++i) (void)add_box();
}

BodyId Editor::add(const BodyDef& def) {
    BodyId id;
    for (World* w : worlds_) id = w->add_body(def);
    return id;
}

InteractionId Editor::add(const InteractionDef& def) {
    InteractionId id;
    for (World* w : worlds_) id = w->add_interaction(def);
    return id;
}

void Editor::add(const ShapeDef& def) {
    for (World* w : worlds_) (void)w->add_shape(def);
}

bool Editor::add_box() {
    const Vec3 half(random_.uniform(0.1, 0.4), random_.uniform(0.1, 0.4),
                    random_.uniform(0.1, 0.4));
    const double mass = random_.uniform(10.0, 200.0);
    BodyDef def;
    def.position = {random_.uniform(-4, 4), random_.uniform(-4, 4), random_.uniform(0.5, 3.0)};
    def.mass = mass;
    def.inertia = box_inertia(mass, half);
    def.linear_damping = Vec3::Constant(0.2 * mass);
    def.angular_damping = Vec3::Constant(0.05 * mass);
    if (random_.unit() < 0.5) def.name = "box " + std::to_string(names_++);
    const BodyId id = add(def);
    add(ShapeDef{.kind = ShapeKind::box, .body = id, .half_size = half});
    return true;
}

/// Add a body, mostly a box.
bool Editor::add_body() {
    const double which = random_.unit();
    if (which < 0.7) return add_box();
    const Vec3 x(random_.uniform(-4, 4), random_.uniform(-4, 4), random_.uniform(0.5, 3.0));
    if (which < 0.85) {
        const BodyId id = add(BodyDef{.kind = BodyKind::lump, .position = x, .mass = 20.0});
        add(ShapeDef{.kind = ShapeKind::sphere, .body = id, .radius = 0.1});
    } else if (which < 0.95) {
        BodyDef def{.kind = BodyKind::kinematic, .position = x};
        def.angular_velocity = {0, 0, 0.2};
        add(def);
    } else {
        add(BodyDef{.kind = BodyKind::scalar, .mass = 3.0});
    }
    return true;
}

/// Add a joint midway between two bodies, or a rod.
bool Editor::add_joint() {
    const BodyId a = any_body(), b = any_body();
    const auto rigid = [&](BodyId id) {
        const BodyKind kind = first().body_def(id).kind;
        return kind == BodyKind::rigid || kind == BodyKind::fixed;
    };
    const auto moves = [&](BodyId id) { return first().body_def(id).kind == BodyKind::rigid; };
    if (a == b || !rigid(a) || !rigid(b) || !(moves(a) || moves(b))) return false;
    constexpr InteractionKind kKinds[] = {InteractionKind::Ball, InteractionKind::Hinge,
                                          InteractionKind::Lock, InteractionKind::Distance};
    InteractionDef def;
    def.kind = kKinds[random_.integer(0, 3)];
    const Vec3 middle = 0.5 * (first().pose(a).position + first().pose(b).position);
    const BodyId ends[2] = {a, b};
    for (std::size_t k = 0; k < 2; ++k) {
        const Pose p = first().pose(ends[k]);
        def.body[k] = ends[k];
        if (def.kind != InteractionKind::Distance)
            def.point[k] = p.orientation.conjugate() * (middle - p.position);
        def.frame[k] = p.orientation.conjugate();
    }
    const double separation = (first().pose(a).position - first().pose(b).position).norm();
    if (separation > kFar || (def.kind == InteractionKind::Distance && separation < 0.2))
        return false;
    add(def);
    return true;
}

bool Editor::add_shape() {
    const BodyId b = any_body();
    if (first().body_def(b).kind != BodyKind::rigid) return false;
    add(ShapeDef{.kind = ShapeKind::sphere, .body = b, .radius = random_.uniform(0.1, 0.5)});
    return true;
}

/// Add an input for a rod's length, or for a force on a body.
bool Editor::add_input() {
    InputDef def{.name = "input " + std::to_string(names_++)};
    const auto all = first().interactions();
    if (random_.chance(0.5) && !all.empty()) {
        def.interaction = any(all);
        if (first().interaction_def(def.interaction).kind != InteractionKind::Distance)
            return false;
        for (const InputId input : first().inputs())
            if (first().input_def(input).interaction == def.interaction) return false;
        def.param = "length";
        def.min = 0.1;
        def.max = 20.0;
    } else {
        def.body = any_body();
        const BodyKind kind = first().body_def(def.body).kind;
        if (kind != BodyKind::rigid && kind != BodyKind::lump) return false;
        def.min = -50.0;
        def.max = 50.0;
    }
    InputId input;
    for (World* w : worlds_) input = w->add_input(def);
    inputs_.push_back(input);
    return true;
}

/// Change a length slightly, or a force.
bool Editor::set_input() {
    std::erase_if(inputs_, [&](InputId id) { return !first().alive(id); });
    if (inputs_.empty()) return false;
    const InputId id = any(std::span<const InputId>(inputs_));
    const double value = first().input_def(id).interaction.valid()
                             ? first().input(id) + random_.uniform(-0.01, 0.01)
                             : random_.uniform(-60.0, 60.0);
    for (World* w : worlds_) w->set_input(id, value);
    return true;
}

bool Editor::set_any() {
    if (random_.chance(0.5)) return set_input();
    const BodyId b = any_body();
    const BodyKind kind = first().body_def(b).kind;
    if (kind != BodyKind::rigid && kind != BodyKind::lump) return false;
    const Vec3 force = random_.vector(200.0);
    for (World* w : worlds_) w->set_force(b, force, Vec3::Zero());
    return true;
}

bool Editor::act(Edit kind) {
    switch (kind) {
        case Edit::body:
            return add_body();
        case Edit::joint:
            return add_joint();
        case Edit::wire:
            return random_.chance(0.3) ? add_chain() : add_wire();
        case Edit::shape:
            return add_shape();
        case Edit::input:
            return add_input();
        case Edit::system:
            return first().system_count() < kMaxSystems ? add_system() : remove_system();
        case Edit::part:
            return part_wire();
        case Edit::remove:
            return remove_any();
        default:
            return set_any();
    }
}

void Editor::edit() {
    for (;;) {
        const bool full = first().bodies().size() > kMaxBodies ||
                          first().interactions().size() > kMaxInteractions;
        auto kind = static_cast<Edit>(random_.integer(0, static_cast<int>(Edit::count) + 2));
        if (kind >= Edit::count || (full && kind < Edit::input)) kind = Edit::remove;
        if (!act(kind)) continue;  // nothing to do
        ++edits_;
        ++done_[static_cast<std::size_t>(kind)];
        return;
    }
}

std::string Editor::summary() const {
    constexpr std::string_view kNames[] = {"bodies",  "joints",   "wires",    "shapes",  "inputs",
                                           "systems", "partings", "removals", "settings"};
    std::string out;
    for (std::size_t k = 0; k < done_.size(); ++k)
        out += (k == 0 ? "" : ", ") + std::to_string(done_[k]) + " " + std::string(kNames[k]);
    return out;
}

}  // namespace hawser::test
