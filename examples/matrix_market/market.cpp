// SPDX-License-Identifier: Apache-2.0
#include "matrix_market/market.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace market {
namespace {

constexpr int kMaxScalars = 6;  // of a node, hawser/factor.h

std::size_t at(std::int64_t i) { return static_cast<std::size_t>(i); }

[[noreturn]] void fail(std::int64_t line, const std::string& what) {
    throw std::runtime_error("line " + std::to_string(line) + ": " + what);
}

/// Return the rows with entries in each column of the full matrix, always with the diagonal.
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

}  // namespace

bool positive(const Sparse& lower, int i) { return lower.coeff(i, i) > 0.0; }

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
    // Columns of one group are adjacent: search only the groups of the neighbours of a column.
    std::vector<int> group(rows.size(), -1);
    std::vector<std::vector<int>> groups;
    for (int j = 0; j < static_cast<int>(rows.size()); ++j) {
        for (const int i : rows[at(j)]) {
            if (i >= j) break;
            const auto g = at(group[at(i)]);
            if (static_cast<int>(groups[g].size()) >= kMaxScalars || rows[at(i)] != rows[at(j)] ||
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

std::vector<std::vector<int>> read_block_sizes(const std::string& file, int scalars) {
    std::ifstream in(file);
    if (!in) throw std::runtime_error(file + ": cannot be read");
    std::vector<std::vector<int>> groups;
    int size = 0, next = 0;
    while (in >> size) {
        if (size < 1 || size > kMaxScalars)
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

Sparse read_lower(const std::string& file) {
    std::ifstream in(file);
    if (!in) throw std::runtime_error(file + ": cannot be read");
    try {
        return parse_matrix_market(in);
    } catch (const std::runtime_error& e) {
        throw std::runtime_error(file + ", " + e.what());
    }
}

std::vector<double> read_vector(const std::string& file, int scalars) {
    std::ifstream in(file);
    if (!in) throw std::runtime_error(file + ": cannot be read");
    std::vector<double> v;
    std::string line;
    bool header = false;  // "%%MatrixMarket matrix array real general": a line of sizes follows
    while (std::getline(in, line)) {
        if (line.rfind("%%", 0) == 0) header = true;
        if (line.empty() || line[0] == '%') continue;
        std::istringstream text(line);
        if (header) {
            int rows = 0, columns = 0;
            if (!(text >> rows >> columns) || columns != 1 || rows != scalars)
                throw std::runtime_error(file + ": expected " + std::to_string(scalars) +
                                         " rows and one column");
            header = false;
            continue;
        }
        for (double value = 0.0; text >> value;) v.push_back(value);
        if (!text.eof())
            throw std::runtime_error(std::string(file).append(": not a number: ").append(line));
    }
    if (static_cast<int>(v.size()) != scalars)
        throw std::runtime_error(file + ": has " + std::to_string(v.size()) +
                                 " numbers, the matrix has " + std::to_string(scalars) + " rows");
    return v;
}

}  // namespace market
