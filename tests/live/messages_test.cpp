// SPDX-License-Identifier: Apache-2.0
/// Clients send messages in any order, and steps fail for any cause. The program continues, each
/// loop ends within a second, and a replay of the recording agrees bit for bit.
///
/// Values are from 1e-320 to 1e308. Messages set inputs, drag, part, save, restore and step
/// (random_messages.h).
#include "files/mutate.h"
#include "live/random_messages.h"

#include "support/tier.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdint>
#include <exception>
#include <filesystem>
#include <string>

namespace hawser::test {
namespace {

std::filesystem::path messages_file(const char* name) {
    return std::filesystem::temp_directory_path() /
           (std::string("hawser_") + name + std::to_string(::getpid()) + ".hwr");
}

TEST(LiveMessages, OfAnyKindAndOrderAreReplayed) {
    const int sessions = inputs_of(10, 200, 200);
    const int messages = by_tier(100, 250, 5000);
    const std::filesystem::path file = messages_file("messages");
    MessageFigures all;
    for (const std::uint32_t seed : seeds(1, 1, 1, 1))
        for (int s = 0; s < sessions && !testing::Test::HasFailure(); ++s) {
            Lines lines;
            std::string difference;
            try {
                const MessageFigures one = run_random(
                    s, messages, seed + 7919U * static_cast<std::uint32_t>(s), file, lines);
                all.add(one);
                EXPECT_LT(one.longest, 1.0)
                    << "[s] of one loop, session " << s << ", seed " << seed;
                difference = replay_difference(file);
            } catch (const std::exception& error) {
                difference = error.what();
            }
            if (difference.empty()) continue;
            ADD_FAILURE() << "session " << s << ", seed " << seed << ": " << difference << "\n"
                          << fmt::format("{}", fmt::join(shortest(s, lines, file), "\n"));
        }
    std::filesystem::remove(file);
    EXPECT_GT(all.steps, 0);
    EXPECT_GT(all.failures, 0) << "no step has failed";
    fmt::print("{} messages, {} steps, failed by status {}, longest loop {:.3f} s\n", all.taken,
               all.steps, fmt::join(all.by_status, " "), all.longest);
}

/// Pulls a node of the wire of session 1 upwards: the first step needs several iterations.
const char* const kPull =
    R"({"type":"drag","body":7,"point":[0,0,0],"target":[39.5,66.8,-62.3],"stiffness":0})";
const char* const kStep = R"({"type":"step","count":1})";

std::uint64_t end_of_lines(const Lines& lines) {
    const std::filesystem::path file = messages_file("lines");
    (void)run_lines(1, lines, file);
    EXPECT_EQ(replay_difference(file), "");
    const std::uint64_t hash = end_hash(file);
    std::filesystem::remove(file);
    return hash;
}

TEST(LiveMessages, AFirstStepThatFailedLeavesNothingBehind) {
    const std::uint64_t plain = end_of_lines({kPull, kStep});
    EXPECT_EQ(end_of_lines({"!late", kStep, kPull, kStep}), plain);
    EXPECT_EQ(end_of_lines({kPull, "!pivot", kStep, kStep}), plain);
}

TEST(LiveMessages, ARestoredStartStepsAsTheFirstTime) {
    const char* const back = R"({"type":"restore","name":"start"})";
    const std::uint64_t plain = end_of_lines({kPull, kStep});
    EXPECT_EQ(end_of_lines({kPull, kStep, kStep, back, kPull, kStep}), plain);
}

/// The winch sets the minimum to 0 N when its mode changes.
TEST(LiveMessages, ARangeThatASystemLeavesEmptyFailsTheStep) {
    const std::filesystem::path file = messages_file("range");
    const auto run = [&](const Lines& lines) {
        const MessageFigures figures = run_lines(0, lines, file);
        EXPECT_EQ(replay_difference(file), "");
        return figures;
    };
    const char* const mode = R"({"type":"set","input":"hoist.mode","value":1})";
    const char* const below = R"({"type":"set","input":"hoist/motor/force_max","value":-1.9})";
    const char* const above = R"({"type":"set","input":"hoist/motor/force_max","value":4e4})";
    const MessageFigures failed = run({mode, below, kStep});
    EXPECT_EQ(failed.steps, 0);
    EXPECT_EQ(failed.by_status[static_cast<std::size_t>(Status::bad_load)], 1);
    EXPECT_EQ(run({mode, below, kStep, above, kStep}).steps, 1);
    std::filesystem::remove(file);
}

TEST(LiveMessages, InputsBeforeAStepWithoutMemoryAreRecorded) {
    const char* const set = R"({"type":"set","inputs":[["push1",0.5],["push2",64]]})";
    const std::uint64_t plain = end_of_lines({set, kStep});
    for (const int request : {0, 1, 2, 3, 5, 20})
        EXPECT_EQ(end_of_lines({set, fmt::format("!memory {}", request), kStep}), plain);
}

}  // namespace
}  // namespace hawser::test
