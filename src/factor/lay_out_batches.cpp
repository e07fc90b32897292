// SPDX-License-Identifier: Apache-2.0
#include "factor/lay_out_batches.h"

#include "base/index.h"
#include "base/memory.h"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace hawser::factor {
namespace {

/// Round scalars up to a multiple of three, so that tiles of the window stay aligned when it moves
/// on.
std::int32_t round_up_to_tile(std::int32_t scalars) {
    return (scalars + kTile - 1) / kTile * kTile;
}

}  // namespace

/// Find the boundary nodes of each chain, sorted by the first step in which they have entries.
void BatchBuilder::find_touches(const Job& job) {
    const Chains& chains = job.chains;
    const std::size_t n = job.pattern.size.size();
    chain_of_.assign(n, -1);
    for (int c = 0; c < chains.count(); ++c)
        for (std::int32_t u = chains.begin[at(c)]; u < chains.begin[at(c + 1)]; ++u)
            for (const std::int32_t v : chains.unit(u)) chain_of_[at(v)] = c;
    touched_by_.assign(n, -1);
    touches_.clear();
    touch_begin_.assign(1, 0);
    for (int c = 0; c < chains.count(); ++c) {
        const std::int32_t last = chains.begin[at(c + 1)];
        for (std::int32_t u = chains.begin[at(c)]; u < last; ++u)
            for (const std::int32_t v : chains.unit(u))
                for (const std::int32_t w : job.pattern.neighbours(v)) {
                    if (chain_of_[at(w)] == c || touched_by_[at(w)] == c) continue;
                    touched_by_[at(w)] = c;
                    touches_.push_back({w, job.pattern.size[at(w)], last - u});
                }
        touch_begin_.push_back(static_cast<std::int32_t>(touches_.size()));
    }
}

/// Sort the chains so that chains of equal structure are adjacent.
void BatchBuilder::sort_chains(const Chains& chains) {
    order_.clear();
    for (std::int32_t c = 0; c < chains.count(); ++c) {
        std::int32_t carried = 0;
        for (const SlotUse& t : touches(c))
            if (2 * t.steps > chains.units(c)) carried += t.size;
        order_.push_back(
            {{chains.body_size[at(c)], chains.reach[at(c)], carried, -chains.units(c)}, c});
    }
    std::sort(order_.begin(), order_.end());
}

void BatchBuilder::run(const Pattern& pattern, const Chains& chains,
                       const std::vector<std::int32_t>& front_of_chain, Symbolic& s) {
    if (chains.count() == 0) return;
    const Job job{pattern, chains, front_of_chain, s};
    // Vectors of the kernels are aligned if the panels are.
    s.panel_size = (s.panel_size + 7) & ~std::int64_t{7};
    s.node_step.assign(pattern.size.size(), -1);
    s.node_slot.assign(pattern.size.size(), -1);
    s.tail_slot.assign(s.rows.size(), -1);
    find_touches(job);
    sort_chains(chains);
    for (std::size_t begin = 0, end; begin < order_.size(); begin = end) {
        const auto alike = [&](const Alike& a) {
            return a.key[0] == order_[begin].key[0] && a.key[1] == order_[begin].key[1];
        };
        for (end = begin + 1;
             end < order_.size() && end - begin < kLaneCount && alike(order_[end]);)
            ++end;
        add_batch(job, std::span(order_).subspan(begin, end - begin));
    }
    s.panel_size += 64;
    for (const Batch& b : s.batches)
        s.batch_scratch = std::max(
            s.batch_scratch, batch_windows(b) + kLaneCount * std::int64_t{2} * (b.max_p + b.max_q));
}

