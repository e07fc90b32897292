// SPDX-License-Identifier: Apache-2.0
// Coefficients in netCDF and HDF5: small files, written here, and hostile ones. HAWSER_HYDRO_DATA
// names a folder of real ones of all formats, which are then read, too.
#include <hawser/hydro_files.h>

#include "scene/hydro_samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#if HAWSER_HAVE_NETCDF
#include <netcdf.h>
#endif
#if HAWSER_HAVE_HDF5
#include <hdf5.h>
#endif

namespace hawser::test::hydro {
namespace {

#if HAWSER_HAVE_NETCDF

void write_netcdf(const fs::path& path, int mode, bool whole = true) {
    int id = 0, dim[5], var[6];
    ASSERT_EQ(nc_create(path.c_str(), mode | NC_CLOBBER, &id), NC_NOERR);
    nc_def_dim(id, "omega", kOmega.size() + 2, &dim[0]);
    nc_def_dim(id, "radiating_dof", 6, &dim[1]);
    nc_def_dim(id, "influenced_dof", whole ? 6 : 5, &dim[2]);
    nc_def_dim(id, "wave_direction", 2, &dim[3]);
    nc_def_dim(id, "complex", 2, &dim[4]);
    const int matrix[] = {dim[0], dim[1], dim[2]}, force[] = {dim[4], dim[0], dim[3], dim[2]};
    nc_def_var(id, "omega", NC_DOUBLE, 1, dim, &var[0]);
    nc_def_var(id, "wave_direction", NC_DOUBLE, 1, dim + 3, &var[1]);
    nc_def_var(id, "added_mass", NC_DOUBLE, 3, matrix, &var[2]);
    nc_def_var(id, "radiation_damping", NC_DOUBLE, 3, matrix, &var[3]);
    nc_def_var(id, "excitation_force", NC_DOUBLE, 4, force, &var[4]);
    nc_def_var(id, "diffraction_force", NC_DOUBLE, 4, force, &var[5]);
    nc_enddef(id);
    std::vector<double> omega{INFINITY}, a, b, x, half;
    omega.insert(omega.end(), kOmega.rbegin(), kOmega.rend());  // descending, ∞ and 0 among them
    omega.push_back(0.0);
    const int motions = whole ? 6 : 5;
    for (const double w : omega)
        for (int j = 0; j < 6; ++j)
            for (int i = 0; i < motions; ++i) {
                a.push_back(std::isinf(w) ? added(i, j, 1e9)
                            : w == 0.0    ? 1.4 * added(i, j, 1e9)
                                          : added(i, j, w));
                b.push_back(std::isinf(w) || w == 0.0 ? 0.0 : damped(i, j, w));
            }
    for (int part = 0; part < 2; ++part)
        for (const double w : omega)
            for (int h = 0; h < 2; ++h)
                for (int k = 0; k < motions; ++k) {
                    const Complex f = std::isinf(w) ? Complex() : pushed(k, h, w);
                    x.push_back(part == 0 ? f.real() : f.imag());
                    half.push_back(0.5 * x.back());
                }
    const double head[] = {0.0, 0.5 * kPi};
    nc_put_var_double(id, var[0], omega.data());
    nc_put_var_double(id, var[1], head);
    nc_put_var_double(id, var[2], a.data());
    nc_put_var_double(id, var[3], b.data());
    nc_put_var_double(id, var[4], x.data());
    nc_put_var_double(id, var[5], half.data());
    nc_close(id);
}

TEST(HydroFiles, Capytaine) {
    const Folder folder;
    for (const int mode : {NC_64BIT_OFFSET, NC_NETCDF4}) {
        write_netcdf(folder / "a.nc", mode);
        const WaveCoefficients c = read_coefficients((folder / "a.nc").string());
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

void put(hid_t file, const std::string& name, const std::vector<hsize_t>& size,
         const std::vector<double>& value) {
    const hid_t links = H5Pcreate(H5P_LINK_CREATE);
    H5Pset_create_intermediate_group(links, 1);
    const hid_t space = H5Screate_simple(int(size.size()), size.data(), nullptr);
    const hid_t set =
        H5Dcreate2(file, name.c_str(), H5T_NATIVE_DOUBLE, space, links, H5P_DEFAULT, H5P_DEFAULT);
    H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, value.data());
    H5Dclose(set);
    H5Sclose(space);
    H5Pclose(links);
}

void write_hdf5(const fs::path& path, hsize_t frequencies) {
    const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    const std::string at = "body1/hydro_coeffs/";
    std::vector<double> a, b, infinite, stiffness;
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) {
            infinite.push_back(added(i, j, 1e9) / kRho);
            stiffness.push_back(i == j ? 7.0 : 0.0);
            for (const double w : kOmega) {
                a.push_back(added(i, j, w) / kRho);
                b.push_back(damped(i, j, w) / (kRho * w));
            }
        }
    put(file, at + "added_mass/all", {6, 6, frequencies}, a);
    put(file, at + "added_mass/inf_freq", {6, 6}, infinite);
    put(file, at + "radiation_damping/all", {6, 6, frequencies}, b);
    put(file, at + "linear_restoring_stiffness", {6, 6}, stiffness);
    for (const double share : {1.0, 0.5}) {
        std::vector<double> re, im;
        for (int k = 0; k < 6; ++k)
            for (int h = 0; h < 2; ++h)
                for (const double w : kOmega) {
                    const Complex x = share * std::conj(pushed(k, h, w)) / (kRho * kG);
                    re.push_back(x.real());
                    im.push_back(x.imag());
                }
        const std::string of = at + (share == 1.0 ? "excitation/" : "excitation/scattering/");
        put(file, of + "re", {6, 2, 5}, re);
        put(file, of + "im", {6, 2, 5}, im);
    }
    put(file, "simulation_parameters/w", {5, 1}, kOmega);
    put(file, "simulation_parameters/wave_dir", {2, 1}, kHead);
    put(file, "simulation_parameters/scaled", {1, 1}, {0.0});
    H5Fclose(file);
}

TEST(HydroFiles, Bemio) {
    const Folder folder;
    write_hdf5(folder / "a.h5", 5);
    const WaveCoefficients c = read_coefficients((folder / "a.h5").string(), kUnits);
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

// What was left out of a build is said, with what to install.
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
    // In long waves the surge force runs a quarter of a period before the wave, as in all files.
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
