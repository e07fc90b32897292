// SPDX-License-Identifier: Apache-2.0
#include "scene/hydro_spawn.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <new>
#include <thread>

extern char** environ;

namespace hawser::scene {
namespace {

using SpawnClock = std::chrono::steady_clock;

class Descriptor {
  public:
    Descriptor() = default;
    ~Descriptor() { reset(); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    void reset(int to = -1) {
        if (value_ >= 0) close(value_);
        value_ = to;
    }
    [[nodiscard]] int get() const { return value_; }

  private:
    int value_ = -1;
};

/// Options of posix_spawn: signals at their defaults, no descriptor of this process but `out`.
class SpawnOptions {
  public:
    explicit SpawnOptions(int out) {
        posix_spawn_file_actions_init(&files_);
        posix_spawnattr_init(&attributes_);
        for (int stream = 0; stream < kReaderDescriptor; ++stream)
            posix_spawn_file_actions_addopen(&files_, stream, "/dev/null", O_RDWR, 0);
        posix_spawn_file_actions_adddup2(&files_, out, kReaderDescriptor);
#if defined(__GLIBC__) && (__GLIBC__ > 2 || (__GLIBC__ == 2 && __GLIBC_MINOR__ >= 34))
        posix_spawn_file_actions_addclosefrom_np(&files_, kReaderDescriptor + 1);
#endif
        sigset_t none, all;
        sigemptyset(&none);
        sigfillset(&all);
        sigdelset(&all, SIGKILL);
        sigdelset(&all, SIGSTOP);
        posix_spawnattr_setsigmask(&attributes_, &none);
        posix_spawnattr_setsigdefault(&attributes_, &all);
        posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    }
    ~SpawnOptions() {
        posix_spawn_file_actions_destroy(&files_);
        posix_spawnattr_destroy(&attributes_);
    }
    SpawnOptions(const SpawnOptions&) = delete;
    SpawnOptions& operator=(const SpawnOptions&) = delete;
    [[nodiscard]] int start(pid_t& child, const std::string& program, char** argv) const {
        return posix_spawn(&child, program.c_str(), &files_, &attributes_, argv, environ);
    }

  private:
    posix_spawn_file_actions_t files_{};
    posix_spawnattr_t attributes_{};
};

/// Read until the other end closes. @return false: at the deadline, or above `most`.
bool collect(int from, SpawnClock::time_point deadline, std::size_t most, SpawnResult& out) {
    char piece[65536];
    for (;;) {
        const auto left =
            std::chrono::duration_cast<std::chrono::milliseconds>(deadline - SpawnClock::now());
        if (left.count() <= 0) {
            out.end = SpawnEnd::too_long;
            return false;
        }
        pollfd one{from, POLLIN, 0};
        const int ready = poll(&one, 1, static_cast<int>(std::min<long long>(left.count(), 1000)));
        if (ready < 0 && errno != EINTR) return true;
        if (ready <= 0) continue;
        const ssize_t n = read(from, piece, sizeof piece);
        if (n < 0 && (errno == EINTR || errno == EAGAIN)) continue;
        if (n <= 0) return true;
        if (out.output.size() + static_cast<std::size_t>(n) > most) {
            out.end = SpawnEnd::too_large;
            return false;
        }
        out.output.insert(out.output.end(), piece, piece + n);
    }
}

/// Wait for the child up to the deadline, then kill it. @return its status; -1: unknown.
int wait_for_status(pid_t child, SpawnClock::time_point deadline, bool kill_now, bool& late) {
    int status = -1;
    for (bool killed = false;;) {
        if (!killed && (kill_now || SpawnClock::now() >= deadline)) {
            late = late || !kill_now;
            kill(child, SIGKILL);
            killed = true;
        }
        const pid_t got = waitpid(child, &status, killed ? 0 : WNOHANG);
        if (got == child) return status;
        if (got < 0 && errno != EINTR) return -1;  // SIGCHLD is ignored
        if (got == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

}  // namespace

SpawnResult spawn_reader(const std::string& program, const std::vector<std::string>& arguments,
                         double seconds, std::size_t most) {
    SpawnResult out;
    Descriptor in, write_end;
    int ends[2] = {-1, -1};
    if (pipe2(ends, O_CLOEXEC) != 0) {
        out.code = errno;
        return out;
    }
    in.reset(ends[0]);
    write_end.reset(ends[1]);
    if (ends[1] == kReaderDescriptor) {  // dup2 onto itself would keep close-on-exec
        const int other = fcntl(ends[1], F_DUPFD_CLOEXEC, kReaderDescriptor + 1);
        if (other < 0) {
            out.code = errno;
            return out;
        }
        write_end.reset(other);
    }
    std::vector<std::string> words = arguments;
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    pid_t child = -1;
    const SpawnOptions options(write_end.get());
    if (const int fault = options.start(child, program, argv.data()); fault != 0) {
        out.code = fault;
        return out;
    }
    write_end.reset();
    const auto deadline =
        SpawnClock::now() + std::chrono::milliseconds(static_cast<long long>(1e3 * seconds));
    bool whole = false;
    try {
        whole = collect(in.get(), deadline, most, out);
    } catch (const std::bad_alloc&) {
        out.end = SpawnEnd::too_large;
    }
    bool late = false;
    const int status = wait_for_status(child, deadline, !whole, late);
    if (!whole) return out;
    if (late) {
        out.end = SpawnEnd::too_long;
    } else if (status != -1 && WIFSIGNALED(status)) {
        out.code = WTERMSIG(status);
        out.end =
            out.code == SIGXCPU || out.code == SIGALRM ? SpawnEnd::too_long : SpawnEnd::killed;
    } else {
        out.end = SpawnEnd::exited;
        out.code = status == -1 ? 0 : WEXITSTATUS(status);
    }
    return out;
}

}  // namespace hawser::scene
