// SPDX-License-Identifier: Apache-2.0
// README.md and docs/library.md: each of their C++ blocks is part of a program in examples/library,
// and the programs give the stated results.
#define main readme_program
#include "../../examples/library/readme.cpp"
#undef main
#define main first_body_program
#include "../../examples/library/first_body.cpp"
#undef main
#define main crane_program
#include "../../examples/library/crane.cpp"
#undef main

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace {

/// Return the lines of a text without indentation and without empty lines.
std::string flattened(const std::string& text) {
    std::istringstream in(text);
    std::string line, out;
    while (std::getline(in, line)) {
        const std::size_t begin = line.find_first_not_of(' ');
        if (begin != std::string::npos) out += line.substr(begin) + "\n";
    }
    return out;
}

std::string contents(const char* file) {
    std::ifstream in(file);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

TEST(LibraryDocument, EveryBlockStandsInAProgram) {
    const std::string programs = flattened(contents("examples/library/first_body.cpp")) +
                                 flattened(contents("examples/library/crane.cpp"));
    const std::string document = contents("docs/library.md");
    int blocks = 0;
    for (std::size_t at = document.find("```cpp\n"); at != std::string::npos;
         at = document.find("```cpp\n", at + 1)) {
        const std::size_t begin = at + 7, end = document.find("```", begin);
        const std::string block = flattened(document.substr(begin, end - begin));
        EXPECT_NE(programs.find(block), std::string::npos) << block;
        ++blocks;
    }
    EXPECT_GE(blocks, 12);
}

TEST(ReadmeDocument, ItsProgramStandsInTheExamplesAndRuns) {
    const std::string document = contents("README.md");
    const std::size_t begin = document.find("```cpp\n") + 7, end = document.find("```", begin);
    const std::string block = flattened(document.substr(begin, end - begin));
    EXPECT_NE(flattened(contents("examples/library/readme.cpp")).find(block), std::string::npos);
    EXPECT_EQ(readme_program(), 0);
}

TEST(LibraryDocument, TheFirstBodySwings) {
    // The rod keeps it 1 m away, except for its lag (docs/theory/step.md): 4.3e-4 m at 240 Hz. The
    // lag grows with the square of the step: 16 times at 60 Hz.
    EXPECT_NEAR(swing(), 1.0, 7e-3);
}

TEST(LibraryDocument, TheCraneKeepsItsLoadWhereItWas) {
    const CraneEnd end = lift();
    // The boom stops in the step in which it passes 0.6 rad, at 0.05 rad/s.
    EXPECT_NEAR(end.angle, 0.6, 0.05 / 60.0 + 1e-4);
    EXPECT_NEAR(end.height, 0.0, 0.05);
    EXPECT_LT(end.worst, 2.0);                       // without the controller it would rise by 17 m
    EXPECT_NEAR(end.tension, 5000.0 * 9.81, 500.0);  // the load still swings
    EXPECT_TRUE(end.same_after_restore);
}

}  // namespace
