// SPDX-License-Identifier: Apache-2.0
/// After any edits, a repaired analysis equals the analysis of the new pattern in the same order.
#include "factor/repair.h"
#include "factor/edited_graph.h"
#include "factor/matrices.h"
#include "factor/partial.h"
#include "runtime/tasks.h"
#include "support/sanitizer.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace hawser::test {
namespace {

using factor::Analysis;
using factor::Pattern;
using factor::Symbolic;

/// Expect that rows come after one of their bodies, which stability requires.
void expect_rows_behind_bodies(const Pattern& p, const Symbolic& s) {
    for (int v = 0; v < p.nodes(); ++v) {
        if (p.sign[static_cast<std::size_t>(v)] > 0) continue;
        bool any = false, before = false;
        for (const std::int32_t u : p.neighbours(v)) {
            if (p.sign[static_cast<std::size_t>(u)] < 0) continue;
            any = true;
            before |=
                s.position[static_cast<std::size_t>(u)] < s.position[static_cast<std::size_t>(v)];
        }
        EXPECT_TRUE(before || !any) << "rows " << v;
    }
}

/// Expect that bodies with unchanged neighbours keep their relative order.
void expect_order_kept(const Pattern& last, const Symbolic& before, const Pattern& next,
                       const Symbolic& s, const std::vector<std::int32_t>& old_of_new) {
    std::vector<bool> same(old_of_new.size());
    for (int v = 0; v < next.nodes(); ++v) {
        std::vector<std::int32_t> now;
        for (const std::int32_t u : next.neighbours(v))
            now.push_back(old_of_new[static_cast<std::size_t>(u)]);
        std::sort(now.begin(), now.end());
        const std::int32_t old = old_of_new[static_cast<std::size_t>(v)];
        if (old < 0) continue;
        const auto then = last.neighbours(old);
        same[static_cast<std::size_t>(v)] =
            std::equal(now.begin(), now.end(), then.begin(), then.end());
    }
    for (int v = 0; v < next.nodes(); ++v) {
        const std::int32_t old_v = old_of_new[static_cast<std::size_t>(v)];
        if (!same[static_cast<std::size_t>(v)] || next.sign[static_cast<std::size_t>(v)] < 0)
            continue;
        for (const std::int32_t u : next.neighbours(v)) {
            const std::int32_t old_u = old_of_new[static_cast<std::size_t>(u)];
            if (!same[static_cast<std::size_t>(u)] || next.sign[static_cast<std::size_t>(u)] < 0)
                continue;
            // Only nodes in an ancestor relation: unrelated fronts may be exchanged.
            const auto front = before.node_front[static_cast<std::size_t>(old_u)];
            bool above = false;
            for (std::int32_t f = before.node_front[static_cast<std::size_t>(old_v)]; f >= 0;
                 f = before.fronts[static_cast<std::size_t>(f)].parent)
                above |= f == front;
            if (!above) continue;
            EXPECT_EQ(
                before.position[static_cast<std::size_t>(old_u)] <
                    before.position[static_cast<std::size_t>(old_v)],
                s.position[static_cast<std::size_t>(u)] < s.position[static_cast<std::size_t>(v)]);
        }
    }
}

/// Factor values for a pattern; small couplings keep it quasi-definite. Return the backward error.
double backward_error_of(const Pattern& p, const Symbolic& s, Random& random) {
    BlockMatrix m;
    m.pattern = p;
    m.offset.push_back(0);
    for (const std::int8_t size : p.size) m.offset.push_back(m.offset.back() + size);
    m.dense = Matrix::Zero(m.scalars(), m.scalars());
    for (int a = 0; a < p.nodes(); ++a) {
        const auto i = static_cast<std::size_t>(a);
        m.block(a, a) = definite(random, p.size[i], 1.0, p.sign[i]);
        for (const std::int32_t b : p.neighbours(a)) {
            if (b > a) continue;
            const auto j = static_cast<std::size_t>(b);
            const double scale = p.sign[i] == p.sign[j] ? 0.9 / (6.0 * p.nodes()) : 1.0;
            set_symmetric(m, a, b, scale * random_matrix(random, p.size[i], p.size[j]));
        }
    }
    const Vector b = random_matrix(random, m.scalars(), 1);
    base::SerialExecutor serial;
    const Solved solved = solve(m, s, b, serial);
    EXPECT_EQ(solved.wrong, 0);
    return backward_error(m, solved.x, b);
}

struct Totals {
    int chains = 0, dissolved = 0, kept = 0, unchanged_columns = 0, columns = 0;
};

/// Check a sequence of edits. @param team  Executor of the repairs, not of the reference.
void check_sequence(const Pattern& first, Random& random, int steps, base::Executor* team,
                    Totals& totals) {
    const bool numbers_stay = random.chance(0.3), keep = random.chance(0.3);
    EditedGraph graph(first);
    Analysis analysis;
    analysis.separate_updates(keep);
    analysis.use(team);
    analysis.plan(first);
    Pattern last = first;
    std::vector<std::int32_t> old_of_new;
    for (int step = 0; step < steps; ++step) {
        edit(graph, random, numbers_stay);
        const Pattern next = graph.pattern(old_of_new);
        const int chains = analysis.elimination().chains.count();
        const Symbolic before = analysis.symbolic();
        const factor::RepairReport r = analysis.repair(
            next, numbers_stay ? std::span<const std::int32_t>{} : std::span(old_of_new));
        totals.chains += chains;
        totals.dissolved += r.dissolved;
        totals.kept += analysis.elimination().chains.count();
        totals.columns += next.nodes();
        totals.unchanged_columns += next.nodes() - r.columns;
        EXPECT_EQ(analysis.elimination().chains.count(), chains - r.dissolved);
        Symbolic fresh = factor::analyse(next, analysis.elimination());
        if (keep) factor::separate_updates(fresh);
        ASSERT_TRUE(fresh == analysis.symbolic()) << "step " << step;
        expect_rows_behind_bodies(next, analysis.symbolic());
        // A node that changed its size is a new node.
        for (std::size_t v = 0; v < old_of_new.size(); ++v) {
            const std::int32_t old = old_of_new[v];
            if (old >= 0 && last.size[static_cast<std::size_t>(old)] != next.size[v])
                old_of_new[v] = -1;
        }
        expect_order_kept(last, before, next, analysis.symbolic(), old_of_new);
        last = next;
        if (step % 4 == 0) {
            // Growth below 1e4 times 2⁻⁵³, like in chains_test.cpp.
            EXPECT_LT(backward_error_of(next, analysis.symbolic(), random), 1e-12);
        }
    }
}

TEST(Repair, EqualsAnAnalysisOfTheNewPattern) {
    const auto all = seeds(1, kSanitized ? 12 : 40, kSanitized ? 20 : 150, 1500);
    Totals totals;
    runtime::Pool pool(3);
    pool.resume();
    for (const std::uint32_t seed : all) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const Pattern first = seed % 2 == 0 ? wires(random, 10, 30).pattern
                                            : random_quasi_definite(random, random.integer(0, 60),
                                                                    random.uniform(0.0, 0.1))
                                                  .pattern;
        check_sequence(first, random, 12, seed % 4 < 2 ? nullptr : &pool, totals);
        if (HasFailure()) return;
    }
    if (all.size() == 1) return;
    // All cases occur: chains that remain and chains that do not, columns that are kept.
    EXPECT_GT(totals.kept, totals.chains / 10);
    EXPECT_GT(totals.dissolved, 0);
    EXPECT_GT(totals.unchanged_columns, totals.columns / 2);
}

