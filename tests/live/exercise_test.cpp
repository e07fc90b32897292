// SPDX-License-Identifier: Apache-2.0
/// An exercise driven over the socket by an instructor, a station and an observer: permissions of
/// each role, and messages to each. Page, headless run and replay give the same score.
#include "exercise/small_exercise.h"
#include "live/client.h"
#include "live/debriefing.h"
#include "live/driver.h"
#include "live/server.h"

#include <hawser/recording.h>

#include <atomic>
#include <map>
#include <thread>

namespace hawser::test {
namespace {

using nlohmann::json;

/// `hawser view EXERCISE` without its command line. Paused: the test requests steps, so that a run
/// without a page can get equal commands at equal steps.
class ShownExercise {
  public:
    ShownExercise(const Yard& yard, const std::string& text, const std::string& record)
        : own(yard.load(text), {.record = record}),
          roles(live::roles_of(own.loaded.exercise)),
          driver(*own.session, hub,
                 {.recording = record,
                  .paused = true,
                  .exercise = &own.loaded.exercise,
                  .run = own.run.get()}),
          server(hub, {.port = 0, .roles = roles}),
          thread_([this] { driver.run([this] { return stop_.load(); }); }) {}
    ~ShownExercise() { stop(); }
    void stop() {
        stop_ = true;
        if (thread_.joinable()) thread_.join();
    }
    [[nodiscard]] std::string token(const std::string& role) const {
        for (const live::Role& one : roles)
            if (one.name == role) return one.token;
        return {};
    }

    Running own;
    live::Hub hub;
    std::vector<live::Role> roles;
    live::Driver driver;
    live::Server server;

  private:
    std::atomic<bool> stop_{false};
    std::thread thread_;
};

/// A client that keeps the last message of each type, and all events.
class Hearer {
  public:
    Hearer(const ShownExercise& shown, const std::string& role)
        : client_(shown.server.port(), shown.token(role)) {
        hear([&] { return last.contains("exercise"); });
    }
    void hear(const std::function<bool()>& enough) {
        const double late = live::clock_now() + 10.0;  // [s]
        while (!enough() && live::clock_now() < late) {
            const Got got = client_.next(5.0);
            if (got.kind == Got::frame) frame = read_frame(got.bytes);
            if (got.kind != Got::text) continue;
            if (got.json["type"] == "event") events.push_back(got.json);
            last[got.json["type"]] = got.json;
            if (got.json.contains("id")) answers[got.json["id"]] = got.json;
        }
        EXPECT_TRUE(enough()) << last["exercise"].dump();
    }
    json ask(json message) {
        const int id = ++id_;
        message["id"] = id;
        client_.say(message);
        hear([&] { return answers.contains(id); });
        return answers[id];
    }
    void tell(const json& message) {
        const json answer = ask(message);
        EXPECT_EQ(answer["type"], "ok") << message.dump() << answer.dump();
    }
    std::string refused(const json& message) {
        const json answer = ask(message);
        EXPECT_EQ(answer["type"], "error") << message.dump();
        return answer.value("reason", "");
    }
    void steps(int count, std::int64_t to) {
        tell({{"type", "step"}, {"count", count}});
        hear([&] { return frame.step == to; });
    }
    /// Count events of a kind.
    [[nodiscard]] int heard(const std::string& kind) const {
        int count = 0;
        for (const json& event : events) count += event["kind"] == kind ? 1 : 0;
        return count;
    }
    [[nodiscard]] float output(const std::string& name) {
        const auto& outputs = last["scene"]["outputs"];
        for (std::size_t k = 0; k < outputs.size(); ++k)
            if (outputs[k]["name"] == name) return frame.outputs[k];
        ADD_FAILURE() << "no output " << name;
        return 0.0F;
    }

    std::map<std::string, json> last;
    std::map<int, json> answers;
    std::vector<json> events;
    ReadFrame frame;

