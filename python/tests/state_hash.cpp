// SPDX-License-Identifier: Apache-2.0
/// Print name and state hash of each scene after a number of steps of a Session.
/// usage: hawser_state_hash STEPS SCENE...
#include <hawser/session.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>

int main(int count, char** given) {
    const long steps = count > 1 ? std::strtol(given[1], nullptr, 10) : 0;
    for (int i = 2; i < count; ++i) {
        try {
            hawser::Session session({.scene = given[i]});
            for (long k = 0; k < steps && session.step() == hawser::Status::ok; ++k) {
            }
            std::printf("%s %lld %016llx\n", std::filesystem::path(given[i]).stem().c_str(),
                        static_cast<long long>(session.world().step_count()),
                        static_cast<unsigned long long>(session.world().state().hash()));
        } catch (const std::exception& error) {
            std::fprintf(stderr, "%s: %s\n", given[i], error.what());
            return 1;
        }
    }
    return 0;
}
