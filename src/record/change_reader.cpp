// SPDX-License-Identifier: Apache-2.0
#include "record/changes.h"
#include "record/field_bytes.h"

#include <hawser/experimental/splits.h>

#include <memory>
#include <string_view>
#include <utility>
#include <vector>

namespace hawser::record {

namespace {

/// Replay of the mass that a system added to an element when its end was released: replays have no
/// systems.
class Carrier final : public System {
  public:
    Carrier(InteractionId element, double mass) : element_(element), mass_(mass) {}
    [[nodiscard]] std::string_view name() const noexcept override { return "recorded mass"; }
    void prestep(Prestep&, Loads&) noexcept override {}
    [[nodiscard]] double carried_mass(InteractionId element) const noexcept override {
        return element == element_ ? mass_ : 0.0;
    }

  private:
    InteractionId element_;
    double mass_;
};

void detach_carried(World& world, InteractionId element, int end, double mass) {
    const System& carrier = world.add_system(std::make_unique<Carrier>(element, mass));
    try {
        world.wires().detach(element, end);
    } catch (...) {
        (void)world.remove_system(carrier);
        throw;
    }
    (void)world.remove_system(carrier);
}

void apply_removal(ChangeKind kind, GetFields& get, World& world) {
    if (kind == ChangeKind::remove_body)
        (void)world.remove_body(get.value<BodyId>());
    else if (kind == ChangeKind::remove_interaction)
        (void)world.remove_interaction(get.value<InteractionId>());
    else if (kind == ChangeKind::remove_shape)
        (void)world.remove_shape(get.value<ShapeId>());
    else
        (void)world.remove_input(get.value<InputId>());
}

void apply_addition(ChangeKind kind, GetFields& get, World& world) {
    if (kind == ChangeKind::add_body)
        (void)world.add_body(get.definition<BodyDef>());
    else if (kind == ChangeKind::add_interaction)
        (void)world.add_interaction(get.definition<InteractionDef>());
    else if (kind == ChangeKind::add_shape)
        (void)world.add_shape(get.definition<ShapeDef>());
    else if (kind == ChangeKind::add_input)
        (void)world.add_input(get.definition<InputDef>());
    else if (kind == ChangeKind::add_material)
        (void)world.add_material(get.definition<MaterialDef>());
    else
        world.add_material_pair(get.definition<MaterialPairDef>());
}

void apply_motion(ChangeKind kind, GetFields& get, World& world) {
    const auto body = get.value<BodyId>();
    if (kind == ChangeKind::set_force) {
        const auto force = get.value<Vec3>();
        world.set_force(body, force, get.value<Vec3>());
    } else if (kind == ChangeKind::set_pose) {
        Pose pose;
        get(pose.position);
        get(pose.orientation);
        world.set_pose(body, pose);
    } else if (kind == ChangeKind::set_velocity) {
        Twist twist;
        get(twist.linear);
        get(twist.angular);
        world.set_velocity(body, twist);
    } else {
        world.wake(body);
    }
}

void apply_grouping(ChangeKind kind, GetFields& get, World& world) {
    if (kind == ChangeKind::set_group) {
        const auto body = get.value<BodyId>();
        world.splits().set_group(body, get.value<std::string>());
    } else if (kind == ChangeKind::set_groups) {
        world.splits().set_groups(get.value<std::int32_t>());
    } else if (kind == ChangeKind::follow_groups) {
        const auto parts = get.value<std::int32_t>();
        world.splits().follow_groups(parts, get.value<std::int32_t>());
    } else {
        const auto id = get.value<InteractionId>();
        Coupling coupling{};
        get.word(coupling, 4);
        world.splits().set_coupling(id, coupling);
    }
}

void apply_wire_change(ChangeKind kind, GetFields& get, World& world) {
    if (kind == ChangeKind::part) {
        world.wires().part(get.value<InteractionId>());
    } else if (kind == ChangeKind::insert_node) {
        const auto element = get.value<InteractionId>();
        const auto share = get.value<double>();
        (void)world.wires().insert_node(element, share, get.value<double>());
    } else if (kind == ChangeKind::remove_node) {
        const auto node = get.value<BodyId>();
        (void)world.wires().remove_node(node, get.value<double>());
    } else if (kind == ChangeKind::set_mass) {
        const auto lump = get.value<BodyId>();
        world.wires().set_mass(lump, get.value<double>());
    } else if (kind == ChangeKind::cut) {
        const auto element = get.value<InteractionId>();
        (void)world.wires().cut(element, get.value<double>());
    } else if (kind == ChangeKind::join) {
        const auto a = get.value<BodyId>(), b = get.value<BodyId>();
        const auto point = get.value<Vec3>();
        (void)world.wires().join(a, b, point, get.definition<JoinDef>());
    } else if (kind == ChangeKind::detach) {
        const auto element = get.value<InteractionId>();
        world.wires().detach(element, get.value<std::int32_t>());
    } else if (kind == ChangeKind::detach_carried) {
        const auto element = get.value<InteractionId>();
        const auto end = get.value<std::int32_t>();
        const auto mass = get.value<double>();
        if (!(mass > 0.0 && mass <= 1e12)) throw BadBytes("a released end of a wire has no mass");
        detach_carried(world, element, end, mass);
    } else {
        world.wires().release(get.value<InteractionId>());
    }
}

void apply_guide_change(ChangeKind kind, GetFields& get, World& world) {
    const auto first = get.value<InteractionId>();
    if (kind == ChangeKind::lay_over) {
        auto before = get.definition<InteractionDef>();
        (void)world.wires().engage(first, std::move(before), get.definition<InteractionDef>());
    } else if (kind == ChangeKind::lift_off) {
        const auto behind = get.value<InteractionId>();
        (void)world.wires().disengage(first, behind, get.definition<InteractionDef>());
    } else {
        const auto behind = get.value<InteractionId>();
        const auto along = get.value<double>();
        (void)world.wires().move_along(first, behind, along, get.value<double>());
    }
}

void apply_change(ChangeKind kind, ByteReader& in, World& world) {
    GetFields get{in};
    if (kind <= ChangeKind::add_material_pair) return apply_addition(kind, get, world);
    if (kind <= ChangeKind::remove_input) return apply_removal(kind, get, world);
    if (kind >= ChangeKind::set_force && kind <= ChangeKind::wake)
        return apply_motion(kind, get, world);
    if (kind >= ChangeKind::set_group && kind <= ChangeKind::set_coupling)
        return apply_grouping(kind, get, world);
    if ((kind >= ChangeKind::part && kind < ChangeKind::rebuild) ||
        kind == ChangeKind::detach_carried)
        return apply_wire_change(kind, get, world);
    if (kind >= ChangeKind::lay_over && kind <= ChangeKind::move_along)
        return apply_guide_change(kind, get, world);
    const bool degrades = kind == ChangeKind::degrade || kind == ChangeKind::degrade_wires;
    if (kind == ChangeKind::set_input) {
        const auto id = get.value<InputId>();
        world.set_input(id, get.value<double>());
    } else if (degrades) {
        Degradation d;
        get(d.iterations);
        get(d.hasty);
        get(d.cuts);
        if (kind == ChangeKind::degrade_wires) get(d.wires);
        world.solver().degrade_next_step(d);
    } else if (kind == ChangeKind::rebuild) {
        const auto made_of = get.definition<Structure>();
        world.state().restore(made_of, in.take(in.get<std::uint32_t>()));
    } else {
        world.state().restore(in.take(in.get<std::uint32_t>()));
    }
}

}  // namespace

void apply_changes(std::span<const std::byte> bytes, World& world) {
    ByteReader in(bytes);
    while (in.bytes_left() > 0) {
        const auto kind = in.get<std::uint8_t>();
        if (kind >= kChangeKindCount) throw BadBytes("a change of an unknown kind");
        apply_change(static_cast<ChangeKind>(kind), in, world);
    }
}

}  // namespace hawser::record
