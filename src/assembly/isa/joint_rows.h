// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file joint_rows.h
/// Version of evaluate() for eight compact joints (model/arms.h) with consecutive indices, one per
/// lane. Arrays by joint are then read without gathers. If the joints connect consecutive bodies,
/// as in a chain, arrays by body are read without gathers, too:
/// ```
///   joint l:   body b + l ──●── body b + l + 1
/// ```
/// The lanes of the second bodies are those of the first ones shifted by one, with one more body.

#include "assembly/isa/arms.h"
#include "assembly/isa/rigid_lanes.h"
#include "assembly/isa/slack.h"
#include "assembly/view.h"
#include "base/lanes.h"

#include <algorithm>
#include <cstring>

namespace hawser::HAWSER_ISA {

class JointRows {
  public:
    explicit JointRows(const assembly::View& view) : view_(view) {}

    /// Select eight compact joints from ids[0] on, with consecutive indices. @return false if
    /// vector loads would exceed the arrays.
    bool take(const std::int32_t* ids) {
        id_ = ids[0];
        const std::int32_t* body = view_.body + kMaxInteractionBodies * id_;
        const std::int32_t first = body[0];
        std::int32_t last = 0, separation = 0;
        for (int l = 0; l < kLanes; ++l)
            for (int b = 0; b < 2; ++b) {
                const std::int32_t i = body[kMaxInteractionBodies * l + b];
                body_[b][l] = i;
                last = std::max(last, i);
                separation |= i - first - l - b;
            }
        chain_ = separation == 0;
        return kExactLoads || chain_ ||
               (last + 3 <= view_.body_count && view_.dof_begin[last] + kLanes <= view_.dof_count);
    }

    /// Evaluate the joints. @param data  Data of the eight joints: a point of body 0 and a point of
    /// body 1, body frames.
    template <class Data>
    void evaluate(const Data* data) const {
        static_assert(sizeof(Data) == 6 * sizeof(double));
        V8 point[kLanes];
        for (int l = 0; l < kLanes; ++l) point[l] = load_first(data[l].point[0], 6);
        transpose(point);
        W3 x[2], arm[2];
        load_poses(point, x, arm);
        V8 v[2][kLanes];
        load_velocities(view_.v, v);

        const std::int32_t row = view_.row_begin[id_];
        const double inv_h4 = 4.0 / view_.h;
        const W3 gap = x[1] + arm[1] - x[0] - arm[0];
        const W3 speed = joint_speeds(v[0], v[1], arm[0], arm[1]);
        V8 g[3], s[3];
        as_threes(gap.x, gap.y, gap.z, g);
        as_threes(speed.x, speed.y, speed.z, s);
        for (int k = 0; k < 3; ++k) {
            const std::int32_t r = row + kLanes * k;
            store(view_.g + r, g[k]);
            store(view_.c + r,
                  load(view_.upsilon + r) * (load(view_.recall + r) * s[k] - inv_h4 * g[k]));
        }
        slack(row, s);
        part();
        const JointTerms<W8> terms = record(arm);
        W3 start{}, back = terms.back * joint_turns(v[0], v[1]);
        if (view_.v_start) {
            load_velocities(view_.v_start, v);
            const W3 begin = joint_speeds(v[0], v[1], arm[0], arm[1]);
            as_threes(begin.x, begin.y, begin.z, s);
            for (int k = 0; k < 3; ++k) store(view_.residual + row + kLanes * k, s[k]);
            start = terms.damping * joint_turns(v[0], v[1]);
        }
        V8 force[kLanes] = {start.x, start.y, start.z, -back.x, -back.y, -back.z, V8{}, V8{}};
        store_bodies(view_.geo_force + view_.geo[id_].force, 6, 6, force);
    }

  private:
    const assembly::View& view_;
    std::int32_t id_ = 0, body_[2][kLanes];
    bool chain_ = false;  ///< True for a chain, see above.

