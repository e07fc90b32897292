// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file lane_rows.h
/// Version of evaluate() for eight interactions of one kind at once, one per lane, if all of their
/// bodies are point masses. The formulas are the scalar ones: evaluate() of the kinds and geo.h are
/// templates over the number type.

#include "assembly/geo.h"
#include "assembly/isa/slack.h"
#include "assembly/view.h"
#include "base/lanes.h"
#include "base/transpose.h"
#include "model/kinds/all.h"

#include <algorithm>
#include <utility>

namespace hawser::HAWSER_ISA {

/// One point mass of each of eight interactions, in the interface that evaluate() needs.
struct NodeLanes {
    V3T<W8> x;
    [[nodiscard]] V3T<W8> arm(const W8*) const { return {W8{}, W8{}, W8{}}; }
};

template <class K>
struct LaneRows {
    static constexpr int B = K::kBodies, R = K::kRows, D = 3, W = B * D;

    explicit LaneRows(const assembly::View& v) : view(v) {}

    const assembly::View& view;
    std::int32_t id[kLanes], row[kLanes], body[B][kLanes];
    bool in_a_row = false;  ///< True if ids and rows are consecutive.

    /// Select eight interactions of View::among_nodes from ids[0] on. @return true if all qualify.
    bool take(const std::int32_t* ids) {
        for (int l = 0; l < kLanes; ++l) {
            id[l] = ids[l];
            row[l] = view.row_begin[id[l]];
            for (int b = 0; b < B; ++b) body[b][l] = view.body[kMaxInteractionBodies * id[l] + b];
        }
        in_a_row = id[kLanes - 1] - id[0] == kLanes - 1;  // ids ascend
        return true;
    }

    W8 pick(const double* values, const std::int32_t* index, int offset) const {
        return gather_range(values + offset, index, 0, kLanes);
    }

    /// Load a value of each row, by its number in the interaction.
    void load_rows(const double* values, V8 (&v)[R]) const {
        if constexpr (R <= 3)
            if (in_a_row) return load_every<R>(values + row[0], v);
        for (int r = 0; r < R; ++r) v[r] = pick(values, row, r);
    }
    void store_rows(double* values, const V8 (&v)[R]) const {
        if constexpr (R <= 3)
            if (in_a_row) return store_every<R>(values + row[0], v);
        for (int l = 0; l < kLanes; ++l)
            for (int r = 0; r < R; ++r) values[row[l] + r] = lane(v[r], l);
    }
    /// Load a value of each interaction.
    W8 load_each(const double* values) const {
        return in_a_row ? W8(load(values + id[0])) : pick(values, id, 0);
    }
    /// True if the flag is set in any interaction.
    bool any_flag(const std::uint8_t* flags, std::uint8_t mask) const {
        std::uint8_t all = 0;
        for (int l = 0; l < kLanes; ++l) all |= flags[id[l]];
        return (all & mask) != 0;
    }

    /// Load the data that evaluate() needs. Point masses have no attachment points: only lengths
    /// are read. The length of a wire element is stored separately.
    void load_data(const typename K::Data* data, typename K::template DataT<W8>& fields) const {
        const auto of_each = [&](auto member) {
            double value[kLanes];
            for (int l = 0; l < kLanes; ++l) value[l] = data[l].*member;
            return W8(load(value));
        };
        if constexpr (requires { K::kRestLength; })
            fields.length =
                in_a_row ? W8(load(view.rest_length + id[0])) : pick(view.rest_length, id, 0);
        else if constexpr (requires { data->length; })
            fields.length = of_each(&K::Data::length);
        if constexpr (requires { data->shortest; }) fields.shortest = of_each(&K::Data::shortest);
    }

    void evaluate(const typename K::Data* data) {
        NodeLanes refs[B];
        V8 v[B][D], start[B][D];
        for (int b = 0; b < B; ++b) {
            std::int32_t place[kLanes], from[kLanes];
            for (int l = 0; l < kLanes; ++l) {
                place[l] = 3 * body[b][l];
                from[l] = view.dof_begin[body[b][l]];
            }
            V8 x[D];
            load_lanes_of_three(view.x, place, are_contiguous<3>(place), x);
            refs[b].x = {x[0], x[1], x[2]};
            const bool in_turn = are_contiguous<3>(from);
            load_lanes_of_three(view.v, from, in_turn, v[b]);
            load_lanes_of_three(view.v_ahead, from, in_turn, start[b]);
        }
        typename K::template DataT<W8> fields{};
        load_data(data, fields);
        Rows<B, R, W8> rows;
        K::evaluate(fields, refs, rows);
        write_rows(rows, v, start);
        write_jacobian(rows);
        if (any_flag(view.parted, 0xff))
            for (int l = 0; l < kLanes; ++l)
                if (view.parted[id[l]]) view.active[id[l]] = 0.0;
        if constexpr (K::kGeometry == Geometry::line) line(refs, rows, v, start);
    }

    /// Compute G u, one entry per row, for u by body.
    HAWSER_INLINE static void products(const Rows<B, R, W8>& rows, const V8 (&u)[B][D],
                                       V8 (&out)[R]) {
        for (int r = 0; r < R; ++r) {
            out[r] = rows.J[0][r][0] * u[0][0];
            for (int b = 0; b < B; ++b)
                for (int j = b == 0 ? 1 : 0; j < D; ++j) out[r] += rows.J[b][r][j] * u[b][j];
        }
    }

