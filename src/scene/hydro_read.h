// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file hydro_read.h
/// Readers of coefficients by format (hawser/hydro_files.h).

#include <hawser/def.h>
#include <hawser/hydro_files.h>

#include <filesystem>
#include <string>
#include <vector>

namespace hawser::scene {

using Path = std::filesystem::path;

/// Largest file that is read [bytes].
inline constexpr std::uintmax_t kLargestHydroFile = 256u << 20u;
/// Largest number of values that number_lines() reads from a text file.
inline constexpr std::size_t kMaxHydroNumbers = 20'000'000;

[[noreturn]] void throw_hydro_error(const Path& file, const std::string& what);

/// A line of numbers.
struct NumberLine {
    std::size_t line = 0;
    std::vector<double> value;
};
/// Return the lines that begin with a number. Other lines are skipped; a word among numbers is
/// rejected. @param most  Largest number of values in a line.
[[nodiscard]] std::vector<NumberLine> number_lines(const Path& file, std::size_t most);
/// Return the content of a text file.
[[nodiscard]] std::string text_of(const Path& file);

/// Ascending values along one axis. Values within 1e-6 of each other count as one.
class Axis {
  public:
    void add(double value) { all_.push_back(value); }
    void sort();
    [[nodiscard]] const std::vector<double>& values() const { return all_; }
    /// Return the index of a value; size() if there is none.
    [[nodiscard]] std::size_t find(double value) const;
    [[nodiscard]] std::size_t size() const { return all_.size(); }

  private:
    std::vector<double> all_;
};

[[nodiscard]] WaveCoefficients read_wamit(const Path& file, const HydroUnits& units);
[[nodiscard]] WaveCoefficients read_nemoh_tec(const Path& file, const HydroUnits& units);
[[nodiscard]] WaveCoefficients read_capytaine(const Path& file, const HydroUnits& units);
[[nodiscard]] WaveCoefficients read_bemio(const Path& file, const HydroUnits& units);
/// Read a file of any format in this process.
[[nodiscard]] WaveCoefficients read_in_process(const Path& file, const HydroUnits& units);
/// Read a file in a reader program.
[[nodiscard]] WaveCoefficients read_in_child(const Path& file, const HydroUnits& units,
                                             const ReaderLimits& limits);

}  // namespace hawser::scene
