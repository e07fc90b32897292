// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file filter.h
/// Filter of pairs of shapes that may touch.
///
/// Excluded pairs are two shapes of one body (a segment belongs to both its nodes) and shapes
/// without freedom. Also excluded are shapes of bodies that a segment or one of these joints holds
/// together: ball, hinge, prismatic, cylindrical, universal, lock. Such shapes overlap by design.
/// Along a wire this excludes neighbours and their neighbours. Lines, distances and springs exclude
/// nothing: two ships joined by a tow line touch.
///
/// A body that holds the end of a wire (Shape::held) does not belong to the wire. Other wires that
/// end on it touch this one, and so do parts of the body away from the end (touch()). Nodes on
/// either side of a guide are neighbours.

#include "collide/placing.h"
#include "model/interactions.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace hawser::collide {

class Filter {
  public:
    void build(const std::vector<Shape>& shapes, int body_count,
               const model::Interactions& interactions);

    [[nodiscard]] bool may_touch(std::int32_t a, std::int32_t b) const noexcept {
        const Entry& p = entries_[static_cast<std::size_t>(a)];
        const Entry& q = entries_[static_cast<std::size_t>(b)];
        if ((p.group & q.touches) == 0 || (q.group & p.touches) == 0) return false;
        if (!p.is_moving && !q.is_moving) return false;
        for (const std::int32_t x : p.body)
            for (const std::int32_t y : q.body)
                if (x >= 0 && y >= 0 && (x == y || joined(x, y))) return false;
        return true;
    }
    /// True if one of two shapes is a segment that a body holds, and the other belongs to that
    /// body. The other shape may also belong to a body that a joint holds to it, or be a segment
    /// held by either.
    [[nodiscard]] bool share_host(std::int32_t a, std::int32_t b) const noexcept {
        const Entry& p = entries_[static_cast<std::size_t>(a)];
        const Entry& q = entries_[static_cast<std::size_t>(b)];
        const auto carrier = [](const Entry& e) {
            return e.host >= 0 ? e.host : e.is_segment ? -1 : e.body[0];
        };
        const std::int32_t x = carrier(p), y = carrier(q);
        return x >= 0 && y >= 0 && (p.host >= 0 || q.host >= 0) && (x == y || joined(x, y));
    }

  private:
    struct Entry {
        std::int32_t body[2];  ///< Bodies without the host.
        std::int32_t host;     ///< Body that holds the segment; −1: none.
        std::uint32_t group, touches;
        bool is_moving, is_segment;
    };
    [[nodiscard]] bool joined(std::int32_t x, std::int32_t y) const noexcept {
        const auto i = static_cast<std::size_t>(x), j = static_cast<std::size_t>(y);
        const bool shorter = begin_[i + 1] - begin_[i] <= begin_[j + 1] - begin_[j];
        const std::size_t of = shorter ? i : j;
        const auto* const first = joined_.data();
        return std::binary_search(first + begin_[of], first + begin_[of + 1], shorter ? y : x);
    }

    std::vector<Entry> entries_;
    std::vector<std::int32_t> begin_, joined_;  ///< Bodies joined to each body, ascending.
    std::vector<std::int32_t> cursor_;          ///< Scratch of build().
    /// Slides of guides, and the nodes whose segments end there. Scratch of build().
    std::vector<std::pair<std::int32_t, std::int32_t>> guide_neighbours_;
};

}  // namespace hawser::collide
