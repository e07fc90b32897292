// SPDX-License-Identifier: Apache-2.0
#include "factor/unsymmetric.h"

#include "base/index.h"
#include "factor/piece.h"

namespace hawser::factor {
void Unsymmetric::reserve(const Symbolic& s) {
    const std::size_t n = s.fronts.size(), batches_n = s.batches.size();
    if (mark_.size() < n) mark_.resize(n, 0);
    if (batch_mark_.size() < batches_n) batch_mark_.resize(batches_n, 0);
    marked_.reserve(n);
    fronts.reserve(n);
    batches.reserve(batches_n);
}

void Unsymmetric::find(const Symbolic& s, std::span<const std::int32_t> columns) noexcept {
    // Clear the previous set, which may belong to another structure.
    for (const std::int32_t f : marked_) mark_[at(f)] = 0;
    for (const std::int32_t b : batches) batch_mark_[at(b)] = 0;
    marked_.clear();
    fronts.clear();
    batches.clear();
    flops = s.flops;
    auto mark = [&](std::int32_t f) {
        mark_[at(f)] = 1;
        marked_.push_back(f);
    };
    for (const std::int32_t node : columns)
        for (std::int32_t f = s.node_front[at(node)]; f >= 0 && mark_[at(f)] == 0;
             f = s.fronts[at(f)].parent) {
            const Front& front = s.fronts[at(f)];
            mark(f);
            if (front.batch >= 0) {
                if (batch_mark_[at(front.batch)] != 0) continue;
                batch_mark_[at(front.batch)] = 1;
                batches.push_back(front.batch);
                flops += s.batches[at(front.batch)].flops;
            } else {
                fronts.push_back(f);
                flops += front_flops(front.p, front.q);
            }
        }
    // The other chains of a batch come last, because they do not add their parents to the set.
    for (const std::int32_t b : batches)
        for (const std::int32_t f : s.batches[at(b)].front)
            if (f >= 0 && mark_[at(f)] == 0) mark(f);
}

bool Unsymmetric::is_piece(const Symbolic& s, const Piece& piece) const noexcept {
    if (piece.begin == piece.end) return is_batch(piece.begin);
    for (std::int32_t f = piece.begin; f < piece.end; ++f)
        if (is(f) && s.fronts[at(f)].batch < 0) return true;
    return false;
}

}  // namespace hawser::factor
