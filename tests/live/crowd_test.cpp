// SPDX-License-Identifier: Apache-2.0
/// Truncated, oversized or invalid messages, many connections, and endless restores. Each gets a
/// response, and the instructor can always connect.
#include "live/client.h"
#include "live/run.h"
#include "support/random.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace hawser::test {
namespace {

SessionDef crowd_def() { return {.scene_text = live_scene()}; }

/// Send hello and receive the scene.
void meet(LiveClient& client) {
    (void)client.wait_for("scene");
    (void)client.frame();
}

/// The client checks the text like a browser: invalid UTF-8 would close the connection.
TEST(LiveCrowd, a_refusal_is_cut_between_characters) {
    LiveRun run(crowd_def());
    for (int shift = 0; shift < 4; ++shift) {
        LiveClient client(run.port(), run.roles[0].token);
        meet(client);
        std::string name(static_cast<std::size_t>(shift), 'x');
        for (int k = 0; k < 40; ++k) name += "\u20ac";  // three bytes each
        client.say({{"type", name}, {"id", 1}});
        const auto type = client.answer_to(1);
        EXPECT_EQ(type["type"], "error");
        client.say({{"type", "pause"}, {name, 1}, {"id", 2}});
        EXPECT_EQ(client.answer_to(2)["type"], "error");
        client.say({{"type", "set"}, {"input", name}, {"value", 1}, {"id", 3}});
        EXPECT_EQ(client.answer_to(3)["type"], "error");
    }
    LiveClient stranger(run.port(), "");
    stranger.say({{"type", "hello"}, {"version", 1}, {"token", "\u20ac\u20ac"}});
    EXPECT_EQ(stranger.closes(2.0), 1008);
    EXPECT_TRUE(run.goes_on());
}

TEST(LiveCrowd, every_message_has_an_answer) {
    LiveRun run(crowd_def());
    {
        LiveClient client(run.port(), run.roles[0].token);
        meet(client);
        client.say(std::string("\xEF\xBB\xBF") + R"({"type": "resume", "id": 5})");
        EXPECT_EQ(client.answer_to(5)["type"], "ok") << "a byte order mark";
        client.say(std::string("\xEF\xBB\xBF"));
        EXPECT_EQ(client.wait_for("error")["type"], "error");
        client.say(std::string(R"({"type": "resume", "id": 9007199254740993})"));
        const auto large = client.wait_for("error");
        EXPECT_EQ(large["id"], 9007199254740993);
        EXPECT_NE(large["reason"].get<std::string>().find("id is to be from 0"), std::string::npos);
    }
    for (const char* id :
         {"1e300", "18446744073709551615", "-1", "-1e308", "1.5", "\"a\"", "1e-320"}) {
        LiveClient client(run.port(), run.roles[0].token);
        meet(client);
        client.say(std::string(R"({"type": "resume", "id": )") + id + "}");
        EXPECT_EQ(client.wait_for("error")["type"], "error") << id;
    }
    EXPECT_TRUE(run.goes_on());
}

/// A header that announces a gigabyte, and nothing more.
TEST(LiveCrowd, an_announced_length_is_answered_at_once) {
    LiveRun run(crowd_def());
    for (const bool hello : {true, false}) {
        LiveClient client(run.port(), hello ? run.roles[0].token : "");
        if (hello) meet(client);
        const unsigned char header[] = {0x81, 0xFF, 0, 0, 0, 0, 0x40, 0, 0, 0, 1, 2, 3, 4, 'x'};
        client.line().send({reinterpret_cast<const char*>(header), sizeof header});
        const auto begun = std::chrono::steady_clock::now();
        EXPECT_EQ(client.closes(4.0), 1009);
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begun;
        EXPECT_LT(took.count(), 1.0);  // handshake_seconds is 5
    }
    // Sent in fragments; the last one exceeds the limit.
    LiveClient parts(run.port(), run.roles[0].token);
    meet(parts);
    for (int k = 0; k < 3; ++k) {
        std::string frame("\x01\xFE\x20\x00", 4);
        frame[0] = k == 0 ? 1 : 0;
        frame += std::string(4, '\0') + std::string(0x2000, ' ');
        parts.line().send(frame);
    }
    EXPECT_EQ(parts.closes(4.0), 1009);
    EXPECT_EQ(run.logged("more than 16 kB", 3), 3);
    EXPECT_TRUE(run.goes_on());
}

TEST(LiveCrowd, a_crowd_of_connections_keeps_nobody_out) {
    LiveRun run(crowd_def());
    std::vector<std::unique_ptr<Line>> half_open;
    for (int k = 0; k < 250; ++k) half_open.push_back(std::make_unique<Line>(run.port()));
    LiveClient instructor(run.port(), run.roles[0].token);
    EXPECT_EQ(instructor.answer(), "HTTP/1.1 101 Switching Protocols");
    meet(instructor);
    EXPECT_EQ(request(run.port(), "/", run.host()), "HTTP/1.1 200 OK");
    EXPECT_TRUE(half_open.front()->ends(2.0));  // the oldest was dropped
    // One thread makes as many connections per second as it can, while the instructor connects and
    // disconnects.
    std::atomic<bool> stop{false};
    std::atomic<int> made{0};
    std::thread crowd([&] {
        std::vector<std::unique_ptr<Line>> lines(200);
        for (std::size_t k = 0; !stop; ++k, ++made)
            lines[k % lines.size()] = std::make_unique<Line>(run.port());
    });
    for (int k = 0; k < 10; ++k) {
        LiveClient again(run.port(), run.roles[0].token);
        EXPECT_EQ(again.answer(), "HTTP/1.1 101 Switching Protocols");
        meet(again);
    }
    stop = true;
    crowd.join();
    std::printf("%d connections beside\n", made.load());
    EXPECT_GT(made.load(), 100);
    EXPECT_TRUE(run.goes_on());
}

TEST(LiveCrowd, values_that_no_input_has_are_refused) {
    LiveRun run(crowd_def());
    Random random(first_seed(63));
    const int rounds = by_tier(40, 400, 4000);
    for (int k = 0; k < rounds; ++k) {
        LiveClient client(run.port(), run.roles[0].token);
        meet(client);
        const auto& inputs = client.scene()["inputs"];
        ASSERT_FALSE(inputs.empty());
        for (int n = 0; n < 3; ++n) {
            const auto& input = inputs[static_cast<std::size_t>(
                random.integer(0, static_cast<int>(inputs.size()) - 1))];
            const double size = std::pow(10.0, random.uniform(-320.0, 308.0));
            const double value = random.chance(0.5) ? size : -size;
            client.say({{"type", "set"}, {"input", input["name"]}, {"value", value}, {"id", n}});
            const auto answer = client.answer_to(n);
            if (answer["type"] == "ok") continue;
            const auto reason = answer["reason"].get<std::string>();
            EXPECT_NE(reason.find(input["name"].get<std::string>()), std::string::npos) << reason;
            const bool range = reason.find("is outside its range") != std::string::npos;
            // The limit of a motor whose other limit was set before.
            const bool empty = reason.find("would be above") != std::string::npos;
            EXPECT_TRUE(range || empty) << reason;
        }
    }
    EXPECT_TRUE(run.goes_on());
}

/// Restores use a bounded fraction of the time: 1 %, besides a tenth of a second that is always
/// allowed. A restore of this scene takes some milliseconds, and the client waits for each answer.
TEST(LiveCrowd, restores_of_a_large_scene_do_not_stop_the_run) {
    LiveRun run({.scene = "scenes/anchor_run.json"}, {.states_fraction = 0.01});
    LiveClient client(run.port(), run.roles[0].token);
    (void)client.wait_for("scene", 20.0);
    int done = 0, refused = 0;
    const auto begun = std::chrono::steady_clock::now();
    for (int id = 1; std::chrono::steady_clock::now() - begun < std::chrono::seconds(20); ++id) {
        client.say({{"type", "restore"}, {"name", "start"}, {"id", id}});
        const auto answer = client.answer_to(id, 10.0);
        if (answer["type"] == "ok")
            ++done;
        else
            ++refused;
        if (refused == 0) continue;
        EXPECT_NE(answer["reason"].get<std::string>().find("try again in"), std::string::npos);
        break;
    }
    std::printf("%d restores, %d refused\n", done, refused);
    EXPECT_GT(refused, 0);
    EXPECT_TRUE(run.goes_on());
}

}  // namespace
}  // namespace hawser::test
