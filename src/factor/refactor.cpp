// SPDX-License-Identifier: Apache-2.0
/// Members of SymmetricNumeric that factor a part again (partial.h).
#include "base/index.h"
#include "factor/kernels.h"
#include "factor/numeric.h"

#include <algorithm>

namespace hawser::factor {

void SymmetricNumeric::clear(const Symbolic&, const DirtyParts& dirty,
                             base::Executor& executor) noexcept {
    auto zero = [&](int i, int) noexcept {
        const PanelRange& r = dirty.panels[at(i)];
        std::fill(panel_.begin() + r.begin, panel_.begin() + r.end, double{0});
    };
    executor.for_each(static_cast<int>(dirty.panels.size()), zero);
}

int SymmetricNumeric::refactor(const Symbolic& s, const DirtyParts& dirty,
                               base::Executor& executor) noexcept {
    const FactorView v = view(s, 0);  // no stacks: every update matrix has its own memory
    const Kernels& kernels = factor_kernels();
    auto node = [&](int i, int thread) noexcept {
        int wrong_pivots = 0;
        if (at(i) < s.batches.size() && dirty.is_batch(i))
            wrong_pivots += kernels.factor_batch(v, s.batches[at(i)], s.batches[at(i)].step_begin,
                                                 s.batches[at(i)].step_end, scratch(thread));
        for (std::int32_t k = dirty.nodes[at(i)]; k < dirty.nodes[at(i) + 1]; ++k)
            wrong_pivots += kernels.factor(v, dirty.ranges[at(k)].begin, dirty.ranges[at(k)].end,
                                           scratch(thread));
        wrong_pivots_[at(i)] = wrong_pivots;
    };
    queue_.run(s.graph, TaskPass::factor, executor, node);
    return count_wrong_pivots(s);
}

}  // namespace hawser::factor
