// SPDX-License-Identifier: Apache-2.0
/// List the contributions to the matrix, ordered by destination.
///
/// It is written sequentially: by address in the panels, then by column. Each column has the terms
/// of its own body or rows, then interactions by id, then contacts. Unchanged batches are reused
/// (op_history.h).
#include "assembly/lane_ops.h"
#include "assembly/system.h"
#include "base/index.h"

#include <algorithm>
#include <numeric>

namespace hawser::assembly {
namespace {

constexpr int kSlotsOfInteraction = kMaxInteractionBodies;

}  // namespace

/// Data of an interaction by slot that all of its blocks need.
struct System::Slots {
    Slots(const System& s, const model::Interactions& in, std::int32_t id) noexcept
        : count(in.bodies[at(id)]) {
        const std::int32_t* body = &in.body[at(kSlotsOfInteraction * id)];
        const std::int32_t first = in.jac_begin[at(id)];
        std::int32_t offset = first;
        for (int b = 0; b < count; ++b) {
            node[b] = s.node_of_body[at(body[b])];
            position[b] = node[b] < 0 ? -1 : s.symbolic.position[at(node[b])];
            dof[b] = s.dof_[at(body[b])];
            jac[b] = offset;
            offset += dof[b];
        }
        width = offset - first;
        if (in.arms[at(id)] == 0) return;
        width = 0;
        for (int b = 0; b < count; ++b) jac[b] = first;
    }
    [[nodiscard]] OpParts op(std::int32_t id, Op::Kind kind, int a, int b) const noexcept {
        return {id, kind, a, b, jac[a], jac[b], dof[a], dof[b], width};
    }

