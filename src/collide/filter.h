// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file filter.h
/// Which shapes may touch at all.
///
/// Never: two shapes of one body (a segment is of both its lumps); shapes without freedom; shapes
/// of bodies that a segment or one of the joints ball, hinge, prismatic, cylindrical, universal,
/// lock holds together, which overlap as drawn. Along a wire that leaves out neighbours and their
/// neighbours. Lines, distances and springs exclude nothing: two ships joined by a tow line touch.

#include "collide/placing.h"
#include "model/interactions.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace hawser::collide {

class Filter {
  public:
    void build(const std::vector<Shape>& shapes, int body_count,
               const model::Interactions& interactions);

    [[nodiscard]] bool allows(std::int32_t a, std::int32_t b) const noexcept {
        const Entry& p = entries_[static_cast<std::size_t>(a)];
        const Entry& q = entries_[static_cast<std::size_t>(b)];
        if ((p.group & q.touches) == 0 || (q.group & p.touches) == 0) return false;
        if (!p.moves && !q.moves) return false;
        for (const std::int32_t x : p.body)
            for (const std::int32_t y : q.body)
                if (x >= 0 && y >= 0 && (x == y || joined(x, y))) return false;
        return true;
    }

  private:
    struct Entry {
        std::int32_t body[2];
        std::uint32_t group, touches;
        bool moves;
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
};

}  // namespace hawser::collide
