// SPDX-License-Identifier: Apache-2.0
/// Add and remove interactions: write the data of a definition to the arrays.
#define HAWSER_KIND_SETUP
#include "base/index.h"
#include "base/sorted.h"
#include "model/interactions.h"
#include "model/kinds/all.h"
#include "model/line_ends.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace hawser::model {
namespace {

auto by_interaction(Interactions& in) noexcept {
    return std::to_array<base::Array<double>*>({&in.active, &in.held, &in.low, &in.high, &in.anchor,
                                                &in.power, &in.breaking, &in.rest_length,
                                                &in.defined_radius, &in.pair_mass, &in.lightness,
                                                &in.flagged, &in.vibration});
}

auto by_row(Interactions& in) noexcept {
    return std::to_array<base::Array<double>*>({&in.defined, &in.epsilon, &in.tau, &in.mobility,
                                                &in.upsilon, &in.recall, &in.sigma, &in.min_sigma,
                                                &in.inv_sigma, &in.g, &in.c, &in.residual,
                                                &in.lambda, &in.multiplier, &in.force});
}

std::uint8_t flags_of(const InteractionDef& d, const generic::RowSpec& first,
                      const Bodies& bodies) {
    int flag = 0;
    if (first.one_sided) flag |= kOneSided;
    if (first.range) flag |= kRange;
    if (first.friction) flag |= kFriction;
    if (kind_info(d.kind).is(kMotorKind)) flag |= kMotor;
    if (kind_info(d.kind).is(kWireElement)) {
        if (d.get("breaking_load") < 1e30) flag |= kBreakable;
        if (std::isnan(d.compliance[0])) flag |= kFromLength;
    }
    for (int b = 0; b < kind_info(d.kind).bodies; ++b)
        if (bodies.kind[at(d.body[at(b)].index)] == BodyKind::kinematic) flag |= kCarried;
    return static_cast<std::uint8_t>(flag);
}

}  // namespace

void Interactions::reserve_more(InteractionKind kind) {
    slots.reserve_more();
    base::reserve_more(def, 1);
    Pool& p = pool[static_cast<std::size_t>(kind)];
    base::reserve_more(p.ids, 1);
    generic::with_kind(kind,
                       [&]<class K>() { base::reserve_more(p.data, sizeof(typename K::Data)); });
    for (std::vector<std::int32_t>* a :
         {&pool_index, &geo, &load_begin, &working, &motors, &frictions, &winches, &spans})
        base::reserve_more(*a, 1);
    base::reserve_more(saturated, 1);
    base::reserve_more(loads, kMaxFrictionLoads);
    for (base::Array<std::int32_t>* a : {&body, &next_holder, &row_begin, &jac_begin})
        base::reserve_more(*a, kMaxInteractionBodies);
    for (base::Array<std::uint8_t>* a :
         {&bodies, &rows, &flags, &arms, &parted, &coarse, &repeats, &completed, &upper})
        base::reserve_more(*a, 1);
    for (base::Array<double>* a : by_interaction(*this)) base::reserve_more(*a, 1);
    for (base::Array<double>* a : by_row(*this)) base::reserve_more(*a, kMaxInteractionRows);
    base::reserve_more(row_flags, kMaxInteractionRows);
    base::reserve_more(kinds, 1);
}

int Interactions::add(InteractionDef filled, Bodies& bodies_in, double h) {
    const InteractionKind kind = filled.kind;
    const int place = slots.find_vacant([&](std::int32_t p) { return def[at(p)].kind == kind; });
    if (place < 0) return append(std::move(filled), bodies_in, h);
    slots.take(place);
    write(place, std::move(filled), bodies_in, h);
    return place;
}

int Interactions::append(InteractionDef filled, Bodies& bodies_in, double h) {
    const int id = slots.append();
    grow(filled.kind);
    write(id, std::move(filled), bodies_in, h);
    return id;
}

void Interactions::append_empty(InteractionKind kind) {
    const auto i = at(slots.append());
    grow(kind);
    def[i].kind = kind;
}

void Interactions::set_loads(int id, const std::array<FrictionLoad, kMaxFrictionLoads>& loads_in) {
    def[at(id)].load = loads_in;
    write_loads(id);
}

/// Append a slot of a kind, with values unset.
void Interactions::grow(InteractionKind of) {
    const auto id = static_cast<std::int32_t>(def.size());
    const auto n = at(id) + 1;
    def.emplace_back();
    kinds.push_back(of);
    Pool& p = pool[static_cast<std::size_t>(of)];
    pool_index.push_back(static_cast<std::int32_t>(p.ids.size()));
    p.ids.push_back(id);
    bool geometric = false;
    generic::with_kind(of, [&]<class K>() {
        static_assert(sizeof(typename K::Data) % sizeof(double) == 0);
        p.stride = sizeof(typename K::Data);
        geometric = K::kGeometry != generic::Geometry::none;
    });
    p.data.resize(p.ids.size() * p.stride);
    geo.push_back(geometric ? geo_count++ : -1);
    load_begin.push_back(-1);
    row_begin.push_back(row_count);
    jac_begin.push_back(0);
    row_count += kind_info(of).rows;
    body.resize(kMaxInteractionBodies * n, -1);
    next_holder.resize(kMaxInteractionBodies * n, -1);
    for (base::Array<std::uint8_t>* a :
         {&bodies, &rows, &flags, &arms, &parted, &coarse, &repeats, &completed, &upper})
        a->resize(n);
    for (base::Array<double>* a : by_interaction(*this)) a->resize(n);
    for (base::Array<double>* a : by_row(*this)) a->resize(at(row_count));
    row_flags.resize(at(row_count));
}

