// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file op_list.h
/// List of contributions to the matrix, made by a direct method: collected interaction by
/// interaction, sorted, and assigned to lanes by search.

#include "assembly/system.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

namespace hawser::test {

class PlainOps {
  public:
    PlainOps(const assembly::System& s, const model::Bodies& bodies, const assembly::View& v)
        : s_(s), v_(v) {
        collect(bodies);
        std::stable_sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
            return std::pair{a.place, a.column} < std::pair{b.place, b.column};
        });
        const std::int64_t batches = s.symbolic.batch_steps.empty()
                                         ? s.symbolic.panel_size
                                         : s.symbolic.batch_steps.front().panel;
        for (std::size_t a = 0, b = 0; a < entries_.size(); a = b) {
            while (b < entries_.size() && entries_[b].place == entries_[a].place) ++b;
            if (entries_[a].place >= batches)
                share(a, b);
            else
                for (std::size_t k = a; k < b; ++k) ops.push_back(entries_[k].op);
        }
    }

    std::vector<assembly::Op> ops;
    std::vector<assembly::LaneOp> lane_ops;

  private:
    using Op = assembly::Op;
    struct Entry {
        std::int64_t place;
        std::int32_t column;  ///< Column of the entry.
        Op op;
    };

    static std::size_t at(std::int64_t i) { return static_cast<std::size_t>(i); }
    [[nodiscard]] std::int32_t position(std::int32_t node) const {
        return s_.symbolic.position[at(node)];
    }

    void add(std::int32_t row, std::int32_t column, std::int32_t id, Op::Kind kind, int a, int b) {
        Op op{};
        const factor::BlockTarget t = s_.symbolic.target(row, column);
        op.address = t.address;
        op.step = t.step;
        op.ld = t.ld;
        op.id = id;
        op.kind = kind;
        op.a = static_cast<std::uint8_t>(a);
        op.b = static_cast<std::uint8_t>(b);
        if (kind == Op::body_block) {
            op.dof_a = op.dof_b = v_.dof[id];
            op.jac_a = op.jac_b =
                static_cast<std::int32_t>(assembly::block_offset(v_.dof_begin[id]));
        } else if (kind == Op::contact) {
            const assembly::ContactBlock& block = s_.contacts.blocks[at(id)];
            op.dof_a = v_.dof[a != 0 ? block.b : block.a];
            op.dof_b = v_.dof[a != 0 ? block.a : block.b];
        } else {
            std::int32_t offset = v_.jac_begin[id];
            for (int b_ = 0; b_ < v_.bodies[id]; ++b_) {
                const std::uint8_t dof = v_.dof[v_.body[kMaxInteractionBodies * id + b_]];
                if (b_ == a) op.jac_a = offset, op.dof_a = dof;
                if (b_ == b) op.jac_b = offset, op.dof_b = dof;
                offset += dof;
            }
            op.width = static_cast<std::uint8_t>(offset - v_.jac_begin[id]);
            if (v_.arms[id] != 0) {
                op.jac_a = op.jac_b = v_.jac_begin[id];
                op.width = 0;
            }
        }
        entries_.push_back({s_.symbolic.column_address(position(column)), position(column), op});
    }

    void collect(const model::Bodies& bodies) {
        for (const std::int32_t b : bodies.moving)
            if (const std::int32_t n = s_.node_of_body[at(b)]; n >= 0)
                add(n, n, b, Op::body_block, 0, 0);
        for (std::int32_t i = 0; i < v_.interaction_count; ++i)
            if (!s_.rests(i)) collect_interaction(i);
        for (std::size_t k = 0; k < s_.contacts.blocks.size(); ++k) {
            const assembly::ContactBlock& block = s_.contacts.blocks[k];
            std::int32_t row = s_.node_of_body[at(block.a)], column = s_.node_of_body[at(block.b)];
            if (row < 0 || column < 0) continue;
            const bool swap = position(row) < position(column);
            if (swap) std::swap(row, column);
            add(row, column, static_cast<std::int32_t>(k), Op::contact, swap ? 1 : 0, 0);
        }
    }

    void collect_interaction(std::int32_t i) {
        const std::int32_t own = s_.node_of_interaction[at(i)];
        if (own >= 0) add(own, own, i, Op::kept_sigma, 0, 0);
        auto node = [&](int slot) {
            return s_.node_of_body[at(v_.body[kMaxInteractionBodies * i + slot])];
        };
        for (int a = 0; a < v_.bodies[i]; ++a) {
            const std::int32_t na = node(a);
            if (na < 0) continue;
            if (own >= 0 && position(own) > position(na)) add(own, na, i, Op::kept_rows, 0, a);
            if (own >= 0 && position(own) < position(na)) add(na, own, i, Op::kept_columns, a, 0);
            for (int b = 0; b < v_.bodies[i]; ++b) {
                const std::int32_t nb = node(b);
                if (nb < 0 || position(na) < position(nb)) continue;
                if (own < 0) add(na, nb, i, Op::condensed, a, b);
                if (own < 0 && v_.arms[i] != 0) continue;
                if (has_geo(i) && a < 2 && b < 2) add(na, nb, i, Op::geometric, a, b);
            }
        }
    }
    [[nodiscard]] bool has_geo(std::int32_t i) const {
        return v_.geo[i].record >= 0 || v_.arms[i] != 0;
    }

    void share(std::size_t begin, std::size_t end) {
        struct Shared {
            assembly::LaneOp op;
            std::size_t first;  ///< First entry of its contributions.
        };
        std::vector<Shared> shared;
        for (std::size_t k = begin; k < end; ++k) {
            const Op& op = entries_[k].op;
            if (op.kind == Op::contact) {
                ops.push_back(op);
                continue;
            }
            const auto lane = at((op.address - entries_[k].place) % factor::kLaneCount);
            const std::int64_t base = op.address - static_cast<std::int64_t>(lane);
            const std::uint8_t rows = op.kind == Op::body_block ? 0 : v_.rows[op.id];
            const bool turns = op.kind == Op::condensed && op.width == 0;
            auto fits = [&](const Shared& s) {
                const assembly::LaneOp& l = s.op;
                const bool slots = (l.a == op.a && l.b == op.b) ||
                                   (turns && op.a != op.b && l.a == op.b && l.b == op.a);
                return l.address == base && l.kind == op.kind && slots && l.dof_a == op.dof_a &&
                       l.dof_b == op.dof_b && l.width == op.width && l.rows == rows &&
                       l.to_b == op.jac_b - op.jac_a && (l.used >> lane & 1) == 0;
            };
            auto found = std::find_if(shared.begin(), shared.end(), fits);
            if (found == shared.end()) {
                assembly::LaneOp l{};
                l.address = base;
                l.step = op.step;
                l.kind = op.kind;
                l.a = op.a;
                l.b = op.b;
                l.dof_a = op.dof_a;
                l.dof_b = op.dof_b;
                l.width = op.width;
                l.rows = rows;
                l.to_b = op.jac_b - op.jac_a;
                found = shared.insert(shared.end(), {l, k});
            }
            const bool record = op.kind == Op::geometric && op.width > 0;
            assembly::LaneOp& l = found->op;
            for (std::size_t other = 0; other < factor::kLaneCount; ++other) {
                if (other != lane && (l.used >> other & 1) != 0) continue;
                l.id[other] = op.id;
                l.from[other] = record ? v_.geo[op.id].record : op.jac_a;
            }
            l.used = static_cast<std::uint8_t>(l.used | 1U << lane);
            if (l.a != op.a) l.turned = static_cast<std::uint8_t>(l.turned | 1U << lane);
        }
        for (const Shared& s : shared)
            if (std::popcount(s.op.used) > 1)
                lane_ops.push_back(s.op);
            else
                ops.push_back(entries_[s.first].op);
    }

    const assembly::System& s_;
    const assembly::View& v_;
    std::vector<Entry> entries_;
};

