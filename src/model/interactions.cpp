// SPDX-License-Identifier: Apache-2.0
#define HAWSER_KIND_SETUP
#include "model/interactions.h"

#include "base/index.h"
#include "base/sorted.h"
#include "model/kinds/all.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace hawser::model {
void complete(InteractionDef& def, const Vec3* positions, double distance) {
    const KindInfo& info = kind_info(def.kind);
    // A list with fewer points than the definition can hold leaves the others uninitialised.
    for (std::size_t b = at(info.bodies); b < kMaxInteractionBodies; ++b) {
        def.body[b] = {};
        def.point[b].setZero();
        def.frame[b].setIdentity();
    }
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

/// Write the data record of an interaction to the pool of its kind.
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

/// Set the range of the force of the first row [N or N m].
void Interactions::set_range(int id) noexcept {
    const InteractionDef& d = def[at(id)];
    low[at(id)] = (flags[at(id)] & kRange) != 0 ? kUnbounded : -kUnbounded;
    high[at(id)] = kUnbounded;
    power[at(id)] = kUnbounded;
    if (flags[at(id)] & kMotor) {
        power[at(id)] = d.params[3];
        low[at(id)] = d.params[1];
        high[at(id)] = d.params[2];
    } else if (flags[at(id)] & kFriction) {
        low[at(id)] = -d.params[0];
        const bool band = d.kind == InteractionKind::ScalarFriction;
        high[at(id)] = band ? d.params[1] * d.params[0] : d.params[0];
    } else if (flags[at(id)] & kOneSided) {
        high[at(id)] = 0.0;
    }
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
        // Σ of a rigid row is set by the analysis.
        if ((row_flags[row] & kRowVelocity) || epsilon[row] == 0.0) continue;
        update_damping_of_row(row, kind_info(d.kind).is(kWireElement), h);
    }
}

void Interactions::mark_driven(int id) {
    flags[at(id)] |= kByInput;
    base::insert_sorted(working, id);
}

void Interactions::unmark_driven(int id) noexcept {
    flags[at(id)] &= static_cast<std::uint8_t>(~kByInput);
    if (!(flags[at(id)] & (kMotor | kFriction | kCarried))) base::erase_sorted(working, id);
}

void Interactions::refresh(int id, const Bodies& bodies_in, double h) noexcept {
    const InteractionDef& d = def[at(id)];
    write_data(id);
    set_range(id);
    if (kind_info(d.kind).is(kWireElement)) update_length_at_drum(id, bodies_in, h);
}

double Interactions::length_at_drum_or_slide(int id, const Bodies& bodies_in) const noexcept {
    const InteractionDef& d = def[at(id)];
    const double length =
        d.params[0] + d.params[4] * (bodies_in.x[3 * at(d.body[2].index)] - d.params[5]);
    return d.kind == InteractionKind::WinchStretch
               ? std::max(length, kLeastOfDrumElement * d.params[0])
               : length;
}

void Interactions::update_length_at_drum(int id, const Bodies& bodies_in, double h) noexcept {
    const InteractionDef& d = def[at(id)];
    const double whole = d.params[0];
    double length = kind_info(d.kind).is(kWoundUp) ? length_at_drum_or_slide(id, bodies_in) : whole;
    // More line may run through a turning point than its last part holds; the law then keeps this
    // minimum length.
    constexpr double kMinLengthFraction = 0.01;
    length = std::max(length, kMinLengthFraction * whole);
    rest_length[at(id)] = length;
    if (!(flags[at(id)] & kFromLength)) return;
    const auto row = at(row_begin[at(id)]);
    epsilon[row] = length / d.params[1];
    update_damping_of_row(row, true, h);
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
        if constexpr (requires { f.template operator()<K>(rows_now, data, refs); })
            f.template operator()<K>(rows_now, data, refs);
        else
            f.template operator()<K>(rows_now);
    });
}

