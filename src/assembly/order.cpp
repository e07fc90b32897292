// SPDX-License-Identifier: Apache-2.0
/// Build the pattern of the system, choose its order of elimination, and lay out the data by it.
#include "assembly/system.h"
#include "base/index.h"

#include <algorithm>

namespace hawser::assembly {

void System::relink(const model::Bodies& bodies, const model::Interactions& interactions,
                    int threads) {
    find_islands(interactions);
    find_order(bodies, interactions, nullptr);
    place(bodies, interactions, threads);
}

void System::find_order(const model::Bodies& bodies, const model::Interactions& interactions,
                        const factor::AnalysisState* state) {
    const factor::Pattern& next = next_;
    const std::int32_t changed = build_pattern(bodies, interactions);
    analysis.separate_updates(!contacts.blocks.empty());
    const bool repairable = ordered_ && changed <= kMaxRepairFraction * next.nodes();
    report_ = {};
    // Until the new order is complete there is none: after std::bad_alloc the next call plans anew.
    ordered_ = false;
    if (state == nullptr && repairable) {
        report_ = analysis.update(next, old_of_new_);
    } else {
        if (state != nullptr)
            analysis.resume(next, *state);
        else
            analysis.plan(next);
        report_.replanned = true;
        report_.columns = next.nodes();
    }
    ordered_ = true;
}

/// Compute the addresses of all matrix blocks in the structure of the factor, and allocate the
/// panels.
void System::place(const model::Bodies& bodies, const model::Interactions& interactions,
                   int threads) {
    check_memory(bodies, interactions, threads);
    if (!contacts.blocks.empty()) dirty.reserve(symbolic);
    if (may_skew()) unsymmetric.reserve(symbolic);
    numeric.reserve(symbolic, threads, may_skew());
    solution_.assign(at(symbolic.scalars) + 8, 0.0);
    for (int b = 0; b < bodies.count(); ++b)
        if (node_of_body[at(b)] >= 0)
            body_offset_[at(b)] = symbolic.node_offset[at(node_of_body[at(b)])];
    for (int i = 0; i < interactions.count(); ++i)
        if (node_of_interaction[at(i)] >= 0)
            interaction_offset_[at(i)] = symbolic.node_offset[at(node_of_interaction[at(i)])];
    build_ops(bodies, interactions);
    place_capstans(interactions);
}

/// Throw LimitError if the panels would exceed max_bytes, before they are allocated: they are most
/// of the memory of a world.
void System::check_memory(const model::Bodies& bodies, const model::Interactions& interactions,
                          int threads) const {
    const double ours = static_cast<double>(bodies.bytes() + interactions.bytes() + bytes()) -
                        static_cast<double>(numeric.bytes());
    const double all = ours + std::max(static_cast<double>(numeric.bytes()),
                                       factor::Numeric::bytes_for(symbolic, threads, may_skew()));
    if (all > max_bytes) throw LimitError({Bound::memory, all, max_bytes});
}

void System::keep(Kept& out) const {
    if (ordered_) analysis.keep(out.analysis);
    out.node_of_body = node_of_body;
    out.node_of_interaction = node_of_interaction;
    out.ordered = ordered_;
    out.updates_kept = symbolic.updates_kept;
}

void System::go_back(Kept& to) noexcept {
    if (to.ordered) analysis.restore(to.analysis);
    node_of_body.swap(to.node_of_body);
    node_of_interaction.swap(to.node_of_interaction);
    ordered_ = to.ordered;
    analysis.separate_updates(to.updates_kept);  // as the next change of shapes requires
}

std::int32_t System::build_pattern(const model::Bodies& bodies, const model::Interactions& in) {
    std::vector<std::int8_t>&size = next_.size, &sign = next_.sign;
    size.clear();
    sign.clear();
    node_of_body.swap(body_before_);
    node_of_interaction.swap(interaction_before_);
    node_of_body.assign(at(bodies.count()), -1);
    node_of_interaction.assign(at(in.count()), -1);
    body_before_.resize(at(bodies.count()), -1);
    interaction_before_.resize(at(in.count()), -1);
    old_of_new_.clear();
    member_of_node_.clear();
    for (std::int32_t b : bodies.moving) {
        if (dof_[at(b)] == 0) continue;
        node_of_body[at(b)] = static_cast<std::int32_t>(size.size());
        old_of_new_.push_back(body_before_[at(b)]);
        member_of_node_.push_back(b);
        size.push_back(static_cast<std::int8_t>(dof_[at(b)]));
        sign.push_back(1);
    }
    for (int i = 0; i < in.count(); ++i)
        if (kept_[at(i)]) {
            node_of_interaction[at(i)] = static_cast<std::int32_t>(size.size());
            old_of_new_.push_back(interaction_before_[at(i)]);
            member_of_node_.push_back(i);
            size.push_back(static_cast<std::int8_t>(in.rows[at(i)]));
            sign.push_back(-1);
        }
    std::vector<std::int32_t>&from = edge_from_, &to = edge_to_;
    from.clear();
    to.clear();
    auto link = [&](std::int32_t a, std::int32_t b) {
        if (a < 0 || b < 0) return;
        from.push_back(a);
        to.push_back(b);
    };
    for (int i = 0; i < in.count(); ++i)
        for (int a = 0; a < in.bodies[at(i)] && !rests(i); ++a) {
            const std::int32_t na = node_of_body[at(in.body[at(kMaxInteractionBodies * i + a)])];
            if (kept_[at(i)]) link(node_of_interaction[at(i)], na);
            for (int b = a + 1; b < in.bodies[at(i)]; ++b)
                if (!kept_[at(i)] || (in.geo[at(i)] >= 0 && b < 2))
                    link(na, node_of_body[at(in.body[at(kMaxInteractionBodies * i + b)])]);
        }
    for (const Contacts::Link& l : contacts.links)
        link(node_of_body[at(l.first)], node_of_body[at(l.second)]);
    edge_dealer_.set_neighbours(from, to, next_);
    std::int32_t stay = 0;
    for (const std::int32_t old : old_of_new_) stay += old >= 0 ? 1 : 0;
    return pattern.nodes() - stay + next_.nodes() - stay;
}

}  // namespace hawser::assembly
