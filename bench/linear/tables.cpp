// SPDX-License-Identifier: Apache-2.0
#include "index.h"
#include "linear/form.h"

namespace hawser::bench {
namespace {

void add_row(const BlockSystem& s, const BlockForm& f, int e, SweepTables& t) {
    for (int k = s.pattern.start[at(e)]; k < s.pattern.start[at(e) + 1]; ++k) {
        const int b = s.pattern.adjacent[at(k)];
        t.row_terms.push_back(
            {static_cast<std::int32_t>(s.edge[at(k)]), s.offset[at(b)], s.size(b)});
    }
    t.rows.push_back({s.offset[at(e)], static_cast<std::int32_t>(s.diagonal[at(e)]),
                      static_cast<std::int32_t>(t.row_terms.size()), s.size(e)});
    t.row_to.push_back(f.index[at(e)] < 0 ? -1 : f.offset[at(f.index[at(e)])]);
}

void add_body(const BlockSystem& s, const BlockForm& f, const std::vector<bool>& is_row, int a,
              SweepTables& t) {
    for (int k = s.pattern.start[at(a)]; k < s.pattern.start[at(a) + 1]; ++k) {
        const int b = s.pattern.adjacent[at(k)];
        const auto block = static_cast<std::int32_t>(s.edge[at(k)]);
        if (!is_row[at(b)]) {
            t.others.push_back({block, s.offset[at(b)], s.size(b), b < a});
            continue;
        }
        for (int r = 0; r < s.size(b); ++r)
            t.columns.push_back({block + r * s.size(a), s.offset[at(b)] + r});
    }
    t.bodies.push_back({s.offset[at(a)], f.offset[at(f.index[at(a)])],
                        static_cast<std::int32_t>(s.diagonal[at(a)]), s.size(a),
                        static_cast<std::int32_t>(t.columns.size()),
                        static_cast<std::int32_t>(t.others.size())});
}

}  // namespace

SweepTables make_tables(const BlockSystem& s, const BlockForm& f) {
    SweepTables t;
    std::vector<bool> is_row(s.pattern.size.size());
    for (int a = 0; a < s.pattern.nodes(); ++a) is_row[at(a)] = can_be_eliminated(s, a);
    for (int a = 0; a < s.pattern.nodes(); ++a) {
        if (is_row[at(a)])
            add_row(s, f, a, t);
        else
            add_body(s, f, is_row, a, t);
    }
    return t;
}

}  // namespace hawser::bench