    int count;
    std::int32_t node[kSlotsOfInteraction], position[kSlotsOfInteraction];  ///< −1: none.
    std::int32_t jac[kSlotsOfInteraction] = {};
    int dof[kSlotsOfInteraction] = {}, width;
};

/// Call sink(row node, op) for the contributions of an interaction to the column of its body in
/// slot `b`.
template <class Sink>
void System::list_interaction(const model::Interactions& in, std::int32_t id, int b,
                              Sink&& sink) const {
    const Slots slots(*this, in, id);
    const std::int32_t own = node_of_interaction[at(id)], position = slots.position[b];
    const bool geometric = in.geo[at(id)] >= 0 && b < 2;
    // The condensed op of a compact joint includes its geometric terms.
    const bool has_geometric_op = own >= 0 || in.arms[at(id)] == 0;
    for (int a = 0; a < slots.count; ++a) {
        if (a == b && own >= 0 && symbolic.position[at(own)] > position)
            sink(own, slots.op(id, Op::kept_rows, 0, b));
        if (slots.position[a] < position) continue;
        if (own < 0) sink(slots.node[a], slots.op(id, Op::condensed, a, b));
        if (geometric && has_geometric_op && a < 2)
            sink(slots.node[a], slots.op(id, Op::geometric, a, b));
    }
}

/// Call sink(row node, op) for each op in the column of the multipliers of a kept interaction.
template <class Sink>
void System::list_kept(const model::Interactions& in, std::int32_t id, Sink&& sink) const {
    const Slots slots(*this, in, id);
    const std::int32_t own = node_of_interaction[at(id)];
    sink(own, slots.op(id, Op::kept_sigma, 0, 0));
    for (int a = 0; a < slots.count; ++a)
        if (slots.position[a] >= 0 && slots.position[a] > symbolic.position[at(own)])
            sink(slots.node[a], slots.op(id, Op::kept_columns, a, 0));
}

/// Call sink(row node, op) for all contributions to the column of a node.
template <class Sink>
void System::list_column(std::int32_t node, const model::Bodies& bodies,
                         const model::Interactions& in, Sink&& sink) const {
    const std::int32_t member = member_of_node_[at(node)];
    if (pattern.sign[at(node)] < 0) return list_kept(in, member, sink);
    const auto block = static_cast<std::int32_t>(block_offset(bodies.dof_begin[at(member)]));
    const int dof = dof_[at(member)];
    sink(node, OpParts{member, Op::body_block, 0, 0, block, block, dof, dof, 0});
    for (std::int32_t k = incident_begin_[at(member)]; k < incident_begin_[at(member) + 1]; ++k)
        if (!rests(incident_of_[at(k)]))
            list_interaction(in, incident_of_[at(k)], incident_[at(k)].slot, sink);
    for (std::int32_t k = contact_begin_[at(node)]; k < contact_begin_[at(node) + 1]; ++k) {
        const ContactBlock& b = contacts.blocks[at(contact_order_[at(k)])];
        const int swap = node_of_body[at(b.b)] != node ? 1 : 0;
        const std::int32_t above = swap ? b.b : b.a, left = swap ? b.a : b.b;
        sink(node_of_body[at(above)], OpParts{contact_order_[at(k)], Op::contact, swap, 0, 0, 0,
                                              dof_[at(above)], dof_[at(left)], 0});
    }
}

/// Sort blocks of contacts by the node of their column. Blocks of sleeping bodies have no column.
void System::sort_contacts() {
    contact_begin_.assign(symbolic.order.size() + 2, 0);
    const auto awake = [&](const ContactBlock& b) {
        return node_of_body[at(b.a)] >= 0 && node_of_body[at(b.b)] >= 0;
    };
    for (const ContactBlock& b : contacts.blocks)
        if (awake(b)) ++contact_begin_[at(column_of(b)) + 2];
    for (std::size_t k = 2; k < contact_begin_.size(); ++k)
        contact_begin_[k] += contact_begin_[k - 1];
    contact_order_.resize(at(contact_begin_.back()));
    for (std::size_t k = 0; k < contacts.blocks.size(); ++k)
        if (awake(contacts.blocks[k]))
            contact_order_[at(contact_begin_[at(column_of(contacts.blocks[k])) + 1]++)] =
                static_cast<std::int32_t>(k);
}

/// Sort columns by address in the panels. Columns of ordinary fronts follow the order of
/// elimination. Steps of batches come after them, each with the columns of its lanes.
void System::place_columns() {
    const auto n = static_cast<std::int32_t>(symbolic.order.size());
    column_slot_.clear();
    step_begin_.assign(symbolic.batch_steps.size() + 1, 0);
    const auto step_of = [&](std::int32_t k) {
        return symbolic.batches.empty() ? -1 : symbolic.node_step[at(symbolic.order[at(k)])];
    };
    for (std::int32_t k = 0; k < n; ++k)
        if (const std::int32_t step = step_of(k); step >= 0)
            ++step_begin_[at(step) + 1];
        else
            column_slot_.emplace_back(symbolic.column_address(k), k);
    step_begin_[0] = static_cast<std::int32_t>(column_slot_.size());
    for (std::size_t i = 1; i < step_begin_.size(); ++i) step_begin_[i] += step_begin_[i - 1];
    column_slot_.resize(at(n));
    for (std::int32_t k = 0; k < n; ++k)
        if (const std::int32_t step = step_of(k); step >= 0)
            column_slot_[at(step_begin_[at(step)]++)] = {symbolic.batch_steps[at(step)].panel, k};
}

/// List the ops of all columns at one address of an ordinary front, starting with entry `column` of
/// column_slot_. @return the first column after them.
std::size_t System::list_slot(std::size_t column, const model::Bodies& bodies,
                              const model::Interactions& in) {
    const std::int64_t place = column_slot_[column].first;
    for (; column < column_slot_.size() && column_slot_[column].first == place; ++column) {
        const std::int32_t node = symbolic.order[at(column_slot_[column].second)];
        const factor::ColumnTargets targets(symbolic, node);
        list_column(node, bodies, in, [&](std::int32_t row, const OpParts& op) {
            const factor::BlockTarget t = targets.of(row);
            op.write(ops.emplace_back(), t.address, t.step, t.ld);
        });
    }
    return column;
}

/// List the ops of a step of a batch. Ops of several lanes are merged. @return the first column
/// after them.
std::size_t System::list_step(std::size_t column, const model::Bodies& bodies,
                              const model::Interactions& in) {
    const std::int64_t place = column_slot_[column].first;
    sharer_.begin(place, lane_ops.size());
    for (; column < column_slot_.size() && column_slot_[column].first == place; ++column) {
        const std::int32_t node = symbolic.order[at(column_slot_[column].second)];
        const factor::ColumnTargets targets(symbolic, node);
        list_column(node, bodies, in, [&](std::int32_t row, const OpParts& op) {
            const factor::BlockTarget t = targets.of(row);
            if (op.kind == Op::contact) {
                op.write(ops.emplace_back(), t.address, t.step, t.ld);
                return;
            }
            const bool record = op.kind == Op::geometric && op.width > 0;
            sharer_.add(op, t.address, t.step, op.kind == Op::body_block ? 0 : in.rows[at(op.id)],
                        record ? geo_slot_[at(op.id)].record : op.jac_a, lane_ops);
        });
    }
    sharer_.end(lane_ops, ops);
    return column;
}

/// Copy the ops of a batch step from the step `before` of the last list. @return the index of the
/// first column behind them.
std::size_t System::carry_step(std::size_t column, std::int32_t step, std::int32_t before) {
    const OpRange& from = steps_before_[at(before)];
    const std::int64_t place = column_slot_[column].first, moved = history_.moved(step);
    for (std::int64_t k = from.op_begin; k < from.op_end; ++k)
        history_.carry(moved, ops.emplace_back(ops_before_[at(k)]));
    for (std::int64_t k = from.lane_begin; k < from.lane_end; ++k)
        history_.carry(moved, lane_ops.emplace_back(lane_ops_before_[at(k)]));
    while (column < column_slot_.size() && column_slot_[column].first == place) ++column;
    return column;
}

/// List the ops of all columns at the address of `column`. @return the first column after them.
std::size_t System::list_columns_at(std::size_t column, const model::Bodies& bodies,
                                    const model::Interactions& in) {
    if (symbolic.batches.empty()) return list_slot(column, bodies, in);
    const std::int32_t step =
        symbolic.node_step[at(symbolic.order[at(column_slot_[column].second)])];
    if (step < 0) return list_slot(column, bodies, in);
    OpRange& range = step_ops_[at(step)];
    range.op_begin = std::ssize(ops);
    range.lane_begin = std::ssize(lane_ops);
    const std::int32_t before = history_.step_before(step);
    column = before >= 0 ? carry_step(column, step, before) : list_step(column, bodies, in);
    range.op_end = std::ssize(ops);
    range.lane_end = std::ssize(lane_ops);
    return column;
}

void System::build_ops(const model::Bodies& bodies, const model::Interactions& in) {
    sort_contacts();
    place_columns();
    history_.follow({symbolic, bodies, in, column_slot_, member_of_node_, node_of_interaction, dof_,
                     rests_, geo_slot_, contacts.blocks});
    ops.swap(ops_before_);
    lane_ops.swap(lane_ops_before_);
    step_ops_.swap(steps_before_);
    step_ops_.assign(symbolic.batch_steps.size(), {});
    ops.clear();
    lane_ops.clear();
    op_slot_.clear();
    lane_slot_.clear();
    const std::vector<factor::Piece>& pieces = numeric.pieces();
    piece_ops_.assign(pieces.size(), {});
    pieces_by_slot_.resize(pieces.size());
    std::iota(pieces_by_slot_.begin(), pieces_by_slot_.end(), 0);
    std::sort(pieces_by_slot_.begin(), pieces_by_slot_.end(), [&](std::int32_t p, std::int32_t q) {
        return pieces[at(p)].panel_begin < pieces[at(q)].panel_begin;
    });
    std::size_t column = 0;
    for (const std::int32_t k : pieces_by_slot_) {
        OpRange& range = piece_ops_[at(k)];
        range.op_begin = std::ssize(ops);
        range.lane_begin = std::ssize(lane_ops);
        while (column < column_slot_.size()) {
            const std::int64_t place = column_slot_[column].first;
            if (place >= pieces[at(k)].panel_end) break;
            column = list_columns_at(column, bodies, in);
            op_slot_.resize(ops.size(), place);
            lane_slot_.resize(lane_ops.size(), place);
        }
        range.op_end = std::ssize(ops);
        range.lane_end = std::ssize(lane_ops);
    }
    list_skew_ops();
    history_.done();
    if (contacts.blocks.empty() && report_.replanned) {  // the next time is not soon
        column_slot_ = {};
        ops_before_ = {};
        lane_ops_before_ = {};
        history_ = {};
    }
}

}  // namespace hawser::assembly