void BatchBuilder::add_batch(const Job& job, std::span<const Alike> members) {
    Symbolic& s = job.s;
    Batch batch;
    batch.body = members[0].key[0];
    batch.window = batch.body * members[0].key[1];
    std::int32_t steps = 0;
    for (const Alike& m : members) steps = std::max(steps, job.chains.units(m.chain));
    find_row_slots(job, members, steps);
    assign_slots(members);
    assign_slot_offsets(batch);
    batch.step_begin = static_cast<std::int32_t>(s.batch_steps.size());
    for (std::int32_t k = 0; k < steps; ++k) {
        std::int32_t active = batch.window;
        for (const Slot& slot : slots_)
            if (slot.steps >= steps - k) active += round_up_to_tile(slot.size);
        add_step(job, batch, active, row_slots(k));
    }
    batch.step_end = static_cast<std::int32_t>(s.batch_steps.size());
    for (int l = 0; l < kLaneCount; ++l) batch.front[l] = -1;
    for (std::size_t l = 0; l < members.size(); ++l)
        assign_lane(job, batch, static_cast<int>(l), members[l].chain);
    s.batches.push_back(batch);
}

/// Find the sizes of the row nodes of every batch step, as the union over the lanes, ascending.
void BatchBuilder::find_row_slots(const Job& job, std::span<const Alike> members,
                                  std::int32_t steps) {
    row_sizes_.clear();
    row_begin_.assign(1, 0);
    for (std::int32_t k = 0; k < steps; ++k) {
        union_.clear();
        for (const Alike& m : members) {
            const std::int32_t u = job.chains.begin[at(m.chain + 1)] - (steps - k);
            // A shorter chain begins later; a body may have no rows.
            if (u < job.chains.begin[at(m.chain)] || job.chains.unit(u).size() == 1) continue;
            sizes_.clear();
            for (const std::int32_t v : job.chains.unit(u).subspan(1))
                sizes_.push_back(job.pattern.size[at(v)]);
            std::sort(sizes_.begin(), sizes_.end());
            merged_.clear();
            std::set_union(union_.begin(), union_.end(), sizes_.begin(), sizes_.end(),
                           std::back_inserter(merged_));
            union_.swap(merged_);
        }
        row_sizes_.insert(row_sizes_.end(), union_.begin(), union_.end());
        row_begin_.push_back(static_cast<std::int32_t>(row_sizes_.size()));
    }
}

/// Assign members to the unused slots of a lane by size; add a slot if none is unused.
void BatchBuilder::assign_slots(std::span<const Alike> members) {
    slots_.clear();
    chosen_.clear();
    for (std::size_t l = 0; l < members.size(); ++l) {
        lane_begin_[l] = chosen_.size();
        slot_used_.assign(slots_.size(), 0);
        for (const SlotUse& t : touches(members[l].chain)) {
            std::size_t i = 0;
            while (i < slots_.size() && (slot_used_[i] != 0 || slots_[i].size != t.size)) ++i;
            if (i == slots_.size()) {
                slots_.push_back({t.size, t.steps, 0});
                slot_used_.push_back(0);
            }
            slot_used_[i] = 1;
            slots_[i].steps = std::max(slots_[i].steps, t.steps);
            chosen_.push_back(static_cast<std::int32_t>(i));
        }
    }
    lane_begin_[members.size()] = chosen_.size();
}

/// Sort slots by first touch and compute their offsets.
void BatchBuilder::assign_slot_offsets(Batch& batch) {
    by_touch_.resize(slots_.size());
    std::iota(by_touch_.begin(), by_touch_.end(), 0);
    std::sort(by_touch_.begin(), by_touch_.end(), [&](std::int32_t a, std::int32_t b) {
        return slots_[at(a)].steps != slots_[at(b)].steps
                   ? slots_[at(a)].steps > slots_[at(b)].steps
                   : a < b;
    });
    std::int32_t q = batch.window;
    for (const std::int32_t i : by_touch_) {
        slots_[at(i)].offset = q;
        q += round_up_to_tile(slots_[at(i)].size);
    }
}

