// SPDX-License-Identifier: Apache-2.0
#include "assembly/part_cost.h"

#include "base/index.h"

namespace hawser::assembly {
namespace {

/// Return the neighbour of a row node that is eliminated first. The row follows it in the order.
std::int32_t body_of_rows(const factor::Pattern& pattern, const factor::Symbolic& symbolic,
                          std::int32_t node) {
    std::int32_t best = -1;
    for (const std::int32_t u : pattern.neighbours(node))
        if (pattern.sign[at(u)] > 0 &&
            (best < 0 || symbolic.position[at(u)] < symbolic.position[at(best)]))
            best = u;
    return best;
}

}  // namespace

std::vector<std::int64_t> node_flops(const factor::Pattern& pattern,
                                     const factor::Symbolic& symbolic) {
    std::vector<std::int64_t> flops(at(pattern.nodes()), 0);
    for (const factor::Front& front : symbolic.fronts) {
        std::int32_t rows = front.p + front.q;
        for (std::int32_t k = front.node_begin; k < front.node_end; ++k) {
            const std::int32_t node = symbolic.order[at(k)];
            const std::int32_t size = pattern.size[at(node)];
            if (front.batch < 0) {
                rows -= size;
                flops[at(node)] = factor::front_flops(size, rows);
            } else if (pattern.sign[at(node)] > 0) {  // a step contains one body with its rows
                const factor::BatchStep& step =
                    symbolic.batch_steps[at(symbolic.node_step[at(node)])];
                flops[at(node)] = factor::front_flops(step.p, step.q);
            }
        }
    }
    return flops;
}

std::vector<std::int64_t> body_flops(const System& system, int bodies) {
    const std::vector<std::int64_t> node = node_flops(system.pattern, system.symbolic);
    std::vector<std::int64_t> flops(at(bodies), 0);
    std::vector<std::int32_t> body(node.size(), -1);
    for (int b = 0; b < bodies; ++b)
        if (const std::int32_t v = system.node_of_body[at(b)]; v >= 0) {
            flops[at(b)] = node[at(v)];
            body[at(v)] = b;
        }
    for (const std::int32_t v : system.node_of_interaction) {
        if (v < 0) continue;
        const std::int32_t of = body_of_rows(system.pattern, system.symbolic, v);
        if (of >= 0) flops[at(body[at(of)])] += node[at(v)];
    }
    return flops;
}

}  // namespace hawser::assembly
