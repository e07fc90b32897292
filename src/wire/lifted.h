// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file lifted.h
/// The part of a wire between the level bottom and an end above it.

#include "wire/chain.h"

#include <cstddef>
#include <vector>

namespace hawser::wire {

/// The part of a wire between an end and the bottom. Elements and nodes are counted from that end.
class Lifted {
  public:
    /// Create the part of a chain that is lifted from the bottom.
    /// @param chain  Counted from this end; must outlive this object.
    /// @param height  Height of the end [m], ≥ 0.
    /// @param kept  Number of elements at the other end that cannot hang, because they rise from an
    ///        end below the bottom.
    Lifted(const Chain& chain, double height, std::size_t kept)
        : chain_(chain),
          max_lifted_(chain.elements() - kept),
          height_(height),
          rounding_(rounding(chain, height)) {
        drop();
        count_from_below();
    }

    /// State without horizontal pull: the hanging elements and the slack ones below.
    struct VerticalPart {
        std::size_t hanging = 0;
        double v = 0.0;           ///< Vertical pull at the end [N].
        double rise = 0.0;        ///< Height of the lowest hanging node over the bottom [m].
        std::size_t leaning = 0;  ///< Number of slack elements below that span `rise`.
        double slack = 0.0;       ///< Length of the slack elements [m].
        double lean = 0.0;        ///< Horizontal distance that they cover [m].
    };
    [[nodiscard]] const VerticalPart& dropped() const { return drop_; }
    /// Return the number of elements off the bottom, without horizontal pull.
    [[nodiscard]] std::size_t elements_off_bottom() const { return drop_.hanging + drop_.leaning; }

    /// Height and reach of the lifted part [m], their derivatives by (h, v) [m/N], and its number
    /// of elements.
    struct Sums {
        double z = 0.0, x = 0.0, x_h = 0.0, x_v = 0.0, z_v = 0.0;
        std::size_t count = 0;
    };
    /// Compute the sums over the elements of the lifted part.
    /// @param h  Horizontal pull [N].
    /// @param v  Vertical pull at the end, from base() [N].
    [[nodiscard]] Sums sum_elements(double h, double v) const;

    /// Find the vertical pull at the end for which the end has its height, starting from base()
    /// [N].
    double match_height(double h);

    /// Return the reference for vertical pulls at the end [N]. The values v in this class are
    /// differences from it.
    [[nodiscard]] double base() const { return base_; }
    /// Return the vertical pull of element e for a pull v of the end [N].
    [[nodiscard]] double pull_at(std::size_t e, double v) const { return v + pull_change_[e]; }
    /// Write the shape without horizontal pull: vertical elements under tension, and slack elements
    /// inclined by `lean`.
    void write_dropped(double lean, std::vector<Vec3>& chord, std::vector<double>& tension) const;
    /// Write the chords of the elements, downwards from the end, and their tensions. v is relative
    /// to base().
    void write(double h, double v, std::vector<Vec3>& chord, std::vector<double>& tension) const;

  private:
    void drop();

    /// Set base() to the vertical pull at the lowest hanging element. Near a fold the last digits
    /// of the pull are decisive, and the sum of all weights would lose them.
    void count_from_below();

    const Chain& chain_;
    std::size_t max_lifted_;
    double height_, rounding_;
    VerticalPart drop_;
    double base_ = 0.0;  ///< Vertical pull at the end from which others are counted [N].
    std::vector<double> pull_change_;  ///< Change of the pull from the end to each element [N].
    double v_ = 0.0;                   ///< Last pull found, from base_ [N].
};

}  // namespace hawser::wire
