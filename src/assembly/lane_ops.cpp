// SPDX-License-Identifier: Apache-2.0
#include "assembly/lane_ops.h"

#include <algorithm>
#include <bit>

namespace hawser::assembly {
namespace {

constexpr std::uint32_t kAllLanes = 0xff;
static_assert(factor::kLaneCount == 8);

/// Return a key of the properties of a matrix contribution (op). Ops with equal keys can be
/// executed together in several SIMD lanes. If a joint may exchange its slots (`turns`), their
/// order does not matter.
std::uint64_t lane_key(const OpParts& op, int rows, bool turns) noexcept {
    const bool swap = turns && op.a > op.b;
    auto key = static_cast<std::uint32_t>(op.kind) << 8 |
               static_cast<std::uint32_t>(swap ? op.b : op.a) << 4 |
               static_cast<std::uint32_t>(swap ? op.a : op.b);
    const auto sizes = static_cast<std::uint32_t>(op.dof_a) << 24 |
                       static_cast<std::uint32_t>(op.dof_b) << 16 |
                       static_cast<std::uint32_t>(op.width) << 8 | static_cast<std::uint32_t>(rows);
    return std::uint64_t{key} << 32 | sizes;
}

void write_lane_op(const OpParts& op, std::int64_t address, std::int32_t step, int rows,
                   LaneOp& l) noexcept {
    l.address = address;
    l.step = step;
    l.kind = op.kind;
    l.a = static_cast<std::uint8_t>(op.a);
    l.b = static_cast<std::uint8_t>(op.b);
    l.dof_a = static_cast<std::uint8_t>(op.dof_a);
    l.dof_b = static_cast<std::uint8_t>(op.dof_b);
    l.width = static_cast<std::uint8_t>(op.width);
    l.rows = static_cast<std::uint8_t>(rows);
    l.to_b = op.jac_b - op.jac_a;
}

}  // namespace

void LaneSharer::begin(std::int64_t panel, std::size_t done) noexcept {
    panel_ = panel;
    done_ = done;
    std::fill(next_, next_ + factor::kLaneCount, std::size_t{0});
    keys_.clear();
    first_.clear();
}

/// Find the first entry of keys_ with the properties of `key` whose lane `lane` is free.
/// @return its index. If there is none, return the number of entries, with `key.again` set if the
/// properties exist. Chains have equal structure, so the entry is usually the one after that of the
/// previous op.
std::size_t LaneSharer::find(Key& key, std::size_t lane) const noexcept {
    const auto same = [&](const Key& k) {
        return k.address == key.address && k.what == key.what && k.to_b == key.to_b;
    };
    const auto is_free = [&](const Key& k) { return (k.used >> lane & 1) == 0; };
    if (const std::size_t behind = next_[lane]; behind < keys_.size()) {
        const Key& k = keys_[behind];
        if (k.again == 0 && same(k) && is_free(k)) return behind;
    }
    for (std::size_t i = 0; i < keys_.size(); ++i) {
        if (!same(keys_[i])) continue;
        if (is_free(keys_[i])) return i;
        key.again = 1;
    }
    return keys_.size();
}

void LaneSharer::add(const OpParts& op, std::int64_t address, std::int32_t step, int rows,
                     std::int32_t from, base::Array<LaneOp>& lane_ops) {
    const auto lane = static_cast<std::size_t>((address - panel_) % factor::kLaneCount);
    const std::int64_t base = address - static_cast<std::int64_t>(lane);
    // A chain eliminated in the other direction has the slots of its joints exchanged.
    const bool turns = op.kind == Op::condensed && op.width == 0 && op.a != op.b;
    Key key{base, lane_key(op, rows, turns), op.jac_b - op.jac_a, 0, 0, op.a, 0};
    const std::size_t found = find(key, lane);
    next_[lane] = found + 1;
    if (found == keys_.size()) {
        keys_.push_back(key);
        op.write(first_.emplace_back(), address, step, factor::kLaneCount);
        write_lane_op(op, base, step, rows, lane_ops.emplace_back());
    }
    Key& k = keys_[found];
    k.used |= 1U << lane;
    k.latest = static_cast<std::uint32_t>(lane);
    LaneOp& l = lane_ops[done_ + found];
    l.id[lane] = op.id;
    l.from[lane] = from;
    if (k.a != op.a) l.turned = static_cast<std::uint8_t>(l.turned | 1U << lane);
}

void LaneSharer::end(base::Array<LaneOp>& lane_ops, base::Array<Op>& ops) {
    std::size_t kept = done_;
    for (std::size_t i = 0; i < keys_.size(); ++i) {
        const Key& k = keys_[i];
        if (std::popcount(k.used) == 1) {
            ops.push_back(first_[i]);
            continue;
        }
        LaneOp& l = lane_ops[done_ + i];
        l.used = static_cast<std::uint8_t>(k.used);
        // A lane without an op repeats the latest one.
        for (std::size_t lane = 0; lane < factor::kLaneCount && k.used != kAllLanes; ++lane) {
            if ((k.used >> lane & 1) != 0) continue;
            l.id[lane] = l.id[k.latest];
            l.from[lane] = l.from[k.latest];
        }
        if (kept != done_ + i) lane_ops[kept] = l;
        ++kept;
    }
    lane_ops.resize(kept);
}

std::size_t LaneSharer::bytes() const noexcept { return base::bytes(keys_) + base::bytes(first_); }

}  // namespace hawser::assembly
