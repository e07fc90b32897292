// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file hydro_spawn.h
/// Start a program, collect its output on a descriptor, and kill it at a time limit.

#include <string>
#include <vector>

namespace hawser::scene {

/// Descriptor that the started program writes to.
inline constexpr int kReaderDescriptor = 3;

enum class SpawnEnd {
    exited,       ///< `code` is its exit code.
    killed,       ///< `code` is the signal.
    too_long,     ///< Killed at the time limit.
    too_large,    ///< Killed because it wrote more than `most` bytes.
    not_started,  ///< `code` is errno.
};
struct SpawnResult {
    SpawnEnd end = SpawnEnd::not_started;
    int code = 0;
    std::vector<char> output{};
};

/// Run `program` by posix_spawn, so that it has no memory and locks of this process. Its standard
/// streams are /dev/null. Return after the program has ended. @param seconds  Wall time after which
/// it is killed [s]. @param most     Largest output [bytes].
[[nodiscard]] SpawnResult spawn_reader(const std::string& program,
                                       const std::vector<std::string>& arguments, double seconds,
                                       std::size_t most);

}  // namespace hawser::scene
