// SPDX-License-Identifier: Apache-2.0
/// Writes the contributions of the list into the panels.
#include "assembly/system.h"
#include "base/index.h"

#include <algorithm>

namespace hawser::assembly {
namespace {

/// Return the index range of the addresses in [low, high), which are ascending.
std::pair<std::int64_t, std::int64_t> between(const std::vector<std::int64_t>& places,
                                              std::int64_t low, std::int64_t high) {
    const auto a = std::lower_bound(places.begin(), places.end(), low);
    const auto b = std::lower_bound(a, places.end(), high);
    return {a - places.begin(), b - places.begin()};
}

}  // namespace

void System::write_blocks(const View& view, int piece, double* panel) const noexcept {
    const OpRange& p = piece_ops_[at(piece)];
    kernels().gather_lane_blocks(view, lane_ops.data(), p.lane_begin, p.lane_end, panel);
    kernels().gather_blocks(view, ops.data(), p.op_begin, p.op_end, panel);
}

void System::write_skew(const View& view, std::int64_t begin, std::int64_t end,
                        double* upper) const noexcept {
    auto i = std::lower_bound(skew_ops_.begin(), skew_ops_.end(), begin) - skew_ops_.begin();
    for (auto k = static_cast<std::size_t>(i); k < skew_ops_.size() && skew_ops_[k] < end; ++k) {
        const Op& op = ops[at(skew_ops_[k])];
        if (contacts.block_skew[at(op.id)] == 0) continue;
        const double* lower =
            view.contact_block + static_cast<std::ptrdiff_t>(kContactBlock) * op.id;
        // The diagonal block of a body is square: the other half is its transpose.
        const bool own = contacts.blocks[at(op.id)].a == contacts.blocks[at(op.id)].b;
        const double* other = own ? lower : lower + (op.a ? 0 : 36);
        const double* mine = own ? lower : lower + (op.a ? 36 : 0);
        double* out = upper + op.address;
        for (int j = 0; j < op.dof_b; ++j)
            for (int r = 0; r < op.dof_a; ++r)
                out[r * op.step + j * op.ld] += other[6 * r + j] - mine[6 * j + r];
    }
}

void System::write_skew(const View& view, int piece, double* upper) const noexcept {
    write_skew(view, piece_ops_[at(piece)].op_begin, piece_ops_[at(piece)].op_end, upper);
}

template <class F>
void System::over_panels(const factor::DirtyParts& part, base::Executor& executor,
                         F&& work) const noexcept {
    const auto count = static_cast<int>(part.panels.size());
    // Use several pieces per thread, because the amount written to panels differs.
    const int pieces = executor.threads() == 1 ? 1 : std::min(count, 8 * executor.threads());
    auto piece = [&](int i, int) noexcept {
        for (int k = count * i / pieces; k < count * (i + 1) / pieces; ++k)
            work(part.panels[at(k)]);
    };
    executor.for_each(pieces, piece);
}

void System::write_blocks(const View& view, const factor::DirtyParts& part, double* panel,
                          base::Executor& executor) const noexcept {
    over_panels(part, executor, [&](const factor::PanelRange& r) {
        const auto [lane_begin, lane_end] = between(lane_slot_, r.begin, r.end);
        kernels().gather_lane_blocks(view, lane_ops.data(), lane_begin, lane_end, panel);
        const auto [begin, end] = between(op_slot_, r.begin, r.end);
        kernels().gather_blocks(view, ops.data(), begin, end, panel);
    });
}

void System::write_skew(const View& view, const factor::DirtyParts& part, double* upper,
                        base::Executor& executor) const noexcept {
    over_panels(part, executor, [&](const factor::PanelRange& r) {
        const auto [begin, end] = between(op_slot_, r.begin, r.end);
        write_skew(view, begin, end, upper);
    });
}

}  // namespace hawser::assembly