  private:
    LiveClient client_;
    int id_ = 0;
};

/// Make an exercise of half a minute instead of six seconds.
std::string long_exercise() {
    std::string text = kSmallExercise;
    const auto replace = [&](const std::string& from, const std::string& to) {
        const auto at = text.find(from);
        ASSERT_NE(at, std::string::npos);
        text.replace(at, from.size(), to);
    };
    replace(R"("duration": 6)", R"("duration": 30, "until_done": false)");
    return text;
}

json set(const char* input, double value) {
    return {{"type", "set"}, {"input", input}, {"value", value}};
}

TEST(LiveExercise, each_role_does_and_hears_what_is_its_own) {
    const Yard yard;
    ShownExercise shown(yard, long_exercise(), "");
    ASSERT_EQ(shown.roles.size(), 4U);
    Hearer instructor(shown, "instructor"), winch(shown, "winch"), watcher(shown, "watcher");
    EXPECT_EQ(winch.last["scene"]["role"]["inputs"],
              json({"hoist.mode", "hoist.speed", "hoist.brake", "heave_half"}));
    EXPECT_EQ(winch.last["exercise"]["displays"], json({"load_z", "hoist.wire_left"}));
    EXPECT_EQ(winch.last["exercise"]["possible"], 10.0);
    winch.tell(set("hoist.speed", -0.8));
    EXPECT_EQ(winch.refused(set("push", 1.0)), "the role winch does not have the input \"push\"");
    EXPECT_EQ(winch.refused({{"type", "fault"}, {"name", "frozen"}, {"active", true}}),
              "the role winch may not fault");
    EXPECT_EQ(watcher.refused({{"type", "end"}}), "the role watcher may not end");
    EXPECT_EQ(instructor.refused({{"type", "fault"}, {"name", "frosen"}, {"active", true}}),
              "there is no fault \"frosen\"; nearest: \"frozen\"");
    EXPECT_EQ(instructor.refused({{"type", "fault"}, {"name", "frozen"}, {"active", 1}}),
              "active is to be true or false");
    instructor.steps(20, 20);
    const float before = instructor.output("load_z");
    instructor.tell({{"type", "fault"}, {"name", "frozen"}, {"active", true}});
    instructor.hear([&] { return instructor.heard("fault") == 1; });
    const auto active = [&](const char* name) {
        for (const json& fault : instructor.last["faults"]["faults"])
            if (fault["name"] == name) return fault["active"].get<bool>();
        return false;
    };
    instructor.hear([&] { return active("frozen"); });
    instructor.steps(40, 60);
    // The display is frozen, the load moves on.
    winch.hear([&] { return winch.frame.step == 60; });
    EXPECT_EQ(winch.output("load_z"), before);
    instructor.tell({{"type", "fault"}, {"name", "frozen"}, {"active", false}});
    instructor.hear([&] { return !active("frozen"); });
    instructor.steps(1, 61);
    EXPECT_GT(instructor.output("load_z"), before + 0.1F);
    // The tow breaks by itself at 1.5 s: all roles get the penalty, the instructor also the fault.
    instructor.steps(30, 91);
    instructor.hear([&] { return instructor.last["exercise"]["penalties"][0]["points"] == -3.0; });
    EXPECT_EQ(instructor.refused({{"type", "fault"}, {"name", "part"}, {"active", false}}),
              "the fault \"part\": a broken line stays broken");
    watcher.hear([&] { return watcher.heard("penalty") >= 1 && watcher.frame.step == 91; });
    EXPECT_EQ(watcher.last["exercise"]["penalties"][0]["times"], 1);
    EXPECT_EQ(instructor.heard("fault"), 2);
    EXPECT_EQ(watcher.heard("fault") + watcher.heard("fault_end"), 0);
    EXPECT_FALSE(watcher.last.contains("faults"));
    for (const json& event : watcher.events)
        EXPECT_EQ(event["words"].get<std::string>().find("fault"), std::string::npos)
            << event.dump();
    instructor.tell({{"type", "end"}});
    watcher.hear([&] { return watcher.last["exercise"]["outcome"] != "running"; });
    EXPECT_EQ(watcher.last["exercise"]["end"], "ended by the instructor");
    EXPECT_EQ(instructor.refused({{"type", "end"}}), "the exercise has ended already");
}

/// Return a message of each kind with all keys that it needs. @param load  Id of a body.
json message_of(live::CommandKind kind, int load) {
    using live::CommandKind;
    json out{{"type", live::to_string(kind)}};
    if (kind == CommandKind::set) out.update({{"input", "push"}, {"value", 1.0}});
    if (kind == CommandKind::rate) out["value"] = 2.0;
    if (kind == CommandKind::drag) out.update({{"body", load}, {"target", {0, 0, 5}}});
    if (kind == CommandKind::part) out.update({{"wire", "tow"}, {"s", 0.5}});
    if (kind == CommandKind::save) out["name"] = "mine";
    if (kind == CommandKind::restore) out["name"] = "start";
    if (kind == CommandKind::pick) out["body"] = load;
    if (kind == CommandKind::seek) out["time"] = 0.0;
    if (kind == CommandKind::fault) out.update({{"name", "stuck"}, {"active", true}});
    if (kind == CommandKind::note) out["text"] = "a remark";
    return out;
}

/// Each message of the table in docs/live.md that only the instructor may send is refused for a
/// station and for a watcher. The table of this test is written from that page.
TEST(LiveExercise, a_trainee_may_send_no_message_of_the_instructor) {
    const std::map<std::string, bool> for_trainees{
        {"set", false},   {"pause", false},   {"resume", false},  {"step", false},
        {"rate", false},  {"drag", false},    {"release", false}, {"part", false},
        {"save", false},  {"restore", false}, {"pick", true},     {"seek", true},
        {"fault", false}, {"end", false},     {"note", false},    {"report", false}};
    const Yard yard;
    ShownExercise shown(yard, long_exercise(), "");
    Hearer instructor(shown, "instructor"), winch(shown, "winch");
    int load = -1;
    for (const auto& body : instructor.last["scene"]["bodies"])
        if (body["name"] == "load") load = body["id"].get<int>();
    const std::uint64_t before = shown.own.session->world().state().motion_hash();
    std::size_t seen = 0;
    for (const live::CommandKind kind : live::message_kinds()) {
        const json message = message_of(kind, load);
        const std::string type = message["type"];
        ASSERT_TRUE(for_trainees.contains(type)) << "add " << type << " to the table";
        ++seen;
        // A connection closes at the third refusal: each message has one of its own.
        for (const char* role : {"winch", "watcher"}) {
            if (for_trainees.at(type)) continue;
            Hearer trainee(shown, role);
            EXPECT_NE(trainee.refused(message).find("the role "), std::string::npos) << type;
        }
    }
    EXPECT_EQ(seen, for_trainees.size());
    // Nothing has happened: no step, no event, no fault, no restore point, and the same state.
    EXPECT_EQ(instructor.frame.step, 0);
    EXPECT_TRUE(instructor.events.empty());
    EXPECT_EQ(instructor.last["state"]["restore_points"].size(), 1U);
    EXPECT_EQ(instructor.last["exercise"]["outcome"], "running");
    EXPECT_EQ(shown.own.session->world().state().motion_hash(), before);
    winch.tell(set("hoist.speed", 0.1));
    instructor.tell({{"type", "note"}, {"text", "hauls too fast"}});
    winch.hear([&] { return winch.heard("command") == 1; });
    EXPECT_EQ(winch.events.back()["words"], "instructor note: hauls too fast");
}

TEST(LiveExercise, a_scene_has_no_faults) {
    Session session({.scene = "scenes/pendulum.json"});
    live::Hub hub;
    live::Driver driver(session, hub, {.paused = true});
    live::Command command;
    command.kind = live::CommandKind::fault;
    command.client = 7;
    (void)command.name.assign("blackout");
    (void)hub.commands.push(live::Command(command));
    driver.advance();
    std::string reason;
    live::Message message;
    while (hub.messages.pop(message))
        if (message.to == 7) reason = json::parse(message.text)["reason"];
    EXPECT_EQ(reason, "this is a scene without an exercise: it has no faults and no end");
}

/// An action and its step, with and without a page.
struct SystemAction {
    std::int64_t step;
    json message;
    const char* by;
};

std::vector<SystemAction> half_a_minute(int load) {
    const json drag = {{"type", "drag"}, {"body", load}, {"target", {2, 12, 7}}};
    return {{0, {{"type", "save"}, {"name", "first"}}, "instructor"},
            {10, set("hoist.speed", -0.8), "winch"},
            {40, set("push", 120.0), "deck"},
            {50, drag, "instructor"},
            {65, {{"type", "release"}}, "instructor"},
            {70, {{"type", "save"}, {"name", "lifted"}}, "instructor"},
            {80, {{"type", "part"}, {"wire", "tow"}, {"s", 0.7}}, "instructor"},
            {90, {{"type", "fault"}, {"name", "late"}, {"active", true}}, "instructor"},
            {120, set("hoist.speed", 0.4), "winch"},
            {200, {{"type", "restore"}, {"name", "lifted"}}, "instructor"},
            {110, set("hoist.speed", 0.1), "winch"},
            {260, {{"type", "fault"}, {"name", "stuck"}, {"active", true}}, "instructor"},
            {300, set("push", -200.0), "deck"},
            {400, {{"type", "fault"}, {"name", "stuck"}, {"active", false}}, "instructor"}};
}

/// The exercise without a server: the actions of the driver for each message, written out.
class Headless {
  public:
    explicit Headless(Running& own) : own_(own) { keep("start"); }
    void to(std::int64_t step) {
        while (own_.session->world().step_count() < step) {
            drags_.before_step(own_.session->world());
            ASSERT_EQ(own_.run->step(), Status::ok);
        }
    }
    void perform(const SystemAction& action) {
        World& world = own_.session->world();
        const std::string type = action.message["type"];
        const std::string name = action.message.value("name", "");
        if (type == "set") {
            own_.run->set_input(action.by, action.message["input"].get<std::string>(),
                                action.message["value"]);
        } else if (type == "drag") {
            const auto at = action.message["target"].get<std::vector<double>>();
            for (const BodyId id : world.bodies())
                if (id.index == action.message["body"].get<int>())
                    drags_.begin(world, 1, id, Vec3::Zero(), Vec3(at.data()), 0.0);
        } else if (type == "release") {
            drags_.end(world, 1);
        } else if (type == "part") {
            const WireId wire = world.wires().find(action.message["wire"].get<std::string>());
            world.wires().part(wire,
                               action.message["s"].get<double>() * world.wires().length(wire));
        } else if (type == "fault") {
            if (action.message["active"])
                own_.run->trigger(action.by, name);
            else
                own_.run->clear(action.by, name);
        } else if (type == "save") {
            keep(name);
        } else if (type == "restore") {
            drags_.end_all(world);
            own_.session->restore(points_[name].made_of, points_[name].state);
            own_.run->back_to(points_[name].mark);
        }
    }

