// SPDX-License-Identifier: Apache-2.0
//
// Solve K x = b with hawser/factor.h. K is a symmetric quasi-definite matrix in a Matrix Market
// file.
//
//   matrix_market K.mtx [--blocks SIZES] [--rhs B] [--threads N] [--solution X]
//
#include "matrix_market/market.h"

#include <hawser/factor.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iomanip>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using Clock = std::chrono::steady_clock;

struct Options {
    std::string matrix, blocks, rhs, solution;
    int threads = 1;
};

Options parse(int argc, char** argv) {
    Options o;
    for (int i = 1; i < argc; ++i) {
        const std::string name = argv[i];
        auto value = [&]() -> std::string {
            if (++i == argc) throw std::runtime_error(name + " needs a value");
            return argv[i];
        };
        if (name == "--blocks")
            o.blocks = value();
        else if (name == "--rhs")
            o.rhs = value();
        else if (name == "--solution")
            o.solution = value();
        else if (name == "--threads")
            o.threads = std::clamp(std::atoi(value().c_str()), 1, 64);
        else if (name[0] == '-' || !o.matrix.empty())
            throw std::runtime_error("unknown argument " + name);
        else
            o.matrix = name;
    }
    if (o.matrix.empty())
        throw std::runtime_error(
            "usage: matrix_market K.mtx [--blocks SIZES] [--rhs B] [--threads N] "
            "[--solution X]");
    return o;
}

/// Blocks of the scalars of the file, and the mapping between both.
struct Blocks {
    hawser::BlockPattern pattern;
    std::vector<std::vector<int>> groups;               ///< Scalars of each node.
    std::vector<int> node, place;                       ///< Node of each scalar; its index there.
    std::map<std::pair<int, int>, std::int32_t> block;  ///< Block of a pair of nodes, row ≥ column.
};

Blocks make_blocks(const market::Sparse& lower, std::vector<std::vector<int>> groups) {
    Blocks b;
    b.groups = std::move(groups);
    const auto n = static_cast<std::size_t>(lower.rows());
    b.node.resize(n);
    b.place.resize(n);
    for (std::size_t g = 0; g < b.groups.size(); ++g) {
        const bool positive = market::positive(lower, b.groups[g].front());
        b.pattern.size.push_back(static_cast<std::int8_t>(b.groups[g].size()));
        b.pattern.sign.push_back(positive ? 1 : -1);
        for (std::size_t i = 0; i < b.groups[g].size(); ++i) {
            const int scalar = b.groups[g][i];
            if (market::positive(lower, scalar) != positive)
                throw std::runtime_error("block " + std::to_string(g + 1) +
                                         " has diagonal entries of both signs");
            b.node[static_cast<std::size_t>(scalar)] = static_cast<int>(g);
            b.place[static_cast<std::size_t>(scalar)] = static_cast<int>(i);
        }
    }
    for (int j = 0; j < lower.outerSize(); ++j)
        for (market::Sparse::InnerIterator it(lower, j); it; ++it) {
            const int r = b.node[static_cast<std::size_t>(it.row())];
            const int c = b.node[static_cast<std::size_t>(j)];
            const std::pair<int, int> pair(std::max(r, c), std::min(r, c));
            if (r == c || b.block.count(pair) != 0) continue;
            b.block[pair] = static_cast<std::int32_t>(b.groups.size() + b.pattern.edges.size());
            b.pattern.edges.push_back({pair.first, pair.second});
        }
    return b;
}

