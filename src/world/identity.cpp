// SPDX-License-Identifier: Apache-2.0
#include "world/identity.h"

#include <hawser/settings.h>

#include "base/hash.h"

namespace hawser::world {
namespace {

std::uint64_t hash_of(const MaterialDef& m, std::uint64_t h) {
    const double values[] = {m.friction,     m.restitution, m.stiffness, m.tangential,
                             m.damping_time, m.rolling,     m.torsional};
    return base::fnv1a(values, sizeof values, h);
}

/// Of all that shapes and materials are, names apart.
std::uint64_t hash_of(const std::vector<ShapeDef>& shapes, const collide::Collider& collider,
                      std::uint64_t h) {
    auto array = [&](const auto& a) { h = base::fnv1a(a.data(), a.size() * sizeof(a[0]), h); };
    auto value = [&](const auto& v) { h = base::fnv1a(&v, sizeof v, h); };
    for (int i = 0; i < collider.materials.count(); ++i) h = hash_of(collider.materials.def(i), h);
    for (const MaterialPairDef& pair : collider.materials.pairs()) {
        value(pair.a.index);
        value(pair.b.index);
        h = hash_of(pair.values, h);
    }
    for (const ShapeDef& s : shapes) {
        h = base::fnv1a(s.position.data(), sizeof(Vec3), h);
        h = base::fnv1a(s.orientation.coeffs().data(), 4 * sizeof(double), h);
        value(s.radius);
        value(s.half_length);
        h = base::fnv1a(s.half_size.data(), sizeof(Vec3), h);
        value(s.rows);
        value(s.columns);
        array(s.cell);
        array(s.heights);
        array(s.vertices);
        array(s.triangles);
        value(s.material.index);
        value(s.group);
        value(s.touches);
    }
    return h;
}

}  // namespace

std::uint64_t layout_of(const stepper::StepContext& ctx, std::size_t inputs) {
    std::uint64_t h = base::kFnvStart;
    // Of what the user added: images and copies of cuts follow from it.
    auto add = [&](const auto& a, std::size_t n) {
        h = base::fnv1a(a.data(), n * sizeof(a[0]), h);
    };
    const auto bodies = static_cast<std::size_t>(stepper::body_count(ctx)),
               count = static_cast<std::size_t>(stepper::interaction_count(ctx));
    add(ctx.bodies.kind, bodies);
    add(ctx.regroup.by_hand, bodies);
    add(ctx.interactions.body, kMaxInteractionBodies * count);
    add(ctx.interactions.rows, count);
    for (std::size_t i = 0; i < count; ++i) h = base::fnv1a(&ctx.interactions.def[i].kind, 1, h);
    for (const collide::Shape& s : ctx.collider.shapes()) {
        h = base::fnv1a(&s.geometry.kind, sizeof s.geometry.kind, h);
        h = base::fnv1a(s.body, sizeof s.body, h);
    }
    for (const base::Places* places :
         {&ctx.bodies.places, &ctx.interactions.places, &ctx.collider.places}) {
        const auto n = std::min(places->generations().size(), places == &ctx.bodies.places ? bodies
                                                              : places == &ctx.interactions.places
                                                                  ? count
                                                                  : ctx.collider.shapes().size());
        add(places->generations(), n);
        add(places->vacant(), places->vacant().size());
    }
    h = base::fnv1a(&ctx.def.step, sizeof ctx.def.step, h);
    return base::fnv1a(&inputs, sizeof inputs, h);
}

std::uint64_t parameters_of(const stepper::StepContext& ctx, const std::vector<InputDef>& inputs,
                            const std::vector<ShapeDef>& shapes) {
    std::uint64_t h = hash_of(shapes, ctx.collider, base::kFnvStart);
    auto add = [&](const void* data, std::size_t bytes) { h = base::fnv1a(data, bytes, h); };
    auto array = [&](const auto& a) { add(a.data(), a.size() * sizeof(a[0])); };
    auto value = [&](const auto& v) { add(&v, sizeof v); };
    const auto bodies = static_cast<std::size_t>(stepper::body_count(ctx));
    add(ctx.bodies.mass.data(), bodies * sizeof(double));
    add(ctx.bodies.inertia.data(), 9 * bodies * sizeof(double));
    add(ctx.bodies.damping.data(), 6 * bodies * sizeof(double));
    add(ctx.bodies.weight.data(), bodies);
    for (const SettingInfo& s : setting_infos())
        for (int c = 0; s.identity && c < (s.type == SettingType::vector ? 3 : 1); ++c)
            value(s.get(ctx.def, c));
    if (stepper::makes_groups(ctx)) {
        value(ctx.def.parts);
        value(ctx.def.regroup_every);
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(stepper::interaction_count(ctx)); ++i)
        value(i < ctx.cuts.coupling.size() ? ctx.cuts.coupling[i] : ctx.def.coupling);
    for (const InputDef& input : inputs) {
        array(input.name);
        array(input.param);
        value(input.interaction.index);
        value(input.body.index);
        value(input.component);
        value(input.min);
        value(input.max);
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(stepper::interaction_count(ctx)); ++i) {
        InteractionDef d = ctx.interactions.def[i];
        for (std::size_t b = 0; b < kMaxInteractionBodies; ++b) {
            add(d.point[b].data(), sizeof(Vec3));
            add(d.frame[b].coeffs().data(), 4 * sizeof(double));
        }
        array(d.compliance);
        array(d.damping_time);
        for (const FrictionLoad& load : d.load) {
            value(load.interaction.index);
            value(load.factor);
        }
        if ((ctx.interactions.flags[i] & model::kByInput) != 0)
            for (const InputDef& input : inputs)
                if (input.interaction.index == static_cast<std::int32_t>(i))
                    d.set(input.param, 0.0);
        array(d.params);
    }
    return h;
}

}  // namespace hawser::world
