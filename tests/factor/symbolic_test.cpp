// SPDX-License-Identifier: Apache-2.0
/// Invariants of every symbolic factorisation, on random graphs.
#include "factor/matrices.h"
#include "support/sanitizer.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <rapidcheck.h>
// rapidcheck first
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

namespace hawser::test {
namespace {

using factor::Front;
using factor::Symbolic;

struct Case {
    factor::Pattern pattern;
    Symbolic symbolic;
};

/// Draw a random graph: islands, trees, dense cores and everything between.
Case draw(std::uint64_t seed) {
    Random random(seed);
    const int nodes = random.integer(0, 90);
    const double density = random.chance(0.3) ? random.uniform(0.0, 0.4) : 1.5 / (nodes + 1);
    const bool tree = random.chance(0.5);
    std::vector<std::int8_t> size, sign;
    std::vector<std::int32_t> from, to;
    for (int i = 0; i < nodes; ++i) {
        size.push_back(static_cast<std::int8_t>(random.integer(1, 6)));
        sign.push_back(random.chance(0.6) ? 1 : -1);
        if (tree && i > 0 && random.chance(0.97)) {
            from.push_back(i);
            to.push_back(random.integer(random.chance(0.5) ? 0 : std::max(0, i - 3), i - 1));
        }
        for (int j = 0; j < i; ++j)
            if (random.chance(density)) {
                from.push_back(j);
                to.push_back(i);
                if (random.chance(0.2)) {  // duplicates and loops are allowed
                    from.push_back(i);
                    to.push_back(random.chance(0.5) ? j : i);
                }
            }
    }
    Case c;
    c.pattern = factor::make_pattern(size, sign, from, to);
    std::vector<std::int32_t> order = factor::order_nodes(c.pattern);
    if (random.chance(0.3)) random.shuffle(order);
    c.symbolic = factor::analyse(c.pattern, order);
    return c;
}

void check_pattern(const factor::Pattern& p) {
    for (int a = 0; a < p.nodes(); ++a) {
        const auto n = p.neighbours(a);
        RC_ASSERT(std::is_sorted(n.begin(), n.end()));
        RC_ASSERT(std::adjacent_find(n.begin(), n.end()) == n.end());
        for (std::int32_t b : n) {
            const auto back = p.neighbours(b);
            RC_ASSERT(b != a);
            RC_ASSERT(std::binary_search(back.begin(), back.end(), a));
        }
    }
}

void check_order(const Case& c) {
    const Symbolic& s = c.symbolic;
    std::vector<std::int32_t> sorted = s.order;
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t i = 0; i < sorted.size(); ++i)
        RC_ASSERT(sorted[i] == static_cast<std::int32_t>(i));
    RC_ASSERT(sorted.size() == c.pattern.size.size());
    std::int32_t at = 0;
    for (std::size_t k = 0; k < s.order.size(); ++k) {
        const auto node = static_cast<std::size_t>(s.order[k]);
        RC_ASSERT(s.position[node] == static_cast<std::int32_t>(k));
        RC_ASSERT(s.node_offset[node] == at);
        at += c.pattern.size[node];
    }
    RC_ASSERT(s.scalars == at);
}

/// Check that fronts are in postorder, and pivots and rows contiguous and ascending.
void check_fronts(const Case& c) {
    const Symbolic& s = c.symbolic;
    std::int32_t offset = 0, node = 0;
    std::vector<std::int32_t> first(s.fronts.size());  // first front of the subtree
    for (std::size_t f = 0; f < s.fronts.size(); ++f) {
        const Front& front = s.fronts[f];
        RC_ASSERT(front.offset == offset);
        RC_ASSERT(front.node_begin == node);
        RC_ASSERT(front.p > 0);
        RC_ASSERT(front.ld % 8 == 0 && front.ld >= front.p + front.q);
        RC_ASSERT(front.ldu % 8 == 0 && front.ldu >= front.q);
        RC_ASSERT(front.parent == -1 || front.parent > static_cast<std::int32_t>(f));
        RC_ASSERT((front.parent == -1) == (front.q == 0));
        offset += front.p;
        node = front.node_end;
        // Postorder: the children's subtrees fill the range just before the front.
        std::int32_t next = static_cast<std::int32_t>(f);
        for (std::int32_t k = front.child_end; k-- > front.child_begin;) {
            const std::int32_t child = s.children[static_cast<std::size_t>(k)];
            RC_ASSERT(s.fronts[static_cast<std::size_t>(child)].parent ==
                      static_cast<std::int32_t>(f));
            RC_ASSERT(child == next - 1);
            next = first[static_cast<std::size_t>(child)];
        }
        first[f] = next;
        const auto rows = s.rows.begin() + front.rows;
        RC_ASSERT(std::is_sorted(rows, rows + front.q));
        if (front.q > 0) RC_ASSERT(*rows >= front.offset + front.p);
    }
    RC_ASSERT(offset == s.scalars);
    RC_ASSERT(node == static_cast<std::int32_t>(s.order.size()));
}

/// Check that runs cover the update rows once, in order, with the right rows of the parent.
void check_runs(const Case& c) {
    const Symbolic& s = c.symbolic;
    for (const Front& front : s.fronts) {
        std::int32_t from = 0;
        if (front.parent < 0) RC_ASSERT(front.run_begin == front.run_end);
        for (std::int32_t k = front.run_begin; k < front.run_end; ++k) {
            const factor::Run& run = s.runs[static_cast<std::size_t>(k)];
            const Front& parent = s.fronts[static_cast<std::size_t>(front.parent)];
            RC_ASSERT(run.from == from && run.length > 0);
            RC_ASSERT(run.to + run.length <= parent.p || run.to >= parent.p);
            for (std::int32_t i = 0; i < run.length; ++i) {
                const std::int32_t local = run.to + i;
                RC_ASSERT(local < parent.p + parent.q);
                const std::int32_t scalar =
                    local < parent.p
                        ? parent.offset + local
                        : s.rows[static_cast<std::size_t>(parent.rows + local - parent.p)];
                RC_ASSERT(scalar == s.rows[static_cast<std::size_t>(front.rows + from + i)]);
            }
            from += run.length;
        }
        if (front.parent >= 0) RC_ASSERT(from == front.q);
    }
}

/// Check that blocks of the pattern are inside the panel of their column's front, without overlap.
void check_targets(const Case& c) {
    const Symbolic& s = c.symbolic;
    std::set<std::int64_t> used;
    std::vector<std::int64_t> panel_of_address;
    auto check = [&](std::int32_t row, std::int32_t column) {
        const factor::BlockTarget t = s.target(row, column);
        const Front& front =
            s.fronts[static_cast<std::size_t>(s.node_front[static_cast<std::size_t>(column)])];
        const int rows = c.pattern.size[static_cast<std::size_t>(row)];
        const int cols = c.pattern.size[static_cast<std::size_t>(column)];
        RC_ASSERT(t.ld == front.ld);
        for (int j = 0; j < cols; ++j)
            for (int i = 0; i < rows; ++i) {
                const std::int64_t at = t.address + static_cast<std::int64_t>(j) * t.ld + i;
                const std::int64_t local = at - front.panel;
                RC_ASSERT(local >= 0 && local < static_cast<std::int64_t>(front.ld) * front.p);
                const std::int64_t r = local % front.ld, k = local / front.ld;
                RC_ASSERT(r < front.p + front.q);
                const std::int64_t scalar =
                    r < front.p ? front.offset + r
                                : s.rows[static_cast<std::size_t>(front.rows + r - front.p)];
                RC_ASSERT(scalar == s.node_offset[static_cast<std::size_t>(row)] + i);
                RC_ASSERT(front.offset + k == s.node_offset[static_cast<std::size_t>(column)] + j);
                RC_ASSERT(used.insert(at).second);
            }
    };
    for (int a = 0; a < c.pattern.nodes(); ++a) {
        check(a, a);
        for (std::int32_t b : c.pattern.neighbours(a))
            if (s.position[static_cast<std::size_t>(b)] < s.position[static_cast<std::size_t>(a)])
                check(a, b);
    }
}

/// Check that each front is in exactly one task. A subtree needs data only from batches of other
/// tasks. A node of the graph has edges to all nodes that use its updates, and these have larger
/// numbers.
std::vector<int> check_tasks(const Symbolic& s) {
    std::vector<int> owner(s.fronts.size(), -1);  // node of the graph
    auto own = [&](std::int32_t f, std::size_t node) {
        RC_ASSERT(owner[static_cast<std::size_t>(f)] == -1);
        owner[static_cast<std::size_t>(f)] = static_cast<int>(node);
    };
    const std::size_t batches = s.batches.size(), below = batches + s.tasks.size();
    for (std::size_t t = 0; t < s.tasks.size(); ++t)
        for (std::int32_t f = s.tasks[t].begin; f < s.tasks[t].end; ++f) own(f, batches + t);
    std::int32_t end = 0;
    for (std::size_t t = 0; t < s.top_tasks.size(); ++t) {
        RC_ASSERT(s.top_tasks[t].begin == end);
        end = s.top_tasks[t].end;
        for (std::int32_t k = s.top_tasks[t].begin; k < end; ++k) {
            const std::int32_t f = s.top[static_cast<std::size_t>(k)];
            if (k > s.top_tasks[t].begin) RC_ASSERT(s.top[static_cast<std::size_t>(k) - 1] < f);
            own(f, below + t);
        }
    }
    RC_ASSERT(end == static_cast<std::int32_t>(s.top.size()));
    RC_ASSERT(static_cast<std::size_t>(s.graph.nodes()) == below + s.top_tasks.size());
    for (std::size_t f = 0; f < s.fronts.size(); ++f) {
        const Front& front = s.fronts[f];
        RC_ASSERT(owner[f] != -1);
        if (front.batch >= 0) owner[f] = front.batch;
    }
    for (std::size_t f = 0; f < s.fronts.size(); ++f) {
        const std::int32_t up = s.fronts[f].parent;
        if (up < 0) continue;
        const int from = owner[f], to = owner[static_cast<std::size_t>(up)];
        if (from == to) continue;
        RC_ASSERT(from < to);
        RC_ASSERT(static_cast<std::size_t>(to) >= below || s.fronts[f].batch >= 0);
        const auto n = static_cast<std::size_t>(from), m = static_cast<std::size_t>(to);
        const auto first = s.graph.upward.next.begin();
        RC_ASSERT(std::find(first + s.graph.upward.start[n], first + s.graph.upward.start[n + 1],
                            to) != first + s.graph.upward.start[n + 1]);
        const auto last = s.graph.downward.next.begin();
        RC_ASSERT(std::find(last + s.graph.downward.start[m], last + s.graph.downward.start[m + 1],
                            from) != last + s.graph.downward.start[m + 1]);
    }
    return owner;
}

/// Check that the memory of an update matrix is not shared from the factorisation of its front
/// until that of its parent. Tasks run in any order and simultaneously.
void check_updates(const Symbolic& s, const std::vector<int>& owner) {
    struct Life {
        std::int64_t from, to;  // addresses
        int task;
        bool stays;               // true if the parent, in the same task, uses it
        std::int32_t born, dies;  // fronts: written while factoring `born`, last read while
                                  // factoring `dies`
    };
    std::vector<Life> all;
    for (std::size_t f = 0; f < s.fronts.size(); ++f) {
        const Front& front = s.fronts[f];
        const std::int64_t size = static_cast<std::int64_t>(front.ldu) * front.q;
        RC_ASSERT(front.update >= 0 && front.update + size <= s.work_size);
        const auto id = static_cast<std::int32_t>(f);
        const bool stays =
            front.parent < 0 || owner[static_cast<std::size_t>(front.parent)] == owner[f];
        RC_ASSERT(size == 0 || stays == (front.update >= s.stack_begin));
        all.push_back({front.update, front.update + size, owner[f], stays, id,
                       front.parent < 0 ? id : front.parent});
    }
    for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const Life &a = all[i], &b = all[j];
            if (a.from >= b.to || b.from >= a.to) continue;  // different memory
            // Two tasks can run simultaneously, but not in one thread, and each thread has its own
            // stacks. An update used by another task stays valid.
            RC_ASSERT(a.stays && b.stays);
            if (a.task != b.task) continue;
            RC_ASSERT(a.born > b.dies || b.born > a.dies);
        }
}

