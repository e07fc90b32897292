// SPDX-License-Identifier: Apache-2.0
/// Half a minute controlled over the socket, recorded and replayed; recordings shown, with jumps in
/// time.
#include "live/client.h"
#include "live/player.h"
#include "live/run.h"
#include "support/repeat.h"

#include <hawser/recording.h>

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <string>

namespace hawser::test {
namespace {

struct LiveFolder {
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("hawser_live_" + std::to_string(::getpid()));
    LiveFolder() { std::filesystem::create_directories(path); }
    ~LiveFolder() { std::filesystem::remove_all(path); }
    [[nodiscard]] std::string file(const char* name) const { return (path / name).string(); }
};

void wait_until(LiveClient& client, double time) {
    for (int k = 0; k < 3000; ++k)
        if (read_frame(client.frame()).time >= time) return;
    FAIL() << "it does not come to " << time << " s";
}

nlohmann::json tell(LiveClient& client, int id, nlohmann::json message) {
    message["id"] = id;
    client.say(message);
    nlohmann::json answer = client.answer_to(id);
    EXPECT_EQ(answer["type"], "ok") << answer.dump();
    return answer;
}

int number_of(const nlohmann::json& list, const std::string& name) {
    for (const auto& one : list)
        if (one["name"] == name) return one["id"].get<int>();
    ADD_FAILURE() << "nothing is called " << name;
    return -1;
}

/// Controls, a drag, a broken line, a wire that the timeline cuts, and a return to the time before.
TEST(LiveShow, half_a_minute_over_the_socket_is_repeated_exactly) {
    const LiveFolder folder;
    const std::string file = folder.file("show.hwr");
    std::int64_t steps = 0;
    {
        LiveRun run({.scene_text = live_scene(), .record = file});
        LiveClient client(run.port(), run.roles[0].token);
        (void)client.wait_for("state");
        const int load = number_of(client.scene()["bodies"], "load");
        EXPECT_EQ(client.scene()["wires"].size(), 2U);
        tell(client, 1, {{"type", "rate"}, {"value", 10}});
        wait_until(client, 3.0);
        tell(client, 2, {{"type", "set"}, {"input", "push"}, {"value", -300}});
        tell(client, 3, {{"type", "set"}, {"input", "hoist.speed"}, {"value", 0.3}});
        tell(client, 4, {{"type", "save"}, {"name", "before"}});
        tell(client, 5, {{"type", "drag"}, {"body", load}, {"target", {3, 14, 7}}});
        wait_until(client, 5.0);
        const auto pulled = read_frame(client.frame());
        EXPECT_EQ(pulled.flags & 8, 8);
        EXPECT_GT(pulled.rigid[1] + client.scene()["origin"][1].get<float>(), 11.0F);
        tell(client, 6, {{"type", "part"}, {"wire", "tow"}, {"s", 0.8}});
        tell(client, 7, {{"type", "drag"}, {"wire", 0}, {"s", 0.3}, {"target", {20, 5, 9}}});
        wait_until(client, 8.0);
        EXPECT_EQ(client.scene()["wires"].size(), 3U);  // cut at 6 s
        EXPECT_GT(client.scene()["epoch"], 1);
        tell(client, 8, {{"type", "restore"}, {"name", "before"}});
        const auto back = read_frame(client.frame());
        EXPECT_LT(back.time, 5.0);
        wait_until(client, 5.0);
        EXPECT_EQ(client.scene()["wires"].size(), 2U);
        tell(client, 9, {{"type", "set"}, {"input", "lift"}, {"value", 200}});
        wait_until(client, 7.0);
        EXPECT_EQ(client.scene()["wires"].size(), 3U);  // cut again
        tell(client, 10, {{"type", "restore"}, {"name", "start"}});
        wait_until(client, 20.0);
        tell(client, 11, {{"type", "pause"}});
        tell(client, 12, {{"type", "set"}, {"input", "lift"}, {"value", -100}});
        run.stop();
        steps = run.driver->figures().steps;
        EXPECT_EQ(run.session.finish(), record::Ending::finished);
    }
    const record::Recording recording = record::Recording::open(file);
    EXPECT_EQ(recording.damage, "");
    EXPECT_EQ(recording.takes.size(), 2U);
    EXPECT_FALSE(recording.loads.empty());  // loads of the winch
    EXPECT_GT(steps, 30 * 60 - 200);
    for (const int threads : {1, 2}) EXPECT_EQ(expect_repeats(recording, threads).steps, steps);
    std::printf("%lld steps in %zu takes repeated with 1 and 2 threads\n",
                static_cast<long long>(steps), recording.takes.size() + 1);
}

TEST(LiveShow, pauses_steps_and_answers_what_is_pointed_at) {
    LiveRun run({.scene_text = live_scene()}, {.paused = true});
    LiveClient client(run.port(), run.roles[0].token), other(run.port(), run.roles[1].token);
    (void)client.wait_for("state");
    (void)other.wait_for("state");
    EXPECT_EQ(read_frame(client.frame()).step, 0);
    tell(client, 1, {{"type", "step"}, {"count", 7}});
    int at_seven = 0;
    for (int k = 0; k < 40 && at_seven < 3; ++k) at_seven += read_frame(client.frame()).step == 7;
    EXPECT_EQ(at_seven, 3);  // and stays cut
    EXPECT_EQ(read_frame(other.frame()).flags & 1, 1);
    client.say({{"type", "pick"}, {"wire", 0}, {"s", 0.5}, {"id", 2}});
    const auto wire = client.answer_to(2);
    EXPECT_EQ(wire["type"], "picked");
    EXPECT_EQ(wire["name"], "tow");
    const World& world = run.session.world();
    const WireId tow = world.wires().find("tow");
    EXPECT_EQ(wire["numbers"][0][2].get<double>(),
              world.wires().tension(tow, 0.5 * world.wires().length(tow)));
    client.say(
        {{"type", "pick"}, {"body", number_of(client.scene()["bodies"], "load")}, {"id", 3}});
    EXPECT_EQ(client.answer_to(3)["name"], "load");
    client.say({{"type", "set"}, {"input", "pusch"}, {"value", 1}, {"id", 4}});
    EXPECT_EQ(client.answer_to(4)["reason"], "there is no input \"pusch\"; nearest: \"push\"");
    client.say({{"type", "restore"}, {"name", "strat"}, {"id", 5}});
    EXPECT_EQ(client.answer_to(5)["reason"],
              "there is no restore point \"strat\"; nearest: \"start\"");
    client.say({{"type", "part"}, {"wire", "tov"}, {"s", 0.5}, {"id", 6}});
    EXPECT_EQ(client.answer_to(6)["reason"], "there is no wire \"tov\"; nearest: \"tow\"");
}

/// An operation of the timeline is impossible: the run pauses and reports it.
TEST(LiveShow, a_step_that_fails_pauses_and_tells_where_and_what_to_do) {
    // The ends to join have moved apart before.
    Session failing({.scene_text = R"({"version": 1, "name": "f",
        "line_types": {"wire": {"mass_per_length": 5, "EA": 5e6, "drag": 40, "diameter": 0.04}},
        "cables": [{"name": "tow", "line_type": "wire", "from": {"at": [0, 0, 9]},
                    "to": {"at": [60, 0, 9]}, "length": 62, "elements": 8, "shape": "hanging"}],
        "timeline": [{"at": 0.1, "cut": "tow", "s": 30},
                     {"at": 1, "join": {"wire": "tow", "to": "tow/2", "gear": "shackle",
                                        "name": "link", "reach": 0.01}}]})"});
    live::Hub hub;
    live::Driver driver(failing, hub, {});
    for (int k = 0; k < 400 && !driver.paused(); ++k) driver.advance();
    EXPECT_TRUE(driver.paused());
    nlohmann::json failure;
    live::Message message;
    while (hub.messages.pop(message))
        if (message.kind == live::MessageKind::text) {
            const auto json = nlohmann::json::parse(message.text);
            if (json["type"] == "failure") failure = json;
        }
    ASSERT_FALSE(failure.is_null());
    EXPECT_NEAR(failure["time"].get<double>(), 1.0, 0.02);
    EXPECT_NE(failure["reason"].get<std::string>().find("timeline, 1 s, join"), std::string::npos)
        << failure.dump();
    EXPECT_NE(failure["remedy"].get<std::string>(), "");
    EXPECT_EQ(failure["restore_point"], "start");
}

TEST(LiveShow, recordings_are_shown_as_they_are_and_sought_within_a_tenth_of_a_second) {
    const LiveFolder folder;
    const std::string file = folder.file("play.hwr");
    {
        Session session({.scene = "scenes/anchor_contact.json", .record = file});
        for (int k = 0; k < 240; ++k) {
            if (k == 100) session.set_input("ahts1/tow_speed", -0.5);
            ASSERT_EQ(session.step(), Status::ok);
        }
        session.finish();
    }
    const record::Recording recording = record::Recording::open(file);
    live::Hub hub;
    live::Player player(recording, hub);
    EXPECT_EQ(player.fault(), "");
    const live::Role watcher = live::watcher();
    live::Server server(hub, {.port = 0, .roles = {watcher}, .recording = true});
    std::atomic<bool> stop{false};
    std::thread thread([&] { player.run([&] { return stop.load(); }); });
    LiveClient client(server.port(), watcher.token);
    (void)client.wait_for("state");
    EXPECT_EQ(client.state()["range"][1], 4.0);
    tell(client, 1, {{"type", "pause"}});
    double worst = 0.0;
    int id = 2;
    for (const double time : {3.5, 0.25, 2.0, 1.0}) {
        const auto begun = std::chrono::steady_clock::now();
        client.say({{"type", "seek"}, {"time", time}, {"id", id++}});
        ReadFrame shown;
        for (int k = 0; k < 100; ++k) {
            shown = read_frame(client.frame());
            if (std::abs(shown.time - time) < 1e-9) break;
        }
        worst = std::max(
            worst, std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count());
        const record::Frame frame = recording.frame(static_cast<std::size_t>(shown.step));
        ASSERT_NEAR(frame.time, time, 1e-9);
        const auto& origin = client.scene()["origin"];
        for (const auto& body : client.scene()["bodies"]) {
            if (body["kind"] != "rigid") continue;
            const Pose& pose = frame.poses[body["id"].get<std::size_t>()];
            const auto at = 7 * body["slot"].get<std::size_t>();
            for (int k = 0; k < 3; ++k)
                EXPECT_EQ(shown.rigid[at + static_cast<std::size_t>(k)],
                          static_cast<float>(pose.position[k] -
                                             origin[static_cast<std::size_t>(k)].get<double>()));
            EXPECT_EQ(shown.rigid[at + 3], static_cast<float>(pose.orientation.w()));
        }
        std::size_t piece = 0;
        for (std::size_t w = 0; w < shown.counts.size(); ++w) {
            const std::string name = client.scene()["wires"][w]["name"];
            for (const record::RecordedCable& cable : recording.cables)
                if (cable.name == name) {
                    EXPECT_EQ(shown.tensions[piece],
                              frame.tensions[static_cast<std::size_t>(cable.first_element)]);
                }
            piece += shown.counts[w] == 0 ? 0 : shown.counts[w] - 1;
        }
        for (std::size_t k = 0; k < shown.inputs.size(); ++k)
            if (client.scene()["inputs"][k]["name"] == "ahts1/tow_speed") {
                EXPECT_EQ(shown.inputs[k], shown.step > 100 ? -0.5F : 0.0F);
            }
    }
    client.say({{"type", "set"}, {"input", "ahts1/tow_speed"}, {"value", 0.1}, {"id", 50}});
    EXPECT_EQ(client.answer_to(50)["reason"], "a recording has no levers");
    EXPECT_LT(worst, 0.1);
    std::printf("a frame that was sought was there after %.1f ms at most\n", 1e3 * worst);
    stop = true;
    thread.join();
}

}  // namespace
}  // namespace hawser::test
