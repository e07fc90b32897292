// SPDX-License-Identifier: Apache-2.0
/// Messages of clients: accepted ones, rejected ones with the reason, and no other effects.
#include "live/command.h"

#include "live/roles.h"
#include "live/web_rules.h"
#include "support/sanitizer.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace hawser::test {
namespace {

using live::Command;
using live::CommandKind;
using live::Request;

Request taken(const std::string& text) {
    Request out;
    std::string reason;
    EXPECT_TRUE(live::parse(text, out, reason)) << text << ": " << reason;
    return out;
}

std::string refused(const std::string& text) {
    Request out;
    std::string reason;
    EXPECT_FALSE(live::parse(text, out, reason)) << text;
    EXPECT_TRUE(out.commands.empty());
    return reason;
}

const std::vector<std::string>& good_messages() {
    static const std::vector<std::string> all{
        R"({"type":"hello","version":1,"token":"0123456789abcdef0123456789abcdef"})",
        R"({"type":"set","input":"ahts1/tow_speed","value":-0.5,"id":7})",
        R"({"type":"set","inputs":[["a",1],["b",2.5e3]],"id":9007199254740992})",
        R"({"type":"pause"})",
        R"({"type":"step","count":12})",
        R"({"type":"rate","value":0.1})",
        R"({"type":"drag","body":4,"point":[1,2,3],"target":[4,5,6],"stiffness":1e4})",
        R"({"type":"drag","wire":2,"s":0.25,"target":[4,5,6]})",
        R"({"type":"release"})",
        R"({"type":"part","wire":"tow","s":0.5})",
        R"({"type":"save","name":"vor dem Schlepp \u2013 1"})",
        R"({"type":"restore","name":"start"})",
        R"({"type":"pick","joint":3})",
        R"({"type":"seek","time":12.5})"};
    return all;
}

TEST(LiveParser, takes_what_the_document_says) {
    const Request hello = taken(good_messages()[0]);
    EXPECT_TRUE(hello.hello);
    EXPECT_EQ(hello.token, "0123456789abcdef0123456789abcdef");
    const Request set = taken(good_messages()[1]);
    ASSERT_EQ(set.commands.size(), 1U);
    EXPECT_EQ(set.commands[0].kind, CommandKind::set);
    EXPECT_EQ(set.commands[0].name.view(), "ahts1/tow_speed");
    EXPECT_EQ(set.commands[0].value, -0.5);
    EXPECT_EQ(set.commands[0].id, 7);
    const Request two = taken(good_messages()[2]);
    ASSERT_EQ(two.commands.size(), 2U);
    EXPECT_FALSE(two.commands[0].answer);
    EXPECT_TRUE(two.commands[1].answer);
    const Command drag = taken(good_messages()[6]).commands.at(0);
    EXPECT_EQ(drag.target_id, 4);
    EXPECT_EQ(drag.point[2], 3.0);
    EXPECT_EQ(drag.target[0], 4.0);
    EXPECT_EQ(drag.stiffness, 1e4);
    EXPECT_TRUE(taken(good_messages()[7]).commands.at(0).by_wire);
    EXPECT_TRUE(taken(good_messages()[9]).commands.at(0).by_name);
    EXPECT_TRUE(taken(good_messages()[12]).commands.at(0).by_joint);
    for (const std::string& message : good_messages()) (void)taken(message);
}

TEST(LiveParser, names_what_is_wrong) {
    EXPECT_EQ(refused("{"), "this is not JSON");
    EXPECT_EQ(refused(R"({"type":"set","input":"a","value":1,"value":2})"),
              "the key \"value\" is given twice");
    EXPECT_EQ(refused(R"({"type":"hello","type":"pause"})"), "the key \"type\" is given twice");
    EXPECT_EQ(refused("[1]"), "a message is a JSON object");
    EXPECT_EQ(refused("{}"), "a message has a type");
    EXPECT_EQ(refused(R"({"type":"puase"})"),
              "there is no message of the type \"puase\"; nearest: \"pause\"");
    EXPECT_EQ(refused(R"({"type":"pause","now":1})"), "pause has no key \"now\"");
    EXPECT_EQ(refused(R"({"type":"rate","value":11})"), "value is to be from 0.1 to 10.0");
    EXPECT_EQ(refused(R"({"type":"step","count":1.5})"), "count is to be a whole number");
    EXPECT_EQ(refused(R"({"type":"set","input":"a"})"), "value is missing");
    EXPECT_EQ(refused(R"({"type":"set","input":"a","value":1e999})"), "this is not JSON");
    EXPECT_EQ(refused(R"({"type":"set","input":"a","value":"1"})"),
              "value is to be a finite number");
    EXPECT_EQ(refused(R"({"type":"set","input":"a","value":1,"inputs":[["a",1]]})"),
              "set needs either input and value, or inputs");
    EXPECT_EQ(refused(R"({"type":"drag","body":1,"wire":1,"target":[0,0,0]})"),
              "either body or wire is to be given");
    EXPECT_EQ(refused(R"({"type":"drag","body":1,"target":[0,0]})"),
              "target is to be three numbers");
    EXPECT_EQ(refused(R"({"type":"drag","body":1,"target":[0,0,1e300]})"),
              "target is farther away than 10,000 km");
    EXPECT_EQ(refused(R"({"type":"pick","body":-1})"), "body is to be from 0.0 to 2147483647.0");
    EXPECT_EQ(refused(R"({"type":"save","name":""})"), "name is to have 1 to 64 bytes");
    EXPECT_EQ(refused(R"({"type":"hello","version":1})"), "hello needs a token");
    EXPECT_EQ(refused(std::string(20000, ' ')), "a message has at most 16 kB");
    EXPECT_EQ(refused("{\"type\":\"save\",\"name\":\"\xff\xfe\"}"), "this is not JSON");
    std::string many = R"({"type":"set","inputs":[)";
    for (int k = 0; k < 65; ++k) many += std::string(k ? "," : "") + "[\"a\",1]";
    EXPECT_EQ(refused(many + "]}"),
              "inputs is to be a list of 1 to 64 pairs of a name and a value");
}

/// Check that a text is accepted or rejected, and that an accepted one only has numbers within
/// their ranges.
void expect_sane(const std::string& text) {
    Request out;
    std::string reason;
    if (!live::parse(text, out, reason)) {
        EXPECT_FALSE(reason.empty());
        return;
    }
    EXPECT_LE(out.commands.size(), live::kMaxInputs);
    for (const Command& command : out.commands) {
        EXPECT_TRUE(std::isfinite(command.value));
        EXPECT_TRUE(std::isfinite(command.stiffness));
        for (const double x : command.target) EXPECT_LE(std::abs(x), 1e7);
        for (const double x : command.point) EXPECT_LE(std::abs(x), 1e7);
    }
}

TEST(LiveParser, stands_random_and_mutated_messages) {
    std::mt19937_64 dice(first_seed(20261126));
    const int rounds = by_tier(kSanitized ? 1'000 : 5'000, kSanitized ? 4'000 : 40'000, 1'000'000);
    const std::string pieces = "{}[]\",:\\u0e+-.19aset \n\t\xff\x80";
    for (int round = 0; round < rounds; ++round) {
        std::string text;
        if (round % 4 == 0) {
            text.resize(dice() % 200);
            for (char& c : text)
                c = round % 8 == 0 ? static_cast<char>(dice()) : pieces[dice() % pieces.size()];
        } else {
            text = good_messages()[dice() % good_messages().size()];
            for (std::uint64_t k = dice() % 4 + 1; k > 0 && !text.empty(); --k) {
                const std::size_t at = dice() % text.size();
                switch (dice() % 4) {
                    case 0:
                        text[at] = static_cast<char>(dice());
                        break;
                    case 1:
                        text.erase(at, dice() % 5);
                        break;
                    case 2:
                        text.insert(at, 1, pieces[dice() % pieces.size()]);
                        break;
                    default:
                        text.insert(at, good_messages()[dice() % good_messages().size()].substr(
                                            dice() % 10, dice() % 20));
                }
            }
        }
        expect_sane(text);
    }
    std::string deep(8000, '[');
    expect_sane("{\"type\":" + deep);
    expect_sane(deep + std::string(8000, ']'));
}

TEST(LiveRoles, may_do_what_is_theirs) {
    const live::Role instructor = live::instructor(), watcher = live::watcher();
    const live::Role deck{.name = "deck", .inputs = {"push"}, .token = live::make_token()};
    const Command push = taken(R"({"type":"set","input":"push","value":1})").commands.at(0);
    const Command lift = taken(R"({"type":"set","input":"lift","value":1})").commands.at(0);
    const Command pause = taken(R"({"type":"pause"})").commands.at(0);
    const Command pick = taken(R"({"type":"pick","body":1})").commands.at(0);
    EXPECT_EQ(live::rejection_reason(instructor, lift, false), "");
    EXPECT_EQ(live::rejection_reason(deck, push, false), "");
    EXPECT_EQ(live::rejection_reason(deck, lift, false),
              "the role deck does not have the input \"lift\"");
    EXPECT_EQ(live::rejection_reason(watcher, push, false),
              "the role watcher does not have the input \"push\"");
    EXPECT_EQ(live::rejection_reason(watcher, pause, false), "the role watcher may not pause");
    EXPECT_EQ(live::rejection_reason(watcher, pause, true), "");  // allowed for a recording
    EXPECT_EQ(live::rejection_reason(instructor, push, true), "a recording has no levers");
    EXPECT_EQ(live::rejection_reason(watcher, pick, false), "");
    const std::vector<live::Role> roles{instructor, watcher, deck};
    EXPECT_EQ(live::role_of(roles, deck.token), &roles[2]);
    EXPECT_EQ(live::role_of(roles, deck.token.substr(0, 31)), nullptr);
    EXPECT_EQ(live::role_of(roles, ""), nullptr);
    EXPECT_NE(instructor.token, live::instructor().token);
    EXPECT_EQ(instructor.token.size(), 32U);
}

TEST(LiveRules, answer_to_their_own_names_only) {
    const live::HostNames here = live::host_names("127.0.0.1", 8080, "bridge");
    EXPECT_TRUE(live::host_allowed(here, "127.0.0.1:8080"));
    EXPECT_TRUE(live::host_allowed(here, "LocalHost:8080"));
    for (const char* foreign : {"", "127.0.0.1", "127.0.0.1:8081", "evil.example:8080",
                                "bridge:8080", "127.0.0.1:8080.evil.example"})
        EXPECT_FALSE(live::host_allowed(here, foreign)) << foreign;
    const live::HostNames all = live::host_names("0.0.0.0", 8080, "bridge");
    EXPECT_TRUE(live::host_allowed(all, "192.168.1.7:8080"));
    EXPECT_TRUE(live::host_allowed(all, "bridge:8080"));
    EXPECT_TRUE(live::host_allowed(all, "[fe80::1]:8080"));
    EXPECT_FALSE(live::host_allowed(all, "evil.example:8080"));
    EXPECT_TRUE(live::origin_allowed("http://localhost:8080", "localhost:8080"));
    EXPECT_TRUE(live::origin_allowed("", "localhost:8080"));
    for (const char* foreign : {"https://localhost:8080", "http://evil.example", "null",
                                "http://localhost:8080.evil.example", "http://localhost:80801"})
        EXPECT_FALSE(live::origin_allowed(foreign, "localhost:8080")) << foreign;
    EXPECT_NE(live::file_at("/"), nullptr);
    EXPECT_NE(live::file_at("/?a=b"), nullptr);
    for (const char* none : {"", "/../etc/passwd", "//", "/etc/passwd", "/%2e%2e/", "\\"})
        EXPECT_EQ(live::file_at(none), nullptr) << none;
}

}  // namespace
}  // namespace hawser::test