TEST(Repair, GoesOnAlikeFromItsState) {
    auto all = seeds(1, kSanitized ? 4 : 10, kSanitized ? 6 : 30, 300);
    // Their chains have rows of three bodies, without which two units would not be joined.
    if (all.size() > 1) all.insert(all.end(), {452772533, 26108896});
    for (const std::uint32_t seed : all) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const Pattern first = wires(random, 10, 30).pattern;
        EditedGraph graph(first);
        Analysis one;
        one.plan(first);
        std::vector<std::int32_t> old_of_new;
        Pattern now;
        for (int round = 0; round < 3; ++round) {
            for (int i = 0; i < 4; ++i) {
                edit(graph, random, false);
                now = graph.pattern(old_of_new);
                one.update(now, old_of_new);
            }
            Analysis other;
            ASSERT_TRUE(other.resume(now, one.state()));
            for (int i = 0; i < 4; ++i) {
                edit(graph, random, false);
                now = graph.pattern(old_of_new);
                const bool replanned = one.update(now, old_of_new).replanned;
                ASSERT_EQ(other.update(now, old_of_new).replanned, replanned);
                ASSERT_TRUE(other.symbolic() == one.symbolic()) << round << ", " << i;
                ASSERT_TRUE(other.state() == one.state());
            }
        }
    }
}

/// An accepted state is an order of elimination.
TEST(Repair, RefusesAStateThatDoesNotFit) {
    Random random(first_seed(3));
    const int trials = by_tier(kSanitized ? 60 : 120, kSanitized ? 60 : 400, 4000);
    Pattern p;
    Analysis planned, other;
    do {
        p = wires(random, 10, 30).pattern;
        planned.plan(p);
    } while (planned.elimination().chains.count() == 0);
    int refused = 0;
    for (int trial = 0; trial < trials; ++trial) {
        factor::AnalysisState state = planned.state();
        auto& chains = state.elimination.chains;
        auto& array = trial % 4 == 0   ? state.elimination.order
                      : trial % 4 == 1 ? chains.nodes
                      : trial % 4 == 2 ? chains.unit_begin
                                       : chains.begin;
        auto at_random = [&, last = static_cast<int>(array.size()) - 1] {
            return static_cast<std::size_t>(random.integer(0, last));
        };
        if (random.chance(0.5))
            std::swap(array[at_random()], array[at_random()]);
        else
            array[at_random()] += random.integer(-3, 3);
        if (other.resume(p, state)) {
            EXPECT_TRUE(other.symbolic() == factor::analyse(p, other.elimination()));
            // A random order is stable enough for this tolerance; a wrong address is not.
            EXPECT_LT(backward_error_of(p, other.symbolic(), random), 1e-10);
            continue;
        }
        ++refused;
        EXPECT_TRUE(other.symbolic() == planned.symbolic());
    }
    EXPECT_GT(refused, trials / 20);
    EXPECT_FALSE(other.resume(wires(random, 5, 20).pattern, planned.state()));
}

