// SPDX-License-Identifier: Apache-2.0
#define HAWSER_KIND_SETUP
#include "model/interactions.h"

#include "base/index.h"
#include "model/kinds/all.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace hawser::model {
namespace {

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

/// How easily the lighter end of a line moves across it [1/kg]: arms at their longest, or, between
/// two rigid bodies, by the mean inertia across the arm.
double lightest_end(const InteractionDef& d, const Bodies& b) {
    double most = 0.0;
    const bool rigid = b.dof(d.body[0].index) == 6 && b.dof(d.body[1].index) == 6;
    for (std::size_t slot = 0; slot < 2; ++slot) {
        const auto body = at(d.body[slot].index);
        const int dof = b.dof(d.body[slot].index);
        if (dof < 3) continue;
        double end = 1.0 / b.mass[body];
        const Vec3& arm = d.point[slot];
        const double square = arm.squaredNorm();
        if (rigid && square > 0.0) {
            const Eigen::Map<const Mat3> inertia(&b.inertia[9 * body]);
            end += 2.0 * square / (inertia.trace() - arm.dot(inertia * arm) / square);
        }
        for (std::size_t i = 0; i < 3 && dof == 6 && !rigid; ++i)
            end += square * b.inv_inertia[9 * body + 4 * i];
        most = std::max(most, end);
    }
    return most;
}

/// Range of the force of the first row [N or N m].
void force_range(const InteractionDef& d, int flags, double& low, double& high) {
    low = -kUnbounded;
    high = kUnbounded;
    if (flags & kMotor) {
        low = d.params[1];
        high = d.params[2];
    } else if (flags & kFriction) {
        low = -d.params[0];
        high = d.params[0];
    } else if (flags & kOneSided) {
        high = 0.0;
    }
}

}  // namespace

void complete(InteractionDef& def, const Vec3* positions, double distance) {
    const KindInfo& info = kind_info(def.kind);
    for (std::size_t i = 0; i < info.params.size(); ++i) {
        if (!std::isnan(def.params[i])) continue;
        if (info.length_from_pose && std::string_view(info.params[i].name) == "length")
            def.params[i] = distance;
        else
            def.params[i] = info.params[i].fallback;
    }
    generic::with_kind(def.kind, [&]<class K>() {
        if constexpr (requires { K::complete(def, positions); }) K::complete(def, positions);
    });
}

void Interactions::make_room(InteractionKind kind) {
    base::make_room(def, 1);
    Pool& p = pool[static_cast<std::size_t>(kind)];
    base::make_room(p.ids, 1);
    generic::with_kind(kind, [&]<class K>() { base::make_room(p.data, sizeof(typename K::Data)); });
    for (std::vector<std::int32_t>* a :
         {&pool_index, &geo, &load_begin, &working, &motors, &frictions, &winches})
        base::make_room(*a, 1);
    base::make_room(saturated, 1);
    base::make_room(loads, kMaxFrictionLoads);
    for (base::Array<std::int32_t>* a : {&body, &row_begin, &jac_begin})
        base::make_room(*a, kMaxInteractionBodies);
    for (base::Array<std::uint8_t>* a :
         {&bodies, &rows, &flags, &arms, &parted, &coarse, &repeats, &completed})
        base::make_room(*a, 1);
    for (base::Array<double>* a :
         {&active, &held, &low, &high, &anchor, &rest_length, &lightness, &alert, &swing})
        base::make_room(*a, 1);
    for (base::Array<double>* a :
         {&epsilon, &tau, &mobility, &upsilon, &recall, &sigma, &least_sigma, &inv_sigma, &g, &c,
          &residual, &lambda, &multiplier, &force})
        base::make_room(*a, kMaxInteractionRows);
    base::make_room(row_flags, kMaxInteractionRows);
}

