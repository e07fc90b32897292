// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file hydro_files.h
/// Reader of coefficients of floating bodies (hydro.h) from files of other programs. Part of
/// hawser::scene.
///
/// ```
///     file                        program                  content
///     .1                          WAMIT                    A, B, A(0), A(∞)
///       .3                                                 excitation X
///       .4                                                 motions
///       .9 or .8                                           drift
///       .hst                                               stiffness C
///       .gdf                                               length
///     RadiationCoefficients.tec   NEMOH 2                  A, B
///       ExcitationForce.tec                                excitation X
///       DiffractionForce.tec                               scattering
///       KH.dat                                             stiffness C, body 0 only
///     .nc                         Capytaine (netCDF-3/4)   A, B, A(0), A(∞), X, scattering, C
///     .h5                         BEMIO of WEC-Sim         A, B, A(∞), X, scattering, C
/// ```
/// Indented files are read from the same folder if they exist. A build without
/// libnetcdf-dev or libhdf5-dev rejects `.nc` or `.h5` files with the name of the package.
///
/// A separate process, the reader program, reads `.nc` and `.h5` files, because a damaged file can
/// crash or block their libraries. The function read_coefficients() starts it, limits its time and
/// memory, and checks each value. The reader program is the first of these that exists:
///
///   1. The program of ReaderLimits::program.
///   2. The environment variable HAWSER_READER.
///   3. The running program, if its main() calls serve_coefficients_reader() first.
///   4. The program `hawser` in the folder of the running program.
///
/// Without a reader program the file is rejected. ReaderLimits::in_process reads a trusted file
/// without one.

#include <hawser/hydro.h>

#include <cstddef>
#include <optional>
#include <string>

namespace hawser {

/// Data that a file does not contain.
struct HydroUnits {
    double density = 1025.0;  ///< Density of water for dimensionless files (WAMIT, BEMIO) [kg/m³].
    double gravity = 9.81;    ///< Gravity [m/s²].
    double length = 0.0;  ///< ULEN of WAMIT [m]; 0: from the `.gdf` file in the same folder, or 1
                          ///< m.
    int body = 0;         ///< Index of the body in the file, from 0.
    NegativeDamping negative_damping = NegativeDamping::refuse;  ///< Treatment before checks.
};

/// Limits of the program that reads a `.nc` or `.h5` file.
struct ReaderLimits {
    std::string program{};                      ///< Path of the reader program; empty: see above.
    double seconds = 10.0;                      ///< Wall and processor time, 0.1 to 3600 [s].
    std::size_t memory = std::size_t{1} << 30;  ///< Address space, at least 64 MiB [bytes].
    bool in_process = false;  ///< Read without a reader program, without these limits.

    /// Return the defaults, changed by HAWSER_READER_SECONDS [s] and HAWSER_READER_MEMORY [MiB].
    /// @throws DefError if a variable is not a number or out of its range.
    [[nodiscard]] static ReaderLimits of_environment();
};

/// Read the coefficients of a file. coefficients_fault() finds no fault in the result; its
/// `reference` is 0.
/// @throws DefError with file, line or variable, the fault and the remedy.
[[nodiscard]] WaveCoefficients read_coefficients(const std::string& file,
                                                 const HydroUnits& units = {});
[[nodiscard]] WaveCoefficients read_coefficients(const std::string& file, const HydroUnits& units,
                                                 const ReaderLimits& limits);

/// Serve as the reader program if the arguments request it, and let read_coefficients() start this
/// program as the reader otherwise. Call it first in main().
/// @return exit code of the reader; nullopt: the arguments request something else.
[[nodiscard]] std::optional<int> serve_coefficients_reader(int argc, char** argv);

}  // namespace hawser
