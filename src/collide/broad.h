// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file broad.h
/// Broad phase: pairs of shapes whose swept boxes intersect.
///
/// Sort and sweep along one axis, by insertion into the order of the last step. Strips along a
/// second axis limit the sweep: in a wide field only shapes of one strip are compared. A shape is
/// in every strip that its box intersects. A pair counts in the first strip that contains both.
///
/// Shapes much larger than the others (seabed, decks, hulls) would span the sweep. They are
/// excluded from it and compared with all shapes instead. Sorting history, width of strips and
/// choice of large shapes change only the computing time: pairs are output in ascending order.

#include "base/executor.h"
#include "base/memory.h"
#include "collide/filter.h"
#include "collide/placing.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hawser::collide {

struct Pair {
    std::int32_t a, b;  ///< Shapes, a < b.
    friend auto operator<=>(const Pair&, const Pair&) = default;
};

class Broad {
  public:
    /// Choose the large shapes by their boxes. @throws std::bad_alloc.
    void prepare(const base::Array<Placed>& placed);
    /// Find all pairs that the filter allows, ascending. @param most  Maximum number of pairs; the
    /// search stops if it is exceeded. @throws std::bad_alloc, LimitError.
    void find(const base::Array<Placed>& placed, const Filter& filter, double h, double margin,
              std::int64_t most, base::Executor& pool, base::Array<Pair>& out);
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    struct Sorted {
        /// Bounds; the axis of the sweep comes first, the axis of the strips second.
        double low[3], high[3];
        std::int32_t shape;
        std::int32_t first,
            strip;  ///< First strip of the shape, and the strip of this entry.
    };
    void sort(const base::Array<Placed>& placed);
    void cut_into_strips();
    struct Count;
    void find_pairs_in_strip(int chunk, const Filter& filter, Count& count);
    void test_against_large(int chunk, const base::Array<Placed>& placed, const Filter& filter,
                            double h, double margin, Count& count);
    void gather(int lists, base::Array<Pair>& out);

    std::vector<double> extents_, by_size_;  ///< Scratch of prepare().
    std::vector<std::uint8_t> is_large_;
    std::vector<std::int32_t> large_, small_;  ///< Shapes; large ones ascending.
    int axis_[3] = {0, 1, 2};     ///< Axes of the sweep and of the strips, and the third one.
    double width_ = 1.0;          ///< Minimum width of a strip [m].
    base::Array<Sorted> sorted_;  ///< Small shapes along the first axis.
    /// Small shapes by strip, one entry for each strip that they reach.
    base::Array<Sorted> entries_;
    std::vector<std::int32_t> strip_begin_;  ///< First entry of each strip.
    std::vector<base::Array<Pair>> found_;   ///< Pairs found by each task.
    std::vector<std::int32_t> first_;        ///< First pair of each shape.
};

}  // namespace hawser::collide
