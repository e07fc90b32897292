// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file hydro_files.h
/// Reads coefficients of floating bodies (hydro.h) from the files of other programs. Part of
/// hawser::scene.
///
/// | file | by | has |
/// |---|---|---|
/// | `.1` | WAMIT | A, B, A(0), A(∞); beside it `.3` excitation, `.4` motions, `.9` or `.8` drift,
/// `.hst` stiffness, `.gdf` length | | `RadiationCoefficients.tec` | NEMOH 2 | A, B; beside it
/// `ExcitationForce.tec`, `DiffractionForce.tec`, `Nemoh.cal` | | `.nc` | Capytaine, netCDF-3 or -4
/// | A, B, A(0), A(∞), excitation, scattering, stiffness | | `.h5` | BEMIO of WEC-Sim | A, B, A(∞),
/// excitation, scattering, stiffness |
///
/// Built without libnetcdf-dev or libhdf5-dev, the latter two are refused with the name of the
/// package.
///
/// A reader program reads `.nc` and `.h5` files: a damaged file can crash or block their libraries.
/// read_coefficients() starts it, limits its time and memory, and checks each value that it
/// returns. The reader program is the first of
///
///   1. ReaderLimits::program,
///   2. the environment variable HAWSER_READER,
///   3. the running program, if its main() calls serve_coefficients_reader() first,
///   4. `hawser` in the folder of the running program.
///
/// Without one the file is refused. ReaderLimits::in_process reads a trusted file without it.

#include <hawser/hydro.h>

#include <cstddef>
#include <optional>
#include <string>

namespace hawser {

/// What a file does not say.
struct HydroUnits {
    double density = 1025.0;  ///< Of water, of files without dimensions (WAMIT, BEMIO) [kg/m³].
    double gravity = 9.81;    ///< [m/s²].
    double length = 0.0;      ///< WAMIT's ULEN [m]; 0: of the `.gdf` beside it, or 1 m.
    int body = 0;             ///< Which of several, from 0.
    NegativeDamping negative_damping = NegativeDamping::refuse;  ///< Treatment before checks.
};

/// Limits of the program that reads a `.nc` or `.h5` file.
struct ReaderLimits {
    std::string program{};                      ///< Path of the reader program; empty: see above.
    double seconds = 10.0;                      ///< Wall and processor time, 0.1 to 3600 [s].
    std::size_t memory = std::size_t{1} << 30;  ///< Address space, at least 64 MiB [bytes].
    bool in_process = false;  ///< Read without a reader program, without these limits.

    /// Defaults, changed by HAWSER_READER_SECONDS [s] and HAWSER_READER_MEMORY [MiB].
    /// @throws DefError if one is no number or out of its range.
    [[nodiscard]] static ReaderLimits of_environment();
};

/// @throws DefError with file, line or variable, what is wrong, and the remedy. The result is free
/// of faults but for reference, which stays 0.
[[nodiscard]] WaveCoefficients read_coefficients(const std::string& file,
                                                 const HydroUnits& units = {});
[[nodiscard]] WaveCoefficients read_coefficients(const std::string& file, const HydroUnits& units,
                                                 const ReaderLimits& limits);

/// Serve as the reader program if the arguments request it, and let read_coefficients() start this
/// program as the reader otherwise. Call it first in main().
/// @return exit code of the reader; nullopt: the arguments request something else.
[[nodiscard]] std::optional<int> serve_coefficients_reader(int argc, char** argv);

}  // namespace hawser
