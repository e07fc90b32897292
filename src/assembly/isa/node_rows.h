// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file node_rows.h
/// Version of row_update() for rows between point masses: elements of wires (one row, two bodies)
/// and their bends (two rows, three bodies). Eight interactions are updated at once, one per lane.
///
/// The interactions are collected by kind in any order. An incomplete group repeats its last
/// interaction in the remaining lanes. All interactions of these kinds are updated in lanes, so
/// the bits of a result do not depend on the group that it is in.

#include "assembly/isa/geo_force.h"
#include "base/lanes.h"
#include "base/transpose.h"

namespace hawser::HAWSER_ISA {

/// Group of up to eight interactions with R condensed rows between B point masses.
template <int R, int B>
class NodeRows {
  public:
    static constexpr int kDof = 3, kWidth = B * kDof, kEntries = R * kWidth;
    /// True if the interactions have geometric terms of a line (assembly/geo.h): one slot for both
    /// bodies.
    static constexpr bool kLine = B == 2;

    NodeRows(const assembly::View& view, bool first) : view_(view), first_(first) {}

    /// True if this interaction belongs to the kind.
    [[nodiscard]] HAWSER_INLINE static bool accepts(const assembly::View& view, std::int32_t id) {
        return view.among_nodes[id] != 0 && view.rows[id] == R && view.bodies[id] == B &&
               view.interaction_offset[id] < 0 && (view.geo[id].record >= 0) == kLine;
    }
    /// Add an interaction to the present group. Update the group when it has one interaction per
    /// lane.
    HAWSER_INLINE void add(std::int32_t id) {
        id_[count_++] = id;
        if (count_ == kLanes) update();
    }
    /// Update the last, incomplete group.
    void finish() {
        if (count_ > 0) update();
    }

  private:
    /// Load a value of each interaction.
    [[nodiscard]] HAWSER_INLINE V8 load_each(const double* values) const {
        return in_a_row_ ? load(values + id_[0]) : gather_range(values, id_, 0, kLanes);
    }
    /// Load a value of each row, by its number in the interaction.
    HAWSER_INLINE void load_rows(const double* values, V8 (&v)[R]) const {
        if (in_a_row_) return load_every<R>(values + row_[0], v);
        for (int r = 0; r < R; ++r) v[r] = gather_range(values + r, row_, 0, kLanes);
    }
    HAWSER_INLINE void store_rows(double* values, const V8 (&v)[R]) const {
        if (in_a_row_) return store_every<R>(values + row_[0], v);
        for (int r = 0; r < R; ++r) {
            double lanes[kLanes];
            store(lanes, v[r]);
            for (int l = 0; l < count_; ++l) values[row_[l] + r] = lanes[l];
        }
    }

    /// Load the velocities of body `slot`, from a vector packed by `offset`.
    HAWSER_INLINE void load_body(const double* u, const std::int32_t* offset, int slot,
                                 V8 (&out)[kDof]) const {
        std::int32_t from[kLanes];
        for (int l = 0; l < kLanes; ++l)
            from[l] = offset[view_.body[kMaxInteractionBodies * id_[l] + slot]];
        if (are_contiguous<kDof>(from)) return load_threes(u + from[0], out);
        V8 t[kLanes];
        for (int l = 0; l < kLanes; ++l) t[l] = load_at_least(u + from[l], kDof);
        transpose(t);
        for (int k = 0; k < kDof; ++k) out[k] = t[k];
    }

    HAWSER_INLINE void load_jacobian(V8 (&jac)[kEntries]) const {
        std::int32_t begin[kLanes];
        for (int l = 0; l < kLanes; ++l) begin[l] = view_.jac_begin[id_[l]];
        constexpr int kWhole = kEntries / kLanes * kLanes;
        for (int from = 0; from < kEntries; from += kLanes) {
            if (from == kWhole && kEntries - from <= 2) {  // too few for a transposition
                for (int k = from; k < kEntries; ++k)
                    jac[k] = gather_range(view_.jacobian + k, begin, 0, kLanes);
                break;
            }
            V8 t[kLanes];
            for (int l = 0; l < kLanes; ++l)
                t[l] = load_at_least(view_.jacobian + begin[l] + from,
                                     kEntries - from < kLanes ? kEntries - from : kLanes);
            transpose(t);
            for (int k = 0; k < kLanes && from + k < kEntries; ++k) jac[from + k] = t[k];
        }
    }