void BatchBuilder::add_step(const Job& job, Batch& batch, std::int32_t q,
                            std::span<const std::int32_t> rows) {
    Symbolic& s = job.s;
    BatchStep step;
    step.p = batch.body + std::accumulate(rows.begin(), rows.end(), 0);
    step.q = q;
    step.slot = static_cast<std::int64_t>(s.slot_sign.size());
    step.panel = s.panel_size;
    s.panel_size += static_cast<std::int64_t>(kLaneCount) * step.p * (step.p + step.q);
    for (std::int32_t i = 0; i < step.p; ++i)
        s.slot_sign.push_back(i < batch.body ? std::int8_t{1} : std::int8_t{-1});
    s.slot_index.resize(kLaneCount * s.slot_sign.size(), -1);
    batch.max_p = std::max(batch.max_p, step.p);
    batch.max_q = std::max(batch.max_q, step.q);
    batch.unused += static_cast<std::int64_t>(kLaneCount) * step.p;
    s.batch_steps.push_back(step);
}

/// Assign a batch step and slots to the nodes of one unit in one lane.
void BatchBuilder::assign_unit(const Job& job, Batch& batch, int lane, std::int32_t unit,
                               std::int32_t step) {
    Symbolic& s = job.s;
    const BatchStep& of = s.batch_steps[at(batch.step_begin + step)];
    const std::span<const std::int32_t> rows = row_slots(step);
    slot_used_.assign(rows.size(), 0);
    for (const std::int32_t v : job.chains.unit(unit)) {
        std::int32_t slot = 0;
        if (v != job.chains.unit(unit)[0]) {
            slot = batch.body;
            std::size_t r = 0;  // find_row_slots() made a slot for each
            while (slot_used_[r] != 0 || rows[r] != job.pattern.size[at(v)]) slot += rows[r++];
            slot_used_[r] = 1;
        }
        s.node_step[at(v)] = batch.step_begin + step;
        s.node_slot[at(v)] = slot;
        for (std::int32_t i = 0; i < job.pattern.size[at(v)]; ++i)
            s.slot_index[static_cast<std::size_t>(kLaneCount * (of.slot + slot + i) + lane)] =
                s.node_offset[at(v)] + i;
        batch.unused -= job.pattern.size[at(v)];
    }
}

void BatchBuilder::assign_lane(const Job& job, Batch& batch, int lane, std::int32_t chain) {
    Symbolic& s = job.s;
    Front& front = s.fronts[at(job.front[at(chain)])];
    batch.front[lane] = job.front[at(chain)];
    front.batch = static_cast<std::int32_t>(s.batches.size());
    front.lane = lane;
    const std::int32_t last = job.chains.begin[at(chain + 1)];
    const auto steps = static_cast<std::int32_t>(row_begin_.size()) - 1;
    for (std::int32_t u = job.chains.begin[at(chain)]; u < last; ++u) {
        const std::int32_t k = steps - (last - u);
        assign_unit(job, batch, lane, u, k);
        const BatchStep& step = s.batch_steps[at(batch.step_begin + k)];
        const std::int64_t flops = front_flops(step.p, step.q);
        batch.flops += flops;
        s.flops += flops;
        s.factor_nnz += static_cast<std::int64_t>(step.p) * (step.p + 1) / 2 +
                        static_cast<std::int64_t>(step.p) * step.q;
    }
    const std::span<const SlotUse> own = touches(chain);
    for (std::size_t t = 0; t < own.size(); ++t) {
        const std::int32_t* begin = s.rows.data() + front.rows;
        const auto row = static_cast<std::int32_t>(
            std::lower_bound(begin, begin + front.q, s.node_offset[at(own[t].node)]) - begin);
        const Slot& slot = slots_[at(chosen_[lane_begin_[at(lane)] + t])];
        for (std::int32_t i = 0; i < own[t].size; ++i)
            s.tail_slot[static_cast<std::size_t>(front.rows + row + i)] = slot.offset + i;
    }
}

std::size_t BatchBuilder::bytes() const noexcept {
    using base::bytes;
    return bytes(chain_of_) + bytes(touched_by_) + bytes(touch_begin_) + bytes(touches_) +
           bytes(order_) + bytes(row_begin_) + bytes(row_sizes_) + bytes(sizes_) + bytes(union_) +
           bytes(merged_) + bytes(slots_) + bytes(chosen_) + bytes(by_touch_) + bytes(slot_used_);
}

}  // namespace hawser::factor
