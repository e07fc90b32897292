// SPDX-License-Identifier: Apache-2.0
#include "factor/lay_out_batches.h"

#include "base/index.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace hawser::factor {
namespace {

/// Update slots come in threes, so that tiles of the window meet tiles when it moves on.
std::int32_t whole_tiles(std::int32_t scalars) { return (scalars + kTile - 1) / kTile * kTile; }

/// A boundary node of a chain, and how many steps before the end it is touched first.
struct Touch {
    std::int32_t node, size, steps;
};

/// Boundary nodes of one chain, the earliest touched first.
std::vector<Touch> boundary_of(const Pattern& pattern, const Chains& chains, int chain,
                               const std::vector<std::int32_t>& chain_of) {
    std::vector<Touch> touches;
    const std::int32_t first = chains.begin[at(chain)], last = chains.begin[at(chain + 1)];
    for (std::int32_t u = first; u < last; ++u)
        for (std::int32_t v : chains.unit(u))
            for (std::int32_t w : pattern.neighbours(v)) {
                if (chain_of[at(w)] == chain) continue;
                if (std::none_of(touches.begin(), touches.end(),
                                 [&](const Touch& t) { return t.node == w; }))
                    touches.push_back({w, pattern.size[at(w)], last - u});
            }
    return touches;
}

/// What a template holds: boundary slots shared by the lanes.
struct Slot {
    std::int32_t size, steps, offset;
};

/// Match sizes with the slots not used yet by this lane; add slots where none is left.
std::vector<std::size_t> assign(const std::vector<Touch>& touches, std::vector<Slot>& slots) {
    std::vector<std::size_t> chosen;
    std::vector<bool> used(slots.size(), false);
    for (const Touch& t : touches) {
        std::size_t s = 0;
        while (s < slots.size() && (used[s] || slots[s].size != t.size)) ++s;
        if (s == slots.size()) {
            slots.push_back({t.size, t.steps, 0});
            used.push_back(false);
        }
        used[s] = true;
        slots[s].steps = std::max(slots[s].steps, t.steps);
        chosen.push_back(s);
    }
    return chosen;
}

class Builder {
  public:
    Builder(const Pattern& pattern, const Chains& chains,
            const std::vector<std::int32_t>& front_of_chain, Symbolic& s)
        : pattern_(pattern), chains_(chains), front_(front_of_chain), s_(s) {
        chain_of_.assign(pattern.size.size(), -1);
        for (int c = 0; c < chains.count(); ++c)
            for (std::int32_t u = chains.begin[at(c)]; u < chains.begin[at(c + 1)]; ++u)
                for (std::int32_t v : chains.unit(u)) chain_of_[at(v)] = c;
        for (int c = 0; c < chains.count(); ++c)
            touches_.push_back(boundary_of(pattern, chains, c, chain_of_));
    }

    void run() {
        s_.node_step.assign(pattern_.size.size(), -1);
        s_.node_slot.assign(pattern_.size.size(), -1);
        s_.tail_slot.assign(s_.rows.size(), -1);
        std::vector<std::int32_t> order(at(chains_.count()));
        std::iota(order.begin(), order.end(), 0);
        // Alike chains side by side: shape, then what they carry, then length.
        auto key = [&](std::int32_t c) {
            std::int32_t carried = 0;
            for (const Touch& t : touches_[at(c)])
                if (2 * t.steps > chains_.units(c)) carried += t.size;
            return std::array<std::int32_t, 5>{chains_.body_size[at(c)], chains_.reach[at(c)],
                                               carried, -chains_.units(c), c};
        };
        std::sort(order.begin(), order.end(),
                  [&](std::int32_t a, std::int32_t b) { return key(a) < key(b); });
        std::vector<std::int32_t> members;
        for (std::int32_t c : order) {
            if (!members.empty() &&
                (members.size() == kLaneCount ||
                 chains_.body_size[at(c)] != chains_.body_size[at(members[0])] ||
                 chains_.reach[at(c)] != chains_.reach[at(members[0])])) {
                add_batch(members);
                members.clear();
            }
            members.push_back(c);
        }
        if (!members.empty()) add_batch(members);
    }

  private:
    void add_batch(const std::vector<std::int32_t>& members) {
        Batch batch;
        batch.body = chains_.body_size[at(members[0])];
        batch.window = batch.body * chains_.reach[at(members[0])];
        std::int32_t steps = 0;
        for (std::int32_t c : members) steps = std::max(steps, chains_.units(c));
        const std::vector<std::vector<std::int32_t>> rows = row_slots(members, steps);
        std::vector<Slot> slots;
        std::vector<std::vector<std::size_t>> chosen;
        for (std::int32_t c : members) chosen.push_back(assign(touches_[at(c)], slots));
        // Slots by first touch; offsets follow.
        std::vector<std::size_t> by_touch(slots.size());
        std::iota(by_touch.begin(), by_touch.end(), std::size_t{0});
        std::stable_sort(by_touch.begin(), by_touch.end(), [&](std::size_t a, std::size_t b) {
            return slots[a].steps > slots[b].steps;
        });
        std::int32_t q = batch.window;
        for (std::size_t i : by_touch) {
            slots[i].offset = q;
            q += whole_tiles(slots[i].size);
        }
        batch.step_begin = static_cast<std::int32_t>(s_.batch_steps.size());
        for (std::int32_t k = 0; k < steps; ++k) {
            std::int32_t active = batch.window;
            for (const Slot& slot : slots)
                if (slot.steps >= steps - k) active += whole_tiles(slot.size);
            add_step(batch, active, rows[at(k)]);
        }
        batch.step_end = static_cast<std::int32_t>(s_.batch_steps.size());
        for (int l = 0; l < kLaneCount; ++l) batch.front[l] = -1;
        for (std::size_t l = 0; l < members.size(); ++l)
            place_lane(batch, static_cast<int>(l), members[l], rows, slots, chosen[l]);
        s_.batches.push_back(batch);
    }

