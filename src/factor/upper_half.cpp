// SPDX-License-Identifier: Apache-2.0
/// Members of Numeric for fronts with unsymmetric values (unsymmetric.h): memory for the upper
/// half, its values, and pivots of the wrong sign.
#include "base/index.h"
#include "factor/grow.h"
#include "factor/numeric.h"

#include <algorithm>

namespace hawser::factor {

void Numeric::reserve(const Symbolic& s, int threads, bool unsymmetric) {
    reserve_buffers(s, threads, unsymmetric ? 2 : 1);
    make_pieces(s);
    find_stage(s, threads);
    use(s, nullptr);
    if (!unsymmetric) return;
    grow_discarding(upper_, s.panel_size, s.updates_kept);
    grow_discarding(upper_work_, work_size(s, threads), s.updates_kept);
    grow_discarding(kind_, static_cast<std::int64_t>(s.fronts.size()));
    grow_discarding(wrong_pivot_mark_, s.scalars);
    failed_nodes_.reserve(s.order.size());
}

double Numeric::bytes_for(const Symbolic& s, int threads, bool unsymmetric) noexcept {
    const auto panels = static_cast<double>(s.panel_size + work_size(s, threads));
    const double sides = unsymmetric ? 2.0 : 1.0;
    const auto scratch =
        static_cast<double>(std::max(scratch_size(s.max_front), s.batch_scratch)) * threads;
    return sizeof(double) * (sides * (panels + scratch) + static_cast<double>(s.rows.size()) +
                             static_cast<double>(s.scalars) +
                             2.0 * kLaneCount * static_cast<double>(s.slot_sign.size()));
}

void Numeric::use(const Symbolic& s, const Unsymmetric* set) noexcept {
    failed_nodes_.clear();
    unsymmetric_ = set != nullptr && !set->empty();
    if (unsymmetric_) std::copy_n(set->marks().begin(), s.fronts.size(), kind_.begin());
}

int Numeric::factor(const Symbolic& s, base::Executor& executor,
                    const Unsymmetric* unsymmetric) noexcept {
    use(s, unsymmetric);
    return find_wrong_pivots(s, SymmetricNumeric::factor(s, executor));
}

int Numeric::refactor(const Symbolic& s, const DirtyParts& dirty, base::Executor& executor,
                      const Unsymmetric* unsymmetric) noexcept {
    use(s, unsymmetric);
    return find_wrong_pivots(s, SymmetricNumeric::refactor(s, dirty, executor));
}

std::size_t Numeric::bytes() const noexcept {
    return SymmetricNumeric::bytes() + base::bytes(stage_) + base::bytes(upper_) +
           base::bytes(upper_work_) + base::bytes(kind_) + base::bytes(wrong_pivot_mark_) +
           base::bytes(failed_nodes_);
}

void Numeric::copy_front(const Front& front) noexcept {
    const auto size = static_cast<std::int64_t>(front.ld) * front.p;
    std::copy_n(panel_.data() + front.panel, size, upper_.data() + front.panel);
}

void Numeric::copy_range(std::int64_t begin, std::int64_t end) noexcept {
    std::copy(panel_.data() + begin, panel_.data() + end, upper_.data() + begin);
}

bool Numeric::copy_piece(const Symbolic& s, const Piece& piece) noexcept {
    if (piece.begin == piece.end) {
        const Batch& batch = s.batches[at(piece.begin)];
        if (kind_[at(batch.front[0])] == 0) return false;
        copy_range(piece.panel_begin, piece.panel_end);
        return true;
    }
    bool any = false;
    for (std::int32_t f = piece.begin; f < piece.end; ++f) {
        const Front& front = s.fronts[at(f)];
        if (kind_[at(f)] == 0 || front.batch >= 0) continue;
        copy_front(front);
        any = true;
    }
    return any;
}

void Numeric::copy_to_upper(const Symbolic& s, const Unsymmetric& set,
                            base::Executor& executor) noexcept {
    auto front = [&](int i, int) noexcept { copy_front(s.fronts[at(set.fronts[at(i)])]); };
    auto batch = [&](int i, int) noexcept {
        const PanelRange r = panel_of(s, s.batches[at(set.batches[at(i)])]);
        copy_range(r.begin, r.end);
    };
    executor.for_each(static_cast<int>(set.fronts.size()), front);
    executor.for_each(static_cast<int>(set.batches.size()), batch);
}

void Numeric::copy_to_upper(const Symbolic& s, const DirtyParts& dirty, const Unsymmetric& set,
                            base::Executor& executor) noexcept {
    auto front = [&](int i, int) noexcept {
        const std::int32_t f = dirty.fronts[at(i)];
        if (set.is(f)) copy_front(s.fronts[at(f)]);
    };
    auto batch = [&](int i, int) noexcept {
        const std::int32_t b = dirty.batches[at(i)];
        if (!set.is_batch(b)) return;
        const PanelRange r = panel_of(s, s.batches[at(b)]);
        copy_range(r.begin, r.end);
    };
    executor.for_each(static_cast<int>(dirty.fronts.size()), front);
    executor.for_each(static_cast<int>(dirty.batches.size()), batch);
}

int Numeric::find_wrong_pivots(const Symbolic& s, int wrong) noexcept {
    if (wrong == 0 || !unsymmetric_) return wrong;
    for (std::size_t k = 0; k < s.order.size(); ++k) {
        const auto begin = wrong_pivot_mark_.begin() + s.node_offset[at(s.order[k])];
        const auto end = k + 1 < s.order.size()
                             ? wrong_pivot_mark_.begin() + s.node_offset[at(s.order[k + 1])]
                             : wrong_pivot_mark_.begin() + s.scalars;
        if (std::find(begin, end, 1) == end) continue;
        failed_nodes_.push_back(s.order[k]);
        std::fill(begin, end, std::int8_t{0});
    }
    return wrong;
}

}  // namespace hawser::factor
