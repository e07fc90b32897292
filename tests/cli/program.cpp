// SPDX-License-Identifier: Apache-2.0
#include "cli/program.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

namespace hawser::test {

std::filesystem::path program_file() {
    const char* folder = std::getenv("HAWSER_BIN_DIR");
    const std::filesystem::path file =
        std::filesystem::absolute(folder != nullptr ? folder : "build/release/bin") / "hawser";
    if (!std::filesystem::exists(file))
        throw std::runtime_error(file.string() + " does not exist; set HAWSER_BIN_DIR");
    return file;
}

namespace {

// In the child process: prepare everything before fork, which is not followed by any allocation.
[[noreturn]] void become(char* const* argv, const char* out, const char* err) {
    const int flags = O_WRONLY | O_CREAT | O_TRUNC;
    dup2(open(out, flags, 0600), STDOUT_FILENO);
    dup2(open(err, flags, 0600), STDERR_FILENO);
    execv(argv[0], argv);
    _exit(127);
}

}  // namespace

Outcome run_program(const std::vector<std::string>& arguments, double interrupt_after,
                    const std::vector<std::string>& environment) {
    const auto folder = std::filesystem::path(testing::TempDir()) / "hawser_program";
    std::filesystem::create_directories(folder);
    const std::string tag = std::to_string(getpid());
    const std::string out = folder / ("out." + tag), err = folder / ("err." + tag);
    // env(1) sets the variables and replaces itself by the program, so that signals reach it.
    std::vector<std::string> words{"/usr/bin/env"};
    words.insert(words.end(), environment.begin(), environment.end());
    words.push_back(program_file());
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    for (const std::string& file : {out, err}) std::ofstream(file).flush();
    const pid_t child = fork();
    if (child == 0) become(argv.data(), out.c_str(), err.c_str());
    if (interrupt_after >= 0.0) {
        // A program handles signals once it has printed its first line: instrumented programs start
        // slowly.
        const auto silent = [&] {
            return std::filesystem::file_size(out) + std::filesystem::file_size(err) == 0;
        };
        for (int i = 0; i < 600 && silent(); ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
        std::this_thread::sleep_for(std::chrono::duration<double>(interrupt_after));
        kill(child, SIGINT);
    }
    int status = 0;
    waitpid(child, &status, 0);
    Outcome result;
    result.code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    result.out = read_text(out);
    result.err = read_text(err);
    std::filesystem::remove(out);
    std::filesystem::remove(err);
    return result;
}

std::filesystem::path test_folder() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    const auto folder = std::filesystem::path(testing::TempDir()) / "hawser" /
                        (std::string(test->test_suite_name()) + "." + test->name());
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    return folder;
}

std::string read_text(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

void write_text(const std::filesystem::path& file, const std::string& text) {
    std::ofstream(file, std::ios::binary) << text;
}

void damage(const std::filesystem::path& file, std::size_t at) {
    std::fstream out(file, std::ios::binary | std::ios::in | std::ios::out);
    out.seekg(static_cast<std::streamoff>(at));
    const int byte = out.get();
    out.seekp(static_cast<std::streamoff>(at));
    out.put(static_cast<char>(byte ^ 0x5A));
}

}  // namespace hawser::test
