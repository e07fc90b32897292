// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file change_fields.h
/// List the fields of definitions in the order of a recording, once for writing and reading.
///
/// Fields of bodies and materials are rows of tables (hawser/fields.h). A new field of bodies is
/// recorded by name. A new field of other definitions goes to the end of its list and needs a new
/// ChangeKind.

#include <hawser/body_fields.h>
#include <hawser/hawser.h>
#include <hawser/material_fields.h>

#include <concepts>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <variant>

namespace hawser::record {

/// Kinds of a change, as the format has them.
enum class ChangeKind : std::uint8_t {
    add_body,
    add_interaction,
    add_shape,
    add_input,
    add_material,
    add_material_pair,
    remove_body,
    remove_interaction,
    remove_shape,
    remove_input,
    set_input,
    set_force,
    set_pose,
    set_velocity,
    wake,
    set_group,
    set_groups,
    follow_groups,
    set_coupling,
    degrade,
    restore,
    part,
    insert_node,
    remove_node,
    set_mass,
    cut,
    join,
    detach,
    release,
    rebuild,
    degrade_wires,
    lay_over,
    lift_off,
    move_along,
    detach_carried,
};
inline constexpr int kChangeKindCount = 35;

template <class D, class T>
concept FieldsOf = std::same_as<std::remove_const_t<D>, T>;

/// Call f with the member that a row of a field table describes.
template <class D, class Def, class F>
void visit_member(D& d, const FieldInfo<Def>& row, F& f) {
    std::visit([&](auto member) { f(d.*member); }, row.member);
}

template <class F, FieldsOf<BodyDef> D>
void visit_fields(D& d, F&& f) {
    f(d.name);
    f.table(d, d.kind, 5, kBodyFields, kFirstNamedBodyField);
}

template <class F, FieldsOf<InteractionDef> D>
void visit_fields(D& d, F&& f) {
    f(d.name);
    f.word(d.kind, kInteractionKindCount);
    for (auto& id : d.body) f(id);
    for (auto& point : d.point) f(point);
    for (auto& frame : d.frame) f(frame);
    for (auto& value : d.compliance) f(value);
    for (auto& value : d.damping_time) f(value);
    for (auto& value : d.params) f(value);
    for (auto& load : d.load) {
        f(load.interaction);
        f(load.factor);
    }
}

template <class F, FieldsOf<ShapeDef> D>
void visit_fields(D& d, F&& f) {
    f(d.name);
    f.word(d.kind, 8);
    f(d.body);
    f(d.body_b);
    f(d.position);
    f(d.orientation);
    f(d.radius);
    f(d.half_length);
    f(d.half_size);
    f(d.rows);
    f(d.columns);
    for (auto& value : d.cell) f(value);
    f.list(d.heights);
    f.list(d.vertices);
    f.list(d.triangles);
    f(d.material);
    f(d.group);
    f(d.touches);
    f(d.margin);
}

template <class F, FieldsOf<InputDef> D>
void visit_fields(D& d, F&& f) {
    f(d.name);
    f(d.interaction);
    f(d.param);
    f(d.body);
    f(d.component);
    f(d.min);
    f(d.max);
    f(d.local);
    f(d.unit);
    f(d.group);
    f(d.nominal);
    bool springs = d.spring.has_value();
    double home = d.spring.value_or(0.0);
    f(springs);
    f(home);
    if constexpr (!std::is_const_v<D>) d.spring = springs ? std::optional(home) : std::nullopt;
}

template <class F, FieldsOf<MaterialDef> D>
void visit_fields(D& d, F&& f) {
    f(d.name);
    for (const FieldInfo<MaterialDef>& row : kMaterialFields) visit_member(d, row, f);
}

template <class F, FieldsOf<JoinDef> D>
void visit_fields(D& d, F&& f) {
    f(d.name);
    f.word(d.gear, 5);
    f(d.mass);
    f(d.length);
    f(d.EA);
    f(d.breaking_load);
    f(d.radius);
    f(d.reach);
}

template <class F, FieldsOf<MaterialPairDef> D>
void visit_fields(D& d, F&& f) {
    f(d.a);
    f(d.b);
    visit_fields(d.values, f);
}

template <class F, FieldsOf<SeaLevel> D>
void visit_fields(D& d, F&& f) {
    f(d.time);
    f(d.level);
}

template <class F, FieldsOf<SeaCurrent> D>
void visit_fields(D& d, F&& f) {
    f(d.depth);
    f(d.speed);
    f(d.direction);
}

template <class F, FieldsOf<WaveDef> D>
void visit_fields(D& d, F&& f) {
    f.word(d.kind, 3);
    for (auto* value : {&d.height, &d.period, &d.direction, &d.phase, &d.gamma, &d.spreading})
        f(*value);
    f(d.components);
    f(d.seed);
    f(d.lowest);
    f(d.highest);
}

template <class F, FieldsOf<LineWater> D>
void visit_fields(D& d, F&& f) {
    for (auto* value :
         {&d.diameter, &d.volume, &d.cd_normal, &d.cd_tangential, &d.ca_normal, &d.ca_tangential})
        f(*value);
}

template <class F, FieldsOf<LineSea::Element> D>
void visit_fields(D& d, F&& f) {
    f(d.id);
    f(d.sort);
}

template <class F, FieldsOf<LineSea> D>
void visit_fields(D& d, F&& f) {
    f(d.gravity);
    f(d.sea.depth);
    f(d.sea.density);
    f(d.sea.convective);
    f.list(d.sea.level);
    f.list(d.sea.waves);
    f.list(d.sea.current);
    f.list(d.sorts);
    f.list(d.elements);
    f.list(d.holders);
}

template <class F, FieldsOf<WirePieces> D>
void visit_fields(D& d, F&& f) {
    f(d.name);
    f.list(d.nodes);
    f.list(d.elements);
    f.list(d.lumps);
    f.list(d.bends);
    f.list(d.shapes);
    f(d.owns);
    f(d.trim.EI);
    // Extent of the wire's capsules: none, between nodes, or to its ends.
    enum class Capsules : std::uint8_t { none, lumps, ends };
    Capsules capsules = !d.trim.segment   ? Capsules::none
                        : !d.trim.to_ends ? Capsules::lumps
                                          : Capsules::ends;
    f.word(capsules, 3);
    if constexpr (!std::is_const_v<D>) {
        if (capsules != Capsules::none) d.trim.segment.emplace();
        d.trim.to_ends = capsules == Capsules::ends;
    }
    if (capsules != Capsules::none) f(*d.trim.segment);
}

template <class F, FieldsOf<GearPiece> D>
void visit_fields(D& d, F&& f) {
    f(d.id);
    f.word(d.kind, 5);
}

template <class F, FieldsOf<Structure> D>
void visit_fields(D& d, F&& f) {
    const auto placed = [&](auto& all) {
        f.list(all.defs);
        f.list(all.generations);
        f.list(all.vacant);
    };
    placed(d.bodies);
    placed(d.interactions);
    placed(d.shapes);
    placed(d.inputs);
    placed(d.wires);
    f.list(d.materials);
    f.list(d.pairs);
    f.list(d.gear);
    f.list(d.compliances);
    f.list(d.radii);
    f.words(d.coupling, 4);
}

}  // namespace hawser::record
