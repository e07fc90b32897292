// SPDX-License-Identifier: Apache-2.0
#include "streams.h"

#include "commands.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/types.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>

namespace hawser::cli {

namespace {

struct Stream {
    int descriptor;
    int write_error = 0;  ///< Error of the first failed write; 0: none failed.
};

Stream g_out{STDOUT_FILENO}, g_error{STDERR_FILENO};

/// Write to the stream. Always report all bytes as written, so that no print fails.
extern "C" ssize_t write_to_stream(void* cookie, const char* from, std::size_t size) {
    auto& stream = *static_cast<Stream*>(cookie);
    for (std::size_t done = 0; done < size && stream.write_error == 0;) {
        const ssize_t n = ::write(stream.descriptor, from + done, size - done);
        if (n >= 0) {
            done += static_cast<std::size_t>(n);
        } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
            pollfd wait{stream.descriptor, POLLOUT, 0};
            (void)::poll(&wait, 1, -1);
        } else if (errno != EINTR) {
            stream.write_error = errno;
        }
    }
    return static_cast<ssize_t>(size);
}

void replace(std::FILE*& standard, Stream& stream, int buffering) noexcept {
    cookie_io_functions_t functions{};
    functions.write = write_to_stream;
    std::FILE* const mine = fopencookie(&stream, "w", functions);
    if (mine == nullptr) return;
    (void)std::setvbuf(mine, nullptr, buffering, BUFSIZ);
    standard = mine;
}

}  // namespace

void open_streams() noexcept {
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    for (int number = 0; number <= STDERR_FILENO; ++number)
        if (::fcntl(number, F_GETFD) < 0 && errno == EBADF) {
            // Open input for writing and outputs for reading, so that their use fails visibly.
            const int flags = number == STDIN_FILENO ? O_WRONLY : O_RDONLY;
            if (::open("/dev/null", flags) != number) _exit(kUsageError);
        }
    replace(stdout, g_out, ::isatty(STDOUT_FILENO) == 1 ? _IOLBF : _IOFBF);
    replace(stderr, g_error, _IONBF);
}

int close_streams(int code) noexcept {
    (void)std::fflush(stdout);
    if (g_out.write_error == 0) return code;
    char text[200];
    const int size =
        std::snprintf(text, sizeof text, "hawser: standard output: %s; the output is lost\n",
                      std::strerror(g_out.write_error));
    if (size > 0) (void)std::fwrite(text, 1, std::strlen(text), stderr);
    return code == kOk ? kUsageError : code;
}

}  // namespace hawser::cli
