// SPDX-License-Identifier: Apache-2.0
// Every node runs once, after all nodes that it depends on, on any executor. Priorities are
// computed by hand.
#include "factor/task_graph.h"

#include "runtime/tasks.h"

#include <gtest/gtest.h>

#include <atomic>
#include <utility>
#include <vector>

namespace hawser::test {
namespace {

using factor::TaskGraph;
using factor::TaskPass;
using factor::TaskQueue;

using Edges = std::vector<std::pair<std::int32_t, std::int32_t>>;

TaskGraph graph_of(std::vector<std::int64_t> work, Edges edges) {
    TaskGraph graph;
    graph.work = std::move(work);
    graph.build(edges);
    return graph;
}

/// Make a tree with edges from node i to i / 3 steps up, and some additional edges.
TaskGraph large() {
    constexpr std::int32_t kNodes = 400;
    Edges edges;
    std::vector<std::int64_t> work;
    for (std::int32_t i = 0; i < kNodes; ++i) {
        work.push_back(1 + i * 7 % 13);
        if (i + 1 < kNodes) edges.emplace_back(i, i + 1 + (kNodes - i - 2) / 2);
        if (i % 5 == 0 && i + 1 < kNodes) edges.emplace_back(i, kNodes - 1);
    }
    return graph_of(std::move(work), edges);
}

/// Run the graph, and expect that nodes start and end in a valid sequence.
void expect_in_order(const TaskGraph& graph, bool up, base::Executor& executor, int repeat) {
    TaskQueue queue;
    queue.reserve(graph, executor.threads());
    const auto n = static_cast<std::size_t>(graph.nodes());
    for (int k = 0; k < repeat; ++k) {
        std::atomic<int> clock{0};
        std::vector<int> begun(n, -1), ended(n, -1);
        auto node = [&](int i, int) noexcept {
            const auto v = static_cast<std::size_t>(i);
            begun[v] = clock.fetch_add(1);
            ended[v] = clock.fetch_add(1);
        };
        queue.run(graph, up ? TaskPass::factor : TaskPass::backward, executor, node);
        const TaskGraph::Way& way = up ? graph.upward : graph.downward;
        for (std::size_t v = 0; v < n; ++v) {
            ASSERT_GE(begun[v], 0) << "node " << v << " was left out";
            for (std::int32_t e = way.start[v]; e < way.start[v + 1]; ++e)
                ASSERT_LT(ended[v],
                          begun[static_cast<std::size_t>(way.next[static_cast<std::size_t>(e)])]);
        }
        ASSERT_EQ(clock.load(), 2 * graph.nodes()) << "a node ran twice";
    }
}

TEST(TaskGraph, KeepsTheOrderForAnyNumberOfThreads) {
    const TaskGraph graph = large();
    for (const int threads : {1, 2, 3, 8}) {
        runtime::Pool pool(threads);
        pool.resume();
        for (const bool up : {true, false}) expect_in_order(graph, up, pool, 20);
        pool.pause();
        expect_in_order(graph, true, pool, 1);  // with sleeping workers the caller does everything
    }
}

TEST(TaskGraph, TakesNoNodesAndNoEdges) {
    runtime::Pool pool(2);
    pool.resume();
    expect_in_order(graph_of({}, {}), true, pool, 1);
    expect_in_order(graph_of({1, 1, 1}, {}), false, pool, 1);
}

/// Executor of two alternating threads, the second one first.
class Turns final : public base::Executor {
  public:
    void run(int count, Task task, void* context) noexcept override {
        for (int i = 0; i < count; ++i) task(context, i, 1 - i % 2);
    }
    [[nodiscard]] int threads() const noexcept override { return 2; }
};

/// Executor that reports several threads and uses only the first.
class First final : public base::Executor {
  public:
    explicit First(int threads) : threads_(threads) {}
    void run(int count, Task task, void* context) noexcept override {
        for (int i = 0; i < count; ++i) task(context, i, 0);
    }
    [[nodiscard]] int threads() const noexcept override { return threads_; }

  private:
    int threads_;
};

TEST(TaskGraph, GivesAThreadWhatItFactoredLast) {
    const TaskGraph graph = graph_of({6, 5, 4, 3, 2, 1}, {});
    Turns executor;
    TaskQueue queue;
    queue.reserve(graph, executor.threads());
    std::vector<int> first(6, -1), again(6, -1);
    const auto run = [&](base::Executor& team, TaskPass pass, std::vector<int>& by) {
        auto node = [&](int v, int thread) noexcept { by[static_cast<std::size_t>(v)] = thread; };
        queue.run(graph, pass, team, node);
    };
    run(executor, TaskPass::factor, first);
    EXPECT_EQ(first, (std::vector<int>{0, 1, 0, 1, 0, 1})) << "dealt out in turns at first";
    run(executor, TaskPass::factor, again);
    EXPECT_EQ(again, first);  // by urgency alone the second thread would get node 0
    // In a substitution the first thread does everything, and owns no more tasks than before.
    First alone(2);
    run(alone, TaskPass::forward, again);
    EXPECT_EQ(again, std::vector<int>(6, 0));
    run(executor, TaskPass::backward, again);
    EXPECT_EQ(again, first);
    run(alone, TaskPass::factor, again);
    run(executor, TaskPass::backward, again);
    EXPECT_NE(again, first);
}

TEST(TaskGraph, KeepsToTheRoomThatWasReserved) {
    const TaskGraph graph = large();
    First executor(64);
    TaskQueue queue;
    queue.reserve(graph, 2);
    int nodes = 0;
    auto node = [&](int, int thread) noexcept { nodes += thread == 0 ? 1 : 0; };
    queue.run(graph, TaskPass::factor, executor, node);
    EXPECT_EQ(nodes, graph.nodes());
}

TEST(TaskGraph, RanksByTheWorkThatIsLeft) {
    // 0 (5) ─┐        Time left going up: 0: 5 + 2 + 1 = 8, 1: 3 + 2 + 1 = 6, 2: 9 + 1 = 10.
    // 1 (3) ─┴ 3 (2) ─┐
    // 2 (9) ──────────┴ 4 (1)
    const TaskGraph graph =
        graph_of({5, 3, 9, 2, 1}, {{0, 3}, {1, 3}, {3, 4}, {2, 4}, {0, 3}});  // one edge twice
    EXPECT_EQ(graph.upward.by_rank, (std::vector<std::int32_t>{2, 0, 1, 3, 4}));
    EXPECT_EQ(graph.upward.waits, (std::vector<std::int32_t>{0, 0, 0, 2, 2}));
    EXPECT_EQ(graph.downward.by_rank, (std::vector<std::int32_t>{4, 2, 3, 0, 1}));
    EXPECT_EQ(graph.downward.waits, (std::vector<std::int32_t>{1, 1, 1, 1, 0}));
    EXPECT_EQ(graph.path, 10);
}

}  // namespace
}  // namespace hawser::test
