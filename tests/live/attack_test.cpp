// SPDX-License-Identifier: Apache-2.0
/// Attacks of unknown and faulty clients on a server: they are rejected and logged once, and steps
/// continue.
#include "live/client.h"
#include "live/run.h"

#include <gtest/gtest.h>
#include <sys/socket.h>

#include <chrono>
#include <memory>
#include <thread>
#include <vector>

namespace hawser::test {
namespace {

SessionDef live_def() { return {.scene_text = live_scene()}; }

/// Send hello and receive the scene.
void greet(LiveClient& client) {
    (void)client.wait_for("scene");
    (void)client.frame();
}

TEST(LiveAttack, a_foreign_origin_or_host_is_refused) {
    LiveRun run(live_def());
    const std::string token = run.roles[0].token;
    LiveClient origin(run.port(), token, "Origin: http://evil.example\r\n");
    EXPECT_EQ(origin.answer(), "HTTP/1.1 403 Forbidden");
    EXPECT_EQ(run.logged("foreign Origin \"http://evil.example\"", 1), 1);
    LiveClient host(run.port(), token, "", "evil.example:" + std::to_string(run.port()));
    EXPECT_EQ(host.answer(), "HTTP/1.1 403 Forbidden");
    EXPECT_EQ(run.logged("foreign Host", 1), 1);
    EXPECT_EQ(request(run.port(), "/", "evil.example"), "HTTP/1.1 403 Forbidden");
    EXPECT_EQ(run.logged("refused", 3), 3);
    LiveClient own(run.port(), token, "Origin: http://" + run.host() + "\r\n");
    EXPECT_EQ(own.answer(), "HTTP/1.1 101 Switching Protocols");
    greet(own);
    EXPECT_TRUE(run.goes_on());
}

TEST(LiveAttack, without_a_token_nothing_is_seen) {
    LiveRun run(live_def());
    LiveClient wrong(run.port(), std::string(32, '0'));
    EXPECT_EQ(wrong.next().json["reason"], "no role has this token");
    EXPECT_EQ(wrong.closes(2.0), 1008);
    EXPECT_EQ(run.logged("no role has this token", 1), 1);
    LiveClient none(run.port(), "");
    none.say({{"type", "pause"}});
    EXPECT_EQ(none.next().json["reason"], "the first message is a hello");
    EXPECT_EQ(none.closes(2.0), 1008);
    LiveClient version(run.port(), "");
    version.say({{"type", "hello"}, {"version", 2}, {"token", run.roles[0].token}});
    EXPECT_EQ(version.closes(2.0), 1008);
    EXPECT_TRUE(run.goes_on());
}

TEST(LiveAttack, who_has_no_right_to_it_moves_no_lever) {
    LiveRun run(live_def());
    LiveClient deck(run.port(), run.roles[2].token);
    greet(deck);
    EXPECT_EQ(deck.scene()["role"]["inputs"], nlohmann::json({"push"}));
    deck.say({{"type", "set"}, {"input", "push"}, {"value", 50}, {"id", 1}});
    EXPECT_EQ(deck.answer_to(1)["type"], "ok");
    deck.say({{"type", "set"}, {"input", "lift"}, {"value", 50}, {"id", 2}});
    EXPECT_EQ(deck.answer_to(2)["reason"], "the role deck does not have the input \"lift\"");
    deck.say({{"type", "set"},
              {"inputs", nlohmann::json::array({{"push", 70}, {"lift", 70}})},
              {"id", 3}});
    EXPECT_EQ(deck.answer_to(3)["type"], "error");
    deck.say({{"type", "pause"}, {"id", 4}});
    EXPECT_EQ(deck.answer_to(4)["reason"], "the role deck may not pause");
    EXPECT_EQ(deck.closes(2.0), 1008);  // the third rejected message
    EXPECT_EQ(run.logged("does not have the input \"lift\"", 2), 2);
    LiveClient watcher(run.port(), run.roles[1].token);
    greet(watcher);
    const auto frame = read_frame(watcher.frame());
    const auto& inputs = watcher.scene()["inputs"];
    for (std::size_t k = 0; k < inputs.size(); ++k) {
        if (inputs[k]["name"] == "lift") {
            EXPECT_EQ(frame.inputs[k], 0.0F);
        }
    }
    EXPECT_TRUE(run.goes_on());
}

TEST(LiveAttack, ten_megabytes_close_the_connection) {
    LiveRun run(live_def());
    LiveClient client(run.port(), run.roles[0].token);
    greet(client);
    client.say(std::string(10'000'000, ' '));
    EXPECT_EQ(client.closes(5.0), 1009);
    EXPECT_EQ(run.logged("more than 16 kB", 1), 1);
    LiveClient binary(run.port(), run.roles[0].token);
    greet(binary);
    for (int k = 0; k < 3; ++k) binary.say(std::string("\0\1\2", 3), 2);
    EXPECT_EQ(binary.closes(5.0), 1008);
    Line body(run.port());
    body.send("POST / HTTP/1.1\r\nHost: " + run.host() + "\r\nContent-Length: 10000000\r\n\r\n");
    body.send(std::string(1 << 20, 'x'));
    EXPECT_TRUE(body.ends(6.0));
    EXPECT_TRUE(run.goes_on());
}

TEST(LiveAttack, a_flood_ends_with_the_third_error) {
    LiveRun run(live_def());
    LiveClient client(run.port(), run.roles[0].token);
    greet(client);
    // The number of messages that a connection may send per second, and half as many more: the
    // surplus is rejected.
    for (int k = 0; k < 300; ++k)
        if (!client.say({{"type", "set"}, {"input", "push"}, {"value", k % 100}})) break;
    EXPECT_EQ(client.closes(5.0), 1008);
    EXPECT_EQ(run.logged("more than 200 messages a second", 3), 3);
    EXPECT_TRUE(run.goes_on());
}

TEST(LiveAttack, half_a_handshake_is_not_waited_for) {
    LiveRun run(live_def(), {.handshake_seconds = 0.5});
    Line half(run.port());
    half.send("GET /live HTTP/1.1\r\nHost: ");
    Line mute(run.port());
    LiveClient no_hello(run.port(), "");
    EXPECT_TRUE(half.ends(3.0));
    EXPECT_TRUE(mute.ends(3.0));
    EXPECT_EQ(no_hello.closes(3.0), 1008);
    EXPECT_EQ(run.logged("no complete request in time", 2), 2);
    EXPECT_EQ(run.logged("no hello", 1), 1);
    Line header(run.port());
    header.send("GET / HTTP/1.1\r\nX: " + std::string(100'000, 'y'));
    EXPECT_TRUE(header.ends(3.0));
    Line nonsense(run.port());
    nonsense.send("\x16\x03\x01 what is this\r\n\r\n");
    EXPECT_TRUE(nonsense.ends(3.0));
    EXPECT_TRUE(run.goes_on());
}

TEST(LiveAttack, no_path_leads_to_the_file_system) {
    LiveRun run(live_def());
    for (const char* path : {"/../../../../etc/passwd", "/%2e%2e/%2e%2e/etc/passwd",
                             "/..%2f..%2fetc/passwd", "//etc/passwd", "/scenes/pendulum.json"})
        EXPECT_EQ(request(run.port(), path, run.host()), "HTTP/1.1 404 Not Found") << path;
    EXPECT_EQ(run.logged("no file", 5), 5);
    EXPECT_EQ(request(run.port(), "/", run.host()), "HTTP/1.1 200 OK");
    EXPECT_EQ(request(run.port(), "/", run.host(), "", "DELETE"),
              "HTTP/1.1 405 Method Not Allowed");
    Line line(run.port());
    line.send("GET / HTTP/1.1\r\nHost: " + run.host() + "\r\n\r\n");
    const std::string answer = line.read_all(2.0);
    for (const char* header :
         {"Content-Security-Policy: default-src 'none'", "X-Content-Type-Options: nosniff",
          "Referrer-Policy: no-referrer", "Cross-Origin-Resource-Policy: same-origin"})
        EXPECT_NE(answer.find(header), std::string::npos) << header;
    EXPECT_TRUE(run.goes_on());
}

TEST(LiveAttack, who_reads_nothing_is_dropped_and_others_are_not) {
    LiveRun run({.scene = "scenes/anchor_contact.json"}, {.slow_seconds = 1.0});
    LiveClient reader(run.port(), run.roles[1].token);
    greet(reader);
    LiveClient deaf(run.port(), run.roles[0].token);
    const int small = 4096;
    setsockopt(deaf.line().descriptor(), SOL_SOCKET, SO_RCVBUF, &small, sizeof small);
    int frames = 0;
    for (int k = 0; k < 600 && run.logged("received nothing for") == 0; ++k) {
        (void)reader.frame();
        ++frames;
    }
    EXPECT_EQ(run.logged("dropped", 1), 1);
    // The reader is served in the second before the drop; busy or instrumented machines make few
    // frames.
    EXPECT_GT(frames, 5);
    EXPECT_EQ(run.server->figures().dropped, 1);
    EXPECT_TRUE(run.goes_on());
}

TEST(LiveAttack, places_for_clients_are_counted) {
    LiveRun run(live_def(), {.clients = 2});
    LiveClient one(run.port(), run.roles[0].token);
    greet(one);
    auto two = std::make_unique<LiveClient>(run.port(), run.roles[1].token);
    greet(*two);
    {
        LiveClient three(run.port(), run.roles[1].token);
        EXPECT_EQ(three.wait_for("error")["reason"],
                  "all places for clients are taken (--clients 2)");
        EXPECT_EQ(three.closes(2.0), 1013);
    }
    {
        // Exactly one connection is reserved for roles with control.
        LiveClient instructor(run.port(), run.roles[0].token);
        greet(instructor);
        LiveClient beside(run.port(), run.roles[0].token);
        EXPECT_EQ(beside.closes(2.0), 1013);
        instructor.say("", 8);
        EXPECT_NE(instructor.closes(3.0), -1);
    }
    two->say("", 8);
    EXPECT_NE(two->closes(3.0), -1);
    two.reset();
    // The server notices the end shortly after its close message.
    for (int k = 0; k < 100 && run.hub.clients.load() > 1; ++k)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    LiveClient again(run.port(), run.roles[1].token);
    EXPECT_EQ(again.answer(), "HTTP/1.1 101 Switching Protocols");
    greet(again);
}

TEST(LiveAttack, sockets_without_a_hello_take_no_place) {
    LiveRun run(live_def(), {.handshake_seconds = 1.0, .clients = 2});
    std::vector<std::unique_ptr<LiveClient>> strangers;
    for (int k = 0; k < 40; ++k) strangers.push_back(std::make_unique<LiveClient>(run.port(), ""));
    for (int k = 0; k < 2; ++k) {
        LiveClient client(run.port(), run.roles[k].token);
        EXPECT_EQ(client.answer(), "HTTP/1.1 101 Switching Protocols");
        greet(client);
    }
    // At most 32 waiting connections are kept: the oldest is dropped for a new one.
    EXPECT_EQ(strangers.front()->closes(0.2), 0);
    EXPECT_GE(run.logged("too many sockets without a hello", 8), 8);
    // A connection that is not dropped for others ends by its time limit without a reason: 1 s,
    // half a second for the message, and a check every quarter of a second.
    EXPECT_TRUE(strangers.back()->line().ends(3.0));
    EXPECT_TRUE(run.goes_on());
}

TEST(LiveServer, ends_while_clients_do_not_hang_up) {
    std::unique_ptr<LiveClient> silent, stranger;
    {
        LiveRun run(live_def());
        silent = std::make_unique<LiveClient>(run.port(), run.roles[1].token);
        greet(*silent);
        stranger = std::make_unique<LiveClient>(run.port(), "");
        // The connection is accepted once the server has answered.
        EXPECT_EQ(stranger->answer(), "HTTP/1.1 101 Switching Protocols");
    }
    EXPECT_EQ(silent->wait_for("bye")["reason"], "the program ends");
    EXPECT_EQ(silent->closes(2.0), 1000);
    EXPECT_EQ(stranger->closes(2.0), 1000);
}

TEST(LiveServer, proposes_a_free_port_and_refuses_addresses_that_make_no_sense) {
    LiveRun run(live_def());
    live::Hub hub;
    try {
        live::Server second(hub, {.port = run.port(), .roles = {live::watcher()}});
        FAIL() << "two servers at one port";
    } catch (const live::ServerError& error) {
        const std::string words = error.what();
        EXPECT_NE(words.find("port " + std::to_string(run.port()) +
                             " of 127.0.0.1 is taken; free "
                             "is --port "),
                  std::string::npos)
            << words;
    }
    EXPECT_THROW(live::Server(hub, {.address = "here"}), live::ServerError);
}

}  // namespace
}  // namespace hawser::test
