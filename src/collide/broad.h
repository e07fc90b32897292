// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file broad.h
/// Broad phase: pairs of shapes whose swept boxes meet.
///
/// Sort and sweep along one axis, by insertion into the order of the last step, in strips along a
/// second axis: of a wide field of shapes only those of one strip are held against each other. A
/// shape is in every strip that its box meets; a pair counts in the first strip that both are in.
/// Shapes much larger than the others (seabed, decks, hulls) are kept out of it, since each would
/// span the sweep, and are held against all shapes instead. What was sorted when, how wide strips
/// are, and which shapes count as large, changes the time that this takes and nothing else: pairs
/// are handed out in ascending order.

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
    /// All pairs that the filter allows, ascending. @param most  More are refused as soon as they
    /// are counted. @throws std::bad_alloc, LimitError.
    void find(const base::Array<Placed>& placed, const Filter& filter, double h, double margin,
              std::int64_t most, base::Executor& pool, base::Array<Pair>& out);
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    struct Sorted {
        double low[3], high[3];  ///< The axis of the sweep comes first, that of the strips second.
        std::int32_t shape;
        std::int32_t first,
            strip;  ///< First strip of the shape, and the one that this entry is in.
    };
    void sort(const base::Array<Placed>& placed);
    void cut_into_strips();
    struct Count;
    void sweep(int chunk, const Filter& filter, Count& count);
    void hold_against_large(int chunk, const base::Array<Placed>& placed, const Filter& filter,
                            double h, double margin, Count& count);
    void gather(int lists, base::Array<Pair>& out);

    std::vector<double> extents_, by_size_;  ///< Scratch of prepare().
    std::vector<std::uint8_t> is_large_;
    std::vector<std::int32_t> large_, small_;  ///< Shapes; large ones ascending.
    int axis_[3] = {0, 1, 2};                  ///< Of the sweep, of the strips, the third.
    double width_ = 1.0;                       ///< Of a strip, at least [m].
    base::Array<Sorted> sorted_;               ///< Small shapes along the first axis.
    base::Array<Sorted> entries_;  ///< Small shapes strip by strip, once for each that they reach.
    std::vector<std::int32_t> strip_begin_;  ///< In entries_.
    std::vector<base::Array<Pair>> found_;   ///< By task.
    std::vector<std::int32_t> first_;        ///< Where the pairs of each shape begin.
};

}  // namespace hawser::collide