int Interactions::add(InteractionDef filled, const Bodies& bodies_in, double h) {
    const int id = count();
    const KindInfo& info = kind_info(filled.kind);
    def.push_back(std::move(filled));
    InteractionDef& d = def.back();

    generic::RowSpec spec[kMaxInteractionRows];
    std::size_t stride = 0;
    generic::Geometry geometry = generic::Geometry::none;
    generic::with_kind(d.kind, [&]<class K>() {
        K::defaults(d, h, spec);
        stride = sizeof(typename K::Data);
        static_assert(sizeof(typename K::Data) % sizeof(double) == 0);
        geometry = K::kGeometry;
    });

    Pool& p = pool[static_cast<std::size_t>(d.kind)];
    p.stride = stride;
    pool_index.push_back(static_cast<std::int32_t>(p.ids.size()));
    p.ids.push_back(id);
    p.data.resize(p.ids.size() * stride);

    for (int b = 0; b < kMaxInteractionBodies; ++b) {
        const bool used = b < info.bodies;
        const std::int32_t index = used ? d.body[static_cast<std::size_t>(b)].index : -1;
        body.push_back(index);
    }
    bodies.push_back(static_cast<std::uint8_t>(info.bodies));
    rows.push_back(static_cast<std::uint8_t>(info.rows));
    row_begin.push_back(row_count);
    jac_begin.push_back(0);
    arms.push_back(0);
    row_count += info.rows;

    rest_length.push_back(0.0);
    flags.push_back(flags_of(d, spec[0], bodies_in));
    geo.push_back(geometry == generic::Geometry::none ? -1 : geo_count++);
    active.push_back(1.0);
    parted.push_back(0);
    coarse.push_back(0);
    repeats.push_back(0);
    completed.push_back(0);
    swing.push_back(0.0);
    held.push_back(0.0);
    lightness.push_back(geometry == generic::Geometry::line ? lightest_end(d, bodies_in) : 0.0);
    alert.push_back(0.0);
    low.push_back(0.0);
    high.push_back(0.0);
    force_range(d, flags.back(), low.back(), high.back());
    anchor.push_back(0.0);
    write_data(id);
    add_loads(d);

    for (int r = 0; r < info.rows; ++r) {
        const auto k = static_cast<std::size_t>(r);
        d.compliance[k] = spec[r].compliance;
        // One that is the scheme's own stays unsaid: a copy is to know that no damper stands for
        // it.
        if (!spec[r].calmed) d.damping_time[k] = spec[r].damping_time;
        epsilon.push_back(spec[r].compliance);
        tau.push_back(spec[r].damping_time);
        const bool damper = !spec[r].velocity && !spec[r].calmed;
        row_flags.push_back(static_cast<std::uint8_t>((spec[r].velocity ? kRowVelocity : 0) |
                                                      (spec[r].gap ? kRowGap : 0) |
                                                      (damper ? kRowDamper : 0)));
        for (base::Array<double>* a : {&mobility, &upsilon, &recall, &inv_sigma, &least_sigma, &g,
                                       &c, &residual, &lambda, &multiplier, &force})
            a->push_back(0.0);
        share_damping(upsilon.size() - 1, kind_info(d.kind).is(kWireElement), h);
        sigma.push_back(spec[r].velocity ? spec[r].compliance / h
                                         : 4.0 * spec[r].compliance * upsilon.back() / (h * h));
    }
    if (kind_info(d.kind).is(kWireElement)) follow_length(id, bodies_in, h);
    if (kind_info(d.kind).is(kWoundUp) && (flags.back() & kFromLength)) winches.push_back(id);
    if (flags.back() & kMotor) {
        motors.push_back(id);
        saturated.push_back(0);
    }
    if (flags.back() & kFriction) {
        frictions.push_back(id);
        set_anchor(id, row_state(id, bodies_in).g[0]);
    }
    if (flags.back() & (kMotor | kFriction | kCarried)) working.push_back(id);
    return id;
}

void Interactions::add_loads(const InteractionDef& d) {
    load_begin.push_back(-1);
    if (!d.load[0].interaction.valid() && !d.load[1].interaction.valid()) return;
    load_begin.back() = static_cast<std::int32_t>(loads.size());
    for (const FrictionLoad& load : d.load) {
        Load& l = loads.emplace_back();
        if (!load.interaction.valid()) continue;
        const auto of = at(load.interaction.index);
        const std::string_view units = kind_info(def[of].kind).row_units;
        l.row_begin = row_begin[of];
        l.rows = static_cast<std::int32_t>(std::min(units.find_first_not_of('m'), units.size()));
        l.factor = load.factor;
    }
}

