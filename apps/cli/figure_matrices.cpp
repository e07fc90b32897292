// SPDX-License-Identifier: Apache-2.0
#include "figure_matrices.h"

#include "draw/figures/index.h"

#include <algorithm>
#include <ctime>
#include <memory>
#include <numeric>
#include <stdexcept>

namespace hawser::cli {
using draw::at;

namespace {

double thread_seconds() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// Return random values, diagonally dominant with the right signs, so that all pivots are
/// acceptable.
std::vector<double> draw_values(const BlockPattern& p, const BlockFactor& f) {
    std::vector<double> values(at(f.value_count()));
    std::uint64_t state = 0x9E3779B97F4A7C15ull;
    for (double& v : values) {  // Marsaglia, "Xorshift RNGs", 2003
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        v = 2.0 * static_cast<double>(state >> 11) * 0x1p-53 - 1.0;
    }
    std::vector<double> sum(p.size.size(), 0.0);
    for (const BlockEdge& e : p.edges) {
        sum[at(e.row)] += p.size[at(e.column)];
        sum[at(e.column)] += p.size[at(e.row)];
    }
    for (std::size_t v = 0; v < p.size.size(); ++v)
        for (std::int64_t i = 0; i < p.size[v]; ++i)
            values[at(f.value_begin(static_cast<std::int32_t>(v)) + i * p.size[v] + i)] =
                p.sign[v] * (sum[v] + p.size[v] + 1.0);
    return values;
}

struct Job {
    std::unique_ptr<BlockFactor> factor = std::make_unique<BlockFactor>();
    std::vector<double> values, seconds;
    double spent = 0.0;  ///< Time used [s]
    double* median = nullptr;
    int* samples = nullptr;
};

// Time for samples of one matrix [s]: in natural order some factorisations need seconds.
constexpr double kMaxSampleSeconds = 0.5;

}  // namespace

double OrderedMatrix::seconds() const {
    return std::accumulate(part_seconds.begin(), part_seconds.end(), 0.0);
}

double OrderedMatrix::longest_seconds() const {
    return part_seconds.empty() ? 0.0 : *std::max_element(part_seconds.begin(), part_seconds.end());
}

OrderedMatrix order_matrix(const draw::BlockGraph& graph, std::int32_t parts, Ordering ordering) {
    OrderedMatrix m;
    m.ordering = ordering;
    m.graph = &graph;
    if (ordering == Ordering::metis && !metis_available()) {
        m.missing = "built without METIS: install libmetis-dev and build again";
        return m;
    }
    if (parts == 0)
        m.order = elimination_order(pattern_of(graph), ordering);
    else
        for (std::int32_t p = 0; p < parts; ++p) {
            const draw::BlockGraph piece = draw::part_graph(graph, p);
            for (const std::int32_t node : elimination_order(pattern_of(piece), ordering))
                m.order.push_back(piece.origin[at(node)]);
        }
    m.factor = draw::factor_blocks(graph.start, graph.adjacent, m.order);
    m.counts = count(graph, m.order, m.factor);
    m.part_seconds.assign(at(std::max(1, parts)), 0.0);
    return m;
}

void time_matrices(const std::vector<OrderedMatrix*>& matrices, int samples, double max_flops) {
    std::vector<Job> jobs;
    for (OrderedMatrix* m : matrices) {
        if (!m->missing.empty() || static_cast<double>(m->counts.flops) > max_flops) continue;
        m->samples = samples;
        for (std::size_t p = 0; p < m->part_seconds.size(); ++p) {
            const bool whole = m->part_seconds.size() == 1;
            const draw::BlockGraph piece =
                whole ? *m->graph : draw::part_graph(*m->graph, static_cast<std::int32_t>(p));
            std::vector<std::int32_t> place(at(m->graph->nodes()), -1), order;
            for (std::size_t k = 0; k < piece.origin.size(); ++k)
                place[whole ? k : at(piece.origin[k])] = static_cast<std::int32_t>(k);
            for (const std::int32_t node : m->order)
                if (place[at(node)] >= 0) order.push_back(place[at(node)]);
            const BlockPattern pattern = pattern_of(piece);
            Job job;
            job.factor->analyse(pattern, order);
            job.values = draw_values(pattern, *job.factor);
            job.median = &m->part_seconds[p];
            job.samples = &m->samples;
            const FactorInfo info = job.factor->info();
            m->solver_nnz += info.factor_nnz;
            m->solver_matrix_nnz += info.matrix_nnz;
            m->solver_flops += info.flops;
            jobs.push_back(std::move(job));
        }
    }
    for (int turn = 0; turn < samples; ++turn)
        for (Job& job : jobs) {
            if (job.spent > kMaxSampleSeconds) continue;
            const double begin = thread_seconds();
            if (job.factor->factor(job.values) != Status::ok)
                throw std::runtime_error("a factorisation for the figures failed");
            job.seconds.push_back(thread_seconds() - begin);
            job.spent += job.seconds.back();
        }
    for (Job& job : jobs) {
        const auto middle =
            job.seconds.begin() + static_cast<std::ptrdiff_t>(job.seconds.size() / 2);
        std::nth_element(job.seconds.begin(), middle, job.seconds.end());
        *job.median = *middle;
        *job.samples = std::min(*job.samples, static_cast<int>(job.seconds.size()));
    }
}

}  // namespace hawser::cli
