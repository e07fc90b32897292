// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file lifted.h
/// The part of a wire that an end above a level bottom lifts from it.

#include "wire/chain.h"

#include <cstddef>
#include <vector>

namespace hawser::wire {

/// The part of a wire between an end and the bottom. Elements and nodes are counted from that end.
class Lifted {
  public:
    /// Create the lifted part.
    /// @param chain  Counted from this end; must outlive this object.
    /// @param height  Height of the end [m], ≥ 0.
    /// @param kept  Elements at the other end that cannot hang: those that rise from under it.
    Lifted(const Chain& chain, double height, std::size_t kept)
        : chain_(chain),
          max_lifted_(chain.elements() - kept),
          height_(height),
          rounding_(rounding(chain, height)) {
        drop();
        count_from_below();
    }

    /// State without horizontal pull: the hanging elements and the slack ones below.
    struct Drop {
        std::size_t hanging = 0;
        double v = 0.0;           ///< Vertical pull at the end [N].
        double rise = 0.0;        ///< Height of the lowest hanging node over the bottom [m].
        std::size_t leaning = 0;  ///< Number of slack elements below that span `rise`.
        double slack = 0.0;       ///< Their length [m].
        double lean = 0.0;        ///< Their reach along the bottom [m].
    };
    [[nodiscard]] const Drop& dropped() const { return drop_; }
    /// Return the number of elements off the bottom, without horizontal pull.
    [[nodiscard]] std::size_t elements_off_bottom() const { return drop_.hanging + drop_.leaning; }

    /// Height and reach of the lifted part [m], their derivatives by (h, v) [m/N], and its number
    /// of elements.
    struct Sums {
        double z = 0.0, x = 0.0, x_h = 0.0, x_v = 0.0, z_v = 0.0;
        std::size_t count = 0;
    };
    /// Sum up the lifted part.
    /// @param h  Horizontal pull [N].
    /// @param v  Vertical pull at the end, from base() [N].
    [[nodiscard]] Sums sum_elements(double h, double v) const;

    /// Find the vertical pull at the end, from base(), that gives its height [N].
    double match_height(double h);

    /// Return the vertical pull at the end from which the others are counted [N].
    [[nodiscard]] double base() const { return base_; }
    /// Return the vertical pull of element e for a pull v of the end [N].
    [[nodiscard]] double pull_at(std::size_t e, double v) const { return v + fall_[e]; }
    /// Write the shape without horizontal pull: hanging elements, and slack ones that lean by
    /// `lean`.
    void write_dropped(double lean, std::vector<Vec3>& chord, std::vector<double>& tension) const;
    /// Write chords of its elements, downwards from the end, and tensions; v from base().
    void write(double h, double v, std::vector<Vec3>& chord, std::vector<double>& tension) const;

  private:
    void drop();

    /// Count pulls from the lowest hanging element. Near a fold their last digits decide, and the
    /// sum of all weights loses digits.
    void count_from_below();

    const Chain& chain_;
    std::size_t max_lifted_;
    double height_, rounding_;
    Drop drop_;
    double base_ = 0.0;         ///< Vertical pull at the end from which others are counted [N].
    std::vector<double> fall_;  ///< Change of the pull from the end to each element [N].
    double v_ = 0.0;            ///< Last pull found, from base_ [N].
};

}  // namespace hawser::wire
