// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file random_report.h
/// How runs of random mechanisms ended: counted by what the mechanisms hold, and why those that did
/// not end ok did not.

#include "random_cases.h"
#include "random_judge.h"

#include <array>
#include <cstdint>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace hawser::bench {

enum class Outcome { ok, doubtful, failed, refused };

/// A case that has been run.
struct Ended {
    RandomCase of;
    std::uint64_t number = 0;
    Outcome outcome = Outcome::ok;
    std::string why;    ///< Of a failure or a refusal.
    std::string worst;  ///< Name of the joint that is open furthest.
    Status status = Status::ok;
    hawser::Verdict verdict;  ///< Of the world.
    Judged judged;            ///< Of the judge of this command.
    double seconds = 0.0;     ///< Wall time.
    [[nodiscard]] bool wrong() const { return outcome == Outcome::ok && judged.wrong(); }
};

/// A line about a case.
[[nodiscard]] std::string told(const Ended& ended);

/// Counts of a category.
struct Tally {
    int cases = 0, ok = 0, doubtful = 0, failed = 0, refused = 0, wrong = 0, energy = 0, open = 0,
        infinite = 0;
    int consistent = 0, consistent_ok = 0;  ///< Without contradictory joints.
    int swung = 0;  ///< Of those that ended ok: energy swung by more than 1 % in one state.
    void add(const Ended& ended);
    [[nodiscard]] double share_ok() const;
};

inline constexpr std::size_t kCategoryCount = 11;
using Tallies = std::array<Tally, kCategoryCount>;

/// All that is counted.
class RandomReport {
  public:
    void add(const Ended& ended);
    [[nodiscard]] const Tally& all() const { return tallies_[0]; }
    void print_outcomes() const;
    /// Of the cases without contradictory joints that did not end ok: who says so, in how many of
    /// them the judge of this command sees nothing wrong, and what they hold.
    void print_reasons() const;
    /// Write the figures to a file. @throws std::runtime_error.
    void write_json(const std::string& path, std::uint64_t seed, int count) const;

  private:
    struct Reason {
        int unseen = 0;  ///< The judge of this command sees nothing wrong up to there.
        std::array<int, kCategoryCount> cases{};
    };
    Tallies tallies_{};
    std::map<std::string, Reason> reasons_;
    std::vector<std::uint64_t> wrong_;
};

/// A table with a line for each case, in comma-separated values.
class CaseList {
  public:
    /// @param path  Nothing is written where it is empty. @throws std::runtime_error.
    explicit CaseList(const std::string& path);
    void add(const Ended& ended);
    /// @throws std::runtime_error where something could not be written.
    void close();

  private:
    std::string path_;
    std::ofstream file_;
};

}  // namespace hawser::bench
