// SPDX-License-Identifier: Apache-2.0
/// The list of contributions to the matrix, ordered by where they go.
#include "assembly/system.h"
#include "base/index.h"

#include <algorithm>
#include <numeric>

namespace hawser::assembly {
namespace {

constexpr int kSlots = kMaxInteractionBodies;

/// Indices of the places in [low, high), which are ascending.
std::pair<std::int64_t, std::int64_t> between(const std::vector<std::int64_t>& places,
                                              std::int64_t low, std::int64_t high) {
    const auto a = std::lower_bound(places.begin(), places.end(), low);
    const auto b = std::lower_bound(a, places.end(), high);
    return {a - places.begin(), b - places.begin()};
}

/// An entry as an op, with its address. It is written where it stays: what is written field by
/// field and copied at once waits for the stores.
template <class Entry>
void write_op(const Entry& entry, const factor::Symbolic& symbolic, const Contacts& contacts,
              const std::uint8_t* dofs, const model::Bodies& bodies, const model::Interactions& in,
              Op& op) {
    const factor::BlockTarget t = symbolic.target(entry.row, entry.column);
    op.address = t.address;
    op.step = t.step;
    op.ld = t.ld;
    op.id = entry.id;
    op.kind = entry.kind;
    op.a = entry.a;
    op.b = entry.b;
    if (op.kind == Op::body_block) {
        op.dof_a = op.dof_b = dofs[op.id];
        op.jac_a = op.jac_b = static_cast<std::int32_t>(block_place(bodies.dof_begin[at(op.id)]));
        return;
    }
    if (op.kind == Op::contact) {
        const ContactBlock& block = contacts.blocks[at(op.id)];
        op.dof_a = dofs[op.a ? block.b : block.a];
        op.dof_b = dofs[op.a ? block.a : block.b];
        return;
    }
    const std::int32_t* body = &in.body[at(kSlots * op.id)];
    const std::int32_t first = in.jac_begin[at(op.id)];
    std::int32_t offset = first;
    for (int b = 0; b < in.bodies[at(op.id)]; ++b) {
        const std::uint8_t dof = dofs[body[b]];
        if (b == op.a) {
            op.jac_a = offset;
            op.dof_a = dof;
        }
        if (b == op.b) {
            op.jac_b = offset;
            op.dof_b = dof;
        }
        offset += dof;
    }
    op.width = static_cast<std::uint8_t>(offset - first);
    if (in.arms[at(op.id)]) {
        op.jac_a = op.jac_b = first;
        op.width = 0;
    }
}

}  // namespace

/// The ops before they have addresses: body blocks first, then interactions by id, then contacts.
void System::collect_ops(const model::Bodies& bodies, const model::Interactions& in) {
    op_entries_.clear();
    auto add = [&](std::int32_t row, std::int32_t column, std::int32_t id, Op::Kind kind, int a,
                   int b) {
        op_entries_.push_back(
            {row, column, id, kind, static_cast<std::uint8_t>(a), static_cast<std::uint8_t>(b)});
    };
    auto position = [&](std::int32_t node) { return symbolic.position[at(node)]; };
    for (std::int32_t b : bodies.moving)
        if (dof_[at(b)] > 0) add(node_of_body[at(b)], node_of_body[at(b)], b, Op::body_block, 0, 0);
    for (std::int32_t i = 0; i < in.count(); ++i) {
        if (rests(i)) continue;
        const std::int32_t own = node_of_interaction[at(i)];
        if (own >= 0) add(own, own, i, Op::kept_sigma, 0, 0);
        for (int a = 0; a < in.bodies[at(i)]; ++a) {
            const std::int32_t na = node_of_body[at(in.body[at(kSlots * i + a)])];
            if (na < 0) continue;
            if (own >= 0) {
                if (position(own) > position(na))
                    add(own, na, i, Op::kept_rows, 0, a);
                else
                    add(na, own, i, Op::kept_columns, a, 0);
            }
            for (int b = 0; b < in.bodies[at(i)]; ++b) {
                const std::int32_t nb = node_of_body[at(in.body[at(kSlots * i + b)])];
                if (nb < 0 || position(na) < position(nb)) continue;
                if (na == nb && a != b) continue;  // a body twice in one interaction is refused
                if (own < 0) add(na, nb, i, Op::condensed, a, b);
                if (own < 0 && in.arms[at(i)]) continue;  // in the same op
                if (in.geo[at(i)] >= 0 && a < 2 && b < 2) add(na, nb, i, Op::geometric, a, b);
            }
        }
    }
    for (std::size_t k = 0; k < contacts.blocks.size(); ++k) {
        const ContactBlock& block = contacts.blocks[k];
        const std::int32_t na = node_of_body[at(block.a)], nb = node_of_body[at(block.b)];
        if (na < 0 || nb < 0) continue;  // asleep
        const bool swap = position(na) < position(nb);
        add(swap ? nb : na, swap ? na : nb, static_cast<std::int32_t>(k), Op::contact, swap ? 1 : 0,
            0);
    }
}

Op System::placed(const OpEntry& entry, const model::Bodies& bodies,
                  const model::Interactions& in) const {
    Op op{};
    write_op(entry, symbolic, contacts, dof_.data(), bodies, in, op);
    return op;
}

/// Columns by place in the panels. Those of ordinary fronts stand in the order of elimination; the
/// steps of batches come behind them, each with the columns of its lanes.
void System::place_columns() {
    const auto n = static_cast<std::int32_t>(symbolic.order.size());
    column_place_.clear();
    step_begin_.assign(symbolic.batch_steps.size() + 1, 0);
    const auto step_of = [&](std::int32_t k) {
        return symbolic.batches.empty() ? -1 : symbolic.node_step[at(symbolic.order[at(k)])];
    };
    for (std::int32_t k = 0; k < n; ++k)
        if (const std::int32_t step = step_of(k); step >= 0)
            ++step_begin_[at(step) + 1];
        else
            column_place_.emplace_back(symbolic.column_address(k), k);
    step_begin_[0] = static_cast<std::int32_t>(column_place_.size());
    for (std::size_t i = 1; i < step_begin_.size(); ++i) step_begin_[i] += step_begin_[i - 1];
    column_place_.resize(at(n));
    for (std::int32_t k = 0; k < n; ++k)
        if (const std::int32_t step = step_of(k); step >= 0)
            column_place_[at(step_begin_[at(step)]++)] = {symbolic.batch_steps[at(step)].panel, k};
}

/// Sort the entries by place in the panels and by column; within one column they stay in the order
/// of collection. Columns of one place (lanes of one step) come together.
void System::sort_ops() {
    place_columns();
    op_begin_.assign(symbolic.order.size() + 1, 0);
    for (const OpEntry& e : op_entries_) ++op_begin_[at(symbolic.position[at(e.column)])];
    std::int32_t sum = 0;
    for (const auto& [place, k] : column_place_) {
        const std::int32_t count = op_begin_[at(k)];
        op_begin_[at(k)] = sum;
        sum += count;
    }
    op_order_.resize(op_entries_.size());
    for (std::size_t i = 0; i < op_entries_.size(); ++i)
        op_order_[at(op_begin_[at(symbolic.position[at(op_entries_[i].column)])]++)] =
            static_cast<std::int32_t>(i);
}

void System::build_ops(const model::Bodies& bodies, const model::Interactions& in) {
    collect_ops(bodies, in);
    sort_ops();
    std::vector<Op>& together = together_;
    ops.clear();
    lane_ops.clear();
    op_place_.clear();
    lane_place_.clear();
    const std::vector<factor::Piece>& pieces = numeric.pieces();
    piece_ops_.assign(pieces.size(), {});
    pieces_by_place_.resize(pieces.size());
    std::iota(pieces_by_place_.begin(), pieces_by_place_.end(), 0);
    std::sort(pieces_by_place_.begin(), pieces_by_place_.end(),
              [&](std::int32_t p, std::int32_t q) {
                  return pieces[at(p)].panel_begin < pieces[at(q)].panel_begin;
              });
    // Ordinary fronts come first.
    const std::int64_t batches_begin =
        symbolic.batch_steps.empty() ? symbolic.panel_size : symbolic.batch_steps.front().panel;
    std::size_t column = 0;
    std::int32_t begin = 0;
    for (const std::int32_t k : pieces_by_place_) {
        PieceOps& range = piece_ops_[at(k)];
        range.op_begin = static_cast<std::int64_t>(ops.size());
        range.lane_begin = static_cast<std::int64_t>(lane_ops.size());
        while (column < column_place_.size()) {
            const std::int64_t place = column_place_[column].first;
            if (place >= pieces[at(k)].panel_end) break;
            std::int32_t end = begin;  // sort_ops() left where each column's entries end
            for (; column < column_place_.size() && column_place_[column].first == place; ++column)
                end = op_begin_[at(column_place_[column].second)];
            if (begin == end) continue;
            auto write = [&](auto& list) {
                for (; begin < end; ++begin)
                    write_op(op_entries_[at(op_order_[at(begin)])], symbolic, contacts, dof_.data(),
                             bodies, in, list.emplace_back());
            };
            if (place < batches_begin) {
                write(ops);
            } else {
                together.clear();
                write(together);
                share_lanes(together, place, in);
            }
            op_place_.resize(ops.size(), place);
            lane_place_.resize(lane_ops.size(), place);
        }
        range.op_end = static_cast<std::int64_t>(ops.size());
        range.lane_end = static_cast<std::int64_t>(lane_ops.size());
    }
    list_skew_ops();
    if (contacts.blocks.empty() && report_.replanned) {  // the next time is not soon
        op_entries_ = {};
        column_place_ = {};
        op_begin_ = op_order_ = {};
    }
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

template <class F>
void System::over_panels(const factor::DirtyParts& part, base::Executor& executor,
                         F&& work) const noexcept {
    const auto count = static_cast<int>(part.panels.size());
    // Some pieces a thread, as panels differ in what is written to them.
    const int pieces = executor.threads() == 1 ? 1 : std::min(count, 8 * executor.threads());
    auto piece = [&](int i, int) noexcept {
        for (int k = count * i / pieces; k < count * (i + 1) / pieces; ++k)
            work(part.panels[at(k)]);
    };
    executor.for_each(pieces, piece);
}

void System::write_blocks(const View& view, const factor::DirtyParts& part, double* panel,
                          base::Executor& executor) const noexcept {
    over_panels(part, executor, [&](const factor::PanelRange& r) {
        const auto [lane_begin, lane_end] = between(lane_place_, r.begin, r.end);
        kernels().gather_lane_blocks(view, lane_ops.data(), lane_begin, lane_end, panel);
        const auto [begin, end] = between(op_place_, r.begin, r.end);
        kernels().gather_blocks(view, ops.data(), begin, end, panel);
    });
}

void System::write_skew(const View& view, const factor::DirtyParts& part, double* upper,
                        base::Executor& executor) const noexcept {
    over_panels(part, executor, [&](const factor::PanelRange& r) {
        const auto [begin, end] = between(op_place_, r.begin, r.end);
        write_skew(view, begin, end, upper);
    });
}

}  // namespace hawser::assembly