    /// Load the centres of mass and the arms of the joints, world frame.
    HAWSER_INLINE void load_poses(const V8 (&point)[kLanes], W3 (&x)[2], W3 (&arm)[2]) const {
        WM3 r[2];
        if (chain_) {
            const std::int64_t first = body_[0][0], last = body_[1][kLanes - 1];
            x[0] = load_threes(view_.x + 3 * first);
            x[1] = load_threes(view_.x + 3 * first + 3);
            r[0] = load_bodies9(view_.r + 9 * first);
            for (int i = 0; i < 9; ++i) r[1].a[i] = shift_in(r[0].a[i], view_.r[9 * last + i]);
        } else {
            for (int b = 0; b < 2; ++b) {
                V8 t[kLanes], end[kLanes];
                load_by_body(view_.x, b, 3, t);
                x[b] = {t[0], t[1], t[2]};
                load_by_body(view_.r, b, 9, t);
                load_by_body(view_.r + 1, b, 9, end);
                r[b] = {{t[0], t[1], t[2], t[3], t[4], t[5], t[6], t[7], end[7]}};
            }
        }
        for (int b = 0; b < 2; ++b)
            arm[b] = r[b] * W3{point[3 * b], point[3 * b + 1], point[3 * b + 2]};
    }
    /// Load up to eight of the `scale` doubles of body b of each joint.
    void load_by_body(const double* base, int b, int scale, V8 (&v)[kLanes]) const {
        const int own = std::min(scale, kLanes);
        for (int l = 0; l < kLanes; ++l)
            v[l] = load_at_least(base + std::int64_t{scale} * body_[b][l], own);
        transpose(v);
    }

    /// Load six entries per body from a vector packed like v.
    HAWSER_INLINE void load_velocities(const double* packed, V8 (&v)[2][kLanes]) const {
        if (chain_) {
            const double* first = packed + view_.dof_begin[body_[0][0]];
            load_bodies(first, 6, v[0]);
            for (int i = 0; i < 6; ++i) v[1][i] = shift_in(v[0][i], first[6 * kLanes + i]);
            return;
        }
        for (int b = 0; b < 2; ++b)
            load_slots(
                view_, id_, b, packed, [&](std::int32_t i) { return view_.dof_begin[i]; }, v[b]);
    }

    /// Add the term of slack lines (when_slack()) to c of one-sided joints.
    /// @param speed  Speeds in the order of the rows.
    void slack(std::int32_t row, const V8 (&speed)[3]) const {
        std::uint64_t flags;
        std::memcpy(&flags, view_.flags + id_, sizeof flags);
        if ((flags & 0x0101010101010101) == 0) return;
        for (int k = 0; k < 3 * kLanes; ++k) {
            if ((view_.flags[id_ + k / 3] & 1) == 0) continue;
            const std::int32_t r = row + k;
            view_.c[r] += when_slack(view_.g[r], lane(speed[k / kLanes], k % kLanes),
                                     view_.upsilon[r] * view_.recall[r], view_.h);
        }
    }
    /// Write zeros to the rows of broken joints among the eight.
    void part() const {
        std::uint64_t parted;
        std::memcpy(&parted, view_.parted + id_, sizeof parted);
        if (parted == 0) return;
        for (int l = 0; l < kLanes; ++l)
            if (view_.parted[id_ + l]) view_.active[id_ + l] = 0.0;
    }

    /// Write the compact Jacobians (model/arms.h) of the eight joints. @return their terms of
    /// geometric stiffness.
    HAWSER_INLINE JointTerms<W8> record(const W3 (&arm)[2]) const {
        const W8 on = (1.0 / view_.h) * W8(load(view_.active + id_));
        const W3 f = on * load_threes(view_.lambda + view_.row_begin[id_]);
        double* out = view_.jacobian + view_.jac_begin[id_];
        const double* last = out + model::kArmsVibration;
        const W8 vibration{last[0],  last[8],  last[16], last[24],
                           last[32], last[40], last[48], last[56]};
        static_assert(model::kArms == 8);
        const JointTerms<W8> terms =
            joint_terms(view_, norm(f), norm(arm[0]), norm(arm[1]), vibration);
        V8 t[kLanes] = {arm[0].x, arm[0].y, arm[0].z,      arm[1].x,
                        arm[1].y, arm[1].z, terms.damping, vibration};
        transpose(t);
        for (int l = 0; l < kLanes; ++l) store(out + model::kArms * l, t[l]);
        return terms;
    }
};

}  // namespace hawser::HAWSER_ISA
