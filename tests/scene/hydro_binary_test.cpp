// SPDX-License-Identifier: Apache-2.0
// Coefficients in netCDF and HDF5: small files written here, and hostile ones. If HAWSER_HYDRO_DATA
// names a folder of real files of all formats, they are read too.
#include <hawser/hydro_files.h>

#include "scene/hydro_binary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

namespace hawser::test::hydro {
namespace {

/// Read in this process: sanitized builds of a test have no reader program beside them.
[[maybe_unused]] const ReaderLimits kHere{.in_process = true};

#if HAWSER_HAVE_NETCDF

TEST(HydroFiles, Capytaine) {
    const Folder folder;
    for (const int mode : {NC_64BIT_OFFSET, NC_NETCDF4}) {
        write_netcdf(folder / "a.nc", mode);
        const WaveCoefficients c = read_coefficients((folder / "a.nc").string(), {}, kHere);
        expect_all(c, true);
        EXPECT_NEAR(c.infinite(2, 2), added(2, 2, 1e9), 1.0);
        EXPECT_TRUE(c.has_zero);
    }
    write_netcdf(folder / "a.nc", NC_CLOBBER, false);
    refuses((folder / "a.nc").string(), "needs six");
    refuses(folder.write("a.nc", "CDF no file at all"), "netCDF");
    refuses(folder.write("a.nc", ""), "netCDF");
}

#endif
#if HAWSER_HAVE_HDF5

TEST(HydroFiles, Bemio) {
    const Folder folder;
    write_hdf5(folder / "a.h5", 5);
    const WaveCoefficients c = read_coefficients((folder / "a.h5").string(), kUnits, kHere);
    expect_all(c, true);
    EXPECT_NEAR(c.stiffness(4, 4), 7.0 * kRho * kG, 1e-6);
    write_hdf5(folder / "a.h5", 4);
    refuses((folder / "a.h5").string(), "not 6 x 6 x 5");
    std::string bytes;
    {
        std::ifstream in(folder / "a.h5", std::ios::binary);
        bytes.assign(std::istreambuf_iterator<char>(in), {});
    }
    refuses(folder.write("b.h5", bytes.substr(0, bytes.size() / 3)), "HDF5");
    refuses(folder.write("b.h5", "text"), "HDF5");
}

#endif

// A format left out of a build is reported, with the package to install.
#if !HAWSER_HAVE_NETCDF
TEST(HydroFiles, WithoutNetcdfCapytaineIsRefused) {
    const Folder folder;
    refuses(folder.write("a.nc", "CDF"), "install libnetcdf-dev and build with HAWSER_NETCDF=ON");
}
#endif
#if !HAWSER_HAVE_HDF5
TEST(HydroFiles, WithoutHdf5BemioIsRefused) {
    const Folder folder;
    refuses(folder.write("a.h5", "text"), "install libhdf5-dev and build with HAWSER_HDF5=ON");
}
#endif

TEST(HydroFiles, RealOnes) {
    const char* folder = std::getenv("HAWSER_HYDRO_DATA");
    if (folder == nullptr) GTEST_SKIP() << "HAWSER_HYDRO_DATA names no folder";
    const fs::path data(folder);
    const WaveCoefficients semi = read_coefficients((data / "semisub.1").string());
    // In long waves the surge force leads the wave by a quarter of a period, in all files.
    const auto phase = [](const WaveCoefficients& c, std::size_t w, int k) {
        return std::arg(c.excitation[c.index(0, w, k)]) * 180 / kPi;
    };
    EXPECT_EQ(semi.frequency.size(), 29u);
    EXPECT_NEAR(phase(semi, 0, 0), -90.0, 3.0);
    EXPECT_NEAR(phase(semi, 0, 2), 0.0, 3.0);
    const WaveCoefficients cylinder =
        read_coefficients((data / "nemoh_cylinder/RadiationCoefficients.tec").string());
    EXPECT_NEAR(phase(cylinder, 0, 0), -90.0, 1.0);
    EXPECT_NEAR(phase(cylinder, 0, 2), 0.0, 1.0);
#if HAWSER_HAVE_NETCDF
    const WaveCoefficients capytaine = read_coefficients((data / "capytaine_sphere.nc").string());
    EXPECT_NEAR(phase(capytaine, 0, 0), -90.0, 1.0);
    EXPECT_NEAR(phase(capytaine, 0, 2), 0.0, 1.0);
#endif
#if HAWSER_HAVE_HDF5
    const WaveCoefficients bemio =
        read_coefficients((data / "sphere.h5").string(), {.density = 1000});
    EXPECT_NEAR(phase(bemio, 0, 0), -90.0, 1.0);
    EXPECT_NEAR(phase(bemio, 0, 2), 0.0, 1.0);
#endif
}

}  // namespace
}  // namespace hawser::test::hydro
