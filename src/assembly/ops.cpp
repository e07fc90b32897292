// SPDX-License-Identifier: Apache-2.0
/// The list of contributions to the matrix, ordered by where they go.
#include "assembly/system.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <tuple>

namespace hawser::assembly {
namespace {

constexpr int kSlots = kMaxInteractionBodies;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

/// An op whose address and offsets are still to be filled in.
Op make_op(std::int32_t id, Op::Kind kind, std::uint8_t a, std::uint8_t b) {
    return {0, 0, 0, id, 0, 0, kind, a, b, 0, 0, 0};
}

/// Indices of the places in [low, high), which are ascending.
std::pair<std::int64_t, std::int64_t> between(const std::vector<std::int64_t>& places,
                                              std::int64_t low, std::int64_t high) {
    const auto a = std::lower_bound(places.begin(), places.end(), low);
    const auto b = std::lower_bound(a, places.end(), high);
    return {a - places.begin(), b - places.begin()};
}

}  // namespace

/// Columns of one place in the panels (lanes of one step) stay together.
struct System::OpEntry {
    std::int64_t place;
    std::int32_t column, index;
    Op op;
    [[nodiscard]] auto key() const { return std::tie(place, column, index); }
};

void System::build_ops(const model::Bodies& bodies, const model::Interactions& in) {
    // Collect the ops, then sort by place in the panels and by column; within one column they stay
    // in the order of collection: body block first, then interactions by id. Columns of one place
    // (lanes of one step) stay together.
    std::vector<OpEntry> entries;
    auto add = [&](std::int32_t row, std::int32_t column, Op op) {
        const factor::BlockTarget t = symbolic.target(row, column);
        op.address = t.address;
        op.step = t.step;
        op.ld = t.ld;
        if (op.kind == Op::body_block) {
            op.dof_a = op.dof_b = dof_[at(op.id)];
        } else if (op.kind == Op::contact) {
            const ContactBlock& block = contacts.blocks[at(op.id)];
            op.dof_a = dof_[at(op.a ? block.b : block.a)];
            op.dof_b = dof_[at(op.a ? block.a : block.b)];
        } else {
            const std::int32_t* body = &in.body[at(kSlots * op.id)];
            std::int32_t offset = in.jac_begin[at(op.id)];
            for (int b = 0; b < in.bodies[at(op.id)]; ++b) {
                const std::uint8_t dof = dof_[at(body[b])];
                if (b == op.a) {
                    op.jac_a = offset;
                    op.dof_a = dof;
                }
                if (b == op.b) {
                    op.jac_b = offset;
                    op.dof_b = dof;
                }
                offset += dof;
                op.width = static_cast<std::uint8_t>(op.width + dof);
            }
        }
        entries.push_back({symbolic.column_address(symbolic.position[at(column)]),
                           symbolic.position[at(column)], static_cast<std::int32_t>(entries.size()),
                           op});
    };
    for (std::int32_t b : bodies.moving)
        if (dof_[at(b)] > 0)
            add(node_of_body[at(b)], node_of_body[at(b)], make_op(b, Op::body_block, 0, 0));
    for (std::int32_t i = 0; i < in.count(); ++i) {
        const std::int32_t own = node_of_interaction[at(i)];
        if (own >= 0) add(own, own, make_op(i, Op::kept_sigma, 0, 0));
        for (int a = 0; a < in.bodies[at(i)]; ++a) {
            const std::int32_t na = node_of_body[at(in.body[at(kSlots * i + a)])];
            if (na < 0) continue;
            const auto sa = static_cast<std::uint8_t>(a);
            if (own >= 0) {
                if (symbolic.position[at(own)] > symbolic.position[at(na)])
                    add(own, na, make_op(i, Op::kept_rows, 0, sa));
                else
                    add(na, own, make_op(i, Op::kept_columns, sa, 0));
            }
            for (int b = 0; b < in.bodies[at(i)]; ++b) {
                const std::int32_t nb = node_of_body[at(in.body[at(kSlots * i + b)])];
                if (nb < 0 || symbolic.position[at(na)] < symbolic.position[at(nb)]) continue;
                if (na == nb && a != b) continue;  // a body twice in one interaction is refused
                const auto sb = static_cast<std::uint8_t>(b);
                if (own < 0) add(na, nb, make_op(i, Op::condensed, sa, sb));
                if (in.geo[at(i)] >= 0 && a < 2 && b < 2)
                    add(na, nb, make_op(i, Op::geometric, sa, sb));
            }
        }
    }
    for (std::size_t k = 0; k < contacts.blocks.size(); ++k) {
        const ContactBlock& block = contacts.blocks[k];
        const std::int32_t na = node_of_body[at(block.a)], nb = node_of_body[at(block.b)];
        if (na < 0 || nb < 0) continue;  // asleep
        const bool swap = symbolic.position[at(na)] < symbolic.position[at(nb)];
        add(swap ? nb : na, swap ? na : nb,
            make_op(static_cast<std::int32_t>(k), Op::contact, swap ? 1 : 0, 0));
    }
    std::sort(entries.begin(), entries.end(),
              [](const OpEntry& p, const OpEntry& q) { return p.key() < q.key(); });
    ops.clear();
    lane_ops.clear();
    op_place_.clear();
    lane_place_.clear();
    const std::vector<factor::Piece>& pieces = numeric.pieces();
    piece_ops_.assign(pieces.size(), {});
    std::vector<std::size_t> by_place(pieces.size());
    std::iota(by_place.begin(), by_place.end(), std::size_t{0});
    std::sort(by_place.begin(), by_place.end(), [&](std::size_t p, std::size_t q) {
        return pieces[p].panel_begin < pieces[q].panel_begin;
    });
    std::size_t begin = 0;
    for (const std::size_t k : by_place) {
        PieceOps& range = piece_ops_[k];
        range.op_begin = static_cast<std::int64_t>(ops.size());
        range.lane_begin = static_cast<std::int64_t>(lane_ops.size());
        while (begin < entries.size() && entries[begin].place < pieces[k].panel_end) {
            std::size_t end = begin;
            while (end < entries.size() && entries[end].place == entries[begin].place) ++end;
            if (entries[begin].op.step == 1)
                for (std::size_t i = begin; i < end; ++i) ops.push_back(entries[i].op);
            else
                share_lanes(std::span(entries).subspan(begin, end - begin), in);
            op_place_.resize(ops.size(), entries[begin].place);
            lane_place_.resize(lane_ops.size(), entries[begin].place);
            begin = end;
        }
        range.op_end = static_cast<std::int64_t>(ops.size());
        range.lane_end = static_cast<std::int64_t>(lane_ops.size());
    }
    skew_ops_.clear();
    for (std::size_t i = 0; i < ops.size(); ++i)
        if (ops[i].kind == Op::contact) skew_ops_.push_back(static_cast<std::int32_t>(i));
}

void System::write_blocks(const View& view, int piece, double* panel) const noexcept {
    const PieceOps& p = piece_ops_[at(piece)];
    kernels().gather_lane_blocks(view, lane_ops.data(), p.lane_begin, p.lane_end, panel);
    kernels().gather_blocks(view, ops.data(), p.op_begin, p.op_end, panel);
}

void System::write_skew(const View& view, std::int64_t begin, std::int64_t end,
                        double* upper) const noexcept {
    auto i = std::lower_bound(skew_ops_.begin(), skew_ops_.end(), begin) - skew_ops_.begin();
    for (auto k = static_cast<std::size_t>(i); k < skew_ops_.size() && skew_ops_[k] < end; ++k) {
        const Op& op = ops[at(skew_ops_[k])];
        if (contacts.block_skew[at(op.id)] == 0) continue;
        const double* lower =
            view.contact_block + static_cast<std::ptrdiff_t>(kContactBlock) * op.id;
        // A body's own block is square: the other half is its transpose.
        const bool own = contacts.blocks[at(op.id)].a == contacts.blocks[at(op.id)].b;
        const double* other = own ? lower : lower + (op.a ? 0 : 36);
        const double* mine = own ? lower : lower + (op.a ? 36 : 0);
        double* out = upper + op.address;
        for (int j = 0; j < op.dof_b; ++j)
            for (int r = 0; r < op.dof_a; ++r)
                out[r * op.step + j * op.ld] += other[6 * r + j] - mine[6 * j + r];
    }
}

void System::write_skew(const View& view, int piece, double* upper) const noexcept {
    write_skew(view, piece_ops_[at(piece)].op_begin, piece_ops_[at(piece)].op_end, upper);
}

void System::write_blocks(const View& view, const factor::DirtyParts& part,
                          double* panel) const noexcept {
    for (const factor::PanelRange& r : part.panels) {
        const auto [lane_begin, lane_end] = between(lane_place_, r.begin, r.end);
        kernels().gather_lane_blocks(view, lane_ops.data(), lane_begin, lane_end, panel);
        const auto [begin, end] = between(op_place_, r.begin, r.end);
        kernels().gather_blocks(view, ops.data(), begin, end, panel);
    }
}

void System::write_skew(const View& view, const factor::DirtyParts& part,
                        double* upper) const noexcept {
    for (const factor::PanelRange& r : part.panels) {
        const auto [begin, end] = between(op_place_, r.begin, r.end);
        write_skew(view, begin, end, upper);
    }
}

/// Ops of one batch step: those that do the same in several lanes become one.
void System::share_lanes(std::span<const OpEntry> entries, const model::Interactions& in) {
    const auto first = static_cast<std::ptrdiff_t>(lane_ops.size());
    std::vector<Op> single;  // the only op so far of each new lane op
    for (const OpEntry& e : entries) {
        const Op& op = e.op;
        if (op.kind == Op::contact) {
            ops.push_back(op);
            continue;
        }
        const auto lane = static_cast<std::size_t>((op.address - e.place) % factor::kLaneCount);
        const std::uint8_t rows = op.kind == Op::body_block ? 0 : in.rows[at(op.id)];
        const std::int64_t base = op.address - static_cast<std::int64_t>(lane);
        auto same = [&](const LaneOp& l) {
            return l.address == base && l.kind == op.kind && l.a == op.a && l.b == op.b &&
                   l.dof_a == op.dof_a && l.dof_b == op.dof_b && l.width == op.width &&
                   l.rows == rows && l.to_b == op.jac_b - op.jac_a && (l.used >> lane & 1) == 0;
        };
        auto found = std::find_if(lane_ops.begin() + first, lane_ops.end(), same);
        if (found == lane_ops.end()) {
            LaneOp l{};
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
            lane_ops.push_back(l);
            single.push_back(op);
            found = lane_ops.end() - 1;
        }
        auto put = [&](std::size_t k) {
            found->id[k] = op.id;
            found->from[k] = op.jac_a;
            if (op.kind == Op::body_block) found->from[k] = kBodyBlock * op.id;
            if (op.kind == Op::geometric) found->from[k] = geo_place_[at(op.id)].record;
        };
        // Until a lane has its own, it repeats the latest.
        for (std::size_t k = 0; k < factor::kLaneCount; ++k)
            if ((found->used >> k & 1) == 0) put(k);
        put(lane);
        found->used = static_cast<std::uint8_t>(found->used | 1U << lane);
    }
    // What only one lane does is done alone.
    std::size_t kept = static_cast<std::size_t>(first);
    for (std::size_t i = 0; i < single.size(); ++i) {
        const LaneOp& l = lane_ops[static_cast<std::size_t>(first) + i];
        if (std::popcount(l.used) > 1)
            lane_ops[kept++] = l;
        else
            ops.push_back(single[i]);
    }
    lane_ops.resize(kept);
}

}  // namespace hawser::assembly
