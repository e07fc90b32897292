// SPDX-License-Identifier: Apache-2.0
/// Read the numeric output of WAMIT (WAMIT User Manual, version 7, chapter 4). Dimensionless
/// values:
/// ```
///     .1    A/ρL^k, B/ρL^k ω          k = 3; 4 if one, 5 if both are rotations
///     .3    X/ρgaL^m, .4  ξ/(a/L^n)   m = 2, 3; n = 0, 1
///     .9    D/ρga²L^m                 m = 1, 2 (also .8)
///     .hst  C/ρgL^k                   k = 2, 3, 4
/// ```
/// The values are listed by periods. A negative period means ω = 0, the period 0 means ω = ∞.
/// Phases are those of e^{+iωt}.
#include "scene/hydro_read.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <numbers>

namespace hawser::scene {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi, kDegree = std::numbers::pi / 180.0;

std::string line_text(const NumberLine& row) { return "line " + std::to_string(row.line) + ": "; }

/// Return the index 0 to 5 of the motion in a table column, for the requested body; −1 for another
/// body.
int motion_of(const Path& file, const NumberLine& row, std::size_t column, int body) {
    const double value = std::abs(row.value[column]);
    if (!(value >= 1.0 && value <= 6000.0) || value != std::floor(value))
        throw_hydro_error(file, line_text(row) + "mode " +
                                    fmt::format("{:.6g}", row.value[column]) +
                                    " is none of 1, 2, …");
    const int mode = static_cast<int>(value) - 1;
    return mode / 6 == body ? mode % 6 : -1;
}

void need_columns(const Path& file, const NumberLine& row, std::size_t count) {
    if (row.value.size() != count)
        throw_hydro_error(file, line_text(row) + std::to_string(row.value.size()) + " numbers; " +
                                    std::to_string(count) + " belong here");
}

int rotations(int i, int j) { return (i > 2 ? 1 : 0) + (j > 2 ? 1 : 0); }

class Wamit {
  public:
    Wamit(const Path& file, const HydroUnits& units)
        : file_(file),
          rho_(units.density),
          g_(units.gravity),
          length_(units.length),
          body_(units.body) {
        if (length_ > 0.0) return;
        length_ = 1.0;
        Path gdf = file;
        gdf.replace_extension(".gdf");
        std::ifstream in(gdf);
        std::string line;
        if (!in || !std::getline(in, line)) return;
        if (!(in >> length_) || !(length_ > 0.0 && length_ < 1e6))
            throw_hydro_error(gdf, "line 2: ULEN is no length");
    }

    WaveCoefficients read() {
        read_radiation();
        read_table(".3", 7, out_.excitation,
                   [this](int k) { return rho_ * g_ * power(2 + (k > 2)); });
        read_table(".4", 7, out_.motion, [this](int k) { return k > 2 ? 1.0 / length_ : 1.0; });
        read_drift();
        read_stiffness();
        return std::move(out_);
    }

  private:
    [[nodiscard]] double power(int n) const { return std::pow(length_, n); }
    [[nodiscard]] Path file_with_ending(const char* ending) const {
        Path path = file_;
        return path.replace_extension(ending);
    }

    void read_radiation() {
        const auto rows = number_lines(file_, 16);
        for (const NumberLine& row : rows) {
            need_columns(file_, row, row.value[0] > 0.0 ? 5 : 4);
            if (row.value[0] > 0.0) frequency_.add(kTurn / row.value[0]);
        }
        frequency_.sort();
        out_.frequency = frequency_.values();
        const std::size_t n = frequency_.size();
        if (n == 0) throw_hydro_error(file_, "it has no line of a period above 0");
        out_.added_mass.assign(n, Matrix6::Zero());
        out_.damping = out_.added_mass;
        // Count the entries of each pair at each frequency.
        std::vector<int> entry_count(n * 36, 0);
        for (const NumberLine& row : rows) {
            const int i = motion_of(file_, row, 1, body_), j = motion_of(file_, row, 2, body_);
            if (i < 0 || j < 0) continue;
            const double scale = rho_ * power(3 + rotations(i, j));
            const double period = row.value[0], a = scale * row.value[3];
            if (period < 0.0) {
                out_.zero(i, j) = a;
                out_.has_zero = true;
            } else if (period == 0.0) {
                out_.infinite(i, j) = a;
                out_.has_infinite = true;
            } else {
                const std::size_t w = frequency_.find(kTurn / period);
                out_.added_mass[w](i, j) = a;
                out_.damping[w](i, j) = scale * frequency_.values()[w] * row.value[4];
                ++entry_count[w * 36 + static_cast<std::size_t>(6 * i + j)];
            }
        }
        for (std::size_t pair = 0; pair < 36; ++pair)
            for (std::size_t w = 0; w < n; ++w)
                if (entry_count[w * 36 + pair] != entry_count[pair] ||
                    entry_count[w * 36 + pair] > 1)
                    throw_hydro_error(file_,
                                      "the coefficient of modes " + std::to_string(pair / 6 + 1) +
                                          " and " + std::to_string(pair % 6 + 1) + " at " +
                                          fmt::format("{:.6g}", kTurn / frequency_.values()[w]) +
                                          " s is missing or given twice");
    }

