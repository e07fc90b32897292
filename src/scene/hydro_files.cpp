// SPDX-License-Identifier: Apache-2.0
/// Select the reader of a file of coefficients, and read the common parts of text files.
#include "scene/hydro_read.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>

namespace hawser {

WaveCoefficients read_coefficients(const std::string& file, const HydroUnits& units) {
    return read_coefficients(file, units, ReaderLimits::of_environment());
}

WaveCoefficients read_coefficients(const std::string& file, const HydroUnits& units,
                                   const ReaderLimits& limits) {
    const scene::Path path(file);
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (error) scene::throw_hydro_error(path, "cannot open it");
    if (size > scene::kLargestHydroFile)
        scene::throw_hydro_error(path, std::to_string(size) + " bytes; up to " +
                                           std::to_string(scene::kLargestHydroFile) + " are read");
    if (!(units.body >= 0 && units.body <= 999))
        scene::throw_hydro_error(
            path, "body number " + std::to_string(units.body) + " is outside 0 to 999");
    const std::string ending = path.extension().string();
    const bool in_child = (ending == ".nc" || ending == ".h5") && !limits.in_process;
    WaveCoefficients out =
        in_child ? scene::read_in_child(path, units, limits) : scene::read_in_process(path, units);
    out = repaired_damping(out, units.negative_damping);
    if (const std::string fault = coefficients_fault(out); !fault.empty())
        scene::throw_hydro_error(path, fault);
    return out;
}

}  // namespace hawser

namespace hawser::scene {

void throw_hydro_error(const Path& file, const std::string& what) {
    throw DefError("coefficients '" + file.string() + "': " + what);
}

WaveCoefficients read_in_process(const Path& file, const HydroUnits& units) {
    const std::string ending = file.extension().string();
    if (ending == ".1") return read_wamit(file, units);
    if (ending == ".tec") return read_nemoh_tec(file, units);
    if (ending == ".nc") return read_capytaine(file, units);
    if (ending == ".h5") return read_bemio(file, units);
    throw_hydro_error(file,
                      "its name ends with none of .1 (WAMIT), .tec (NEMOH), .nc (Capytaine), "
                      ".h5 (BEMIO)");
}

std::string text_of(const Path& file) {
    std::error_code error;
    if (std::filesystem::file_size(file, error) > kLargestHydroFile || error)
        throw_hydro_error(file, error ? "cannot open it" : "it is too large");
    std::ifstream in(file, std::ios::binary);
    if (!in) throw_hydro_error(file, "cannot open it");
    return {std::istreambuf_iterator<char>(in), {}};
}

namespace {

/// Read a number as Fortran writes it, with D for E.
bool fortran_number(std::string word, double& out) {
    std::replace(word.begin(), word.end(), 'D', 'E');
    std::replace(word.begin(), word.end(), 'd', 'e');
    const char* const begin = word.data() + (word.starts_with('+') ? 1 : 0);
    const char* const end = word.data() + word.size();
    const auto [at, fault] = std::from_chars(begin, end, out);
    return fault == std::errc() && at == end && std::isfinite(out);
}

}  // namespace

std::vector<NumberLine> number_lines(const Path& file, std::size_t most) {
    std::istringstream lines(text_of(file));
    std::vector<NumberLine> out;
    std::string row;
    // A line needs as much memory as about eight numbers.
    constexpr std::size_t kNumbersPerLine = 8;
    std::size_t total = 0;
    for (std::size_t line = 1; std::getline(lines, row); ++line) {
        std::istringstream words(row);
        NumberLine numbers{line, {}};
        bool heading = false;
        for (std::string word; words >> word;) {
            double value = 0.0;
            if (!fortran_number(word, value)) {
                // A heading begins with a word; a number that is too large does not.
                heading = numbers.value.empty() &&
                          std::string("0123456789+-.").find(word[0]) == std::string::npos;
                if (!heading)
                    throw_hydro_error(file, "line " + std::to_string(line) + ": '" + word +
                                                "' is no finite number");
                break;
            }
            if (numbers.value.size() == most)
                throw_hydro_error(file, "line " + std::to_string(line) + ": more than " +
                                            std::to_string(most) + " numbers");
            numbers.value.push_back(value);
        }
        if (heading || numbers.value.empty()) continue;
        total += numbers.value.size() + kNumbersPerLine;
        if (total > kMaxHydroNumbers)
            throw_hydro_error(file,
                              "line " + std::to_string(line) + ": more numbers than are read (" +
                                  std::to_string(kMaxHydroNumbers) + ", a line counts as 8 more)");
        out.push_back(std::move(numbers));
    }
    return out;
}

void Axis::sort() {
    std::sort(all_.begin(), all_.end());
    const auto same = [](double a, double b) {
        return std::abs(a - b) <= 1e-6 * std::max({std::abs(a), std::abs(b), 1e-3});
    };
    all_.erase(std::unique(all_.begin(), all_.end(), same), all_.end());
}

std::size_t Axis::find(double value) const {
    const double near = 1e-6 * std::max(std::abs(value), 1e-3);
    const auto at = std::lower_bound(all_.begin(), all_.end(), value - near);
    return at != all_.end() && std::abs(*at - value) <= 2.0 * near
               ? static_cast<std::size_t>(at - all_.begin())
               : all_.size();
}

}  // namespace hawser::scene
