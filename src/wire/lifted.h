// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file lifted.h
/// The part of a wire that is lifted from a level bottom by an end over it.

#include "wire/chain.h"

#include <cstddef>
#include <vector>

namespace hawser::wire {

/// The part of a wire between an end and the bottom, elements and nodes counted from that end.
class Lifted {
  public:
    /// @param chain  Seen from this end; it has to stay. @param height  Of the end [m], 0 or more.
    /// @param kept  Elements at the other end that cannot hang: those that rise from under it.
    Lifted(const Chain& chain, double height, std::size_t kept)
        : chain_(chain),
          most_(chain.elements() - kept),
          height_(height),
          small_(rounding(chain, height)) {
        drop();
        count_from_below();
    }

    /// Without horizontal pull: how many elements hang, and what the one below spans.
    struct Drop {
        std::size_t hanging = 0;
        double v = 0.0;           ///< Vertical pull at the end [N].
        double rise = 0.0;        ///< Height of the lowest hanging node over the bottom [m].
        std::size_t leaning = 0;  ///< So many elements below are slack and span `rise`.
        double slack = 0.0;       ///< Their length [m].
        double lean = 0.0;        ///< How far they reach along the bottom [m].
    };
    [[nodiscard]] const Drop& dropped() const { return drop_; }
    /// Elements that do not lie, without horizontal pull.
    [[nodiscard]] std::size_t off_bottom() const { return drop_.hanging + drop_.leaning; }

    /// Height and reach of the lifted part [m], their derivatives by (h, v) [m/N], its elements.
    struct Sums {
        double z = 0.0, x = 0.0, x_h = 0.0, x_v = 0.0, z_v = 0.0;
        std::size_t count = 0;
    };
    /// @param h  Horizontal pull [N]. @param v  Vertical pull at the end, from base() [N].
    [[nodiscard]] Sums add_up(double h, double v) const;

    /// Vertical pull at the end, from base(), for which its height is right [N].
    double match_height(double h);

    /// Vertical pull at the end from which the others are counted [N].
    [[nodiscard]] double base() const { return base_; }
    /// Vertical pull of element e when that of the end is v [N].
    [[nodiscard]] double pull_at(std::size_t e, double v) const { return v + fall_[e]; }
    /// Without horizontal pull: what hangs, and what leans by `lean`.
    void write_dropped(double lean, std::vector<Vec3>& chord, std::vector<double>& tension) const;
    /// Chords of its elements as seen from the end, downwards, and tensions; v from base().
    void write(double h, double v, std::vector<Vec3>& chord, std::vector<double>& tension) const;

  private:
    void drop();

    /// Pulls are told from that of the lowest element that hangs: near a fold their last digits
    /// decide, and the sum of all weights has fewer of them.
    void count_from_below();

    const Chain& chain_;
    std::size_t most_;
    double height_, small_;
    Drop drop_;
    double base_ = 0.0;         ///< Vertical pulls are counted from this one at the end [N].
    std::vector<double> fall_;  ///< From there to the elements [N].
    double v_ = 0.0;            ///< Last pull found, from base_.
};

}  // namespace hawser::wire