std::vector<double> values_of(const market::Sparse& lower, const Blocks& b,
                              const hawser::BlockFactor& factor) {
    std::vector<double> values(static_cast<std::size_t>(factor.value_count()), 0.0);
    auto put = [&](int row, int column, double v) {
        int r = b.node[static_cast<std::size_t>(row)];
        int c = b.node[static_cast<std::size_t>(column)];
        if (r < c) {
            std::swap(r, c);
            std::swap(row, column);
        }
        const std::int32_t block = r == c ? r : b.block.at({r, c});
        const auto width = static_cast<std::int64_t>(b.groups[static_cast<std::size_t>(c)].size());
        values[static_cast<std::size_t>(factor.value_begin(block) +
                                        b.place[static_cast<std::size_t>(row)] * width +
                                        b.place[static_cast<std::size_t>(column)])] = v;
    };
    for (int j = 0; j < lower.outerSize(); ++j)
        for (market::Sparse::InnerIterator it(lower, j); it; ++it) {
            put(static_cast<int>(it.row()), j, it.value());
            if (b.node[static_cast<std::size_t>(it.row())] == b.node[static_cast<std::size_t>(j)])
                put(j, static_cast<int>(it.row()), it.value());
        }
    return values;
}

/// Reorder a vector from the scalars of the file to those of the nodes, or back.
std::vector<double> reorder(const Blocks& b, const hawser::BlockFactor& factor,
                            const std::vector<double>& from, bool back) {
    std::vector<double> to(from.size());
    for (std::size_t i = 0; i < from.size(); ++i) {
        const auto k = static_cast<std::size_t>(factor.scalar_begin(b.node[i]) + b.place[i]);
        (back ? to[i] : to[k]) = back ? from[k] : from[i];
    }
    return to;
}

double milliseconds(Clock::time_point from) {
    return std::chrono::duration<double, std::milli>(Clock::now() - from).count();
}

int run(const Options& o) {
    const market::Sparse lower = market::read_lower(o.matrix);
    const int n = static_cast<int>(lower.rows());
    const Blocks blocks =
        make_blocks(lower, o.blocks.empty() ? market::indistinguishable_columns(lower)
                                            : market::read_block_sizes(o.blocks, n));
    hawser::BlockFactor factor({.threads = o.threads});
    Clock::time_point start = Clock::now();
    factor.analyse(blocks.pattern);
    const double analyse = milliseconds(start);
    const std::vector<double> k = values_of(lower, blocks, factor);
    std::vector<double> b = o.rhs.empty() ? std::vector<double>(static_cast<std::size_t>(n), 1.0)
                                          : market::read_vector(o.rhs, n);
    b = reorder(blocks, factor, b, false);
    // Measure the second call: the first one touches memory for the first time.
    hawser::Status status = factor.factor(k);
    start = Clock::now();
    status = factor.factor(k);
    const double refactor = milliseconds(start);
    const hawser::FactorInfo info = factor.info();
    std::printf("scalars %lld, blocks %lld, fronts %lld\n", static_cast<long long>(info.scalars),
                static_cast<long long>(info.nodes), static_cast<long long>(info.fronts));
    std::printf("nnz of the lower triangle %lld, of L %lld; %.3f Mflop; %.2f MB\n",
                static_cast<long long>(lower.nonZeros()), static_cast<long long>(info.factor_nnz),
                1e-6 * static_cast<double>(info.flops), 1e-6 * static_cast<double>(info.bytes));
    if (status != hawser::Status::ok) {
        std::printf("%lld pivots of the wrong sign: the matrix is not quasi-definite\n",
                    static_cast<long long>(info.wrong_pivots));
        return 2;
    }
    std::vector<double> x = b;
    start = Clock::now();
    status = factor.solve(x);
    const double solve = milliseconds(start);
    const double first = factor.residual(k, x, b);
    if (status == hawser::Status::ok) status = factor.refine(k, b, x);
    std::printf("analyse %.3f ms, factor %.3f ms, solve %.3f ms, %d thread(s)\n", analyse, refactor,
                solve, o.threads);
    std::printf("residual %.2e, after one refinement %.2e\n", first, factor.residual(k, x, b));
    if (!o.solution.empty()) {
        std::ofstream out(o.solution);
        out << std::setprecision(17);
        for (const double v : reorder(blocks, factor, x, true)) out << v << '\n';
        if (!out) throw std::runtime_error(o.solution + ": cannot be written");
    }
    return status == hawser::Status::ok ? 0 : 3;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(parse(argc, argv));
    } catch (const std::exception& e) {
        std::fprintf(stderr, "%s\n", e.what());
        return 1;
    }
}
