// SPDX-License-Identifier: Apache-2.0
#include "factor/symbolic.h"

#include "base/index.h"

#include <algorithm>

namespace hawser::factor {
namespace {

/// Return the local row of a permuted scalar in a front.
std::int32_t local_row(const Symbolic& s, const Front& front, std::int32_t scalar) {
    if (scalar < front.offset + front.p) return scalar - front.offset;
    const auto* first = s.rows.data() + front.rows;
    return front.p +
           static_cast<std::int32_t>(std::lower_bound(first, first + front.q, scalar) - first);
}

}  // namespace

std::int64_t front_flops(int p, int q) noexcept {
    // Sums of m and m² up to the last, less those below the first.
    auto sum = [](std::int64_t n) { return n * (n + 1) * (2 * n + 1) / 6 + n * (n + 1); };
    return sum(static_cast<std::int64_t>(p) + q - 1) - sum(static_cast<std::int64_t>(q) - 1);
}

ColumnTargets::ColumnTargets(const Symbolic& symbolic, std::int32_t column) noexcept
    : s_(symbolic),
      front_(symbolic.fronts[at(symbolic.node_front[at(column)])]),
      index_(symbolic.node_front[at(column)]) {
    if (front_.batch >= 0) {
        step_index_ = s_.node_step[at(column)];
        step_ = &s_.batch_steps[at(step_index_)];
        begin_ = step_->panel + kLaneCount * std::int64_t{s_.node_slot[at(column)]} + front_.lane;
    } else {
        begin_ =
            front_.panel + std::int64_t{s_.node_offset[at(column)] - front_.offset} * front_.ld;
    }
}

/// Return the row of a step's panel at which a node begins.
std::int32_t ColumnTargets::panel_row_of(std::size_t row) const noexcept {
    if (s_.node_front[row] != index_)
        return step_->p + s_.tail_slot[at(front_.rows + local_row(s_, front_, s_.node_offset[row]) -
                                          front_.p)];
    const std::int32_t behind = s_.node_step[row] - step_index_;
    if (behind == 0) return s_.node_slot[row];
    return step_->p + (behind - 1) * s_.batches[at(front_.batch)].body;
}

BlockTarget ColumnTargets::of(std::int32_t row) const noexcept {
    if (step_ == nullptr)
        return {begin_ + local_row(s_, front_, s_.node_offset[at(row)]), 1, front_.ld};
    const std::int32_t stride = kLaneCount * step_->p;
    return {begin_ + std::int64_t{panel_row_of(at(row))} * stride, stride, kLaneCount};
}

BlockTarget Symbolic::target(std::int32_t row, std::int32_t column) const noexcept {
    return ColumnTargets(*this, column).of(row);
}

std::int64_t Symbolic::column_address(std::int32_t k) const noexcept {
    const auto node = static_cast<std::size_t>(order[static_cast<std::size_t>(k)]);
    const Front& front = fronts[static_cast<std::size_t>(node_front[node])];
    if (front.batch >= 0) return batch_steps[static_cast<std::size_t>(node_step[node])].panel;
    return front.panel + static_cast<std::int64_t>(node_offset[node] - front.offset) * front.ld;
}

std::size_t Symbolic::bytes() const noexcept {
    return base::bytes(order) + base::bytes(position) + base::bytes(node_offset) +
           base::bytes(node_front) + base::bytes(fronts) + base::bytes(children) +
           base::bytes(rows) + base::bytes(runs) + base::bytes(sign) + base::bytes(tasks) +
           base::bytes(top) + base::bytes(top_tasks) + base::bytes(front_task) + graph.bytes() +
           base::bytes(batches) + base::bytes(batch_steps) + base::bytes(slot_sign) +
           base::bytes(slot_index) + base::bytes(tail_slot) + base::bytes(node_step) +
           base::bytes(node_slot);
}

}  // namespace hawser::factor