inline bool same(const assembly::Op& a, const assembly::Op& b) {
    return a.address == b.address && a.step == b.step && a.ld == b.ld && a.id == b.id &&
           a.jac_a == b.jac_a && a.jac_b == b.jac_b && a.kind == b.kind && a.a == b.a &&
           a.b == b.b && a.dof_a == b.dof_a && a.dof_b == b.dof_b && a.width == b.width;
}

inline bool same(const assembly::LaneOp& a, const assembly::LaneOp& b) {
    return a.address == b.address && a.step == b.step && a.kind == b.kind && a.a == b.a &&
           a.b == b.b && a.dof_a == b.dof_a && a.dof_b == b.dof_b && a.width == b.width &&
           a.rows == b.rows && a.used == b.used && a.turned == b.turned && a.to_b == b.to_b &&
           std::equal(a.id, a.id + 8, b.id) && std::equal(a.from, a.from + 8, b.from);
}

/// Expect that a system lists the contributions of the direct method, entry by entry.
inline void expect_plain_ops(const assembly::System& s, const model::Bodies& bodies,
                             const assembly::View& view) {
    const PlainOps plain(s, bodies, view);
    ASSERT_EQ(s.ops.size(), plain.ops.size());
    ASSERT_EQ(s.lane_ops.size(), plain.lane_ops.size());
    for (std::size_t k = 0; k < plain.ops.size(); ++k)
        ASSERT_TRUE(same(s.ops[k], plain.ops[k])) << "op " << k;
    for (std::size_t k = 0; k < plain.lane_ops.size(); ++k)
        ASSERT_TRUE(same(s.lane_ops[k], plain.lane_ops[k])) << "lane op " << k;
}

}  // namespace hawser::test
