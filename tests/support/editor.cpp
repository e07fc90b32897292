// SPDX-License-Identifier: Apache-2.0
#include "support/editor.h"

#include "support/yard.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

namespace hawser::test {
namespace {

constexpr std::size_t kMostBodies = 60, kMostInteractions = 80;

}  // namespace

Editor::Editor(std::uint64_t seed, std::vector<World*> worlds)
    : random_(seed), worlds_(std::move(worlds)) {
    floor_ = add(BodyDef{.name = "floor", .kind = BodyKind::fixed});
    add(ShapeDef{.kind = ShapeKind::plane, .body = floor_});
    for (int i = 0; i < 8; ++i) add_box();
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

/// The floor included.
BodyId Editor::any_body() {
    const auto ids = first().bodies();
    return ids[static_cast<std::size_t>(random_.integer(0, static_cast<int>(ids.size()) - 1))];
}

void Editor::add_box() {
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
}

/// A joint half-way between two bodies, or a rod.
void Editor::add_joint() {
    const BodyId a = any_body(), b = any_body();
    const auto rigid = [&](BodyId id) {
        const BodyKind kind = first().body_def(id).kind;
        return kind == BodyKind::rigid || kind == BodyKind::fixed;
    };
    const auto moves = [&](BodyId id) { return first().body_def(id).kind == BodyKind::rigid; };
    if (a == b || !rigid(a) || !rigid(b) || !(moves(a) || moves(b))) return;
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
    const double apart = (first().pose(a).position - first().pose(b).position).norm();
    if (def.kind == InteractionKind::Distance && apart < 0.2) return;
    add(def);
}

/// From the sky: lumps, stretches between them, and segments that touch.
void Editor::add_wire() {
    const Vec3 top(random_.uniform(-4, 4), random_.uniform(-4, 4), 4.0);
    BodyId last = add(BodyDef{.kind = BodyKind::fixed, .position = top});
    for (int i = 1; i <= 3; ++i) {
        const BodyId next = add(BodyDef{
            .kind = BodyKind::lump, .position = top - Vec3(0.05 * i, 0.0, 0.6 * i), .mass = 5.0});
        InteractionDef def;
        def.kind = InteractionKind::Stretch;
        def.body = {last, next};
        add(def.set("EA", 1e6).set("length", 0.602));
        add(ShapeDef{.kind = ShapeKind::capsule, .body = last, .body_b = next, .radius = 0.03});
        last = next;
    }
}

void Editor::add_shape() {
    const BodyId b = any_body();
    if (first().body_def(b).kind != BodyKind::rigid) return;
    add(ShapeDef{.kind = ShapeKind::sphere, .body = b, .radius = random_.uniform(0.1, 0.5)});
}

void Editor::add_input() {
    const auto all = first().interactions();
    if (all.empty()) return;
    const InteractionId id =
        all[static_cast<std::size_t>(random_.integer(0, static_cast<int>(all.size()) - 1))];
    if (first().interaction_def(id).kind != InteractionKind::Distance) return;
    const InputDef def{.name = "length " + std::to_string(names_++),
                       .interaction = id,
                       .param = "length",
                       .min = 0.1,
                       .max = 20.0};
    InputId input;
    for (World* w : worlds_) input = w->add_input(def);
    inputs_.push_back(input);
}

void Editor::remove_body() {
    const BodyId b = any_body();
    if (b == floor_) return;
    std::size_t went = 0;
    for (World* w : worlds_) {
        const Removed& removed = w->remove_body(b);
        const std::size_t all =
            removed.interactions.size() + removed.shapes.size() + removed.inputs.size();
        if (w == worlds_.front()) went = all;
        EXPECT_EQ(all, went);
    }
    gone_.push_back(b);
}

void Editor::remove_interaction() {
    const auto all = first().interactions();
    if (all.empty()) return;
    const InteractionId id =
        all[static_cast<std::size_t>(random_.integer(0, static_cast<int>(all.size()) - 1))];
    for (World* w : worlds_) (void)w->remove_interaction(id);
}

void Editor::remove_shape() {
    const auto all = first().shapes();
    const ShapeId id =
        all[static_cast<std::size_t>(random_.integer(0, static_cast<int>(all.size()) - 1))];
    if (first().shape_def(id).body == floor_) return;
    for (World* w : worlds_) (void)w->remove_shape(id);
}

/// Changes a length a little, or takes the input away.
void Editor::set_input() {
    std::erase_if(inputs_, [&](InputId id) { return !first().alive(id); });
    if (inputs_.empty()) return;
    const std::size_t k =
        static_cast<std::size_t>(random_.integer(0, static_cast<int>(inputs_.size()) - 1));
    const InputId id = inputs_[k];
    if (random_.unit() < 0.3) {
        for (World* w : worlds_) (void)w->remove_input(id);
        return;
    }
    const double value = first().input(id) + random_.uniform(-0.01, 0.01);
    for (World* w : worlds_) w->set_input(id, value);
}

void Editor::edit() {
    ++edits_;
    const bool full =
        first().bodies().size() > kMostBodies || first().interactions().size() > kMostInteractions;
    switch (random_.integer(full ? 5 : 0, 9)) {
        case 0:
        case 1:
            return add_box();
        case 2:
            return add_joint();
        case 3:
            return add_wire();
        case 4:
            return add_shape();
        case 5:
            return add_input();
        case 6:
            return remove_body();
        case 7:
            return remove_interaction();
        case 8:
            return remove_shape();
        default:
            return set_input();
    }
}

}  // namespace hawser::test
