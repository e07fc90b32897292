// SPDX-License-Identifier: Apache-2.0
// hawser-bench view: a scene in real time, first by `hawser run --realtime`, then by `hawser view`
// with clients. Clients read, never read, or connect and disconnect. All are processes and sockets
// like those of users; figures of steps and frames are those in the frames.
#include "commands.h"
#include "fraction_of.h"
#include "verdict.h"

#include "live/client.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace hawser::bench {
namespace {

constexpr const char* kViewBenchFooter =
    R"(Exit code 1 where a bar is missed: 59 frames/s for each reader, age of a frame where it is read of at
most 10 ms in 95 of 100, step_ms.median at most 1.1 times that without clients, a frame made in 0.15 ms
(median), of at most 72 kB, 256 kB of memory a client. The bars are those of bench/scenes/frozen/anchor_contact.json on
processors without other work; clients run on the same ones.)";

struct ViewBench {
    std::string scene = "bench/scenes/frozen/anchor_contact.json", json;
    double seconds = 60.0;
    int readers = 6;
};

double wall() {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);  // the clock of the frames
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The program `hawser` in the same folder, with its output in a file.
class Program {
  public:
    Program(std::vector<std::string> arguments, std::filesystem::path words)
        : words_(std::move(words)) {
        const auto self = std::filesystem::read_symlink("/proc/self/exe");
        arguments.insert(arguments.begin(), (self.parent_path() / "hawser").string());
        std::vector<char*> argv;
        for (std::string& argument : arguments) argv.push_back(argument.data());
        argv.push_back(nullptr);
        pid_ = fork();
        if (pid_ < 0) throw std::runtime_error("cannot start " + arguments[0]);
        if (pid_ == 0) {
            const int out = open(words_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
            dup2(out, 1);
            dup2(out, 2);
            execv(argv[0], argv.data());
            _exit(127);
        }
    }
    ~Program() {
        if (pid_ > 0) (void)end();
    }
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    int wait() {
        int status = 0;
        waitpid(pid_, &status, 0);
        pid_ = -1;
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    int end() {
        kill(pid_, SIGINT);
        return wait();
    }
    [[nodiscard]] std::string output_text() const {
        std::ifstream in(words_);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    /// Return the text after `what` in its output, up to the end of the line.
    [[nodiscard]] std::string text_after(const std::string& what) const {
        for (int k = 0; k < 600; ++k) {
            const std::string all = output_text();
            const auto at = all.find(what);
            const auto end = at == std::string::npos ? at : all.find('\n', at);
            if (end != std::string::npos)
                return all.substr(at + what.size(), end - at - what.size());
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
        }
        throw std::runtime_error("the program does not say \"" + what + "\":\n" + output_text());
    }
    /// Return the memory from /proc/PID/status [kB].
    [[nodiscard]] double resident() const {
        std::ifstream in("/proc/" + std::to_string(pid_) + "/status");
        for (std::string line; std::getline(in, line);)
            if (line.starts_with("VmRSS:")) return std::stod(line.substr(6));
        return 0.0;
    }

  private:
    std::filesystem::path words_;
    pid_t pid_ = -1;
};

/// Data received by one client.
struct Reader {
    double begun = 0.0, ended = 0.0;
    std::vector<double> ages, step_ms, frame_us, bytes;
    std::string fault;
};

void read_on(std::uint16_t port, const std::string& token, double until, Reader& out) {
    try {
        test::LiveClient client(port, token);
        (void)client.wait_for("scene");
        (void)client.frame();
        out.begun = wall();
        while (wall() < until) {
            const auto bytes = client.frame();
            const double now = wall();
            const test::ReadFrame frame = test::read_frame(bytes);
            out.ages.push_back(1e3 * (now - frame.clock));
            out.step_ms.push_back(frame.stats.at(0));
            out.frame_us.push_back(frame.stats.at(21));
            out.bytes.push_back(frame.length);
            out.ended = now;
        }
    } catch (const std::exception& error) {
        out.fault = error.what();
    }
}

/// Run a client that never reads, and connects again if it is dropped.
void ignore_frames(std::uint16_t port, const std::string& token, double until, int& dropped) {
    while (wall() < until) {
        test::LiveClient client(port, token);
        const int small = 4096;
        setsockopt(client.line().descriptor(), SOL_SOCKET, SO_RCVBUF, &small, sizeof small);
        const double patience = std::min(until, wall() + 15.0);
        while (wall() < patience) std::this_thread::sleep_for(std::chrono::milliseconds(50));
        if (wall() < until) ++dropped;
    }
}

void connect_and_disconnect(std::uint16_t port, const std::string& token, double until,
                            int& times) {
    while (wall() < until) {
        test::LiveClient client(port, token);
        (void)client.wait_for("scene");
        for (int k = 0; k < 30 && wall() < until; ++k) (void)client.frame();
        ++times;
    }
}

struct Seen {
    std::vector<Reader> readers;
    double memory_before = 0.0, memory_with = 0.0;  ///< [kB]
    int deaf = 0, visits = 0;
};

Seen serve(const ViewBench& options, const std::filesystem::path& folder) {
    Program program({"view", options.scene, "--port", "0"}, folder / "view.txt");
    const std::string address = program.text_after("watcher");
    const auto port =
        static_cast<std::uint16_t>(std::stoi(address.substr(address.find("127.0.0.1:") + 10)));
    const std::string token = address.substr(address.find("token=") + 6);
    Seen out;
    out.readers.resize(static_cast<std::size_t>(options.readers));
    // One client alone first, so that data shared by all exist.
    Reader first;
    read_on(port, token, wall() + 2.0, first);
    out.memory_before = program.resident();
    const double until = wall() + options.seconds;
    std::vector<std::thread> threads;
    for (Reader& reader : out.readers)
        threads.emplace_back([&] { read_on(port, token, until, reader); });
    threads.emplace_back([&] { ignore_frames(port, token, until, out.deaf); });
    threads.emplace_back([&] {
        try {
            connect_and_disconnect(port, token, until, out.visits);
        } catch (const std::exception& error) {
            fmt::print("  the one that comes and goes: {}\n", error.what());
        }
    });
    while (wall() < until - 0.5) std::this_thread::sleep_for(std::chrono::milliseconds(100));
    out.memory_with = program.resident();
    for (std::thread& thread : threads) thread.join();
    (void)program.end();
    return out;
}

/// Return the median of step_ms of `hawser run --realtime`.
double median_step_alone(const ViewBench& options, const std::filesystem::path& folder) {
    const std::string summary = (folder / "run.json").string();
    Program program({"run", options.scene, "--realtime", "--quiet", "--duration",
                     fmt::format("{}", options.seconds), "--summary", summary},
                    folder / "run.txt");
    if (program.wait() != 0) throw std::runtime_error("hawser run: " + program.output_text());
    std::ifstream in(summary);
    return nlohmann::json::parse(in).at("step_ms").at("median").get<double>();
}

nlohmann::json report(const ViewBench& options, double median_alone, const Seen& seen,
                      Verdict& verdict) {
    nlohmann::json rows = nlohmann::json::array();
    std::vector<double> steps, frames, bytes;
    double slowest = 1e9, oldest = 0.0;
    for (const Reader& reader : seen.readers) {
        if (!reader.fault.empty()) fmt::print("  a reader: {}\n", reader.fault);
        const double rate = reader.ended > reader.begun ? static_cast<double>(reader.ages.size()) /
                                                              (reader.ended - reader.begun)
                                                        : 0.0;
        const double age = fraction_of(reader.ages, 0.95);
        slowest = std::min(slowest, rate);
        oldest = std::max(oldest, age);
        steps.insert(steps.end(), reader.step_ms.begin(), reader.step_ms.end());
        frames.insert(frames.end(), reader.frame_us.begin(), reader.frame_us.end());
        bytes.insert(bytes.end(), reader.bytes.begin(), reader.bytes.end());
        fmt::print("  reader  {:6.2f} frames/s, age p50 {:.2f} ms, p95 {:.2f} ms, max {:.1f} ms\n",
                   rate, fraction_of(reader.ages, 0.5), age, fraction_of(reader.ages, 1.0));
        rows.push_back({{"frames_per_second", rate}, {"age_p95_ms", age}});
    }
    const double median = fraction_of(steps, 0.5);
    const double clients = static_cast<double>(options.readers) + 2.0;
    const double memory = (seen.memory_with - seen.memory_before) / clients;
    fmt::print(
        "  the one that comes and goes came {} times, the one that never reads was dropped "
        "{} times\n",
        seen.visits, seen.deaf);
    verdict.require("rate", "readers", slowest >= 59.0,
                    fmt::format("{:.2f} frames/s at least", slowest));
    verdict.require("age", "readers", oldest <= 10.0,
                    fmt::format("age p95 {:.2f} ms at most", oldest));
    verdict.require(
        "step", "", median <= 1.1 * median_alone,
        fmt::format("step_ms.median {:.3f} with clients, {:.3f} by run --realtime: {:.3f} "
                    "times",
                    median, median_alone, median / median_alone));
    verdict.require("made", "", fraction_of(frames, 0.5) <= 150.0,
                    fmt::format("a frame made in {:.0f} us, p95 {:.0f} us",
                                fraction_of(frames, 0.5), fraction_of(frames, 0.95)));
    verdict.require("size", "", fraction_of(bytes, 1.0) <= 72e3,
                    fmt::format("a frame of {:.0f} bytes at most", fraction_of(bytes, 1.0)));
    verdict.require("memory", "", memory <= 256.0,
                    fmt::format("{:.0f} kB a client ({:.0f} kB before, {:.0f} kB with {:.0f})",
                                memory, seen.memory_before, seen.memory_with, clients));
    return {{"scene", options.scene},
            {"seconds", options.seconds},
            {"readers", rows},
            {"step_ms_median", median},
            {"step_ms_median_alone", median_alone},
            {"frame_us_median", fraction_of(frames, 0.5)},
            {"frame_bytes", fraction_of(bytes, 1.0)},
            {"memory_kb_per_client", memory},
            {"bars", verdict.json()}};
}

}  // namespace

int view_command(int argc, char** argv) {
    ViewBench options;
    CLI::App app{"Clients of `hawser view`, and what they cost the run", "hawser bench view"};
    app.footer(kViewBenchFooter);
    app.add_option("--scene", options.scene, "Scene file")->capture_default_str();
    app.add_option("--seconds", options.seconds, "Of each of the two runs [s]")
        ->check(CLI::Range(2.0, 3600.0))
        ->capture_default_str();
    app.add_option(
           "--readers", options.readers,
           "Clients that read; with the one that never does and the one that comes and goes "
           "two more")
        ->check(CLI::Range(1, 14))
        ->capture_default_str();
    app.add_option("--json", options.json, "Write the figures");
    CLI11_PARSE(app, argc, argv);
    const auto folder =
        std::filesystem::temp_directory_path() / ("hawser_bench_view_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    Verdict verdict;
    fmt::print("{}: {:.6g} s by run --realtime, then by view with {} clients\n", options.scene,
               options.seconds, options.readers + 2);
    const double median_alone = median_step_alone(options, folder);
    const Seen seen = serve(options, folder);
    const nlohmann::json figures = report(options, median_alone, seen, verdict);
    if (!options.json.empty()) std::ofstream(options.json) << figures.dump(2) << '\n';
    std::filesystem::remove_all(folder);
    return verdict.exit_code();
}

}  // namespace hawser::bench