/// Check that non-zeros of a dense factor are inside the fronts.
void check_fill(const Case& c) {
    const std::size_t n = c.pattern.size.size();
    std::vector<std::set<int>> below(n);
    const Symbolic& s = c.symbolic;
    for (std::size_t k = 0; k < n; ++k) {
        for (std::int32_t u : c.pattern.neighbours(s.order[k])) {
            const std::int32_t p = s.position[static_cast<std::size_t>(u)];
            if (p > static_cast<std::int32_t>(k)) below[k].insert(p);
        }
    }
    for (std::size_t k = 0; k < n; ++k) {
        for (int r : below[k]) {
            // target() finds the row by bisection; the address shows whether the row exists.
            const std::int32_t row = s.order[static_cast<std::size_t>(r)], column = s.order[k];
            const factor::BlockTarget t = s.target(row, column);
            const Front& front =
                s.fronts[static_cast<std::size_t>(s.node_front[static_cast<std::size_t>(column)])];
            const std::int64_t local = (t.address - front.panel) % front.ld;
            const std::int32_t scalar =
                local < front.p ? front.offset + static_cast<std::int32_t>(local)
                                : s.rows[static_cast<std::size_t>(front.rows + local - front.p)];
            RC_ASSERT(scalar == s.node_offset[static_cast<std::size_t>(row)]);
        }
        if (below[k].empty()) continue;
        const int parent = *below[k].begin();
        for (int r : below[k])
            if (r != parent) below[static_cast<std::size_t>(parent)].insert(r);
    }
}