    std::size_t frequency_index(const Path& file, const NumberLine& row) const {
        const double period = row.value[0];
        const std::size_t w = period > 0.0 ? frequency_.find(kTurn / period) : frequency_.size();
        if (w == frequency_.size())
            throw_hydro_error(file, line_text(row) + "the period " + fmt::format("{:.6g}", period) +
                                        " s is not in " + file_.filename().string());
        return w;
    }

    /// Set the directions from the rows of a table. Later tables must have directions of the first
    /// one.
    void store_headings(const Path& file, const std::vector<NumberLine>& rows) {
        Axis found;
        for (const NumberLine& row : rows) found.add(row.value[1] * kDegree);
        found.sort();
        if (out_.heading.empty()) {
            heading_ = found;
            out_.heading = found.values();
            return;
        }
        for (const double h : found.values())
            if (heading_.find(h) == heading_.size())
                throw_hydro_error(file, "the direction " + fmt::format("{:.6g}", h / kDegree) +
                                            " degrees is not in the .3 file");
    }

    void require_all(const Path& file, const std::vector<int>& given) const {
        for (std::size_t i = 0; i < given.size(); ++i)
            if (given[i] != 1)
                throw_hydro_error(
                    file, "mode " + std::to_string(i % 6 + 1) + " at " +
                              fmt::format("{:.6g}",
                                          kTurn / out_.frequency[i / 6 % out_.frequency.size()]) +
                              " s, " +
                              fmt::format("{:.6g}",
                                          out_.heading[i / 6 / out_.frequency.size()] / kDegree) +
                              " degrees is missing or given twice");
    }

    template <class Scale>
    void read_table(const char* ending, std::size_t columns,
                    std::vector<std::complex<double>>& table, const Scale& scale) {
        const Path file = file_with_ending(ending);
        if (!std::filesystem::exists(file)) return;
        const auto rows = number_lines(file, 16);
        for (const NumberLine& row : rows) need_columns(file, row, columns);
        store_headings(file, rows);
        table.assign(out_.heading.size() * out_.frequency.size() * 6, 0.0);
        std::vector<int> entry_count(table.size(), 0);
        for (const NumberLine& row : rows) {
            const std::size_t w = frequency_index(file, row);
            const std::size_t h = heading_.find(row.value[1] * kDegree);
            const int k = motion_of(file, row, 2, body_);
            if (k < 0) continue;
            const std::size_t at = out_.index(h, w, k);
            // Conjugate, because the file has phases of e^{+iωt}.
            table[at] = scale(k) * std::complex<double>(row.value[5], -row.value[6]);
            ++entry_count[at];
        }
        require_all(file, entry_count);
    }

    void read_drift() {
        Path file = file_with_ending(".9");
        if (!std::filesystem::exists(file)) file = file_with_ending(".8");
        if (!std::filesystem::exists(file)) return;
        const bool horizontal = file.extension() == ".8";  // surge, sway and yaw alone
        const auto rows = number_lines(file, 16);
        for (const NumberLine& row : rows) need_columns(file, row, 8);
        store_headings(file, rows);
        out_.drift.assign(out_.heading.size() * out_.frequency.size() * 6, 0.0);
        std::vector<int> entry_count(out_.drift.size(), 0);
        for (const NumberLine& row : rows) {
            // Skip rows of two different directions, and moments about body-fixed axes (negative
            // numbers), which repeat components 4 to 6.
            if (row.value[1] != row.value[2] || row.value[3] < 0.0) continue;
            const std::size_t w = frequency_index(file, row);
            const std::size_t h = heading_.find(row.value[1] * kDegree);
            const int k = motion_of(file, row, 3, body_);
            if (k < 0) continue;
            const std::size_t at = out_.index(h, w, k);
            out_.drift[at] = rho_ * g_ * power(k > 2 ? 2 : 1) * row.value[6];
            ++entry_count[at];
        }
        if (horizontal)
            for (std::size_t i = 0; i < entry_count.size(); ++i)
                if (const std::size_t k = i % 6; k > 1 && k < 5) entry_count[i] = 1;
        require_all(file, entry_count);
    }

    void read_stiffness() {
        const Path file = file_with_ending(".hst");
        if (!std::filesystem::exists(file)) return;
        for (const NumberLine& row : number_lines(file, 16)) {
            need_columns(file, row, 3);
            const int i = motion_of(file, row, 0, body_), j = motion_of(file, row, 1, body_);
            if (i < 0 || j < 0) continue;
            out_.stiffness(i, j) = rho_ * g_ * power(2 + rotations(i, j)) * row.value[2];
            out_.has_stiffness = true;
        }
    }

    Path file_;
    double rho_, g_, length_;
    int body_;
    Axis frequency_, heading_;
    WaveCoefficients out_;
};

}  // namespace

WaveCoefficients read_wamit(const Path& file, const HydroUnits& units) {
    return Wamit(file, units).read();
}

}  // namespace hawser::scene
