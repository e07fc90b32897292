// SPDX-License-Identifier: Apache-2.0
/// Ops of several lanes of one batch step become one.
#include "assembly/system.h"
#include "base/index.h"

#include <algorithm>
#include <bit>

namespace hawser::assembly {
namespace {

/// What ops of several lanes have in common, in one number; of a joint whose slots may change
/// places (`turns`) whichever comes first.
std::uint64_t lane_key(const Op& op, std::uint8_t rows, bool turns) noexcept {
    const bool swap = turns && op.a > op.b;
    std::uint64_t key = op.kind;
    key = key << 8 | (swap ? op.b : op.a);
    key = key << 8 | (swap ? op.a : op.b);
    key = key << 8 | op.dof_a;
    key = key << 8 | op.dof_b;
    key = key << 8 | op.width;
    return key << 8 | rows;
}

/// Written where it stays, see write_op().
void write_lane_op(const Op& op, std::int64_t address, std::uint8_t rows, LaneOp& l) noexcept {
    l.address = address;
    l.step = op.step;
    l.kind = op.kind;
    l.a = op.a;
    l.b = op.b;
    l.dof_a = op.dof_a;
    l.dof_b = op.dof_b;
    l.width = op.width;
    l.rows = rows;
    l.to_b = op.jac_b - op.jac_a;
}

}  // namespace

/// The first of lane_keys_ that does the same and has this lane free; their number: none, and
/// `key.again` is set. Chains are alike, so that it is mostly the one `behind` that of the op
/// before.
std::size_t System::find_lane_op(LaneKey& key, std::size_t lane,
                                 std::size_t behind) const noexcept {
    const auto same = [&](const LaneKey& k) {
        return k.address == key.address && k.what == key.what && k.to_b == key.to_b;
    };
    const auto is_free = [&](const LaneKey& k) { return (k.used >> lane & 1) == 0; };
    if (behind < lane_keys_.size()) {
        const LaneKey& k = lane_keys_[behind];
        if (!k.again && same(k) && is_free(k)) return behind;
    }
    for (std::size_t i = 0; i < lane_keys_.size(); ++i) {
        if (!same(lane_keys_[i])) continue;
        if (is_free(lane_keys_[i])) return i;
        key.again = true;
    }
    return lane_keys_.size();
}

/// Ops of one batch step: those that do the same in several lanes become one.
void System::share_lanes(std::span<const Op> together, std::int64_t place,
                         const model::Interactions& in) {
    const std::size_t first = lane_ops.size();
    lane_keys_.clear();  // of each new lane op
    std::size_t next[factor::kLaneCount] = {};
    for (std::size_t i = 0; i < together.size(); ++i) {
        const Op& op = together[i];
        if (op.kind == Op::contact) {
            ops.push_back(op);
            continue;
        }
        const auto lane = static_cast<std::size_t>((op.address - place) % factor::kLaneCount);
        const std::uint8_t rows = op.kind == Op::body_block ? 0 : in.rows[at(op.id)];
        const std::int64_t base = op.address - static_cast<std::int64_t>(lane);
        // A chain that is eliminated the other way round has its joints' slots changed.
        const bool turns = op.kind == Op::condensed && op.width == 0 && op.a != op.b;
        LaneKey key{base, lane_key(op, rows, turns), op.jac_b - op.jac_a, 0, false, i};
        const std::size_t found = find_lane_op(key, lane, next[lane]);
        next[lane] = found + 1;
        if (found == lane_keys_.size()) {
            lane_keys_.push_back(key);
            write_lane_op(op, base, rows, lane_ops.emplace_back());
        }
        LaneOp& l = lane_ops[first + found];
        std::int32_t from = op.jac_a;
        if (op.kind == Op::geometric && op.width > 0) from = geo_place_[at(op.id)].record;
        // Until a lane has its own, it repeats the latest.
        for (std::size_t k = 0; k < factor::kLaneCount; ++k) {
            const bool own = (l.used >> k & 1) != 0;
            l.id[k] = own ? l.id[k] : op.id;
            l.from[k] = own ? l.from[k] : from;
        }
        l.used = static_cast<std::uint8_t>(l.used | 1U << lane);
        lane_keys_[found].used = l.used;
        if (l.a != op.a) l.turned = static_cast<std::uint8_t>(l.turned | 1U << lane);
    }
    // What only one lane does is done alone.
    std::size_t kept = first;
    for (std::size_t i = 0; i < lane_keys_.size(); ++i) {
        const LaneOp& l = lane_ops[first + i];
        if (std::popcount(l.used) > 1) {
            if (kept != first + i) lane_ops[kept] = l;
            ++kept;
        } else {
            ops.push_back(together[lane_keys_[i].op]);
        }
    }
    lane_ops.resize(kept);
}

}  // namespace hawser::assembly
