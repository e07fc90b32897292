// SPDX-License-Identifier: Apache-2.0
#include "assembly/op_history.h"

#include "base/index.h"

#include <algorithm>

namespace hawser::assembly {
namespace {

std::size_t body_key(std::int32_t body) noexcept { return 2 * at(body); }
std::size_t interaction_key(std::int32_t id) noexcept { return 2 * at(id) + 1; }

/// True if a precedes b in the sort order: diagonal blocks of bodies precede links.
bool before(const ContactBlock& a, const ContactBlock& b) noexcept {
    const bool link_a = a.a != a.b, link_b = b.a != b.b;
    if (link_a != link_b) return link_b;
    return a.a != b.a ? a.a < b.a : a.b < b.b;
}

}  // namespace

void OpHistory::mark(const Traits& of) noexcept {
    for (int b = 0; b < of.bodies; ++b) changed_[body_key(of.body[b])] = 1;
}

void OpHistory::mark(const ContactBlock& block) noexcept {
    changed_[body_key(block.a)] = changed_[body_key(block.b)] = 1;
}

void OpHistory::follow(const OpSources& now) {
    const bool known = has_list_;
    has_list_ = false;
    std::size_t most = std::max(now.dof.size(), dof_begin_.size());
    most = std::max({most, traits_.size(), at(now.interactions.count())});
    changed_.assign(2 * most, known ? std::uint8_t{0} : std::uint8_t{1});
    compare_interactions(now);
    compare_bodies(now);
    compare_blocks(now.blocks);
    std::swap(batches_, before_);
    list_batches(now);
    match_batches();
}

void OpHistory::compare_interactions(const OpSources& now) {
    const model::Interactions& in = now.interactions;
    const std::size_t count = at(in.count());
    for (std::size_t i = count; i < traits_.size(); ++i) mark(traits_[i]);
    const std::size_t known = std::min(count, traits_.size());
    traits_.resize(count);
    places_.resize(count);
    slot_moved_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        Traits t{};
        t.bodies = in.bodies[i];
        t.rows = in.rows[i];
        t.flags = static_cast<std::uint8_t>((now.node_of_interaction[i] >= 0 ? 1 : 0) |
                                            (in.arms[i] != 0 ? 2 : 0) | (in.geo[i] >= 0 ? 4 : 0) |
                                            (now.rests[i] != 0 ? 8 : 0));
        for (int b = 0; b < t.bodies; ++b) {
            t.body[b] = in.body[kMaxInteractionBodies * i + at(b)];
            t.dof[b] = now.dof[at(t.body[b])];
        }
        const Place place{in.jac_begin[i], now.geo[i].record};
        slot_moved_[i] = {place.jacobian - places_[i].jacobian, place.record - places_[i].record};
        places_[i] = place;
        if (i < known && t == traits_[i]) continue;
        if (i < known) mark(traits_[i]);
        mark(t);
        changed_[interaction_key(static_cast<std::int32_t>(i))] = 1;
        traits_[i] = t;
    }
}

void OpHistory::compare_bodies(const OpSources& now) {
    const std::size_t count = now.dof.size();
    dof_begin_.resize(count);
    block_moved_.resize(count);
    for (std::size_t b = 0; b < count; ++b) {
        const std::int32_t begin = now.bodies.dof_begin[b];
        block_moved_[b] =
            static_cast<std::int32_t>(block_offset(begin) - block_offset(dof_begin_[b]));
        dof_begin_[b] = begin;
    }
}

/// Compare the contact blocks of the last list and of the new one, both sorted. Blocks in both
/// lists keep their order.
void OpHistory::compare_blocks(std::span<const ContactBlock> now) {
    block_now_.clear();
    const auto same = [](const ContactBlock& a, const ContactBlock& b) {
        return a.a == b.a && a.b == b.b;
    };
    if (std::equal(now.begin(), now.end(), blocks_.begin(), blocks_.end(), same)) return;
    block_now_.resize(blocks_.size(), -1);
    std::size_t k = 0;
    for (std::size_t old = 0; old < blocks_.size(); ++old) {
        for (; k < now.size() && before(now[k], blocks_[old]); ++k) mark(now[k]);
        if (k < now.size() && same(now[k], blocks_[old]))
            block_now_[old] = static_cast<std::int32_t>(k++);
        else
            mark(blocks_[old]);
    }
    for (; k < now.size(); ++k) mark(now[k]);
    blocks_.assign(now.begin(), now.end());
}

void OpHistory::renumber_blocks(std::span<const ContactBlock> blocks) {
    blocks_.assign(blocks.begin(), blocks.end());
    has_list_ = true;
}