/// Write the Data of an interaction into its pool.
void Interactions::write_data(int id) noexcept {
    const InteractionDef& d = def[at(id)];
    Pool& p = pool[static_cast<std::size_t>(d.kind)];
    generic::with_kind(d.kind, [&]<class K>() {
        typename K::Data data = K::make(d);
        if constexpr (requires { data.anchor; }) data.anchor = anchor[at(id)];
        std::memcpy(p.data.data() + at(pool_index[at(id)]) * p.stride, &data, sizeof data);
    });
}

void Interactions::set_anchor(int id, double coordinate) noexcept {
    anchor[at(id)] = coordinate;
    write_data(id);
}

void Interactions::truncate(int kept) {
    const auto n = at(kept);
    if (kept >= count()) return;
    row_count = row_begin[n];
    for (Pool& p : pool) {
        while (!p.ids.empty() && p.ids.back() >= kept) p.ids.pop_back();
        p.data.resize(p.ids.size() * p.stride);
    }
    geo_count -= static_cast<std::int32_t>(
        std::count_if(geo.begin() + kept, geo.end(), [](std::int32_t i) { return i >= 0; }));
    def.resize(n);
    pool_index.resize(n);
    body.resize(kMaxInteractionBodies * n);
    for (base::Array<std::uint8_t>* a :
         {&bodies, &rows, &flags, &parted, &coarse, &repeats, &completed, &arms})
        a->resize(n);
    row_begin.resize(n);
    jac_begin.resize(n);
    geo.resize(n);
    for (base::Array<double>* a :
         {&active, &held, &low, &high, &anchor, &rest_length, &lightness, &alert, &swing})
        a->resize(n);
    load_begin.resize(n);
    const auto m = at(row_count);
    for (base::Array<double>* a :
         {&epsilon, &tau, &mobility, &upsilon, &recall, &sigma, &least_sigma, &inv_sigma, &g, &c,
          &residual, &lambda, &multiplier, &force})
        a->resize(m);
    row_flags.resize(m);
}

void Interactions::mirror(int copy, int original, const Bodies& bodies_in, double h) noexcept {
    InteractionDef& d = def[at(copy)];
    const InteractionDef& from = def[at(original)];
    parted[at(copy)] = parted[at(original)];
    if (d.params == from.params &&
        epsilon[at(row_begin[at(copy)])] == epsilon[at(row_begin[at(original)])])
        return;
    d.params = from.params;
    refresh(copy, bodies_in, h);
    rest_length[at(copy)] = rest_length[at(original)];
    for (int r = 0; r < rows[at(copy)]; ++r) {
        const auto row = at(row_begin[at(copy)] + r), of = at(row_begin[at(original)] + r);
        epsilon[row] = epsilon[of];
        // A rigid row's Σ is that of the analysis.
        if ((row_flags[row] & kRowVelocity) || epsilon[row] == 0.0) continue;
        share_damping(row, kind_info(d.kind).is(kWireElement), h);
        sigma[row] = std::max(4.0 * epsilon[row] * upsilon[row] / (h * h), least_sigma[row]);
        if (inv_sigma[row] != 0.0) inv_sigma[row] = 1.0 / sigma[row];
    }
}

void Interactions::mark_driven(int id) {
    flags[at(id)] |= kByInput;
    const auto place = std::lower_bound(working.begin(), working.end(), id);
    if (place == working.end() || *place != id) working.insert(place, id);
}

void Interactions::refresh(int id, const Bodies& bodies_in, double h) noexcept {
    const InteractionDef& d = def[at(id)];
    write_data(id);
    force_range(d, flags[at(id)], low[at(id)], high[at(id)]);
    if (kind_info(d.kind).is(kWireElement)) follow_length(id, bodies_in, h);
}

void Interactions::follow_length(int id, const Bodies& bodies_in, double h) noexcept {
    const InteractionDef& d = def[at(id)];
    const double whole = d.params[0];
    double length = whole;
    if (kind_info(d.kind).is(kWoundUp))
        length += d.params[4] * bodies_in.x[3 * at(d.body[2].index)];
    // A drum may wind in more than the element holds; its law then keeps the stiffness of the rest.
    constexpr double kShortest = 0.01;
    length = std::max(length, kShortest * whole);
    rest_length[at(id)] = length;
    if (!(flags[at(id)] & kFromLength)) return;
    const auto row = at(row_begin[at(id)]);
    epsilon[row] = length / d.params[1];
    share_damping(row, true, h);
    sigma[row] = std::max(4.0 * epsilon[row] * upsilon[row] / (h * h), least_sigma[row]);
    if (inv_sigma[row] != 0.0) inv_sigma[row] = 1.0 / sigma[row];
}