    /// Sizes of the row nodes of every step, the union over the lanes, ascending.
    [[nodiscard]] std::vector<std::vector<std::int32_t>> row_slots(
        const std::vector<std::int32_t>& members, std::int32_t steps) const {
        std::vector<std::vector<std::int32_t>> rows(at(steps));
        for (std::int32_t c : members)
            for (std::int32_t u = chains_.begin[at(c)]; u < chains_.begin[at(c + 1)]; ++u) {
                if (chains_.unit(u).size() == 1) continue;  // a body without rows
                auto& slots = rows[at(steps - (chains_.begin[at(c + 1)] - u))];
                std::vector<std::int32_t> sizes, merged;
                for (std::int32_t v : chains_.unit(u).subspan(1))
                    sizes.push_back(pattern_.size[at(v)]);
                std::sort(sizes.begin(), sizes.end());
                std::set_union(slots.begin(), slots.end(), sizes.begin(), sizes.end(),
                               std::back_inserter(merged));
                slots.swap(merged);
            }
        return rows;
    }

    void add_step(Batch& batch, std::int32_t q, const std::vector<std::int32_t>& rows) {
        BatchStep step;
        step.p = batch.body + std::accumulate(rows.begin(), rows.end(), 0);
        step.q = q;
        step.slot = static_cast<std::int64_t>(s_.slot_sign.size());
        step.panel = s_.panel_size;
        s_.panel_size += static_cast<std::int64_t>(kLaneCount) * step.p * (step.p + step.q);
        for (std::int32_t i = 0; i < step.p; ++i)
            s_.slot_sign.push_back(i < batch.body ? std::int8_t{1} : std::int8_t{-1});
        s_.slot_index.resize(kLaneCount * s_.slot_sign.size(), -1);
        batch.most_p = std::max(batch.most_p, step.p);
        batch.most_q = std::max(batch.most_q, step.q);
        batch.unused += static_cast<std::int64_t>(kLaneCount) * step.p;
        s_.batch_steps.push_back(step);
    }

    void place_lane(Batch& batch, int lane, std::int32_t chain,
                    const std::vector<std::vector<std::int32_t>>& rows,
                    const std::vector<Slot>& slots, const std::vector<std::size_t>& chosen) {
        Front& front = s_.fronts[at(front_[at(chain)])];
        batch.front[lane] = front_[at(chain)];
        front.batch = static_cast<std::int32_t>(s_.batches.size());
        front.lane = lane;
        const std::int32_t first = chains_.begin[at(chain)], last = chains_.begin[at(chain + 1)];
        const auto steps = static_cast<std::int32_t>(rows.size());
        for (std::int32_t u = first; u < last; ++u) {
            const std::int32_t k = steps - (last - u);
            const BatchStep& step = s_.batch_steps[at(batch.step_begin + k)];
            used_.assign(rows[at(k)].size(), 0);
            for (std::int32_t v : chains_.unit(u)) {
                std::int32_t slot = 0;
                if (v != chains_.unit(u)[0]) {
                    slot = batch.body;
                    std::size_t r = 0;  // row_slots() made one for each
                    while (used_[r] != 0 || rows[at(k)][r] != pattern_.size[at(v)])
                        slot += rows[at(k)][r++];
                    used_[r] = 1;
                }
                s_.node_step[at(v)] = batch.step_begin + k;
                s_.node_slot[at(v)] = slot;
                for (std::int32_t i = 0; i < pattern_.size[at(v)]; ++i)
                    s_.slot_index[static_cast<std::size_t>(kLaneCount * (step.slot + slot + i) +
                                                           lane)] = s_.node_offset[at(v)] + i;
                batch.unused -= pattern_.size[at(v)];
            }
            const std::int64_t flops = front_flops(step.p, step.q);
            batch.flops += flops;
            s_.flops += flops;
            s_.factor_nnz += static_cast<std::int64_t>(step.p) * (step.p + 1) / 2 +
                             static_cast<std::int64_t>(step.p) * step.q;
        }
        for (std::size_t t = 0; t < chosen.size(); ++t) {
            const Touch& touch = touches_[at(chain)][t];
            const std::int32_t* begin = s_.rows.data() + front.rows;
            const auto row = static_cast<std::int32_t>(
                std::lower_bound(begin, begin + front.q, s_.node_offset[at(touch.node)]) - begin);
            for (std::int32_t i = 0; i < touch.size; ++i)
                s_.tail_slot[static_cast<std::size_t>(front.rows + row + i)] =
                    slots[chosen[t]].offset + i;
        }
    }

    const Pattern& pattern_;
    const Chains& chains_;
    const std::vector<std::int32_t>& front_;
    Symbolic& s_;
    std::vector<std::int32_t> chain_of_;
    std::vector<std::vector<Touch>> touches_;
    std::vector<std::uint8_t> used_;
};

}  // namespace

void lay_out_batches(const Pattern& pattern, const Chains& chains,
                     const std::vector<std::int32_t>& front_of_chain, Symbolic& s) {
    if (chains.count() == 0) return;
    // Vectors of the kernels are aligned when the panels are.
    s.panel_size = (s.panel_size + 7) & ~std::int64_t{7};
    Builder(pattern, chains, front_of_chain, s).run();
    s.panel_size += 64;
    for (const Batch& b : s.batches)
        s.batch_scratch =
            std::max(s.batch_scratch,
                     batch_windows(b) + kLaneCount * std::int64_t{2} * (b.most_p + b.most_q));
}

}  // namespace hawser::factor
