// SPDX-License-Identifier: Apache-2.0
/// `hawser view` from the command line: addresses, a response, the end by SIGINT, and rejected
/// options.
#include "cli/program.h"

#include <nlohmann/json.hpp>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <regex>
#include <thread>

namespace hawser::test {
namespace {

namespace fs = std::filesystem;

/// A port of this machine that this process uses, or used before.
class Port {
  public:
    Port() : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
        sockaddr_in at{};
        at.sin_family = AF_INET;
        at.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof at;
        EXPECT_EQ(::bind(socket_, reinterpret_cast<sockaddr*>(&at), size), 0);
        EXPECT_EQ(::listen(socket_, 1), 0);
        EXPECT_EQ(::getsockname(socket_, reinterpret_cast<sockaddr*>(&at), &size), 0);
        number_ = ntohs(at.sin_port);
    }
    ~Port() { free(); }
    Port(const Port&) = delete;
    Port& operator=(const Port&) = delete;
    void free() {
        if (socket_ >= 0) ::close(socket_);
        socket_ = -1;
    }
    [[nodiscard]] std::string text() const { return std::to_string(number_); }
    [[nodiscard]] std::uint16_t number() const { return number_; }

  private:
    int socket_;
    std::uint16_t number_ = 0;
};

/// Return the first line of a server's response to GET PATH, retried for some seconds; "" without a
/// response.
std::string first_line(std::uint16_t port, const std::string& path = "/") {
    for (int tried = 0; tried < 100; ++tried) {
        const int line = ::socket(AF_INET, SOCK_STREAM, 0);
        sockaddr_in at{};
        at.sin_family = AF_INET;
        at.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        at.sin_port = htons(port);
        std::string got;
        if (::connect(line, reinterpret_cast<sockaddr*>(&at), sizeof at) == 0) {
            const std::string asked =
                "GET " + path + " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port) + "\r\n\r\n";
            if (::send(line, asked.data(), asked.size(), MSG_NOSIGNAL) > 0) {
                char bytes[256];
                const auto count = ::recv(line, bytes, sizeof bytes, 0);
                if (count > 0) got.assign(bytes, static_cast<std::size_t>(count));
            }
        }
        ::close(line);
        if (!got.empty()) return got.substr(0, got.find('\r'));
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return {};
}

/// A WebSocket client at /live that sends nothing and never closes the connection.
class Silent {
  public:
    explicit Silent(std::uint16_t port) {
        for (int tried = 0; tried < 100 && answer_.empty(); ++tried) {
            socket_ = ::socket(AF_INET, SOCK_STREAM, 0);
            sockaddr_in at{};
            at.sin_family = AF_INET;
            at.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
            at.sin_port = htons(port);
            if (::connect(socket_, reinterpret_cast<sockaddr*>(&at), sizeof at) == 0) {
                ask(port);
            } else {
                ::close(socket_);
                std::this_thread::sleep_for(std::chrono::milliseconds(50));
            }
        }
    }
    ~Silent() { ::close(socket_); }
    Silent(const Silent&) = delete;
    Silent& operator=(const Silent&) = delete;
    [[nodiscard]] const std::string& answer() const { return answer_; }

  private:
    void ask(std::uint16_t port) {
        const std::string asked =
            "GET /live HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port) +
            "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
            "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n";
        if (::send(socket_, asked.data(), asked.size(), MSG_NOSIGNAL) <= 0) return;
        char bytes[256];
        const auto count = ::recv(socket_, bytes, sizeof bytes, 0);
        if (count > 0) answer_.assign(bytes, static_cast<std::size_t>(count));
        answer_ = answer_.substr(0, answer_.find('\r'));
    }

    int socket_ = -1;
    std::string answer_;
};

TEST(View, ASocketThatNeverHangsUpDoesNotCostTheReport) {
    const fs::path folder = test_folder();
    const std::string report = (folder / "r.html").string(), score = (folder / "s.json").string();
    Port port;
    port.free();
    Outcome outcome;
    std::thread program([&] {
        outcome = run_program({"view", "exercises/tow_out.json", "--port", port.text(), "--report",
                               report, "--summary", score},
                              3.0);
    });
    const Silent silent(port.number());
    program.join();
    EXPECT_EQ(silent.answer(), "HTTP/1.1 101 Switching Protocols");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_TRUE(fs::exists(score));
    EXPECT_TRUE(fs::exists(report));
}

TEST(View, ServesASceneUntilItIsInterrupted) {
    Port port;
    port.free();
    Outcome outcome;
    std::thread program([&] {
        outcome = run_program({"view", "scenes/pendulum.json", "--port", port.text()}, 2.0);
    });
    EXPECT_EQ(first_line(port.number()), "HTTP/1.1 200 OK");
    // A program without its page says how to build it; one with its page does not.
    const bool page = first_line(port.number(), "/view.js") == "HTTP/1.1 200 OK";
    program.join();
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err.find("make view") == std::string::npos, page) << outcome.err;
    for (const char* role : {"instructor", "watcher"})
        EXPECT_TRUE(std::regex_search(
            outcome.out, std::regex(std::string(role) + " +http://127\\.0\\.0\\.1:" + port.text() +
                                    "/#token=[0-9a-f]{32}\n")))
            << outcome.out;
    EXPECT_NE(outcome.out.find(" s in "), std::string::npos) << outcome.out;
}

TEST(View, AnExerciseHasAnAddressForEachStationAndLeavesReportAndScore) {
    const fs::path folder = test_folder();
    const std::string report = (folder / "r.html").string(), score = (folder / "s.json").string(),
                      file = (folder / "run.hwr").string();
    const Outcome outcome = run_program({"view", "exercises/tow_out.json", "--port", "0", "--go",
                                         "--report", report, "--summary", score, "--record", file},
                                        2.5);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    for (const char* role : {"instructor", "bridge", "winch", "watcher"})
        EXPECT_TRUE(std::regex_search(outcome.out,
                                      std::regex("(^|\n)" + std::string(role) + " +http://127")))
            << outcome.out;
    const auto live = nlohmann::json::parse(read_text(score));
    EXPECT_EQ(live["outcome"], "failed");
    EXPECT_EQ(live["end"], "interrupted");
    EXPECT_NE(read_text(report).find("interrupted"), std::string::npos);
    const std::string again = (folder / "again.json").string();
    const Outcome replay = run_program({"exercise", "exercises/tow_out.json", "--replay", file,
                                        "--threads", "2", "--summary", again, "--quiet"});
    EXPECT_EQ(replay.code, 4) << replay.err;  // verification failed
    EXPECT_EQ(read_text(again), read_text(score));
}

TEST(View, ATakenPortProposesAFreeOne) {
    const Port port;
    const Outcome outcome = run_program({"view", "scenes/pendulum.json", "--port", port.text()});
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.err.find("port " + port.text() + " of 127.0.0.1 is taken; free is --port "),
              std::string::npos)
        << outcome.err;
}