/// List the columns of each batch step, and the rows behind them.
void OpHistory::list_batches(const OpSources& now) {
    const factor::Symbolic& s = now.symbolic;
    batches_.steps.assign(s.batch_steps.begin(), s.batch_steps.end());
    batches_.ranges.clear();
    batches_.entries.clear();
    const auto key = [&](std::int32_t node) {
        const std::int32_t member = now.member_of_node[at(node)];
        const bool body = s.sign[at(s.node_offset[at(node)])] > 0;
        return static_cast<std::int32_t>(body ? body_key(member) : interaction_key(member));
    };
    // Columns of batches follow all others.
    auto column = now.columns.begin();
    for (const factor::Batch& batch : s.batches) {
        const auto begin = static_cast<std::int32_t>(batches_.entries.size());
        for (; column != now.columns.end(); ++column) {
            const std::int32_t node = s.order[at(column->second)], step = s.node_step[at(node)];
            if (step < 0) continue;
            if (step >= batch.step_end) break;
            batches_.entries.push_back({key(node), step - batch.step_begin,
                                        s.fronts[at(s.node_front[at(node)])].lane,
                                        s.node_slot[at(node)]});
        }
        for (int lane = 0; lane < factor::kLaneCount; ++lane)
            if (batch.front[lane] >= 0) list_rows(s, batch.front[lane], lane, key);
        batches_.ranges.push_back({batch.step_begin, batch.step_end, begin,
                                   static_cast<std::int32_t>(batches_.entries.size())});
    }
}

/// List the rows behind a chain, with their slots at its end.
template <class Key>
void OpHistory::list_rows(const factor::Symbolic& s, std::int32_t front, int lane, Key&& key) {
    const factor::Front& f = s.fronts[at(front)];
    for (std::int64_t r = f.rows; r < f.rows + f.q;) {
        const std::int32_t scalar = s.rows[at(r)];
        const auto next = std::upper_bound(
            s.order.begin(), s.order.end(), scalar,
            [&](std::int32_t wanted, std::int32_t v) { return wanted < s.node_offset[at(v)]; });
        batches_.entries.push_back({key(next[-1]), -1, lane, s.tail_slot[at(r)]});
        r += (next == s.order.end() ? s.scalars : s.node_offset[at(*next)]) - scalar;
    }
}

bool OpHistory::same(const BatchRange& now, const BatchRange& then) const noexcept {
    if (now.step_end - now.step_begin != then.step_end - then.step_begin) return false;
    const auto entry = batches_.entries.begin() + now.entry_begin;
    const auto end = batches_.entries.begin() + now.entry_end;
    if (!std::equal(entry, end, before_.entries.begin() + then.entry_begin,
                    before_.entries.begin() + then.entry_end))
        return false;
    for (std::int32_t k = 0; k < now.step_end - now.step_begin; ++k) {
        const factor::BatchStep& a = batches_.steps[at(now.step_begin + k)];
        const factor::BatchStep& b = before_.steps[at(then.step_begin + k)];
        if (a.p != b.p || a.q != b.q) return false;
    }
    return std::none_of(entry, end,
                        [&](const Entry& e) { return e.step >= 0 && changed_[at(e.node)] != 0; });
}

void OpHistory::match_batches() {
    step_before_.assign(batches_.steps.size(), -1);
    moved_.assign(batches_.steps.size(), 0);
    const std::size_t count = before_.ranges.size();
    std::size_t next = 0;
    for (const BatchRange& now : batches_.ranges) {
        std::size_t tried = 0;
        while (tried < count && !same(now, before_.ranges[(next + tried) % count])) ++tried;
        if (tried == count) continue;
        const BatchRange& then = before_.ranges[(next + tried) % count];
        for (std::int32_t k = 0; k < now.step_end - now.step_begin; ++k) {
            const std::size_t step = at(now.step_begin + k), old = at(then.step_begin + k);
            step_before_[step] = static_cast<std::int32_t>(old);
            moved_[step] = batches_.steps[step].panel - before_.steps[old].panel;
        }
        next = (next + tried + 1) % count;
    }
}

void OpHistory::carry(std::int64_t moved, Op& op) const noexcept {
    op.address += moved;
    if (op.kind == Op::contact) {
        if (!block_now_.empty()) op.id = block_now_[at(op.id)];
        return;
    }
    const std::int32_t by =
        op.kind == Op::body_block ? block_moved_[at(op.id)] : slot_moved_[at(op.id)].jacobian;
    op.jac_a += by;
    op.jac_b += by;
}

void OpHistory::carry(std::int64_t moved, LaneOp& op) const noexcept {
    op.address += moved;
    const bool record = op.kind == Op::geometric && op.width > 0;
    for (int l = 0; l < factor::kLaneCount; ++l) {
        const std::size_t id = at(op.id[l]);
        if (op.kind == Op::body_block)
            op.from[l] += block_moved_[id];
        else
            op.from[l] += record ? slot_moved_[id].record : slot_moved_[id].jacobian;
    }
}

std::size_t OpHistory::bytes() const noexcept {
    using base::bytes;
    std::size_t sum = 0;
    for (const Batches* b : {&batches_, &before_})
        sum += bytes(b->steps) + bytes(b->ranges) + bytes(b->entries);
    return sum + bytes(traits_) + bytes(places_) + bytes(slot_moved_) + bytes(dof_begin_) +
           bytes(block_moved_) + bytes(blocks_) + bytes(block_now_) + bytes(changed_) +
           bytes(step_before_) + bytes(moved_);
}

}  // namespace hawser::assembly
