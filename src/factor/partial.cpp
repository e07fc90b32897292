// SPDX-License-Identifier: Apache-2.0
#include "factor/partial.h"

#include "base/index.h"

#include <algorithm>

namespace hawser::factor {
namespace {

/// Return the end of a front's panel with the gap behind it, where the next panel begins.
std::int64_t panel_end(const Front& f) {
    return f.panel + static_cast<std::int64_t>(f.ld) * f.p + (f.p + f.ldu > f.ld ? 8 : 0);
}

}  // namespace

PanelRange panel_of(const Symbolic& s, const Batch& batch) noexcept {
    const BatchStep& last = s.batch_steps[at(batch.step_end - 1)];
    return {s.batch_steps[at(batch.step_begin)].panel,
            last.panel + static_cast<std::int64_t>(kLaneCount) * last.p * (last.p + last.q)};
}

void separate_updates(Symbolic& s) noexcept {
    std::int64_t size = 0;
    for (Front& f : s.fronts) {
        f.update = size;
        // Vector loads of an update matrix may read one vector past it.
        size += static_cast<std::int64_t>(f.ldu) * f.q + 8;
    }
    s.stack_begin = s.work_size = size + 64;
    s.updates_kept = true;
}

void DirtyParts::reserve(const Symbolic& s) {
    const std::size_t n = s.fronts.size(), batches_n = s.batches.size();
    if (front_mark_.size() < n) front_mark_.resize(n, 0);
    if (batch_mark_.size() < batches_n) batch_mark_.resize(batches_n, 0);
    fronts.reserve(n);
    batches.reserve(batches_n);
    panels.reserve(n + batches_n);
    ranges.reserve(n);
    nodes.reserve(at(s.graph.nodes()) + 1);
}

void DirtyParts::find(const Symbolic& s, std::span<const std::int32_t> columns,
                      const Unsymmetric* unsymmetric) noexcept {
    if (++epoch_ == 0) {  // after 2³² calls: clear all marks, so that no old one is valid
        std::fill(front_mark_.begin(), front_mark_.end(), 0U);
        std::fill(batch_mark_.begin(), batch_mark_.end(), 0U);
        epoch_ = 1;
    }
    fronts.clear();
    batches.clear();
    panels.clear();
    flops = 0;
    for (const std::int32_t node : columns)
        for (std::int32_t f = s.node_front[at(node)]; f >= 0 && front_mark_[at(f)] != epoch_;
             f = s.fronts[at(f)].parent) {
            front_mark_[at(f)] = epoch_;
            const std::int32_t b = s.fronts[at(f)].batch;
            if (b < 0) {
                fronts.push_back(f);
            } else if (batch_mark_[at(b)] != epoch_) {
                batch_mark_[at(b)] = epoch_;
                batches.push_back(b);
            }
        }
    std::sort(fronts.begin(), fronts.end());
    std::sort(batches.begin(), batches.end());
    for (const std::int32_t f : fronts) {
        const Front& front = s.fronts[at(f)];
        add_panel(front.panel, panel_end(front));
        const bool twice = unsymmetric != nullptr && unsymmetric->is(f);
        flops += (twice ? 2 : 1) * front_flops(front.p, front.q);
    }
    for (const std::int32_t b : batches) {
        const PanelRange r = panel_of(s, s.batches[at(b)]);
        add_panel(r.begin, r.end);
        const bool twice = unsymmetric != nullptr && unsymmetric->is_batch(b);
        flops += (twice ? 2 : 1) * s.batches[at(b)].flops;
    }
    make_ranges(s);
}

void DirtyParts::add_panel(std::int64_t begin, std::int64_t end) noexcept {
    if (!panels.empty() && panels.back().end == begin)
        panels.back().end = end;
    else if (end > begin)
        panels.push_back({begin, end});
}

void DirtyParts::make_ranges(const Symbolic& s) noexcept {
    ranges.clear();
    for (const std::int32_t f : fronts) {
        const std::int32_t node = s.front_task[at(f)];
        if (!ranges.empty() && ranges.back().end == f && ranges.back().node == node)
            ++ranges.back().end;
        else
            ranges.push_back({f, f + 1, node});
    }
    std::sort(ranges.begin(), ranges.end(), [](const FrontRange& a, const FrontRange& b) {
        return a.node != b.node ? a.node < b.node : a.begin < b.begin;
    });
    nodes.clear();
    std::int32_t k = 0;
    for (std::int32_t n = 0; n <= s.graph.nodes(); ++n) {
        while (k < static_cast<std::int32_t>(ranges.size()) && ranges[at(k)].node < n) ++k;
        nodes.push_back(k);
    }
}

}  // namespace hawser::factor
