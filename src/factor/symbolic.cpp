// SPDX-License-Identifier: Apache-2.0
#include "factor/symbolic.h"

#include <algorithm>

namespace hawser::factor {
namespace {

/// Local row of a permuted scalar in a front.
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

BlockTarget Symbolic::target(std::int32_t row, std::int32_t column) const noexcept {
    const Front& front =
        fronts[static_cast<std::size_t>(node_front[static_cast<std::size_t>(column)])];
    if (front.batch >= 0) {
        const auto i = static_cast<std::size_t>(row), j = static_cast<std::size_t>(column);
        const BatchStep& step = batch_steps[static_cast<std::size_t>(node_step[j])];
        std::int32_t slot = node_slot[i];
        if (node_front[i] != node_front[j])
            slot = step.p + tail_slot[static_cast<std::size_t>(
                                front.rows + local_row(*this, front, node_offset[i]) - front.p)];
        else if (node_step[i] != node_step[j])
            slot = step.p + (node_step[i] - node_step[j] - 1) *
                                batches[static_cast<std::size_t>(front.batch)].body;
        return {step.panel +
                    kLaneCount * (static_cast<std::int64_t>(slot) * step.p + node_slot[j]) +
                    front.lane,
                kLaneCount * step.p, kLaneCount};
    }
    const std::int32_t r = local_row(*this, front, node_offset[static_cast<std::size_t>(row)]);
    const std::int32_t c = node_offset[static_cast<std::size_t>(column)] - front.offset;
    return {front.panel + static_cast<std::int64_t>(c) * front.ld + r, 1, front.ld};
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