    /// Return row r of G u.
    [[nodiscard]] HAWSER_INLINE static V8 product(const V8 (&jac)[kEntries], const V8 (&u)[B][kDof],
                                                  int r) {
        V8 sum = jac[r * kWidth] * u[0][0];
        for (int k = 1; k < kWidth; ++k) sum += jac[r * kWidth + k] * u[k / kDof][k % kDof];
        return sum;
    }

    /// Compute geo_force() of the lines for the velocities v₊ of their ends.
    HAWSER_INLINE void update_line(const V8 (&v)[B][kDof]) const {
        V8 t[kLanes];
        for (int l = 0; l < kLanes; ++l)
            t[l] = load_at_least(view_.geo_record + view_.geo[id_[l]].record, assembly::kGeoLine);
        transpose(t);
        const V3T<W8> along{t[1], t[2], t[3]},
            speed{v[0][0] - v[1][0], v[0][1] - v[1][1], v[0][2] - v[1][2]};
        V3T<W8> force = W8(t[0]) * (speed - dot(along, speed) * along);
        if (view_.pair_mass) {
            double masses[kLanes];
            for (int l = 0; l < kLanes; ++l) masses[l] = pair_mass_of(view_, id_[l]);
            force = force - W8(load(masses)) * speed;
        }
        V8 out[kLanes] = {force.x, force.y, force.z};
        transpose(out);
        for (int l = 0; l < count_; ++l)
            store_first<3>(view_.geo_force + view_.geo[id_[l]].force, out[l]);
    }

    void update() {
        for (int l = count_; l < kLanes; ++l) id_[l] = id_[count_ - 1];
        for (int l = 0; l < kLanes; ++l) row_[l] = view_.row_begin[id_[l]];
        in_a_row_ = are_contiguous<1>(id_) && are_contiguous<R>(row_);
        V8 jac[kEntries], change[B][kDof], now[B][kDof];
        load_jacobian(jac);
        for (int b = 0; b < B; ++b) load_body(view_.solution, view_.body_offset, b, change[b]);
        if (!first_ || kLine)
            for (int b = 0; b < B; ++b) load_body(view_.v_new, view_.dof_begin, b, now[b]);
        const V8 on = load_each(view_.active), held = load_each(view_.held);
        V8 sigma[R], inverse[R], last[R], asked[R] = {}, before[R] = {}, multiplier[R];
        load_rows(view_.sigma, sigma);
        load_rows(view_.inv_sigma, inverse);
        load_rows(view_.residual, last);
        if (!first_) {
            load_rows(view_.c, asked);
            load_rows(view_.lambda, before);
        }
        for (int r = 0; r < R; ++r) {
            const V8 kept = r == 0 ? V8((one(on) - on) * held) : V8{};
            const V8 step = product(jac, change, r);
            if (first_) before[r] = kept;
            const V8 lambda = before[r] + on * inverse[r] * (last[r] - step);
            // The first residual is that of the initial velocities and λ = 0.
            const V8 residual =
                first_ ? V8(last[r] - on * step - sigma[r] * lambda)
                       : V8(on * (asked[r] - product(jac, now, r)) - sigma[r] * (lambda - kept));
            multiplier[r] = on * (lambda + inverse[r] * residual) + kept;
            before[r] = lambda;
            last[r] = residual;
        }
        store_rows(view_.lambda, before);
        store_rows(view_.residual, last);
        store_rows(view_.multiplier, multiplier);
        if constexpr (kLine) update_line(now);
        count_ = 0;
    }

    const assembly::View& view_;
    const bool first_;
    int count_ = 0;
    bool in_a_row_ = false;  ///< True if ids and rows are consecutive.
    std::int32_t id_[kLanes] = {}, row_[kLanes] = {};
};

}  // namespace hawser::HAWSER_ISA
