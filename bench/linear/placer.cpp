// SPDX-License-Identifier: Apache-2.0
#include "linear/placer.h"

#include "index.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace hawser::bench {
namespace {

/// Find the rows of a front by node, except for its pivots.
void find_rows(const BlockForm& form, const factor::Analysis& analysis, const factor::Front& front,
               std::int32_t* row_of) {
    std::int32_t row = front.p;
    const std::int32_t last = analysis.symbolic().order[at(front.node_end - 1)];
    for (const std::int32_t v : analysis.columns().rows(last)) {
        row_of[v] = row;
        row += form.pattern.size[at(v)];
    }
}

}  // namespace

void Placer::place(const BlockForm& form, const factor::Analysis& analysis,
                   const std::vector<factor::Piece>& pieces, std::vector<BlockWrite>& ops,
                   std::vector<Range>& of_piece, base::Executor& executor) {
    const factor::Symbolic& s = analysis.symbolic();
    if (s.panel_size > std::numeric_limits<std::uint32_t>::max()) BlockWrite::is_out_of_reach();
    find_nodes(s, pieces);
    sort(form, executor);
    of_piece.resize(pieces.size());
    for (std::size_t r = 0; r < pieces.size(); ++r)
        of_piece[at(by_slot_[r].second)] = {at(r == 0 ? 0 : next_[r - 1]), at(next_[r])};
    ops.resize(form.ops.size());
    const std::size_t n = s.order.size();
    row_.resize(n * at(executor.threads()));
    // Groups of about equal numbers of blocks, of some microseconds each.
    constexpr std::size_t kBlocks = 512;
    const std::size_t count = index_.size();
    const int parts = executor.threads() == 1
                          ? 1
                          : static_cast<int>(std::clamp(count / kBlocks, std::size_t{1},
                                                        4 * at(executor.threads())));
    auto first = [&](int part) {
        if (part == parts) return start_.size();
        const auto block = static_cast<std::int32_t>(count * at(part) / at(parts));
        return at(std::upper_bound(start_.begin(), start_.end(), block) - start_.begin());
    };
    auto task = [&](int part, int thread) noexcept {
        assign_group_addresses(form, analysis, part == 0 ? 0 : first(part), first(part + 1),
                               row_.data() + n * at(thread), ops.data());
    };
    executor.for_each(parts, task);
}

void Placer::assign_group_addresses(const BlockForm& form, const factor::Analysis& analysis,
                                    std::size_t begin, std::size_t end, std::int32_t* rows,
                                    BlockWrite* ops) const {
    const factor::Symbolic& s = analysis.symbolic();
    const BlockOp* const from = form.ops.data();
    const Place* const places = places_.data();
    const std::int32_t *const index = index_.data(), *const column = column_.data();
    std::int32_t k = begin == 0 ? 0 : start_[begin - 1];
    for (std::size_t g = begin; g < end; ++g) {
        const std::int32_t blocks_end = start_[g];
        if (g >= s.fronts.size()) {  // of a chain
            for (; k < blocks_end; ++k) {
                const std::int32_t i = index[k], col = column[i] / 2;
                const factor::BlockTarget t = s.target(from[i].row + from[i].col - col, col);
                ops[to_[at(i)]] =
                    BlockWrite(from[i], (column[i] & 1) != 0, t.address, t.step, t.ld);
            }
            continue;
        }
        const factor::Front& front = s.fronts[g];
        if (front.batch >= 0) continue;
        find_rows(form, analysis, front, rows);
        const auto id = static_cast<std::int32_t>(g);
        for (; k < blocks_end; ++k) {
            const std::int32_t i = index[k], col = column[i] / 2;
            const std::int32_t row = from[i].row + from[i].col - col;
            const Place &r = places[row], &c = places[col];
            const std::int32_t below = -static_cast<std::int32_t>(r.group != id);
            const std::int32_t place = (rows[row] & below) | (r.row & ~below);
            ops[to_[at(i)]] = BlockWrite(from[i], (column[i] & 1) != 0, c.column + place, 1, c.ld);
        }
    }
}

