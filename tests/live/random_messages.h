// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file random_messages.h
/// Sessions that random messages drive, with steps that fail, and the replay of their recordings.
///
/// A session is a list of lines. A line is a message of a client, or a cause for which the next
/// steps fail. The cause lasts for one step.
/// ```
///   !nan        a system loads a body with NaN
///   !input      a system sets an input that does not exist
///   !edit       a system adds a body and removes one that does not exist
///   !cancel     the step is cancelled
///   !pivot      a load makes the system singular
///   !late       velocities overflow after the step was solved
///   !memory N   !late, and allocation N of the step fails
/// ```

#include "support/random.h"

#include <hawser/session.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace hawser::test {

using Lines = std::vector<std::string>;

/// Number of scenes that sessions run in.
inline constexpr std::size_t kMessageScenes = 5;
/// Return the scene of a session: number `session % kMessageScenes`.
[[nodiscard]] SessionDef message_session(int session);

/// Draws lines.
class Sender {
  public:
    Sender(const World& world, std::uint32_t seed);
    /// Return the next message. @param failed  True if the last step failed.
    [[nodiscard]] std::string next(bool failed);

  private:
    [[nodiscard]] const std::string& name();
    [[nodiscard]] double any_value();
    [[nodiscard]] double near() { return random_.uniform(-1.0, 1.0); }
    [[nodiscard]] double place();
    [[nodiscard]] std::string cause();
    [[nodiscard]] std::string drag();
    [[nodiscard]] std::string set();

    Random random_;
    std::vector<std::string> names_;
    std::int32_t bodies_, wires_;
};

struct MessageFigures {
    std::int64_t steps = 0, failures = 0, taken = 0;
    double longest = 0.0;                 ///< CPU time of the longest loop of the driver [s].
    std::vector<std::int64_t> by_status;  ///< Failed steps by Status.
    void add(const MessageFigures& other);
};

/// Run `count` random lines and record to `file`. @param lines  Gets the lines.
MessageFigures run_random(int session, int count, std::uint32_t seed,
                          const std::filesystem::path& file, Lines& lines);
/// Run given lines.
MessageFigures run_lines(int session, const Lines& lines, const std::filesystem::path& file);
/// Replay a recording. @return the first difference; "": none.
[[nodiscard]] std::string replay_difference(const std::filesystem::path& file);
/// Return the hash of the motion at the end of a recording.
[[nodiscard]] std::uint64_t end_hash(const std::filesystem::path& file);
/// Remove lines as long as a replay differs.
[[nodiscard]] Lines shortest(int session, Lines lines, const std::filesystem::path& file);

}  // namespace hawser::test
