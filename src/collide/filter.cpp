// SPDX-License-Identifier: Apache-2.0
#include "collide/filter.h"

#include <utility>

namespace hawser::collide {
namespace {

using Pairs = std::vector<std::pair<std::int32_t, std::int32_t>>;

Pairs joined_bodies(const std::vector<Shape>& shapes, const model::Interactions& interactions) {
    Pairs pairs;
    auto join = [&](std::int32_t a, std::int32_t b) {
        pairs.emplace_back(a, b);
        pairs.emplace_back(b, a);
    };
    for (const Shape& s : shapes)
        if (s.segment()) join(s.body[0], s.body[1]);
    for (const InteractionDef& d : interactions.def)
        if (kind_info(d.kind).is(kHoldsBodies) && d.body[0].valid())
            join(d.body[0].index, d.body[1].index);
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
}

}  // namespace

void Filter::build(const std::vector<Shape>& shapes, int body_count,
                   const model::Interactions& interactions) {
    const Pairs pairs = joined_bodies(shapes, interactions);
    begin_.assign(static_cast<std::size_t>(body_count) + 1, 0);
    joined_.clear();
    for (const auto& [body, other] : pairs) {
        ++begin_[static_cast<std::size_t>(body) + 1];
        joined_.push_back(other);
    }
    for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
    entries_.clear();
    for (const Shape& s : shapes)
        entries_.push_back({{s.body[0], s.body[1]}, s.group, s.touches, s.moves});
}

}  // namespace hawser::collide