  private:
    struct Point {
        Structure made_of;
        std::vector<std::byte> state;
        int mark = 0;
    };
    void keep(const std::string& name) {
        drags_.remove_forces(own_.session->world());
        const World& world = own_.session->world();
        points_[name] = {world.state().structure(), world.state().save(), own_.run->mark()};
    }
    Running& own_;
    live::Drags drags_;
    std::map<std::string, Point> points_;
};

/// Compare the debriefing of a recording with the last message of the live exercise.
void expect_same_debriefing(const exercise::Rescored& again, const json& live) {
    const json told =
        live::debriefing_json(again.exercise, again.result, again.curves, again.requests, 500);
    for (const char* key : {"points", "possible", "pass", "outcome", "end"})
        EXPECT_EQ(told[key], live[key]) << key;
    ASSERT_EQ(told["goals"].size(), live["goals"].size());
    for (std::size_t k = 0; k < live["goals"].size(); ++k)
        for (const char* key : {"name", "points", "reached", "possible"})
            EXPECT_EQ(told["goals"][k][key], live["goals"][k][key]) << key;
    for (std::size_t k = 0; k < live["penalties"].size(); ++k)
        for (const char* key : {"name", "points", "times"})
            EXPECT_EQ(told["penalties"][k][key], live["penalties"][k][key]) << key;
    EXPECT_EQ(told["entries"].size(), again.result.entries.size());
    ASSERT_EQ(told["values"].size(), told["displays"].size());
    for (const json& curve : told["values"]) EXPECT_EQ(curve.size(), told["times"].size());
    EXPECT_GE(told["times"].size(), 250U);
    EXPECT_LE(told["times"].size(), 1000U);
    // The run lasts 30 s; its last sample is kept.
    EXPECT_EQ(told["times"].back().get<double>(), again.curves.time.back());
    std::map<std::string, int> asked;
    for (const json& request : told["controls"])
        ++asked[request[1].get<std::string>() + " " + request[2].get<std::string>()];
    EXPECT_EQ(asked, (std::map<std::string, int>{{"winch hoist.speed", 3}, {"deck push", 2}}));
}

/// Controls of two stations, a drag, a broken line, faults and a restore.
TEST(LiveExercise, page_headless_run_and_replay_have_the_same_score) {
    constexpr std::int64_t kEnd = 1500;  // steps of 0.02 s: half a minute
    const Yard yard;
    const std::string text = long_exercise(), file = yard.file("page.hwr");
    std::string page, by_page;
    std::uint64_t hash = 0;
    int load = -1;
    std::vector<SystemAction> actions;
    {
        ShownExercise shown(yard, text, file);
        std::map<std::string, std::unique_ptr<Hearer>> who;
        for (const char* role : {"instructor", "winch", "deck"})
            who[role] = std::make_unique<Hearer>(shown, role);
        Hearer& instructor = *who["instructor"];
        for (const auto& body : instructor.last["scene"]["bodies"])
            if (body["name"] == "load") load = body["id"].get<int>();
        actions = half_a_minute(load);
        instructor.tell({{"type", "rate"}, {"value", 10}});
        std::int64_t now = 0;
        const auto go_to = [&](std::int64_t to) {
            for (; now < to; now += std::min<std::int64_t>(1000, to - now))
                instructor.steps(static_cast<int>(std::min<std::int64_t>(1000, to - now)),
                                 now + std::min<std::int64_t>(1000, to - now));
        };
        for (const SystemAction& action : actions) {
            go_to(action.step);
            who[action.by]->tell(action.message);
            if (action.message["type"] == "restore") {
                now = 70;
                instructor.hear([&] { return instructor.frame.step == now; });
            }
        }
        go_to(kEnd);
        instructor.hear([&] { return instructor.last["exercise"]["outcome"] != "running"; });
        EXPECT_EQ(instructor.last["exercise"]["end"], "the time is over");
        by_page = instructor.last["exercise"].dump();
        shown.stop();
        page = exercise::to_json(shown.own.run->result());
        const exercise::Result& result = shown.own.run->result();
        const json& reported = instructor.last["exercise"];
        EXPECT_EQ(reported["points"].get<double>(), result.points);
        EXPECT_EQ(reported["outcome"], exercise::to_string(result.outcome));
        for (std::size_t k = 0; k < result.goals.size(); ++k)
            EXPECT_EQ(reported["goals"][k]["reached"].is_null(), !result.goals[k].reached);
        for (std::size_t k = 0; k < result.penalties.size(); ++k) {
            EXPECT_EQ(reported["penalties"][k]["points"].get<double>(), result.penalties[k].points);
            EXPECT_EQ(reported["penalties"][k]["times"], result.penalties[k].times);
        }
        EXPECT_EQ(result.penalties[0].times, 1);
        hash = shown.own.session->world().state().motion_hash();
        shown.own.session->finish();
    }
    {
        Running own(yard.load(text));
        Headless headless(own);
        for (const SystemAction& action : actions) {
            headless.to(action.step);
            headless.perform(action);
        }
        headless.to(kEnd);
        EXPECT_EQ(exercise::to_json(own.run->result()), page);
        EXPECT_EQ(own.session->world().state().motion_hash(), hash);
    }
    const record::Recording recording = record::Recording::open(file);
    EXPECT_EQ(recording.takes.size(), 1U);
    for (const int threads : {1, 2}) {
        const exercise::Rescored again = exercise::rescore(recording, threads);
        EXPECT_TRUE(again.same) << again.difference;  // hash of every frame, and of the end
        EXPECT_EQ(exercise::to_json(again.result), page);
        expect_same_debriefing(again, json::parse(by_page));
    }
    const json score = json::parse(page);
    std::printf("page, headless run and replay with 1 and 2 threads: %.6g points, %zu entries\n",
                score["points"].get<double>(), score["entries"].size());
}

}  // namespace
}  // namespace hawser::test
