// SPDX-License-Identifier: Apache-2.0
/// Read Tecplot files of NEMOH 2 (A. Babarit and G. Delhommeau, 2015), in SI units, with phases of
/// e^{−iωt}. A zone is a radiating motion, or a direction. Its lines contain ω and pairs A B, or
/// |F| and its angle.
#include "scene/hydro_read.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

namespace hawser::scene {
namespace {

constexpr double kDegreeOfTec = std::numbers::pi / 180.0;

struct Zone {
    std::string title;
    std::size_t line = 0;
    std::vector<NumberLine> rows;
};

/// Return the zones of a file. All zones have equal numbers of lines.
std::vector<Zone> read_zones(const Path& file) {
    std::vector<Zone> out;
    std::istringstream lines(text_of(file));
    std::string row;
    for (std::size_t line = 1; std::getline(lines, row); ++line)
        if (row.find("Zone") != std::string::npos || row.find("ZONE") != std::string::npos)
            out.push_back({row, line, {}});
    if (out.empty()) throw_hydro_error(file, "it has no zone");
    for (NumberLine& numbers : number_lines(file, 200)) {
        std::size_t z = out.size();
        while (z > 0 && out[z - 1].line > numbers.line) --z;
        if (z == 0)
            throw_hydro_error(file,
                              "line " + std::to_string(numbers.line) + ": numbers before a zone");
        out[z - 1].rows.push_back(std::move(numbers));
    }
    return out;
}

void check_zone(const Path& file, const Zone& zone, std::size_t columns,
                const std::vector<double>& frequency) {
    if (zone.rows.size() != frequency.size())
        throw_hydro_error(file, "zone at line " + std::to_string(zone.line) + ": " +
                                    std::to_string(zone.rows.size()) +
                                    " lines; the first zone has " +
                                    std::to_string(frequency.size()));
    for (std::size_t i = 0; i < zone.rows.size(); ++i) {
        const NumberLine& row = zone.rows[i];
        if (row.value.size() < columns)
            throw_hydro_error(file, "line " + std::to_string(row.line) + ": " +
                                        std::to_string(row.value.size()) + " numbers; " +
                                        std::to_string(columns) + " belong here");
        if (std::abs(row.value[0] - frequency[i]) > 1e-5 * frequency[i])
            throw_hydro_error(file, "line " + std::to_string(row.line) + ": the frequency " +
                                        fmt::format("{:.6g}", row.value[0]) +
                                        " rad/s is not that of line " + std::to_string(i + 1) +
                                        " of the radiation's first zone");
    }
}

double heading_of_zone(const Path& file, const Zone& zone) {
    const std::size_t at = zone.title.find("beta");
    const std::size_t equals = at == std::string::npos ? at : zone.title.find('=', at);
    double degrees = 0.0;
    if (equals == std::string::npos ||
        !(std::istringstream(zone.title.substr(equals + 1)) >> degrees) ||
        !(std::abs(degrees) <= 360.0))
        throw_hydro_error(file,
                          "line " + std::to_string(zone.line) + ": no 'beta = … deg' in the zone");
    return degrees * kDegreeOfTec;
}

void read_tec_forces(const Path& file, std::size_t first, WaveCoefficients& out,
                     std::vector<std::complex<double>>& table) {
    if (!std::filesystem::exists(file)) return;
    const std::vector<Zone> zones = read_zones(file);
    std::vector<double> headings;
    for (const Zone& zone : zones) headings.push_back(heading_of_zone(file, zone));
    if (out.heading.empty()) out.heading = headings;
    if (headings != out.heading)
        throw_hydro_error(file, "its directions differ from those of the other files");
    for (std::size_t h = 0; h < zones.size(); ++h) {
        check_zone(file, zones[h], 1 + 2 * (first + 6), out.frequency);
        for (const NumberLine& row : zones[h].rows)
            for (std::size_t k = first; k < first + 6; ++k)
                table.push_back(std::polar(row.value[1 + 2 * k], row.value[2 + 2 * k]));
    }
}

}  // namespace

WaveCoefficients read_nemoh_tec(const Path& file, const HydroUnits& units) {
    const Path folder = file.parent_path(), radiation = folder / "RadiationCoefficients.tec";
    if (!std::filesystem::exists(radiation))
        throw_hydro_error(radiation, "cannot open it; NEMOH's files have to be in one folder");
    WaveCoefficients out;
    const std::vector<Zone> zones = read_zones(radiation);
    for (const NumberLine& row : zones[0].rows) out.frequency.push_back(row.value[0]);
    const auto first = 6 * static_cast<std::size_t>(units.body);
    if (zones.size() < first + 6)
        throw_hydro_error(radiation, std::to_string(zones.size()) + " zones; body " +
                                         std::to_string(units.body) + " needs all six motions");
    out.added_mass.assign(out.frequency.size(), Matrix6::Zero());
    out.damping = out.added_mass;
    for (std::size_t j = 0; j < 6; ++j) {
        const Zone& zone = zones[first + j];
        check_zone(radiation, zone, 1 + 2 * (first + 6), out.frequency);
        for (std::size_t w = 0; w < zone.rows.size(); ++w)
            for (std::size_t i = 0; i < 6; ++i) {
                const auto row = static_cast<Eigen::Index>(i), col = static_cast<Eigen::Index>(j);
                out.added_mass[w](row, col) = zone.rows[w].value[1 + 2 * (first + i)];
                out.damping[w](row, col) = zone.rows[w].value[2 + 2 * (first + i)];
            }
    }
    read_tec_forces(folder / "ExcitationForce.tec", first, out, out.excitation);
    read_tec_forces(folder / "DiffractionForce.tec", first, out, out.scattering);
    const Path stiffness = folder / "KH.dat";
    if (units.body != 0 || !std::filesystem::exists(stiffness)) return out;
    const auto rows = number_lines(stiffness, 6);
    if (rows.size() != 6) throw_hydro_error(stiffness, "six lines of six numbers belong here");
    for (std::size_t i = 0; i < 6; ++i) {
        if (rows[i].value.size() != 6)
            throw_hydro_error(stiffness,
                              "line " + std::to_string(rows[i].line) + ": not six numbers");
        for (std::size_t j = 0; j < 6; ++j)
            out.stiffness(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
                rows[i].value[j];
    }
    out.has_stiffness = true;
    return out;
}

}  // namespace hawser::scene