void Interactions::write(int id, InteractionDef filled, Bodies& bodies_in, double h) {
    const auto i = at(id);
    const KindInfo& info = kind_info(filled.kind);
    def[i] = std::move(filled);
    const InteractionDef& d = def[i];
    for (std::size_t b = 0; b < kMaxInteractionBodies; ++b) {
        const std::size_t place = kMaxInteractionBodies * i + b;
        body[place] = b < at(info.bodies) ? d.body[b].index : -1;
        link(place, bodies_in);
    }
    bodies[i] = static_cast<std::uint8_t>(info.bodies);
    rows[i] = static_cast<std::uint8_t>(info.rows);
    active[i] = 1.0;
    for (base::Array<std::uint8_t>* a : {&arms, &parted, &coarse, &repeats, &completed, &upper})
        (*a)[i] = 0;
    for (base::Array<double>* a : {&held, &anchor, &rest_length, &flagged, &vibration})
        (*a)[i] = 0.0;
    write_rows(id, bodies_in, h);
    enlist(id, bodies_in);
}

/// Compute the constants of the rows of an interaction from its definition.
void Interactions::write_rows(int id, const Bodies& bodies_in, double h) {
    InteractionDef& d = def[at(id)];
    generic::RowSpec spec[kMaxInteractionRows];
    bool line = false;
    generic::with_kind(d.kind, [&]<class K>() {
        K::defaults(d, h, spec);
        line = K::kGeometry == generic::Geometry::line;
    });
    flags[at(id)] = flags_of(d, spec[0], bodies_in);
    const int mass = kind_info(d.kind).mass_param;
    pair_mass[at(id)] = mass < 0 ? 0.0 : d.params[at(mass)] / 6.0;
    lightness[at(id)] = line ? lightest_end(d, bodies_in) : 0.0;
    defined_radius[at(id)] = kind_info(d.kind).is(kWoundUp) ? d.get("radius") : 0.0;
    breaking[at(id)] = flags[at(id)] & kBreakable ? d.get("breaking_load") : 0.0;
    set_range(id);
    write_data(id);
    write_loads(id);
    const bool wire = kind_info(d.kind).is(kWireElement);
    // A `distance` without damping is a spring with a quadratic invariant (docs/theory/step.md).
    const bool joint = kind_completes(d.kind) && !line;
    for (std::size_t r = 0; r < rows[at(id)]; ++r) {
        const std::size_t row = at(row_begin[at(id)]) + r;
        d.compliance[r] = spec[r].compliance;
        // The time of the scheme is not written to the definition, so that a copy has no damper.
        if (!spec[r].damped_by_scheme) d.damping_time[r] = spec[r].damping_time;
        defined[row] = epsilon[row] = spec[r].compliance;
        tau[row] = spec[r].damping_time;
        const bool damper = !spec[r].velocity && !spec[r].damped_by_scheme;
        row_flags[row] = static_cast<std::uint8_t>(
            (spec[r].velocity ? kRowVelocity : 0) | (spec[r].gap ? kRowGap : 0) |
            (damper ? kRowDamper : 0) | (spec[r].turns ? kRowTurns : 0) | (joint ? kRowJoint : 0));
        for (base::Array<double>* a : {&mobility, &upsilon, &recall, &inv_sigma, &min_sigma, &g, &c,
                                       &residual, &lambda, &multiplier, &force})
            (*a)[row] = 0.0;
        split_damping(row, wire, h);
        sigma[row] = sigma_without_floor(row, h);
    }
    if (wire) update_length_at_drum(id, bodies_in, h);
}

/// Add an interaction to the lists of interactions that require work in each step.
void Interactions::enlist(int id, const Bodies& bodies_in) {
    const int flag = flags[at(id)];
    if (kind_info(def[at(id)].kind).is(kWoundUp) && (flag & kFromLength))
        base::insert_sorted(winches, id);
    if (wheel_at(def[at(id)], 0) != 0.0 || wheel_at(def[at(id)], 1) != 0.0)
        base::insert_sorted(spans, id);
    if (flag & kMotor) {
        const auto before = std::lower_bound(motors.begin(), motors.end(), id) - motors.begin();
        saturated.insert(saturated.begin() + before, 0);
        motors.insert(motors.begin() + before, id);
    }
    if (flag & kFriction) {
        base::insert_sorted(frictions, id);
        set_anchor(id, row_state(id, bodies_in).g[0]);
    }
    if (flag & (kMotor | kFriction | kCarried)) base::insert_sorted(working, id);
}

