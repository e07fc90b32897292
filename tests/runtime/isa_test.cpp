// SPDX-License-Identifier: Apache-2.0
/// Values of HAWSER_ISA.
#include "base/isa.h"

#include <gtest/gtest.h>

namespace hawser::base {
namespace {

TEST(InstructionSet, IsTheOneWishedForOrTheBest) {
    EXPECT_EQ(choose_isa(nullptr, Isa::avx512).isa, Isa::avx512);
    EXPECT_EQ(choose_isa("", Isa::avx2).isa, Isa::avx2);
    EXPECT_EQ(choose_isa("sse2", Isa::avx512).isa, Isa::sse2);
    EXPECT_EQ(choose_isa("avx2", Isa::avx2).isa, Isa::avx2);
    for (const char* wish : {"", "sse2", "avx2", "avx512"})
        EXPECT_EQ(choose_isa(wish, Isa::avx512).problem, "") << wish;
}

TEST(InstructionSet, OfNoSuchNameOrProcessorIsRefusedWithTheNamesThereAre) {
    for (const char* wish : {"AVX2", "avx", "sse4", "avx512 ", "\n"}) {
        const std::string problem = choose_isa(wish, Isa::avx2).problem;
        EXPECT_NE(problem.find("HAWSER_ISA"), std::string::npos) << wish;
        EXPECT_NE(problem.find("sse2, avx2;"), std::string::npos) << problem;
        EXPECT_NE(problem.find("names no"), std::string::npos) << problem;
    }
    EXPECT_NE(choose_isa("avx512", Isa::avx2).problem.find("processor"), std::string::npos);
    EXPECT_NE(choose_isa("avx2", Isa::sse2).problem.find("there are sse2;"), std::string::npos);
}

}  // namespace
}  // namespace hawser::base
