// SPDX-License-Identifier: Apache-2.0
#include "world/saved_state.h"

#include <cstring>

namespace hawser::world {

SavedState::SavedState(const context::StepContext& ctx, const std::vector<double>& values,
                       const Header& header) {
    // Use the sizes of the target world, pairwise in the order of the list.
    std::vector<std::size_t> sizes;
    visit_motion(ctx, [&](const auto& its) { sizes.push_back(its.size()); });
    std::size_t next = 0;
    visit_motion(*this, [&](auto& mine) { mine.resize(sizes[next++]); });
    const auto as = [](auto& mine, const auto& its) { mine.resize(its.size()); };
    as(state.analysed_x, ctx.state.analysed_x);
    as(state.analysed_r, ctx.state.analysed_r);
    as(model.regroup.parts.part, ctx.model.regroup.parts.part);
    as(inputs, values);
    model.collider.contacts.resize(header.contacts);
    model.system.contacts.memory.resize(header.contacts);
    model.system.contacts.resistances.memory.resize(header.resistances);
    model.system.contacts.links.resize(header.links);
    model.system.contacts.link_used.resize(header.links);
    order = allocate_order(header);
}

std::uint64_t SavedState::size() {
    std::uint64_t sum = 0;
    visit_state(*this, inputs, order, [&](const void*, std::size_t n) { sum += n; });
    return sum;
}

void SavedState::read(std::span<const std::byte> from) {
    visit_state(*this, inputs, order, [&](void* to, std::size_t n) {
        if (n > 0) std::memcpy(to, from.data(), n);
        from = from.subspan(n);
    });
}

factor::AnalysisState allocate_order(const Header& header) {
    factor::AnalysisState s;
    s.elimination.order.resize(header.nodes);
    s.at_branch_meeting.resize(header.nodes);
    factor::Chains& c = s.elimination.chains;
    c.nodes.resize(header.chained);
    c.unit_begin.resize(header.units + 1);
    c.begin.resize(header.chains + 1);
    c.body_size.resize(header.chains);
    c.reach.resize(header.chains);
    return s;
}

}  // namespace hawser::world
