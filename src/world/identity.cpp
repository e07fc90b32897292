// SPDX-License-Identifier: Apache-2.0
#include "world/identity.h"

#include <hawser/body_fields.h>
#include <hawser/material_fields.h>
#include <hawser/settings.h>

#include "base/hash.h"
#include "context/copies.h"
#include "split/split.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <variant>

namespace hawser::world {
namespace {

/// Collects small values and hashes some kilobytes at a time.
class Digest {
  public:
    void bytes(const void* data, std::size_t size) {
        if (size > kBufferSize - used_) flush();
        if (size > kBufferSize) {
            hash_ = base::checksum(data, size, hash_);
        } else if (size > 0) {
            std::memcpy(buffer_ + used_, data, size);
            used_ += size;
        }
    }
    template <class V>
    void value(const V& v) {
        bytes(&v, sizeof v);
    }
    template <class A>
    void array(const A& a) {
        bytes(a.data(), a.size() * sizeof(a[0]));
    }
    /// Add the first `count` entries of an array to the hash.
    template <class A>
    void add_front(const A& a, std::size_t count) {
        bytes(a.data(), count * sizeof(a[0]));
    }
    [[nodiscard]] std::uint64_t result() {
        flush();
        return hash_;
    }

  private:
    static constexpr std::size_t kBufferSize = 4096;
    void flush() {
        hash_ = base::checksum(buffer_, used_, hash_);
        used_ = 0;
    }
    std::uint64_t hash_ = base::kFnvStart;
    std::size_t used_ = 0;
    unsigned char buffer_[kBufferSize];
};

void add(const MaterialDef& m, Digest& to) {
    std::array<double, kMaterialFields.size()> values{};
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = m.*std::get<double MaterialDef::*>(kMaterialFields[i].member);
    to.value(values);
}

/// Add the members of a body definition that its field table marks to the hash, if they differ from
/// the default. The other members are added with the arrays of bodies.
void add(std::size_t body, const BodyDef& def, Digest& to) {
    for (const FieldInfo<BodyDef>& row : kBodyFields) {
        if (!row.is(kInIdentity) || has_default(def, row)) continue;
        to.value(body);
        std::visit(
            [&]<class T>(T BodyDef::* member) {
                if constexpr (std::is_arithmetic_v<T>)
                    to.value(def.*member);
                else if constexpr (std::is_same_v<T, Quat>)
                    to.bytes((def.*member).coeffs().data(), sizeof(Quat::Coefficients));
                else if constexpr (std::is_same_v<T, std::string>)
                    to.array(def.*member);
                else
                    to.bytes((def.*member).data(), sizeof(T));
            },
            row.member);
    }
}

/// Add the data of all shapes and materials, except names.
void add(const std::vector<ShapeDef>& shapes, const collide::Collider& collider, Digest& to) {
    for (int i = 0; i < collider.materials.count(); ++i) add(collider.materials.def(i), to);
    for (const MaterialPairDef& pair : collider.materials.pairs()) {
        to.value(pair.a.index);
        to.value(pair.b.index);
        add(pair.values, to);
    }
    for (const ShapeDef& s : shapes) {
        to.bytes(s.position.data(), sizeof(Vec3));
        to.bytes(s.orientation.coeffs().data(), 4 * sizeof(double));
        to.value(s.radius);
        to.value(s.half_length);
        to.bytes(s.half_size.data(), sizeof(Vec3));
        to.value(s.rows);
        to.value(s.columns);
        to.array(s.cell);
        to.array(s.heights);
        to.array(s.vertices);
        to.array(s.triangles);
        to.value(s.material.index);
        to.value(s.group);
        to.value(s.touches);
        if (s.margin != 0.0) to.value(s.margin);
    }
}

}  // namespace

std::uint64_t layout_of(const context::StepContext& ctx, std::size_t inputs) {
    Digest to;
    // Only user objects count, because ghost bodies and duplicated rows of cuts follow from them.
    const auto bodies = static_cast<std::size_t>(context::body_count(ctx.model)),
               count = static_cast<std::size_t>(context::interaction_count(ctx.model));
    to.add_front(ctx.model.bodies.kind, bodies);
    to.add_front(ctx.model.regroup.by_hand, bodies);
    to.add_front(ctx.model.interactions.body, kMaxInteractionBodies * count);
    to.add_front(ctx.model.interactions.rows, count);
    for (std::size_t i = 0; i < count; ++i) to.value(ctx.model.interactions.def[i].kind);
    for (const collide::Shape& s : ctx.model.collider.shapes()) {
        to.value(s.geometry.kind);
        to.value(s.body);
    }
    for (const base::Slots* slots :
         {&ctx.model.bodies.slots, &ctx.model.interactions.slots, &ctx.model.collider.slots}) {
        const auto n =
            std::min(slots->generations().size(), slots == &ctx.model.bodies.slots ? bodies
                                                  : slots == &ctx.model.interactions.slots
                                                      ? count
                                                      : ctx.model.collider.shapes().size());
        to.add_front(slots->generations(), n);
        to.array(slots->vacant());
    }
    to.value(ctx.model.def.step);
    to.value(inputs);
    return to.result();
}

std::uint64_t parameters_of(const context::StepContext& ctx, const std::vector<BodyDef>& defs,
                            const std::vector<InputDef>& inputs,
                            const std::vector<ShapeDef>& shapes) {
    Digest to;
    add(shapes, ctx.model.collider, to);
    const auto bodies = static_cast<std::size_t>(context::body_count(ctx.model)),
               count = static_cast<std::size_t>(context::interaction_count(ctx.model));
    to.add_front(ctx.model.bodies.mass, bodies);
    to.add_front(ctx.model.bodies.inertia, 9 * bodies);
    to.add_front(ctx.model.bodies.damping, 6 * bodies);
    to.add_front(ctx.model.bodies.weight, bodies);
    for (std::size_t b = 0; b < std::min(bodies, defs.size()); ++b)
        if (ctx.model.bodies.slots.holds(static_cast<int>(b))) add(b, defs[b], to);
    for (const SettingInfo& s : setting_infos())
        for (int c = 0; s.identity && c < (s.type == SettingType::vector ? 3 : 1); ++c)
            to.value(s.get(ctx.model.def, c));
    if (split::makes_groups(ctx.model)) {
        to.value(ctx.model.def.parts);
        to.value(ctx.model.def.regroup_every);
    }
    for (std::size_t i = 0; i < count; ++i)
        to.value(i < ctx.model.cuts.coupling.size() ? ctx.model.cuts.coupling[i]
                                                    : ctx.model.def.coupling);
    for (const InputDef& input : inputs) {
        to.array(input.name);
        to.array(input.param);
        to.value(input.interaction.index);
        to.value(input.body.index);
        to.value(input.component);
        to.value(input.local);
        to.value(input.min);
        to.value(input.max);
    }
    for (std::size_t i = 0; i < count; ++i) {
        const InteractionDef& d = ctx.model.interactions.def[i];
        to.bytes(d.point.data(), sizeof d.point);
        to.bytes(d.frame.data(), sizeof d.frame);
        // A compliance that follows the length has no own value.
        std::array<double, kMaxInteractionRows> compliance = d.compliance;
        if ((ctx.model.interactions.flags[i] & model::kFromLength) != 0) compliance[0] = kDefault;
        to.array(compliance);
        to.array(d.damping_time);
        for (const FrictionLoad& load : d.load) {
            to.value(load.interaction.index);
            to.value(load.factor);
        }
        if ((ctx.model.interactions.flags[i] & model::kByInput) == 0) {
            to.array(d.params);
            continue;
        }
        InteractionDef without_inputs = d;
        for (const InputDef& input : inputs)
            if (input.interaction.index == static_cast<std::int32_t>(i))
                without_inputs.set(input.param, 0.0);
        to.array(without_inputs.params);
    }
    return to.result();
}

}  // namespace hawser::world
