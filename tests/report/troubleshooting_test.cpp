// SPDX-License-Identifier: Apache-2.0
// docs/troubleshooting.md has a row for each entry of the code's tables, and no other rows.
#include "report/start/findings.h"

#include <hawser/stats.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace hawser::test {

namespace {

/// Return names in the first column of the table of a section. Rows have three filled columns.
std::multiset<std::string> rows_of(const std::string& section) {
    std::ifstream in("docs/troubleshooting.md");
    std::string line;
    std::multiset<std::string> out;
    bool inside = false;
    while (std::getline(in, line)) {
        if (line.starts_with("## ")) inside = line == "## " + section;
        if (!inside || !line.starts_with("| `")) continue;
        std::vector<std::string> cells;
        std::istringstream columns(line.substr(1));
        for (std::string cell; std::getline(columns, cell, '|');) cells.push_back(cell);
        EXPECT_EQ(cells.size(), 3u) << line;
        for (const std::string& cell : cells) EXPECT_GT(cell.size(), 4u) << line;
        out.insert(line.substr(3, line.find('`', 3) - 3));
    }
    return out;
}

template <class Kind>
std::multiset<std::string> names_of(int count) {
    std::multiset<std::string> out;
    for (int k = 0; k < count; ++k) out.insert(to_string(static_cast<Kind>(k)));
    return out;
}

}  // namespace

TEST(Troubleshooting, ListsEveryEntryOfTheTables) {
    EXPECT_EQ(rows_of("Grades"), names_of<Grade>(static_cast<int>(Grade::wrong) + 1));
    EXPECT_EQ(rows_of("Monitors"), names_of<Judge>(kJudgeCount));
    EXPECT_EQ(rows_of("Events"), names_of<EventKind>(kEventKindCount));
    EXPECT_EQ(rows_of("Status of a step"),
              names_of<Status>(static_cast<int>(Status::bad_edit) + 1));
    EXPECT_EQ(rows_of("Findings of a start"),
              names_of<report::start::FindingKind>(report::start::kFindingKindCount));
}

}  // namespace hawser::test