LineShape Interactions::line_shape(int id, const Bodies& b) const noexcept {
    LineShape out;
    evaluated(id, b, [&]<class K>(const auto& now, const auto& data, const auto& refs) {
        if constexpr (K::kBodies > 1 && K::kRows == 1) {
            generic::V3 arm[2]{};
            if constexpr (requires { K::line_arms(data, refs, arm); })
                K::line_arms(data, refs, arm);
            else if constexpr (requires { data.point[1]; })
                for (int k = 0; k < 2; ++k) arm[k] = refs[k].arm(data.point[k]);
            for (int k = 0; k < 2; ++k) {
                const generic::V3 at = refs[k].x + arm[k];
                out.at[k] = {at.x, at.y, at.z};
            }
            if constexpr (requires { data.end[1].radius; })
                for (int k = 0; k < 2; ++k) out.wheel[k] = data.end[k].radius;
            out.along = {now.J[1][0][0], now.J[1][0][1], now.J[1][0][2]};
            out.longer = now.g[0];
        }
    });
    return out;
}

std::array<double, 2> Interactions::wheel_angles(int id, const Bodies& b) const noexcept {
    std::array<double, 2> out{};
    evaluated(id, b, [&]<class K>(const auto&, const auto& data, const auto& refs) {
        if constexpr (requires { data.end[1].radius; }) {
            const generic::kinds::SpanShape shape = generic::kinds::span_shape(data.end, refs);
            out = {shape.angle[0], shape.angle[1]};
        }
    });
    return out;
}

std::array<double, 2> Interactions::wrapped(int id, const Bodies& b) const noexcept {
    std::array<double, 2> out = wheel_angles(id, b);
    const auto more = generic::kinds::WholeTurns::of(anchor[at(id)]);
    for (std::size_t k = 0; k < 2; ++k) out[k] += generic::kinds::kWholeTurn * more.turns[k];
    return out;
}

