// SPDX-License-Identifier: Apache-2.0
#include "linear/form.h"

#include "index.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <tuple>

namespace hawser::bench {
namespace {

/// A pair of kept nodes, row ≥ column, and a contribution to its block: a block, or an eliminated
/// node.
struct Piece {
    std::int32_t row, col;
    std::int32_t base;  ///< −1: a contribution.
    Contribution part;
    std::int32_t rows;  ///< 0: a block.
};

/// Sort by (column, row, rows of the contribution), the base of a block before its contributions:
/// stable counting sorts.
void sort_pieces(std::vector<Piece>& pieces, int nodes) {
    std::vector<Piece> other(pieces.size());
    auto pass = [&](auto key) {
        std::vector<std::int64_t> start(at(std::max(nodes, kMaxRows + 1)) + 1, 0);
        for (const Piece& p : pieces) ++start[at(key(p)) + 1];
        std::partial_sum(start.begin(), start.end(), start.begin());
        for (const Piece& p : pieces) other[at(start[at(key(p))]++)] = p;
        pieces.swap(other);
    };
    pass([](const Piece& p) { return p.rows; });
    pass([](const Piece& p) { return p.row; });
    pass([](const Piece& p) { return p.col; });
}

/// Add the contribution of the eliminated node e to the block of its i-th and j-th neighbour.
void add_pair(const BlockSystem& s, const BlockForm& f, int e, int i, int j,
              std::vector<Piece>& pieces) {
    const std::int32_t a = s.pattern.adjacent[at(i)], b = s.pattern.adjacent[at(j)];
    for (int r = 0; r < s.size(e); r += kMaxRows)
        pieces.push_back({f.index[at(a)],
                          f.index[at(b)],
                          -1,
                          {{static_cast<std::int32_t>(s.edge[at(i)]) + r * s.size(a),
                            static_cast<std::int32_t>(s.edge[at(j)]) + r * s.size(b)},
                           s.offset[at(e)] + r},
                          std::min(kMaxRows, s.size(e) - r)});
}

std::vector<Piece> list_pieces(const BlockSystem& s, const BlockForm& f) {
    std::vector<Piece> pieces;
    for (const std::int32_t a : f.kept) {
        const std::int32_t row = f.index[at(a)];
        pieces.push_back({row, row, static_cast<std::int32_t>(s.diagonal[at(a)]), {}, 0});
        for (int k = s.pattern.start[at(a)]; k < s.pattern.start[at(a) + 1]; ++k) {
            const std::int32_t b = s.pattern.adjacent[at(k)];
            if (b < a && f.index[at(b)] >= 0)
                pieces.push_back(
                    {row, f.index[at(b)], static_cast<std::int32_t>(s.edge[at(k)]), {}, 0});
        }
    }
    for (int e = 0; e < s.pattern.nodes(); ++e) {
        if (f.index[at(e)] >= 0) continue;
        for (int i = s.pattern.start[at(e)]; i < s.pattern.start[at(e) + 1]; ++i)
            for (int j = s.pattern.start[at(e)]; j <= i; ++j) add_pair(s, f, e, i, j, pieces);
    }
    return pieces;
}

}  // namespace

bool can_be_eliminated(const BlockSystem& s, int node) {
    if (s.positive(node)) return false;
    for (const std::int32_t b : s.pattern.neighbours(node))
        if (!s.positive(b) || b > node) return false;
    const int n = s.size(node);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const double v = s.values[at(s.diagonal[at(node)] + i * n + j)];
            if (i == j ? !(v < 0.0) : v != 0.0) return false;
        }
    return true;
}

std::vector<std::int32_t> order_alike(std::span<const BlockOp> ops) {
    auto key = [&](std::int32_t i) {
        const BlockOp& op = ops[at(i)];
        return std::tuple(op.row_size, op.col_size, op.base < 0, op.row == op.col, op.count[0],
                          op.count[1], op.count[2]);
    };
    std::vector<std::int32_t> order(ops.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::int32_t a, std::int32_t b) { return key(a) < key(b); });
    return order;
}

void BlockWrite::is_out_of_reach() {
    throw std::length_error("blocks are written past what 32 bits can address");
}

BlockForm make_form(const BlockSystem& s, bool condensed) {
    if (s.values.size() > std::numeric_limits<std::int32_t>::max())
        throw std::length_error("the blocks have more numbers than 32 bits can address");
    BlockForm f;
    f.condensed = condensed;
    f.index.assign(s.pattern.size.size(), -1);
    f.offset.push_back(0);
    std::vector<std::int8_t> size, sign;
    for (int a = 0; a < s.pattern.nodes(); ++a) {
        if (condensed && can_be_eliminated(s, a)) continue;
        f.index[at(a)] = static_cast<std::int32_t>(f.kept.size());
        f.kept.push_back(a);
        size.push_back(s.pattern.size[at(a)]);
        sign.push_back(s.pattern.sign[at(a)]);
        f.offset.push_back(f.offset.back() + s.size(a));
    }
    std::vector<Piece> pieces = list_pieces(s, f);
    sort_pieces(pieces, static_cast<int>(f.kept.size()));
    std::vector<std::int32_t> from, to;
    for (const Piece& p : pieces) {
        if (f.ops.empty() || f.ops.back().row != p.row || f.ops.back().col != p.col) {
            BlockOp op;
            op.row = p.row;
            op.col = p.col;
            op.begin = static_cast<std::int32_t>(f.contributions.size());
            op.row_size = static_cast<std::uint8_t>(size[at(p.row)]);
            op.col_size = static_cast<std::uint8_t>(size[at(p.col)]);
            op.by_rows = p.row != p.col;
            f.ops.push_back(op);
            from.push_back(p.row);
            to.push_back(p.col);
        }
        if (p.rows == 0) {
            f.ops.back().base = p.base;
        } else {
            f.contributions.push_back(p.part);
            ++f.ops.back().count[p.rows - 1];
        }
    }
    f.pattern = factor::make_pattern(std::move(size), std::move(sign), from, to);
    f.alike = order_alike(f.ops);
    f.tables = make_tables(s, f);
    return f;
}

}  // namespace hawser::bench
