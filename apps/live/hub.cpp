// SPDX-License-Identifier: Apache-2.0
#include "live/hub.h"

#include <sys/eventfd.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <ctime>
#include <stdexcept>

namespace hawser::live {

Hub::Hub() : descriptor_(eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {
    if (descriptor_ < 0)
        throw std::runtime_error(std::string("no descriptor between threads: ") +
                                 std::strerror(errno));
}

Hub::~Hub() { close(descriptor_); }

void Hub::wake() noexcept {
    const std::uint64_t one = 1;
    // If the counter is full, the other thread has been notified already.
    [[maybe_unused]] const auto written = ::write(descriptor_, &one, sizeof one);
}

void Hub::clear() noexcept {
    std::uint64_t count = 0;
    [[maybe_unused]] const auto got = ::read(descriptor_, &count, sizeof count);
}

double clock_now() noexcept {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace hawser::live