/// Sort pieces by their panels, and collect the data of every node.
void Placer::find_nodes(const factor::Symbolic& s, const std::vector<factor::Piece>& pieces) {
    by_slot_.clear();
    for (const factor::Piece& p : pieces)
        by_slot_.emplace_back(p.panel_begin, static_cast<std::int32_t>(by_slot_.size()));
    std::sort(by_slot_.begin(), by_slot_.end());
    const auto fronts = static_cast<std::int32_t>(s.fronts.size());
    rank_.resize(s.fronts.size() + s.batch_steps.size());
    for (std::size_t r = 0; r < pieces.size(); ++r) {
        const factor::Piece& p = pieces[at(by_slot_[r].second)];
        const auto rank = static_cast<std::int32_t>(r);
        if (p.begin == p.end)
            std::fill(rank_.begin() + fronts + p.step_begin, rank_.begin() + fronts + p.step_end,
                      rank);
        else
            std::fill(rank_.begin() + p.begin, rank_.begin() + p.end, rank);
    }
    places_.resize(s.order.size());
    for (std::size_t f = 0; f < s.fronts.size(); ++f) {
        const factor::Front& front = s.fronts[f];
        for (std::int32_t k = front.node_begin; k < front.node_end; ++k) {
            const std::int32_t node = s.order[at(k)];
            const std::int32_t row = s.node_offset[at(node)] - front.offset;
            const std::int32_t group =
                front.batch < 0 ? static_cast<std::int32_t>(f) : fronts + s.node_step[at(node)];
            const std::int64_t column = front.panel + static_cast<std::int64_t>(row) * front.ld;
            places_[at(node)] = {column, front.ld, row, k, group};
        }
    }
}

/// Sort by two counting sorts: by group, to find rows, and by piece, for the positions of blocks.
void Placer::sort(const BlockForm& form, base::Executor& executor) {
    const std::size_t count = form.ops.size();
    start_.assign(rank_.size(), 0);
    next_.assign(by_slot_.size(), 0);
    column_.resize(count);
    index_.resize(count);
    to_.resize(count);
    const Place* const places = places_.data();
    // Successive blocks often have one column, and their counts wait for each other: count both
    // halves in turns.
    const std::size_t half = (count + 1) / 2;
    auto in_turns = [&](auto&& f) {
        for (std::size_t i = 0; i < count - half; ++i) {
            f(i);
            f(i + half);
        }
        if (2 * half > count) f(half - 1);
    };
    std::int32_t *const start = start_.data(), *const column = column_.data();
    in_turns([&](std::size_t i) {
        const std::int32_t row = form.ops[i].row, col = form.ops[i].col;
        const auto turned = static_cast<std::int32_t>(places[row].position < places[col].position);
        const std::int32_t node = col + (row - col) * turned;
        column[i] = 2 * node + turned;
        ++start[places[node].group];
    });
    for (std::size_t g = 0; g < rank_.size(); ++g) next_[at(rank_[g])] += start_[g];
    for (auto* counts : {&start_, &next_}) {
        std::int32_t sum = 0;
        for (std::int32_t& k : *counts) sum += std::exchange(k, sum);
    }
    std::int32_t *const next = next_.data(), *const to = to_.data();
    const std::int32_t* const rank = rank_.data();
    auto one = [&](int which, int) noexcept {
        if (which == 0)
            in_turns([&](std::size_t i) {
                index_[at(start[places[column[i] / 2].group]++)] = static_cast<std::int32_t>(i);
            });
        else
            for (const std::int32_t i : form.alike)
                to[i] = next[rank[places[column[i] / 2].group]]++;
    };
    executor.for_each(2, one);
}

}  // namespace hawser::bench