TEST(View, RefusesWhatItCannotShowWithTheReason) {
    const fs::path folder = test_folder();
    const std::string broken = (folder / "broken.hwr").string();
    write_text(broken, "HAWSERRC and nothing that follows from it");
    const struct {
        std::vector<std::string> arguments;
        const char* reason;
    } cases[] = {
        {{broken}, "broken.hwr: "},
        {{"scenes/pendulum.json", "--report", (folder / "r.html").string()},
         "a scene has no score"},
        {{"exercises/tow_out.json", "--restore", broken}, "an exercise begins at its start"},
        {{"scenes/pendulun.json"}, "pendulun.json"},
        {{"scenes/pendulum.json", "--listen", "here"}, "no address in numbers"},
    };
    for (const auto& one : cases) {
        std::vector<std::string> arguments{"view", "--port", "0"};
        arguments.insert(arguments.end(), one.arguments.begin(), one.arguments.end());
        const Outcome outcome = run_program(arguments);
        EXPECT_EQ(outcome.code, 1) << one.reason;
        EXPECT_NE(outcome.err.find(one.reason), std::string::npos) << outcome.err;
    }
    // A recording of another format: the message contains the reason.
    const std::string run = (folder / "run.hwr").string();
    ASSERT_EQ(run_program(
                  {"run", "scenes/pendulum.json", "--duration", "0.1", "--record", run, "--quiet"})
                  .code,
              0);
    damage(run, 8);
    const Outcome other = run_program({"view", run, "--port", "0"});
    EXPECT_EQ(other.code, 1);
    EXPECT_NE(other.err.find("recording format "), std::string::npos) << other.err;
}

}  // namespace
}  // namespace hawser::test
