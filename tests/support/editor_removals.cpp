// SPDX-License-Identifier: Apache-2.0
/// Wires, systems and removals of an Editor.
#include "support/editor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace hawser::test {
namespace {

/// Pulls a body and sets an input, as long as they exist.
class Tug final : public System {
  public:
    Tug(std::string name, BodyId body, InputId input)
        : name_(std::move(name)), body_(body), input_(input) {}
    [[nodiscard]] std::string_view name() const noexcept override { return name_; }
    void prestep(Prestep& now, Loads& loads) noexcept override {
        ++calls_;
        const double wave = std::sin(0.1 * static_cast<double>(calls_));
        if (now.world.alive(body_)) {
            loads.add_force(body_, {20.0 * wave, 5.0, 0.0});
            loads.add_damping(body_, 3.0 * Mat3::Identity());
        }
        if (now.world.alive(input_)) now.set_input(input_, 1.0 + 0.2 * wave);
    }
    void visit_state(StateVisitor& visitor) override { visitor.visit(calls_); }
    [[nodiscard]] std::unique_ptr<System> clone() const override {
        return std::make_unique<Tug>(name_, body_, input_);
    }

  private:
    std::string name_;
    BodyId body_;
    InputId input_;
    std::int64_t calls_ = 0;
};

}  // namespace

/// Add a chain above the others, piece by piece: point masses, stretches between them, and touching
/// segments.
bool Editor::add_chain() {
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
    return true;
}

/// Add a wire between two bodies, or with a free end.
bool Editor::add_wire() {
    const BodyId from = any_body(), to = any_body();
    const auto holds = [&](BodyId id) { return first().body_def(id).kind != BodyKind::scalar; };
    if (!holds(from)) return false;
    WireDef def;
    def.name = "wire " + std::to_string(names_++);
    def.from = from;
    def.elements = random_.integer(2, 6);
    def.EA = 2e5;
    def.mass_per_length = 4.0;
    def.drag = 2.0;
    def.length = random_.uniform(1.0, 2.5);
    if (random_.chance(0.3)) def.EI = 5.0;
    if (random_.chance(0.5)) def.radius = 0.03;
    if (random_.chance(0.3)) def.breaking_load = 2000.0;
    if (random_.chance(0.5) && from != to && holds(to)) {
        const double separation = (first().pose(from).position - first().pose(to).position).norm();
        if (separation < 0.3 || separation > 8.0) return false;
        def.to = to;
        def.length = 1.02 * separation;
    }
    for (World* w : worlds_) (void)w->wires().add(def);
    return true;
}

/// Cut at a material coordinate, or break an element of any wire.
bool Editor::part_wire() {
    const auto wires = first().wires().ids();
    if (wires.empty()) return false;
    const WireId id = any(wires);
    const double length = first().wires().length(id);
    if (length <= 0.0) return false;
    if (random_.chance(0.5)) {
        const double s = random_.uniform(0.0, length);
        for (World* w : worlds_) w->wires().part(id, s);
        return true;
    }
    const InteractionId element = any(first().wires().elements(id));
    if (!first().alive(element)) return false;
    for (World* w : worlds_) w->wires().part(element);
    return true;
}

bool Editor::add_system() {
    const BodyId body = any_body();
    InputId input;
    if (!inputs_.empty()) input = any(std::span<const InputId>(inputs_));
    const std::string name = "tug " + std::to_string(names_++);
    for (World* w : worlds_) (void)w->add_system(std::make_unique<Tug>(name, body, input));
    return true;
}

bool Editor::remove_system() {
    const int which = random_.integer(0, first().system_count() - 1);
    for (World* w : worlds_) (void)w->remove_system(w->system(which));
    return true;
}

/// Remove from all worlds; `call` returns the removed objects of one world.
template <class Id, class F>
bool Editor::remove(Id id, F&& call) {
    for (World* w : worlds_) {
        const Removed& removed = call(*w);
        EXPECT_FALSE(w->alive(id));
        if (w == worlds_.front()) {
            const auto add = [](auto& to, const auto& from) {
                to.insert(to.end(), from.begin(), from.end());
            };
            add(removed_.bodies, removed.bodies);
            add(removed_.interactions, removed.interactions);
            add(removed_.shapes, removed.shapes);
            add(removed_.inputs, removed.inputs);
        }
        const auto ends_with = [](const auto& all, const auto& last) {
            return all.size() >= last.size() &&
                   std::equal(last.rbegin(), last.rend(), all.rbegin());
        };
        EXPECT_TRUE(ends_with(removed_.bodies, removed.bodies) &&
                    ends_with(removed_.interactions, removed.interactions) &&
                    ends_with(removed_.shapes, removed.shapes) &&
                    ends_with(removed_.inputs, removed.inputs));
    }
    return true;
}

/// Remove a body, preferably one that has moved far away.
bool Editor::remove_body() {
    const auto all = first().bodies();
    const auto far = std::find_if(all.begin(), all.end(),
                                  [&](BodyId b) { return first().pose(b).position.norm() > 50.0; });
    const BodyId id = far != all.end() ? *far : any_body();
    if (id == floor_) return false;
    return remove(id, [&](World& w) -> const Removed& { return w.remove_body(id); });
}

bool Editor::remove_wire() {
    const auto wires = first().wires().ids();
    if (wires.empty()) return false;
    const WireId id = any(wires);
    removed_wires_.push_back(id);
    return remove(id, [&](World& w) -> const Removed& { return w.wires().remove(id); });
}

bool Editor::remove_any() {
    const int which = random_.integer(0, 9);
    if (which < 3) return remove_body();
    if (which < 5) return remove_wire();
    if (which < 7) {
        if (first().interactions().empty()) return false;
        const InteractionId id = any(first().interactions());
        return remove(id, [&](World& w) -> const Removed& { return w.remove_interaction(id); });
    }
    if (which < 9) {
        const ShapeId id = any(first().shapes());
        if (first().shape_def(id).body == floor_) return false;
        return remove(id, [&](World& w) -> const Removed& { return w.remove_shape(id); });
    }
    std::erase_if(inputs_, [&](InputId id) { return !first().alive(id); });
    if (inputs_.empty()) return false;
    const InputId id = any(std::span<const InputId>(inputs_));
    return remove(id, [&](World& w) -> const Removed& { return w.remove_input(id); });
}

std::size_t Editor::removed_count() const noexcept {
    return removed_.bodies.size() + removed_.interactions.size() + removed_.shapes.size() +
           removed_.inputs.size() + removed_wires_.size();
}

std::size_t Editor::accepted_removed_count(World& world) const {
    std::size_t count = 0;
    const auto ask = [&](auto id, auto&& use) {
        try {
            use(id);
            ++count;
        } catch (const DefError&) {
            if (world.alive(id)) ++count;
        }
    };
    for (const BodyId id : removed_.bodies) ask(id, [&](BodyId i) { (void)world.pose(i); });
    for (const InteractionId id : removed_.interactions)
        ask(id, [&](InteractionId i) { (void)world.force(i); });
    for (const ShapeId id : removed_.shapes) ask(id, [&](ShapeId i) { (void)world.shape_def(i); });
    for (const InputId id : removed_.inputs) ask(id, [&](InputId i) { world.set_input(i, 1.0); });
    for (const WireId id : removed_wires_)
        ask(id, [&](WireId i) { (void)world.wires().length(i); });
    return count;
}

}  // namespace hawser::test
