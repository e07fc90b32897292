// SPDX-License-Identifier: Apache-2.0
#include "collide/filter.h"

#include "base/index.h"

#include <algorithm>

namespace hawser::collide {
namespace {

using Beside = std::vector<std::pair<std::int32_t, std::int32_t>>;

/// Find the nodes next to the guides whose elements have segments, sorted by slide.
void find_guide_neighbours(const std::vector<Shape>& shapes,
                           const model::Interactions& interactions, Beside& out) {
    out.clear();
    for (const Shape& s : shapes)
        if (s.held >= 0 && s.line >= 0 && kind_info(interactions.kinds[at(s.line)]).is(kAtGuide))
            out.emplace_back(interactions.body[kMaxInteractionBodies * at(s.line) + 2],
                             s.body[at(1 - s.held)]);
    std::sort(out.begin(), out.end());
}

/// Call f(a, b) for each two bodies that a segment, a joint or a guide holds together.
template <class F>
void each_joined(const std::vector<Shape>& shapes, const model::Interactions& interactions,
                 const Beside& beside, F&& f) {
    for (std::size_t i = 1; i < beside.size(); ++i)
        if (beside[i].first == beside[i - 1].first) f(beside[i - 1].second, beside[i].second);
    for (const Shape& s : shapes)
        if (s.segment() && s.held < 0) f(s.body[0], s.body[1]);
    for (int k = 0; k < kInteractionKindCount; ++k) {
        if (!kind_info(static_cast<InteractionKind>(k)).is(kHoldsBodies)) continue;
        for (const std::int32_t id : interactions.pool[static_cast<std::size_t>(k)].ids) {
            const std::int32_t* body = &interactions.body[kMaxInteractionBodies * at(id)];
            if (!interactions.gone(id)) f(body[0], body[1]);
        }
    }
}

}  // namespace

void Filter::build(const std::vector<Shape>& shapes, int body_count,
                   const model::Interactions& interactions) {
    // Count and store the neighbours by body, then sort and deduplicate each list.
    const auto n = static_cast<std::size_t>(body_count);
    find_guide_neighbours(shapes, interactions, guide_neighbours_);
    begin_.assign(n + 1, 0);
    each_joined(shapes, interactions, guide_neighbours_, [&](std::int32_t a, std::int32_t b) {
        ++begin_[at(a) + 1];
        ++begin_[at(b) + 1];
    });
    for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
    joined_.resize(at(begin_.back()));
    cursor_.assign(begin_.begin(), begin_.end());
    each_joined(shapes, interactions, guide_neighbours_, [&](std::int32_t a, std::int32_t b) {
        joined_[at(cursor_[at(a)]++)] = b;
        joined_[at(cursor_[at(b)]++)] = a;
    });
    auto to = joined_.begin();
    for (std::size_t i = 0; i < n; ++i) {
        const auto first = joined_.begin() + begin_[i];
        std::sort(first, joined_.begin() + cursor_[i]);
        begin_[i] = static_cast<std::int32_t>(to - joined_.begin());
        to = std::unique_copy(first, joined_.begin() + cursor_[i], to);
    }
    begin_[n] = static_cast<std::int32_t>(to - joined_.begin());
    joined_.erase(to, joined_.end());
    entries_.clear();
    for (const Shape& s : shapes)
        entries_.push_back({{s.held == 0 ? -1 : s.body[0], s.held == 1 ? -1 : s.body[1]},
                            s.held >= 0 ? s.body[at(s.held)] : -1,
                            s.group,
                            s.touches,
                            s.moves,
                            s.segment()});
}

}  // namespace hawser::collide
