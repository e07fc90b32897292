// SPDX-License-Identifier: Apache-2.0
#pragma once
// Writes small files of coefficients in netCDF and HDF5.
#include "scene/hydro_samples.h"

#if HAWSER_HAVE_NETCDF
#include <netcdf.h>
#endif
#if HAWSER_HAVE_HDF5
#include <hdf5.h>
#endif

namespace hawser::test::hydro {

#if HAWSER_HAVE_NETCDF

inline void write_netcdf(const fs::path& path, int mode, bool whole = true) {
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
    omega.insert(omega.end(), kOmega.rbegin(), kOmega.rend());  // descending, with ∞ and 0 among
                                                                // them
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

inline fs::path write_sample_netcdf(const fs::path& path, bool four) {
    write_netcdf(path, four ? NC_NETCDF4 : NC_64BIT_OFFSET);
    return path;
}

/// Write a file with a number of zeros as frequencies; most of it is a hole.
inline fs::path write_large_netcdf(const fs::path& path, std::size_t values) {
    int id = 0, dim = 0, var = 0;
    nc_create(path.c_str(), NC_64BIT_OFFSET | NC_CLOBBER, &id);
    nc_set_fill(id, NC_NOFILL, nullptr);
    nc_def_dim(id, "omega", values, &dim);
    nc_def_var(id, "omega", NC_DOUBLE, 1, &dim, &var);
    nc_enddef(id);
    const std::size_t last = values - 1;
    const double one = 1.0;
    nc_put_var1_double(id, var, &last, &one);
    nc_close(id);
    return path;
}

#endif
#if HAWSER_HAVE_HDF5

inline void put(hid_t file, const std::string& name, const std::vector<hsize_t>& size,
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

inline void write_hdf5(const fs::path& path, hsize_t frequencies) {
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

inline fs::path write_sample_hdf5(const fs::path& path) {
    write_hdf5(path, 5);
    return path;
}

#endif

}  // namespace hawser::test::hydro
