// SPDX-License-Identifier: Apache-2.0
#include "paper_matrix/matrix_market.h"

#include "index.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

namespace hawser::bench {
namespace {

[[noreturn]] void fail(std::int64_t line, const std::string& what) {
    throw std::runtime_error("line " + std::to_string(line) + ": " + what);
}

/// Rows with entries in each column of the full matrix, the diagonal always among them.
std::vector<std::vector<int>> structure(const Sparse& lower) {
    std::vector<std::vector<int>> rows(at(lower.cols()));
    for (int j = 0; j < lower.outerSize(); ++j) {
        rows[at(j)].push_back(j);
        for (Sparse::InnerIterator it(lower, j); it; ++it) {
            if (it.row() == j) continue;
            rows[at(j)].push_back(static_cast<int>(it.row()));
            rows[at(it.row())].push_back(j);
        }
    }
    for (auto& r : rows) std::sort(r.begin(), r.end());
    return rows;
}

bool positive(const Sparse& lower, int i) { return lower.coeff(i, i) > 0.0; }

std::vector<std::vector<int>> read_groups(const std::string& file, int scalars) {
    std::ifstream in(file);
    if (!in) throw std::runtime_error(file + ": cannot be read");
    std::vector<std::vector<int>> groups;
    int size = 0, next = 0;
    while (in >> size) {
        if (size < 1 || size > factor::kMaxBlock)
            throw std::runtime_error(file + ": block sizes are 1 to 6, not " +
                                     std::to_string(size));
        groups.emplace_back();
        for (int i = 0; i < size; ++i) groups.back().push_back(next++);
    }
    if (!in.eof() || next != scalars)
        throw std::runtime_error(file + ": the sizes add up to " + std::to_string(next) +
                                 ", the matrix has " + std::to_string(scalars) + " rows");
    return groups;
}

}  // namespace

Sparse parse_matrix_market(std::istream& in) {
    std::string text;
    std::int64_t line = 1;
    std::getline(in, text);
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    std::istringstream header(text);
    std::string banner, object, format, field, symmetry;
    header >> banner >> object >> format >> field >> symmetry;
    if (banner != "%%matrixmarket" || object != "matrix") fail(line, "not a Matrix Market matrix");
    if (format != "coordinate" || (field != "real" && field != "integer"))
        fail(line, "the matrix must be 'coordinate real' or 'coordinate integer'");
    if (symmetry != "symmetric") fail(line, "the matrix must be 'symmetric'");
    auto next_line = [&] {
        while (std::getline(in, text)) {
            ++line;
            if (!text.empty() && text[0] != '%' &&
                text.find_first_not_of(" \t\r") != std::string::npos)
                return;
        }
        fail(line, "the file ends too early");
    };
    next_line();
    std::int64_t rows = 0, columns = 0, entries = 0;
    if (!(std::istringstream(text) >> rows >> columns >> entries) || rows != columns || rows < 1 ||
        rows > 100'000'000 || entries < 0)
        fail(line, "expected rows, equal columns, entries");
    std::vector<Eigen::Triplet<double>> triplets;
    for (std::int64_t k = 0; k < entries; ++k) {
        next_line();
        std::int64_t i = 0, j = 0;
        double v = 0.0;
        if (!(std::istringstream(text) >> i >> j >> v) || i < 1 || j < 1 || i > rows || j > rows)
            fail(line, "expected row, column, value within the matrix");
        triplets.emplace_back(static_cast<int>(std::max(i, j)) - 1,
                              static_cast<int>(std::min(i, j)) - 1, v);
    }
    Sparse m(static_cast<int>(rows), static_cast<int>(rows));
    m.setFromTriplets(triplets.begin(), triplets.end());
    return m;
}

std::vector<std::vector<int>> indistinguishable_columns(const Sparse& lower) {
    const auto rows = structure(lower);
    // Columns of one group are neighbours: look for the group among those that a column meets.
    std::vector<int> group(rows.size(), -1);
    std::vector<std::vector<int>> groups;
    for (int j = 0; j < static_cast<int>(rows.size()); ++j) {
        for (const int i : rows[at(j)]) {
            if (i >= j) break;
            const auto g = at(group[at(i)]);
            if (groups[g].size() >= factor::kMaxBlock || rows[at(i)] != rows[at(j)] ||
                positive(lower, i) != positive(lower, j))
                continue;
            group[at(j)] = static_cast<int>(g);
            groups[g].push_back(j);
            break;
        }
        if (group[at(j)] >= 0) continue;
        group[at(j)] = static_cast<int>(groups.size());
        groups.push_back({j});
    }
    return groups;
}

BlockSystem group_blocks(const Sparse& lower, const std::vector<std::vector<int>>& groups) {
    SystemBuilder builder;
    const auto n = at(lower.rows());
    std::vector<int> node(n), place(n);
    std::vector<const std::vector<int>*> members;
    for (const bool sign : {true, false})
        for (const std::vector<int>& g : groups) {
            if (positive(lower, g.front()) != sign) continue;
            for (const int i : g)
                if (positive(lower, i) != sign)
                    throw std::runtime_error("a block has diagonal entries of both signs");
            std::vector<double> block(g.size() * g.size());
            for (std::size_t i = 0; i < g.size(); ++i)
                for (std::size_t j = 0; j < g.size(); ++j)
                    block[i * g.size() + j] =
                        lower.coeff(std::max(g[i], g[j]), std::min(g[i], g[j]));
            const int a = builder.add_node(static_cast<int>(g.size()), sign ? 1 : -1, block);
            for (std::size_t i = 0; i < g.size(); ++i) {
                node[at(g[i])] = a;
                place[at(g[i])] = static_cast<int>(i);
            }
            members.push_back(&g);
        }
    std::map<std::pair<int, int>, std::vector<double>> blocks;  // (high, low), by rows
    for (int j = 0; j < lower.outerSize(); ++j)
        for (Sparse::InnerIterator it(lower, j); it; ++it) {
            auto row = at(it.row()), column = at(j);
            if (node[row] == node[column]) continue;
            if (node[row] < node[column]) std::swap(row, column);
            const std::size_t width = members[at(node[column])]->size();
            auto& block = blocks[{node[row], node[column]}];
            block.resize(members[at(node[row])]->size() * width, 0.0);
            block[at(place[row]) * width + at(place[column])] = it.value();
        }
    for (const auto& [pair, block] : blocks) builder.add_block(pair.first, pair.second, block);
    return builder.finish("file", 31);
}

BlockSystem read_matrix_market(const std::string& file, const std::string& blocks) {
    std::ifstream in(file);
    if (!in) throw std::runtime_error(file + ": cannot be read");
    Sparse lower;
    try {
        lower = parse_matrix_market(in);
    } catch (const std::runtime_error& e) {
        throw std::runtime_error(file + ", " + e.what());
    }
    return group_blocks(lower, blocks.empty()
                                   ? indistinguishable_columns(lower)
                                   : read_groups(blocks, static_cast<int>(lower.rows())));
}

}  // namespace hawser::bench
