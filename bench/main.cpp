// SPDX-License-Identifier: Apache-2.0
// hawser-bench: measurements that link foreign engines and libraries.
#include "commands.h"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>

namespace {

struct Command {
    const char* name;
    const char* description;
    int (*run)(int argc, char** argv);
};

constexpr Command kCommands[] = {
    {"step", "time and memory of a whole step, by scale", hawser::bench::step_command},
    {"exercise", "steps of an exercise, relative to a scene at rest",
     hawser::bench::exercise_command},
    {"factor", "our factorisation against libraries, on many matrices",
     hawser::bench::factor_command},
    {"roofline", "our factorisation beside the limits of the processor",
     hawser::bench::roofline_command},
    {"links", "whole steps of a million rigid links in one island", hawser::bench::links_command},
    {"friction", "methods for contacts with friction beside each other",
     hawser::bench::friction_command},
    {"partition", "our parts beside those of METIS and Scotch", hawser::bench::partition_command},
    {"coupling", "splits of the paper beside exact coupling", hawser::bench::coupling_command},
    {"deadline", "steps within a budget while the load doubles", hawser::bench::deadline_command},
    {"hashes", "the same bits for any number of threads and after restoring",
     hawser::bench::hashes_command},
    {"random", "mechanisms that no one has tuned: is what ends ok right?",
     hawser::bench::random_command},
    {"view", "clients of `hawser view`, and what they cost the run", hawser::bench::view_command},
    {"interface", "what it costs to read a world: state, outputs, save, restore",
     hawser::bench::interface_command},
    {"sea", "what waves, hulls and their memory cost, and a step of anchor_sea",
     hawser::bench::sea_command},
    {"edits", "what it costs to add and remove while a world runs", hawser::bench::edits_command},
    {"peers", "our steps against other engines, on six scenes", hawser::bench::peers_command},
    {"wires", "a wire round a post: capstan error, creep, cost, beside other engines",
     hawser::bench::wires_command},
};

/// Restart the program with huge pages for all memory, including that of libraries. Debian provides
/// them always, other systems only on request, and only Hawser's largest arrays request them.
/// Results must not depend on this. The setting is read when the program is loaded. If the restart
/// fails, continue without it.
void require_huge_pages(char** argv) {
    constexpr const char* kTunables = "GLIBC_TUNABLES";
    if (std::getenv(kTunables) != nullptr) return;
    if (setenv(kTunables, "glibc.malloc.hugetlb=1", 1) == 0) execv("/proc/self/exe", argv);
}

int usage(std::FILE* out, int code) {
    std::fputs("usage: hawser-bench COMMAND [OPTIONS]\n\ncommands:\n", out);
    for (const Command& c : kCommands) std::fprintf(out, "  %-9s %s\n", c.name, c.description);
    std::fputs("\n'hawser-bench COMMAND --help' tells the options.\n", out);
    return code;
}

}  // namespace

int main(int argc, char** argv) {
    // If both go to one file, progress must not interrupt a line of results. Results can be read
    // while the rest runs.
    std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
    if (argc < 2) return usage(stderr, 2);
    if (std::strcmp(argv[1], "--help") == 0 || std::strcmp(argv[1], "-h") == 0)
        return usage(stdout, 0);
    for (const Command& c : kCommands) {
        if (std::strcmp(argv[1], c.name) != 0) continue;
        require_huge_pages(argv);
        try {
            return c.run(argc - 1, argv + 1);
        } catch (const std::exception& e) {
            std::fprintf(stderr, "hawser-bench %s: %s\n", c.name, e.what());
            return 1;
        }
    }
    std::fprintf(stderr, "hawser-bench: unknown command '%s'\n", argv[1]);
    return usage(stderr, 2);
}
