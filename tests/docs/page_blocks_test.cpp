// SPDX-License-Identifier: Apache-2.0
// Each C++ block of the pages below is part of tests/docs/page_programs.cpp, which is compiled.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

namespace hawser::test {
namespace {

/// Return the lines of a file without indentation, empty lines and includes.
std::string statements(std::istream& in) {
    std::string line, out;
    while (std::getline(in, line)) {
        const std::size_t begin = line.find_first_not_of(' ');
        if (begin != std::string::npos && line[begin] != '#' &&
            line.compare(begin, 15, "// clang-format") != 0)
            out += line.substr(begin) + "\n";
    }
    return out;
}

TEST(PageBlocks, AreCompiled) {
    std::ifstream file("tests/docs/page_programs.cpp");
    const std::string programs = statements(file);
    int blocks = 0;
    for (const char* page : {"docs/cranes.md", "docs/sea.md", "docs/vessels.md",
                             "docs/exercises.md", "docs/library_session.md"}) {
        std::ifstream in(page);
        std::string line, block;
        bool inside = false;
        while (std::getline(in, line)) {
            if (line == "```cpp") {
                inside = true;
                block.clear();
            } else if (inside && line == "```") {
                std::istringstream text(block);
                EXPECT_NE(programs.find(statements(text)), std::string::npos)
                    << page << " has a block that tests/docs/page_programs.cpp lacks:\n"
                    << block;
                inside = false;
                ++blocks;
            } else if (inside) {
                block += line + "\n";
            }
        }
    }
    EXPECT_GE(blocks, 9);
}

}  // namespace
}  // namespace hawser::test