void Interactions::link(std::size_t place, Bodies& bodies_in) noexcept {
    if (body[place] < 0) return;
    std::int32_t& first = bodies_in.first_holder[at(body[place])];
    next_holder[place] = std::exchange(first, static_cast<std::int32_t>(place));
}

void Interactions::unlink(std::size_t place, Bodies& bodies_in) noexcept {
    if (body[place] < 0) return;
    std::int32_t* at_it = &bodies_in.first_holder[at(body[place])];
    while (at(*at_it) != place) at_it = &next_holder[at(*at_it)];
    *at_it = std::exchange(next_holder[place], -1);
}

void Interactions::remove(int id, Bodies& bodies_in) noexcept {
    const auto i = at(id);
    if (flags[i] & kMotor) {
        const auto place = std::lower_bound(motors.begin(), motors.end(), id) - motors.begin();
        saturated.erase(saturated.begin() + place);
    }
    for (std::vector<std::int32_t>* list : {&winches, &motors, &frictions, &working, &spans})
        base::erase_sorted(*list, id);
    for (Load& load : loads)
        if (load.rows > 0 && load.row_begin == row_begin[i]) load.rows = 0;
    for (const std::int32_t friction : frictions)
        for (FrictionLoad& load : def[at(friction)].load)
            if (load.interaction.index == id) load = {};
    if (load_begin[i] >= 0)
        for (std::size_t k = 0; k < kMaxFrictionLoads; ++k) loads[at(load_begin[i]) + k] = {};
    for (std::size_t row = at(row_begin[i]); row < at(row_begin[i]) + rows[i]; ++row) {
        for (base::Array<double>* a : {&g, &c, &residual, &lambda, &multiplier, &force, &epsilon})
            (*a)[row] = 0.0;
        row_flags[row] = 0;
    }
    const InteractionKind kind = def[i].kind;
    def[i] = {};
    def[i].kind = kind;
    for (std::size_t b = 0; b < kMaxInteractionBodies; ++b)
        unlink(kMaxInteractionBodies * i + b, bodies_in);
    std::fill_n(&body[kMaxInteractionBodies * i], kMaxInteractionBodies, -1);
    for (base::Array<std::uint8_t>* a :
         {&bodies, &rows, &flags, &arms, &parted, &coarse, &repeats, &completed, &upper})
        (*a)[i] = 0;
    for (base::Array<double>* a : by_interaction(*this)) (*a)[i] = 0.0;
    slots.vacate(id);
}

void Interactions::write_loads(int id) {
    const InteractionDef& d = def[at(id)];
    if (!d.load[0].interaction.valid() && !d.load[1].interaction.valid()) return;
    if (load_begin[at(id)] < 0) {
        load_begin[at(id)] = static_cast<std::int32_t>(loads.size());
        loads.resize(loads.size() + kMaxFrictionLoads);
    }
    for (std::size_t k = 0; k < kMaxFrictionLoads; ++k) {
        Load& l = loads[at(load_begin[at(id)]) + k];
        const FrictionLoad& load = d.load[k];
        l = {};
        if (!load.interaction.valid()) continue;
        const auto of = at(load.interaction.index);
        const std::string_view units = kind_info(def[of].kind).row_units;
        l.row_begin = row_begin[of];
        l.rows = static_cast<std::int32_t>(std::min(units.find_first_not_of('m'), units.size()));
        l.factor = load.factor;
    }
}

void Interactions::truncate(int kept, Bodies& bodies_in) {
    const auto n = at(kept);
    if (kept >= count()) return;
    for (std::size_t place = body.size(); place-- > kMaxInteractionBodies * n;)
        unlink(place, bodies_in);
    slots.truncate(kept);
    row_count = row_begin[n];
    for (Pool& p : pool) {
        while (!p.ids.empty() && p.ids.back() >= kept) p.ids.pop_back();
        p.data.resize(p.ids.size() * p.stride);
    }
    geo_count -= static_cast<std::int32_t>(
        std::count_if(geo.begin() + kept, geo.end(), [](std::int32_t i) { return i >= 0; }));
    def.resize(n);
    kinds.resize(n);
    pool_index.resize(n);
    body.resize(kMaxInteractionBodies * n);
    next_holder.resize(kMaxInteractionBodies * n);
    for (base::Array<std::uint8_t>* a :
         {&bodies, &rows, &flags, &parted, &coarse, &repeats, &completed, &arms, &upper})
        a->resize(n);
    row_begin.resize(n);
    jac_begin.resize(n);
    geo.resize(n);
    for (base::Array<double>* a : by_interaction(*this)) a->resize(n);
    load_begin.resize(n);
    const auto m = at(row_count);
    for (base::Array<double>* a : by_row(*this)) a->resize(m);
    row_flags.resize(m);
}

}  // namespace hawser::model
