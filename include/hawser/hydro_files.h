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

#include <hawser/hydro.h>

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

/// @throws DefError with file, line or variable, what is wrong, and the remedy. The result is free
/// of faults but for reference, which stays 0.
[[nodiscard]] WaveCoefficients read_coefficients(const std::string& file,
                                                 const HydroUnits& units = {});

}  // namespace hawser