TEST(Repair, OfNothingChangesNothing) {
    Random random(7);
    const Pattern p = wires(random, 10, 30).pattern;
    Analysis analysis;
    analysis.plan(p);
    const Symbolic before = analysis.symbolic();
    const factor::RepairReport r = analysis.repair(p);
    EXPECT_EQ(r.columns, 0);
    EXPECT_EQ(r.placed, 0);
    EXPECT_EQ(r.same, static_cast<int>(before.fronts.size()));
    EXPECT_TRUE(analysis.symbolic() == before);
}

/// An edge inside existing structure changes one column.
TEST(Repair, StopsWhereNothingChanges) {
    // A cycle 0 1 … n−1: eliminating in order fills (k + 1, n − 1).
    constexpr int kNodes = 50;
    std::vector<std::int8_t> size(kNodes, 3), sign(kNodes, 1);
    std::vector<std::int32_t> from, to, order;
    for (int i = 0; i < kNodes; ++i) {
        from.push_back(i);
        to.push_back((i + 1) % kNodes);
        order.push_back(i);
    }
    Analysis analysis;
    analysis.plan(factor::make_pattern(size, sign, from, to), {order, {}});
    from.push_back(20);
    to.push_back(kNodes - 1);
    // Both ends get a new neighbour, but neither column changes.
    const factor::RepairReport r = analysis.repair(factor::make_pattern(size, sign, from, to));
    EXPECT_EQ(r.columns, 2);
}

/// update() makes a new order if the old one has become expensive, and not before.
TEST(Repair, ReplansWhenFlopsGrow) {
    int replans = 0;
    const auto all = seeds(11, 4, 16, 160);
    for (const std::uint32_t seed : all) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const Pattern first = random_quasi_definite(random, 120, 0.01).pattern;
        EditedGraph graph(first);
        Analysis analysis;
        analysis.plan(first);
        std::vector<std::int32_t> old_of_new;
        for (int step = 0; step < 200; ++step) {
            graph.add_edge(random);
            graph.remove_edge(random);
            const auto planned = static_cast<double>(analysis.planned_flops());
            const factor::RepairReport r = analysis.update(graph.pattern(old_of_new), old_of_new);
            const auto flops = static_cast<double>(analysis.symbolic().flops);
            EXPECT_EQ(analysis.planned_flops(), r.replanned ? flops : planned);
            EXPECT_LE(flops, factor::kReplanGrowth * (r.replanned ? flops : planned));
            EXPECT_TRUE(!r.replanned || r.columns == analysis.pattern().nodes());
            replans += r.replanned ? 1 : 0;
        }
    }
    if (all.size() > 1) {
        EXPECT_GT(replans, 0);
    }
    EXPECT_LT(replans, 150 * static_cast<int>(all.size()));
}

/// For this number of changed nodes a plan is faster than a repair.
TEST(Repair, PlansAtOnceWhereMuchChanges) {
    int at_once = 0, repaired = 0;
    for (const std::uint32_t seed : seeds(5, 1, 4, 40)) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const Pattern first = wires(random, 20, 30).pattern;
        const int most = static_cast<int>(factor::kMaxEditedFraction * first.nodes());
        for (int edges = 1; edges < 3 * most; edges += 5) {
            EditedGraph graph(first);
            for (int k = 0; k < edges; ++k) graph.add_edge(random);
            std::vector<std::int32_t> old_of_new;
            const Pattern next = graph.pattern(old_of_new);
            int changed = 0;
            for (int v = 0; v < next.nodes(); ++v) {
                const auto now = next.neighbours(v), then = first.neighbours(v);
                changed += std::equal(now.begin(), now.end(), then.begin(), then.end()) ? 0 : 1;
            }
            Analysis analysis, planned;
            analysis.plan(first);
            const factor::RepairReport r = analysis.update(next);
            if (changed <= most) {
                ++repaired;
                continue;
            }
            ++at_once;
            EXPECT_TRUE(r.replanned);
            EXPECT_EQ(r.placed, 0);
            planned.plan(next);
            EXPECT_TRUE(analysis.symbolic() == planned.symbolic());
            EXPECT_TRUE(analysis.state() == planned.state());
            // The new plan can be repaired.
            analysis.repair(first);
            EXPECT_TRUE(analysis.symbolic() == factor::analyse(first, analysis.elimination()));
        }
    }
    EXPECT_GT(at_once, 0);
    EXPECT_GT(repaired, 0);
}

}  // namespace
}  // namespace hawser::test
