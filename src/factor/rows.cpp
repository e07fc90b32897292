// SPDX-License-Identifier: Apache-2.0
/// Update rows, and the runs by which they are added to the parents.
#include "base/index.h"
#include "factor/layout.h"

#include <algorithm>

namespace hawser::factor {

/// Compute the update rows of the fronts of chains, which must be done first, or of all other
/// fronts.
void Layout::fill_rows(const Pattern& pattern, const Columns& columns, bool of_chains,
                       Symbolic& s) {
    const std::int32_t* offsets = s.node_offset.data();
    const std::int8_t* size = pattern.size.data();
    auto done = chain_rows_.begin();
    for (const Front& front : s.fronts) {
        if (in_chain(s, front) != of_chains) continue;
        if (of_chains) chain_rows_.push_back(front.rows);
        // Entries written past the end of a front are overwritten by the fronts behind it, up to
        // the next chain.
        while (!of_chains && *done < front.rows) ++done;
        const std::int64_t limit = of_chains ? std::ssize(s.rows) : *done;
        std::int32_t* row = s.rows.data() + front.rows;
        const std::int32_t* const end =
            s.rows.data() + std::min(front.rows + front.q + kCopyWidth, limit);
        for (const std::int32_t v : columns.rows(last_node(s, front))) {
            const std::int32_t offset = offsets[v];
            if (end - row >= kCopyWidth)
                for (std::int32_t c = 0; c < kCopyWidth; ++c) row[c] = offset + c;
            else
                for (std::int32_t c = 0; c < size[v]; ++c) row[c] = offset + c;
            row += size[v];
        }
    }
    if (of_chains) chain_rows_.push_back(std::ssize(s.rows));
}

void Layout::find_all_runs(const Pattern& pattern, const Columns& columns, Symbolic& s) {
    const std::size_t count = s.fronts.size();
    s.runs.resize(pattern.size.size());
    row_of_.resize(s.order.size());
    std::size_t runs = 0;
    for (std::size_t f = 0; f < count; ++f) {
        Front& front = s.fronts[f];
        front.run_begin = front.run_end = static_cast<std::int32_t>(runs);
        if (front.parent < 0) continue;
        if (unchanged_front_[f] >= 0 && unchanged_front_[at(front.parent)] >= 0) {
            const Front& old = old_fronts_[at(unchanged_front_[f])];
            if (old.parent == unchanged_front_[at(front.parent)]) {
                const auto length = at(old.run_end - old.run_begin);
                if (runs + length > s.runs.size()) s.runs.resize(2 * (runs + length));
                std::copy_n(old_runs_.begin() + old.run_begin, length,
                            s.runs.begin() + static_cast<std::ptrdiff_t>(runs));
                runs += length;
                front.run_end = static_cast<std::int32_t>(runs);
                continue;
            }
        }
        const std::size_t most = runs + columns.rows(last_node(s, front)).size();
        if (most > s.runs.size()) s.runs.resize(2 * most);
        find_runs(pattern, columns, front, s);
        runs = at(front.run_end);
    }
    s.runs.resize(runs);
}

/// Find the rows of the parent front to which the update rows of a front are added, as runs of
/// consecutive rows.
void Layout::find_runs(const Pattern& pattern, const Columns& columns, Front& front, Symbolic& s) {
    const Front& parent = s.fronts[at(front.parent)];
    const std::int32_t p = parent.p, first = parent.offset;
    const auto own = columns.rows(last_node(s, front));
    const auto theirs = columns.rows(last_node(s, parent));
    const std::int32_t* scalars = s.rows.data() + parent.rows;
    const std::int32_t* offsets = s.node_offset.data();
    const std::int8_t* sizes = pattern.size.data();
    std::int32_t* row_of = row_of_.data();
    // Store the parent's rows by node; if there are many more of them, search them.
    if (theirs.size() > 8 * own.size()) {
        for (const std::int32_t v : own)
            row_of[v] =
                p + static_cast<std::int32_t>(
                        std::lower_bound(scalars, scalars + parent.q, offsets[v]) - scalars);
    } else {
        std::int32_t row = p;
        for (const std::int32_t v : theirs) {
            row_of[v] = row;
            row += sizes[v];
        }
    }
    // A run stays on one side of the parent's pivot boundary, so its columns lie wholly in the
    // panel or wholly in the update matrix. The last run is written again while it grows. Masks
    // replace branches, because the next row is unpredictable.
    Run* runs = s.runs.data();
    std::int32_t from = 0, last = front.run_begin - 1, run_from = 0, run_to = 0;
    std::int32_t next = p;  // continues nowhere
    for (const std::int32_t v : own) {
        const std::int32_t size = sizes[v], pivot = offsets[v] - first;
        const std::int32_t inside = -static_cast<std::int32_t>(pivot < p);
        const std::int32_t to = (pivot & inside) | (row_of[v] & ~inside);
        const std::int32_t joins =
            -(static_cast<std::int32_t>(to == next) & static_cast<std::int32_t>(to != p));
        run_from = (run_from & joins) | (from & ~joins);
        run_to = (run_to & joins) | (to & ~joins);
        next = to + size;
        from += size;
        last += 1 + joins;
        runs[last] = {run_from, run_to, from - run_from};
    }
    front.run_end = last + 1;
}

}  // namespace hawser::factor
