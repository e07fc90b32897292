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
/// Most numbers that number_lines() reads of a text file.
inline constexpr std::size_t kMostHydroNumbers = 20'000'000;

[[noreturn]] void refuse_hydro(const Path& file, const std::string& what);

/// A line of numbers.
struct NumberLine {
    std::size_t line = 0;
    std::vector<double> value;
};
/// Lines that begin with a number; others are passed over, a word among numbers is refused.
/// @param most  Numbers of a line.
[[nodiscard]] std::vector<NumberLine> number_lines(const Path& file, std::size_t most);
/// All of a text file.
[[nodiscard]] std::string text_of(const Path& file);

/// Values by index along one axis, ascending, those within 1e-6 of each other as one.
class Axis {
  public:
    void add(double value) { all_.push_back(value); }
    void sort();
    [[nodiscard]] const std::vector<double>& values() const { return all_; }
    /// @return its number; size() where it is not there.
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
[[nodiscard]] WaveCoefficients read_here(const Path& file, const HydroUnits& units);
/// Read a file in a reader program.
[[nodiscard]] WaveCoefficients read_apart(const Path& file, const HydroUnits& units,
                                          const ReaderLimits& limits);

}  // namespace hawser::scene
