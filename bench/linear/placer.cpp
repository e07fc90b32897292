// SPDX-License-Identifier: Apache-2.0
#include "linear/placer.h"

#include "index.h"

#include <algorithm>

namespace hawser::bench {

void Placer::place(const BlockForm& form, const factor::Analysis& analysis,
                   const std::vector<factor::Piece>& pieces, std::vector<BlockWrite>& ops,
                   std::vector<Range>& of_piece) {
    const factor::Symbolic& s = analysis.symbolic();
    find_nodes(s, pieces);
    sort(form, s.fronts.size());
    of_piece.resize(pieces.size());
    for (std::size_t r = 0; r < pieces.size(); ++r)
        of_piece[at(by_place_[r].second)] = {at(r == 0 ? 0 : next_[r - 1]), at(next_[r])};
    ops.resize(form.ops.size());
    row_.resize(s.order.size());
    for (std::size_t f = 0; f < s.fronts.size(); ++f) {
        const factor::Front& front = s.fronts[f];
        const auto id = static_cast<std::int32_t>(f);
        if (front.batch < 0) find_rows(form, analysis, front);
        for (std::int32_t k = f == 0 ? 0 : start_[f - 1]; k < start_[f]; ++k) {
            const std::int32_t i = index_[at(k)];
            const BlockOp& op = form.ops[at(i)];
            const bool turned = (column_[at(i)] & 1) != 0;
            const std::int32_t row = turned ? op.col : op.row, col = turned ? op.row : op.col;
            BlockWrite& write = ops[at(to_[at(i)])];
            if (front.batch >= 0) {
                const factor::BlockTarget to = s.target(row, col);
                write = BlockWrite(op, turned, to.address, to.step, to.ld);
                continue;
            }
            const Place &r = places_[at(row)], &c = places_[at(col)];
            const std::int32_t below = -static_cast<std::int32_t>(r.front != id);
            const std::int32_t place = (row_[at(row)] & below) | (r.row & ~below);
            write = BlockWrite(op, turned, c.column + place, 1, c.ld);
        }
    }
}

/// Pieces in the sequence of their panels, and what the blocks need of every node.
void Placer::find_nodes(const factor::Symbolic& s, const std::vector<factor::Piece>& pieces) {
    by_place_.clear();
    for (const factor::Piece& p : pieces)
        by_place_.emplace_back(p.panel_begin, static_cast<std::int32_t>(by_place_.size()));
    std::sort(by_place_.begin(), by_place_.end());
    next_.assign(pieces.size(), 0);
    front_rank_.resize(s.fronts.size());
    step_rank_.resize(s.batch_steps.size());
    for (std::size_t r = 0; r < pieces.size(); ++r) {
        const factor::Piece& p = pieces[at(by_place_[r].second)];
        const auto rank = static_cast<std::int32_t>(r);
        if (p.begin == p.end)
            std::fill(step_rank_.begin() + p.step_begin, step_rank_.begin() + p.step_end, rank);
        else
            std::fill(front_rank_.begin() + p.begin, front_rank_.begin() + p.end, rank);
    }
    places_.resize(s.order.size());
    for (std::size_t f = 0; f < s.fronts.size(); ++f) {
        const factor::Front& front = s.fronts[f];
        for (std::int32_t k = front.node_begin; k < front.node_end; ++k) {
            const std::int32_t node = s.order[at(k)];
            const std::int32_t row = s.node_offset[at(node)] - front.offset;
            const std::int32_t rank =
                front.batch < 0 ? front_rank_[f] : step_rank_[at(s.node_step[at(node)])];
            const std::int64_t column = front.panel + static_cast<std::int64_t>(row) * front.ld;
            places_[at(node)] = {column, front.ld, row, k, static_cast<std::int32_t>(f), rank};
        }
    }
}

/// Two counting sorts: by front, to find rows, and by piece, for where blocks end up.
void Placer::sort(const BlockForm& form, std::size_t fronts) {
    const std::size_t count = form.ops.size();
    start_.assign(fronts, 0);
    column_.resize(count);
    index_.resize(count);
    to_.resize(count);
    const Place* const places = places_.data();
    for (std::size_t i = 0; i < count; ++i) {
        const std::int32_t row = form.ops[i].row, col = form.ops[i].col;
        const auto turned = static_cast<std::int32_t>(places[row].position < places[col].position);
        const std::int32_t column = col + (row - col) * turned;
        column_[i] = 2 * column + turned;
        ++start_[at(places[column].front)];
        ++next_[at(places[column].rank)];
    }
    for (auto* counts : {&start_, &next_}) {
        std::int32_t sum = 0;
        for (std::int32_t& k : *counts) sum += std::exchange(k, sum);
    }
    for (std::size_t i = 0; i < count; ++i)
        index_[at(start_[at(places[column_[i] / 2].front)]++)] = static_cast<std::int32_t>(i);
    for (const std::int32_t i : form.alike)
        to_[at(i)] = next_[at(places[column_[at(i)] / 2].rank)]++;
}

/// Rows of a front by node, where they are none of its pivots.
void Placer::find_rows(const BlockForm& form, const factor::Analysis& analysis,
                       const factor::Front& front) {
    std::int32_t row = front.p;
    const std::int32_t last = analysis.symbolic().order[at(front.node_end - 1)];
    for (const std::int32_t v : analysis.columns().rows(last)) {
        row_[at(v)] = row;
        row += form.pattern.size[at(v)];
    }
}

}  // namespace hawser::bench
