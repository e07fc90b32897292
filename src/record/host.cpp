// SPDX-License-Identifier: Apache-2.0
#include "record/host.h"

#include <sched.h>
#include <sys/resource.h>

#include <cstdlib>
#include <fstream>

namespace hawser::record {

std::string processor_model() {
    std::ifstream in("/proc/cpuinfo");
    for (std::string line; std::getline(in, line);) {
        if (!line.starts_with("model name")) continue;
        const std::size_t colon = line.find(": ");
        if (colon != std::string::npos) return line.substr(colon + 2);
    }
    return "unknown";
}

int processor_count() {
    cpu_set_t set;
    CPU_ZERO(&set);
    return sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : 1;
}

std::array<double, 3> load_average() {
    std::array<double, 3> load{};
    if (getloadavg(load.data(), 3) != 3) load.fill(-1.0);
    return load;
}

std::int64_t peak_memory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::int64_t>(usage.ru_maxrss) * 1024;  // Linux counts in KiB.
}

}  // namespace hawser::record