RC_GTEST_PROP(Symbolic, InvariantsOnRandomGraphs, ()) {
    const auto seed = *rc::gen::arbitrary<std::uint32_t>();
    const Case c = draw(seed);
    check_pattern(c.pattern);
    check_order(c);
    check_fronts(c);
    check_runs(c);
    check_targets(c);
    check_fill(c);
    check_updates(c.symbolic, check_tasks(c.symbolic));
}

/// Larger, for many tasks and several top tasks.
TEST(Symbolic, InvariantsOnLargeForests) {
    for (const std::uint32_t seed : seeds(1, kSanitized ? 1 : 2, kSanitized ? 1 : 8, 80)) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const int nodes = 1200;
        std::vector<std::int8_t> size, sign(static_cast<std::size_t>(nodes), 1);
        std::vector<std::int32_t> from, to;
        for (int i = 0; i < nodes; ++i) {
            size.push_back(6);
            if (i > 0 && i % 400 != 0) {
                from.push_back(i);
                to.push_back(std::max(i - random.integer(1, 12), i / 400 * 400));
                if (random.chance(0.2)) {
                    from.push_back(i);
                    to.push_back(std::max(i - random.integer(1, 40), i / 400 * 400));
                }
            }
        }
        Case c;
        c.pattern = factor::make_pattern(size, sign, from, to);
        c.symbolic = factor::analyse(c.pattern, factor::order_nodes(c.pattern));
        EXPECT_GT(c.symbolic.tasks.size(), 5U);
        EXPECT_GT(c.symbolic.top_tasks.size(), 1U);
        bool checked = false;  // rapidcheck calls it a hundred times, but nothing random is drawn
                               // here
        ASSERT_TRUE(rc::check("large forest", [&] {
            if (checked) return;
            checked = true;
            check_fronts(c);
            check_runs(c);
            check_fill(c);
            check_updates(c.symbolic, check_tasks(c.symbolic));
        }));
    }
}

}  // namespace
}  // namespace hawser::test
