// SPDX-License-Identifier: Apache-2.0
/// Restoration of an earlier analysis after a failure.
#include "factor/repair.h"

#include <utility>

namespace hawser::factor {

void Analysis::keep(KeptAnalysis& out) const {
    out.pattern = pattern_;
    out.state.elimination.order = symbolic_.order;
    out.state.elimination.chains = chains_;
    out.state.at_branch_meeting = at_branch_meeting_;
    out.state.planned_flops = planned_flops_;
    out.stale = stale_;
}

void Analysis::restore(KeptAnalysis& to) noexcept {
    std::swap(pattern_, to.pattern);
    std::swap(symbolic_.order, to.state.elimination.order);
    std::swap(chains_, to.state.elimination.chains);
    std::swap(at_branch_meeting_, to.state.at_branch_meeting);
    planned_flops_ = to.state.planned_flops;
    stale_ = true;
}

/// Rebuild the structure of the order after restore(). The source stays unchanged until all is
/// done.
void Analysis::rebuild_derived_data() {
    if (!stale_) return;
    KeptAnalysis now;
    keep(now);
    try {
        const Pattern pattern = now.pattern;
        plan(pattern, now.state.elimination);
        at_branch_meeting_ = now.state.at_branch_meeting;
        planned_flops_ = now.state.planned_flops;
    } catch (...) {
        restore(now);
        throw;
    }
}

}  // namespace hawser::factor