template <class F>
void Interactions::evaluated(int id, const Bodies& b, F&& f) const noexcept {
    const Pool& p = pool[static_cast<std::size_t>(def[at(id)].kind)];
    const std::byte* bytes = p.data.data() + at(pool_index[at(id)]) * p.stride;
    generic::with_kind(def[at(id)].kind, [&]<class K>() {
        typename K::Data data;
        std::memcpy(&data, bytes, sizeof data);
        generic::BodyRef refs[K::kBodies];
        for (int k = 0; k < K::kBodies; ++k) {
            const std::int32_t i = body[at(kMaxInteractionBodies * id + k)];
            const double* x = &b.x[3 * at(i)];
            refs[k] = {{x[0], x[1], x[2]}, &b.r[9 * at(i)], b.dof(i) == 6 || b.dof(i) == 0};
        }
        generic::Rows<K::kBodies, K::kRows> rows_now;
        K::evaluate(data, refs, rows_now);
        f.template operator()<K>(rows_now);
    });
}

void Interactions::add_impulse(int id, int slot, const Bodies& b, const double* impulse,
                               double* out) const noexcept {
    evaluated(id, b, [&]<class K>(const auto& now) {
        if (slot >= K::kBodies) return;
        for (int r = 0; r < K::kRows; ++r)
            for (int j = 0; j < 6; ++j) out[j] += now.J[slot][r][j] * impulse[r];
    });
}

RowState Interactions::row_state(int id, const Bodies& b, const double* v_in) const noexcept {
    RowState out{};
    const double* moving_v = v_in ? v_in : b.v.data();
    evaluated(id, b, [&]<class K>(const auto& evaluated) {
        for (int r = 0; r < K::kRows; ++r) out.g[r] = evaluated.g[r];
        for (int k = 0; k < K::kBodies; ++k) {
            const std::int32_t i = body[at(kMaxInteractionBodies * id + k)];
            const int dof = b.dof(i);
            const double* v = dof > 0 ? moving_v + b.dof_begin[at(i)] : &b.v_fixed[6 * at(i)];
            for (int r = 0; r < K::kRows; ++r)
                for (int j = 0; j < (dof > 0 ? dof : 6); ++j)
                    (dof > 0 ? out.rate : out.carried)[r] += evaluated.J[k][r][j] * v[j];
        }
    });
    return out;
}

double Interactions::elastic(int id, const Bodies& b, double h) const noexcept {
    if (active[at(id)] == 0.0 || (flags[at(id)] & kFriction)) return 0.0;
    const RowState s = row_state(id, b);
    double energy = 0.0;
    for (int r = 0; r < rows[at(id)]; ++r) {
        const auto row = at(row_begin[at(id)] + r);
        if ((row_flags[row] & kRowVelocity) || !holds_energy(epsilon[row], rest_length[at(id)]))
            continue;
        const double middle = s.g[r] - 0.5 * h * (s.rate[r] + s.carried[r]);
        energy += 0.5 * middle * middle / epsilon[row];
    }
    return energy;
}

std::size_t Interactions::bytes() const noexcept {
    using base::bytes;
    std::size_t total =
        bytes(def) + bytes(pool_index) + bytes(body) + bytes(bodies) + bytes(rows) + bytes(flags) +
        bytes(row_begin) + bytes(jac_begin) + bytes(arms) + bytes(geo) + bytes(active) +
        bytes(held) + bytes(low) + bytes(high) + bytes(anchor) + bytes(load_begin) + bytes(loads) +
        bytes(parted) + bytes(coarse) + bytes(repeats) + bytes(completed) + bytes(swing) +
        bytes(lightness) + bytes(alert) + bytes(rest_length) + bytes(epsilon) + bytes(tau) +
        bytes(mobility) + bytes(upsilon) + bytes(recall) + bytes(sigma) + bytes(inv_sigma) +
        bytes(g) + bytes(c) + bytes(residual) + bytes(lambda) + bytes(multiplier) + bytes(force) +
        bytes(row_flags) + bytes(jacobian);
    for (const Pool& p : pool) total += bytes(p.ids) + bytes(p.data);
    return total;
}

}  // namespace hawser::model
