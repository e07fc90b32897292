// SPDX-License-Identifier: Apache-2.0
/// Shapes that the broad phase compares with all others.
#include "collide/broad.h"
#include "model/interactions.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hawser::test {
namespace {

using collide::Placed;

/// Make a shape of a size along x [m]. A negative size: a shape that was removed and has no box.
Placed placed(double x, double size) {
    Placed p{};
    for (int k = 0; k < 3; ++k) {
        const double centre = k == 0 ? x : 0.0, half = 0.5 * (k == 0 ? size : 0.1);
        p.centre[k] = centre;
        p.box.low[k] = p.swept.low[k] = centre - half;
        p.box.high[k] = p.swept.high[k] = centre + half;
    }
    if (size >= 0.0) return p;
    p = {};
    for (int k = 0; k < 3; ++k) {
        p.swept.low[k] = 4e30;
        p.swept.high[k] = -4e30;
    }
    return p;
}

/// Executor that counts its tasks.
class Counting final : public base::Executor {
  public:
    void run(int count, Task task, void* context) noexcept override {
        given += count;
        for (int i = 0; i < count; ++i) task(context, i, 0);
    }
    [[nodiscard]] int threads() const noexcept override { return 1; }
    int given = 0;
};

struct Swept {
    int tasks;  ///< Tasks of the sweep alone.
    std::vector<collide::Pair> pairs;
};

Swept swept(const base::Array<Placed>& placed) {
    constexpr int kHeldByOneTask = 256;  // compared with large shapes: kLargeChunk of broad.cpp
    std::vector<collide::Shape> shapes(placed.size());
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        shapes[i].body[0] = static_cast<std::int32_t>(i);
        shapes[i].body[1] = shapes[i].held = shapes[i].line = -1;
        shapes[i].group = shapes[i].touches = 1;
        shapes[i].moves = true;
    }
    collide::Filter filter;
    filter.build(shapes, static_cast<int>(shapes.size()), model::Interactions{});
    collide::Broad broad;
    broad.prepare(placed);
    Counting pool;
    base::Array<collide::Pair> out;
    broad.find(placed, filter, 0.01, 0.1, 1 << 20, pool, out);
    return {pool.given - base::chunks(placed.size(), kHeldByOneTask), {out.begin(), out.end()}};
}

/// A wire that has lost most of its nodes, under a hull: the sweep does the work of a wire that
/// never had them. A fault counted slots of removed shapes as shapes of size 0. All remaining
/// elements then were large and compared with all others.
TEST(Broad, ShapesThatAreGoneMakeNoneLarge) {
    base::Array<Placed> all, left;
    std::vector<std::int32_t> number;  // index in `all` of each shape in `left`
    const auto add = [&](double x, double size) {
        if (size >= 0.0) {
            number.push_back(static_cast<std::int32_t>(all.size()));
            left.push_back(placed(x, size));
        }
        all.push_back(placed(x, size));
    };
    for (int i = 0; i < 1800; ++i) add(1.6 * i, i % 3 == 0 ? 5.0 : -1.0);
    add(500.0, 80.0);
    const Swept with = swept(all), without = swept(left);
    // 600 elements in tasks of 128; more if an element is in two strips.
    EXPECT_GE(without.tasks, 5);
    EXPECT_EQ(with.tasks, without.tasks);
    std::vector<collide::Pair> expected;
    for (std::size_t a = 0; a < left.size(); ++a)
        for (std::size_t b = a + 1; b < left.size(); ++b)
            if (left[a].swept.low[0] <= left[b].swept.high[0] &&
                left[b].swept.low[0] <= left[a].swept.high[0])
                expected.push_back({number[a], number[b]});
    EXPECT_EQ(with.pairs, expected);
}

}  // namespace
}  // namespace hawser::test
