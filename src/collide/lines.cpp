// SPDX-License-Identifier: Apache-2.0
/// Association of segments with the wires that they lie along.
#include "base/index.h"
#include "collide/collider.h"

#include <hawser/def.h>

#include <algorithm>

namespace hawser::collide {

/// Find the segment that owns the node at each end of each segment, see is_duplicate(). An end that
/// a body holds has no owner, because the body may hold segments of several wires.
void Collider::find_owners(int body_count) {
    std::vector<std::int32_t>& owner = of_body_;
    owner.assign(at(body_count), -1);
    for (std::int32_t i = 0; i < count(); ++i) {
        Shape& s = shapes_[at(i)];
        if (!s.segment()) continue;
        for (int end = 0; end < 2; ++end) {
            s.owner[end] = -1;
            if (end == s.held) continue;
            std::int32_t& first = owner[at(s.body[end])];
            s.owner[end] = first;
            if (first < 0) first = i;
        }
    }
}

/// Find the wire element (stretch) between the two ends of each segment. If there are several, use
/// the one with the lowest id. If a body holds the segment, the order of the ends must agree,
/// because a node may have the same body on both sides.
void Collider::find_lines(const model::Interactions& interactions, int body_count) {
    of_body_.assign(at(body_count), -1);  // last line with this lower end
    lines_of_bodies_.clear();
    for (int k = 0; k < kInteractionKindCount; ++k) {
        if (!kind_info(static_cast<InteractionKind>(k)).is(kWireElement)) continue;
        for (const std::int32_t id : interactions.pool[at(k)].ids) {
            if (interactions.gone(id)) continue;
            const std::int32_t* body = &interactions.body[kMaxInteractionBodies * at(id)];
            std::int32_t& last = of_body_[at(std::min(body[0], body[1]))];
            lines_of_bodies_.push_back({std::max(body[0], body[1]), id, last});
            last = static_cast<std::int32_t>(lines_of_bodies_.size()) - 1;
        }
    }
    const auto fits = [&](const Shape& s, std::int32_t id) {
        const std::int32_t* body = &interactions.body[kMaxInteractionBodies * at(id)];
        return s.held < 0 || (body[0] == s.body[0] && body[1] == s.body[1]);
    };
    for (Shape& s : shapes_) {
        s.line = -1;
        if (!s.segment()) continue;
        const std::int32_t other = std::max(s.body[0], s.body[1]);
        for (std::int32_t k = of_body_[at(std::min(s.body[0], s.body[1]))]; k >= 0;
             k = lines_of_bodies_[at(k)].before) {
            const Line& line = lines_of_bodies_[at(k)];
            if (line.other == other && (s.line < 0 || line.id < s.line) && fits(s, line.id))
                s.line = line.id;
        }
    }
    lines_ = &interactions;
}

}  // namespace hawser::collide