void Interactions::update_whole_turns(int id, const std::array<double, 2>& before,
                                      const Bodies& b) noexcept {
    const std::array<double, 2> now = wheel_angles(id, b);
    auto turns = generic::kinds::WholeTurns::of(anchor[at(id)]);
    bool any = false;
    for (std::size_t k = 0; k < 2; ++k) {
        const double passed = std::round((before[k] - now[k]) / generic::kinds::kWholeTurn);
        turns.turns[k] += passed;
        any = any || passed != 0.0;
    }
    if (any) set_anchor(id, turns.packed());
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

void Interactions::moved_gaps(int id, const Bodies& b, const double* v_in, const double* v_fixed,
                              double time, double* gaps) const noexcept {
    const Pool& p = pool[static_cast<std::size_t>(def[at(id)].kind)];
    const std::byte* bytes = p.data.data() + at(pool_index[at(id)]) * p.stride;
    using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
    generic::with_kind(def[at(id)].kind, [&]<class K>() {
        if constexpr (requires { requires K::kCompletes; }) {
            typename K::Data data;
            std::memcpy(&data, bytes, sizeof data);
            generic::BodyRef refs[K::kBodies];
            RowMajor turned[K::kBodies];
            for (int k = 0; k < K::kBodies; ++k) {
                const std::int32_t i = body[at(kMaxInteractionBodies * id + k)];
                const double* x = &b.x[3 * at(i)];
                const int dof = b.dof(i);
                const double* v = dof > 0 ? v_in + b.dof_begin[at(i)] : v_fixed + 6 * at(i);
                refs[k] = {{x[0] + time * v[0], x[1], x[2]}, &b.r[9 * at(i)], dof == 6 || dof == 0};
                if (dof == 1) continue;
                refs[k].x.y += time * v[1];
                refs[k].x.z += time * v[2];
                if (!refs[k].rotates) continue;
                turned[k] =
                    turn_by(v + 3, time).toRotationMatrix() * Eigen::Map<const RowMajor>(refs[k].r);
                refs[k].r = turned[k].data();
            }
            generic::Rows<K::kBodies, K::kRows> moved;
            K::evaluate(data, refs, moved);
            std::copy_n(moved.g, K::kRows, gaps);
        }
    });
}

void Interactions::secants_before(int id, const Bodies& b, double h, double* out) const noexcept {
    double now[kMaxInteractionRows], before[kMaxInteractionRows];
    const base::Array<double>& fixed = b.v_before.empty() ? b.v_fixed : b.v_before;
    moved_gaps(id, b, b.v.data(), b.v_fixed.data(), 0.0, now);
    moved_gaps(id, b, b.v.data(), fixed.data(), -h, before);
    for (std::size_t r = 0; r < rows[at(id)]; ++r) out[r] = (now[r] - before[r]) / h;
}

void Interactions::secants_after(int id, const Bodies& b, const double* v, double h,
                                 double* out) const noexcept {
    double now[kMaxInteractionRows], after[kMaxInteractionRows];
    moved_gaps(id, b, v, b.v_fixed.data(), 0.0, now);
    moved_gaps(id, b, v, b.v_fixed.data(), h, after);
    for (std::size_t r = 0; r < rows[at(id)]; ++r) out[r] = (after[r] - now[r]) / h;
}

double Interactions::elastic(int id, const Bodies& b, double h) const noexcept {
    // The energy of a line follows from its length, not from the status (taut or slack) of the last
    // step.
    const bool line = (flags[at(id)] & kOneSided) != 0;
    if ((line ? parted[at(id)] != 0 : active[at(id)] == 0.0) || (flags[at(id)] & kFriction))
        return 0.0;
    RowState s = row_state(id, b);
    if (uses_secants(id)) {
        secants_before(id, b, h, s.rate);
        std::fill_n(s.carried, kMaxInteractionRows, 0.0);
    }
    double energy = 0.0;
    for (int r = 0; r < rows[at(id)]; ++r) {
        const auto row = at(row_begin[at(id)] + r);
        if ((row_flags[row] & kRowVelocity) || !holds_energy(epsilon[row], rest_length[at(id)]))
            continue;
        double middle = s.g[r] - 0.5 * h * (s.rate[r] + s.carried[r]);
        // A short line that rotates far within a step appears longer than its force implies. Its
        // energy is limited to the recoverable part.
        constexpr double kMuchLonger = 4.0;
        const double pulls = std::fabs(force[row]) * epsilon[row];
        if (line && pulls > 0.0 && middle > kMuchLonger * pulls) middle = pulls;
        if (line && middle < 0.0) continue;
        energy += 0.5 * middle * middle / epsilon[row];
    }
    return energy;
}

std::size_t Interactions::bytes() const noexcept {
    using base::bytes;
    std::size_t total =
        slots.bytes() + bytes(def) + bytes(kinds) + bytes(pool_index) + bytes(body) +
        bytes(next_holder) + bytes(bodies) + bytes(rows) + bytes(flags) + bytes(row_begin) +
        bytes(jac_begin) + bytes(arms) + bytes(geo) + bytes(active) + bytes(held) + bytes(low) +
        bytes(high) + bytes(anchor) + bytes(load_begin) + bytes(loads) + bytes(parted) +
        bytes(coarse) + bytes(repeats) + bytes(completed) + bytes(upper) + bytes(vibration) +
        bytes(lightness) + bytes(pair_mass) + bytes(flagged) + bytes(rest_length) + bytes(power) +
        bytes(breaking) + bytes(defined) + bytes(epsilon) + bytes(tau) + bytes(mobility) +
        bytes(upsilon) + bytes(recall) + bytes(sigma) + bytes(inv_sigma) + bytes(g) + bytes(c) +
        bytes(residual) + bytes(lambda) + bytes(multiplier) + bytes(force) + bytes(row_flags) +
        bytes(jacobian);
    for (const Pool& p : pool) total += bytes(p.ids) + bytes(p.data);
    return total;
}

}  // namespace hawser::model
