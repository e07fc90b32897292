// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file random_report.h
/// Results of runs of random mechanisms: counted by the contents of the mechanisms, and reasons of
/// those that did not end ok.

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
    std::string why;    ///< Reason of a failure or a rejection.
    std::string worst;  ///< Name of the joint with the largest gap.
    Status status = Status::ok;
    hawser::Verdict verdict;  ///< Result of the world's monitors.
    JointErrors judged;       ///< Result of this command's monitor.
    double seconds = 0.0;     ///< Wall time.
    [[nodiscard]] bool wrong() const { return outcome == Outcome::ok && judged.wrong(); }
};

/// Return a line about a case.
[[nodiscard]] std::string reported(const Ended& ended);

/// Counts of a category.
struct Tally {
    int cases = 0, ok = 0, doubtful = 0, failed = 0, refused = 0, wrong = 0, energy = 0, open = 0,
        infinite = 0;
    int consistent = 0, consistent_ok = 0;  ///< Cases without inconsistent joints.
    int swung = 0;  ///< Cases that ended ok with an energy change above 1 % in one state.
    void add(const Ended& ended);
    [[nodiscard]] double fraction_ok() const;
};

inline constexpr std::size_t kCategoryCount = 11;
using Tallies = std::array<Tally, kCategoryCount>;

/// Counts of all cases.
class RandomReport {
  public:
    void add(const Ended& ended);
    [[nodiscard]] const Tally& all() const { return tallies_[0]; }
    void print_outcomes() const;
    /// Print the cases without inconsistent joints that did not end ok: the check that reports it,
    /// the number in which this command's monitor finds no error, and their contents.
    void print_reasons() const;
    /// Write the figures to a file. @throws std::runtime_error.
    void write_json(const std::string& path, std::uint64_t seed, int count) const;

  private:
    struct Reason {
        int unseen = 0;  ///< This command's monitor finds no error up to this time.
        std::array<int, kCategoryCount> cases{};
    };
    Tallies tallies_{};
    std::map<std::string, Reason> reasons_;
    std::vector<std::uint64_t> wrong_;
};

/// A table with a line for each case, in comma-separated values.
class CaseList {
  public:
    /// Open a file. @param path  Empty: write no file. @throws std::runtime_error.
    explicit CaseList(const std::string& path);
    void add(const Ended& ended);
    /// Close the file. @throws std::runtime_error if a line could not be written.
    void close();

  private:
    std::string path_;
    std::ofstream file_;
};

}  // namespace hawser::bench