    HAWSER_INLINE void write_rows(const Rows<B, R, W8>& rows, const V8 (&v)[B][D],
                                  const V8 (&start)[B][D]) const {
        const double inv_h4 = 4.0 / view.h;
        V8 speed[R], upsilon[R], recall[R], c[R], g[R];
        products(rows, v, speed);
        load_rows(view.upsilon, upsilon);
        load_rows(view.recall, recall);
        for (int r = 0; r < R; ++r) {
            g[r] = rows.g[r];
            c[r] = upsilon[r] * (recall[r] * speed[r] - inv_h4 * g[r]);
        }
        store_rows(view.g, g);
        store_rows(view.c, c);
        if (any_flag(view.flags, 1))
            for (int l = 0; l < kLanes; ++l)
                for (int r = 0; r < R && (view.flags[id[l]] & 1); ++r)
                    view.c[row[l] + r] +=
                        when_slack(lane(g[r], l), lane(speed[r], l),
                                   view.upsilon[row[l] + r] * view.recall[row[l] + r], view.h);
        if (!view.v_start) return;
        products(rows, start, speed);
        store_rows(view.residual, speed);
    }

    /// Write the packed Jacobians, eight entries of each at a time. The last eight overlap with
    /// others, so that all vectors are complete.
    void write_jacobian(const Rows<B, R, W8>& rows) const {
        constexpr int size = R * W;
        [&]<int... I>(std::integer_sequence<int, I...>) {
            (write_entries<size <= kLanes ? 0 : std::min(I * kLanes, size - kLanes)>(rows), ...);
        }(std::make_integer_sequence<int, (size + kLanes - 1) / kLanes>());
    }

    /// Write eight entries from `Begin` on, or the remaining ones.
    template <int Begin>
    void write_entries(const Rows<B, R, W8>& rows) const {
        constexpr int count = std::min(R * W - Begin, kLanes);
        V8 t[kLanes] = {};
        [&]<int... I>(std::integer_sequence<int, I...>) {
            ((t[I] = rows.J[(Begin + I) % W / D][(Begin + I) / W][(Begin + I) % W % D]), ...);
        }(std::make_integer_sequence<int, count>());
        put<Begin, count>(view.jacobian, [&](std::int32_t k) { return view.jac_begin[k]; }, t);
    }

    /// Write entries [Begin, Begin + Count) to base + start(id).
    template <int Begin, int Count, class Start>
    void put(double* base, Start start, V8 (&t)[kLanes]) const {
        transpose(t);
        for (int l = 0; l < kLanes; ++l) {
            double* to = base + start(id[l]) + Begin;
            if constexpr (Count == kLanes)
                store(to, t[l]);
            else
                store_lanes(to, t[l], 0, Count);
        }
    }
    template <int Begin, int Count>
    void put_record(V8 (&t)[kLanes]) const {
        put<Begin, Count>(view.geo_record, [&](std::int32_t i) { return view.geo[i].record; }, t);
    }
    template <int Begin, int Count>
    void put_force(V8 (&t)[kLanes]) const {
        put<Begin, Count>(view.geo_force, [&](std::int32_t i) { return view.geo[i].force; }, t);
    }

    /// Compute the record of a line between point masses, and its parts of M̃ v and of a.
    void line(const NodeLanes* refs, const Rows<B, R, W8>& rows, const V8 (&v)[B][D],
              const V8 (&start)[B][D]) const {
        const double scale = view.h * view.h * view.geometric_stiffness;
        V8 lambda[R];
        load_rows(view.lambda, lambda);
        const W8 none{}, tension = (-1.0 / view.h) * W8(lambda[0]);
        const W8 length = norm(refs[1].x - refs[0].x);
        const W8 at_least = constant(length, 1e-9);
        const W8 size = select_greater(length, at_least, length, at_least);
        const W8 pulls = positive_part(tension) * load_each(view.active);
        const W8 full = scale * pulls * (1.0 / size);  // h² T/l
        const auto [late, ahead] =
            across_fractions(W8(full * load_each(view.lightness)), load_each(view.flagged));
        const W8 w = (late + ahead) * full;
        const V3T<W8> u{rows.J[1][0][0], rows.J[1][0][1], rows.J[1][0][2]};
        V8 record[kLanes] = {w, u.x, u.y, u.z, none, none, none, none};
        put_record<0, assembly::kGeoLine>(record);
        const V3T<W8> rel{v[0][0] - v[1][0], v[0][1] - v[1][1], v[0][2] - v[1][2]};
        const V3T<W8> begin{start[0][0] - start[1][0], start[0][1] - start[1][1],
                            start[0][2] - start[1][2]};
        const V3T<W8> mix = late * rel + ahead * begin;
        V3T<W8> t = full * (mix - dot(u, mix) * u);
        V3T<W8> s{none, none, none};
        if (view.v_start) s = w * (begin - dot(u, begin) * u);
        if (view.pair_mass) {
            double masses[kLanes];
            for (int l = 0; l < kLanes; ++l) masses[l] = pair_mass_of(view, id[l]);
            const W8 pair = load(masses);
            t = t - pair * rel;
            if (view.v_start) s = s - pair * begin;
        }
        V8 force[kLanes] = {s.x, s.y, s.z, t.x, t.y, t.z, none, none};
        put_force<0, 6>(force);
    }
};

}  // namespace hawser::HAWSER_ISA
