// SPDX-License-Identifier: Apache-2.0
// Files of coefficients by other programs: small ones, written here in each format, and hostile
// ones. HAWSER_HYDRO_DATA names a folder of real ones, which are then read, too.
#include <hawser/hull.h>
#include <hawser/hydro_files.h>
#include <hawser/scene.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include <unistd.h>

#if HAWSER_HAVE_NETCDF
#include <netcdf.h>
#endif
#if HAWSER_HAVE_HDF5
#include <hdf5.h>
#endif

namespace hawser::test {
namespace {

namespace fs = std::filesystem;
using Complex = std::complex<double>;
constexpr double kRho = 1025.0, kG = 9.81, kPi = std::numbers::pi;

/// A folder that goes with the test.
class Folder {
  public:
    Folder() {
        path_ = fs::temp_directory_path() /
                ("hawser_hydro_" + std::to_string(::getpid()) + "_" +
                 ::testing::UnitTest::GetInstance()->current_test_info()->name());
        fs::create_directories(path_);
    }
    ~Folder() { fs::remove_all(path_); }
    std::string write(const std::string& name, const std::string& text) const {
        std::ofstream(path_ / name, std::ios::binary) << text;
        return (path_ / name).string();
    }
    fs::path operator/(const std::string& name) const { return path_ / name; }

  private:
    fs::path path_;
};

// What all formats are to give: heave and sway-roll at four frequencies, 0 and 90 degrees.
double added(int i, int j, double omega) {
    const double a[6] = {1e5, 2e5, 3e5, 4e6, 5e6, 6e6};
    if (i == j) return a[i] * (1.0 + 0.1 / omega);
    return (i == 1 && j == 3) || (i == 3 && j == 1) ? -2e5 : 0.0;
}
double damped(int i, int j, double omega) {
    const double b[6] = {1e4, 2e4, 3e4, 4e5, 5e5, 6e5};
    return i == j ? b[i] * omega * std::exp(-omega) : 0.0;
}
Complex pushed(int k, int head, double omega) {
    return Complex(1e4 * (k + 1), -2e3 * (head + 1)) * std::exp(-0.3 * omega);
}
const std::vector<double> kOmega{0.4, 0.7, 1.0, 1.5, 2.2};
const std::vector<double> kHead{0.0, 90.0};

void expect_all(const WaveCoefficients& c, bool scattering) {
    ASSERT_EQ(c.frequency.size(), kOmega.size());
    ASSERT_EQ(c.heading.size(), 2u);
    EXPECT_NEAR(c.heading[1], 0.5 * kPi, 1e-6);
    for (std::size_t w = 0; w < kOmega.size(); ++w) {
        EXPECT_NEAR(c.frequency[w], kOmega[w], 1e-5);
        for (int i = 0; i < 6; ++i) {
            for (int j = 0; j < 6; ++j) {
                // Text files have seven digits.
                EXPECT_NEAR(c.added_mass[w](i, j), added(i, j, kOmega[w]), 1e-5 * 6e6);
                EXPECT_NEAR(c.damping[w](i, j), damped(i, j, kOmega[w]), 1e-5 * 6e5);
            }
            for (int h = 0; h < 2; ++h) {
                const Complex x = pushed(i, h, kOmega[w]);
                const std::size_t at = c.index(std::size_t(h), w, i);
                EXPECT_LT(std::abs(c.excitation[at] - x), 1e-5 * std::abs(x)) << i << h << w;
                if (scattering) {
                    EXPECT_LT(std::abs(c.scattering[at] - 0.5 * x), 1e-5 * std::abs(x));
                }
            }
        }
    }
}

std::string line(const char* format, auto... values) {
    char text[256];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

std::string wamit_1(bool swapped = false) {
    std::string out;
    const auto scale = [](int i, int j) { return kRho * std::pow(2.0, 3 + (i > 2) + (j > 2)); };
    for (int i = 0; i < 6; ++i) {
        const double infinite = added(i, i, 1e9), zero = 1.4 * infinite;
        out += line(" -1.0 %d %d %.9E\n", i + 1, i + 1, (swapped ? infinite : zero) / scale(i, i));
        out += line(" 0.0 %d %d %.9E\n", i + 1, i + 1, (swapped ? zero : infinite) / scale(i, i));
    }
    for (std::size_t w = kOmega.size(); w-- > 0;)  // by ascending period
        for (int i = 0; i < 6; ++i)
            for (int j = 0; j < 6; ++j)
                if (added(i, j, 1.0) != 0.0)
                    out += line(" %.9E %d %d %.9E %.9E\n", 2 * kPi / kOmega[w], i + 1, j + 1,
                                added(i, j, kOmega[w]) / scale(i, j),
                                damped(i, j, kOmega[w]) / scale(i, j) / kOmega[w]);
    return out;
}

std::string wamit_3() {
    std::string out = " PER BETA I MOD PHA RE IM\n";
    for (std::size_t w = kOmega.size(); w-- > 0;)
        for (int h = 0; h < 2; ++h)
            for (int k = 0; k < 6; ++k) {
                const Complex x =
                    std::conj(pushed(k, h, kOmega[w])) / (kRho * kG * std::pow(2.0, k > 2 ? 3 : 2));
                out += line(" %.9E %.6E %d %.7E %.7E %.9E %.9E\n", 2 * kPi / kOmega[w],
                            kHead[std::size_t(h)], k + 1, std::abs(x), std::arg(x) * 180 / kPi,
                            x.real(), x.imag());
            }
    return out;
}

std::string wamit_9() {
    std::string out;
    for (std::size_t w = kOmega.size(); w-- > 0;)
        for (int h = 0; h < 2; ++h)
            for (int k = 0; k < 6; ++k)
                out += line(" %.9E %.6E %.6E %d 1.0 0.0 %.9E 0.0\n", 2 * kPi / kOmega[w],
                            kHead[std::size_t(h)], kHead[std::size_t(h)], k + 1,
                            100.0 * (k + 1) / (kRho * kG * std::pow(2.0, k > 2 ? 2 : 1)));
    return out;
}

const HydroUnits kUnits{.density = kRho, .gravity = kG};

void refuses(const std::string& file, const char* why) {
    try {
        (void)read_coefficients(file, kUnits);
        ADD_FAILURE() << "taken, but for " << why;
    } catch (const DefError& error) {
        EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
    }
}

TEST(HydroFiles, Wamit) {
    const Folder folder;
    folder.write("a.gdf", "title\n 2.0 9.81\n");
    folder.write("a.3", wamit_3());
    folder.write("a.9", wamit_9());
    folder.write("a.hst", " 3 3 1.5\n 4 4 2.5\n 5 5 3.5\n");
    const WaveCoefficients c = read_coefficients(folder.write("a.1", wamit_1()), kUnits);
    expect_all(c, false);
    EXPECT_NEAR(c.infinite(2, 2), added(2, 2, 1e9), 1.0);
    EXPECT_NEAR(c.zero(2, 2), 1.4 * added(2, 2, 1e9), 1.0);
    EXPECT_NEAR(c.drift[c.index(1, 2, 4)], 500.0, 1e-3);
    EXPECT_NEAR(c.stiffness(2, 2), 1.5 * kRho * kG * 4, 1e-6);
    EXPECT_NEAR(c.stiffness(3, 3), 2.5 * kRho * kG * 16, 1e-6);
}

TEST(HydroFiles, WamitsMistakes) {
    const Folder folder;
    folder.write("a.gdf", "title\n 2.0 9.81\n");
    const std::string good = wamit_1();
    refuses(folder.write("s.1", ""), "no line of a period");
    const std::size_t last = good.rfind('\n', good.size() - 2);
    refuses(folder.write("a.1", good.substr(0, last + 1)), "missing");
    refuses(folder.write("a.1", good + good.substr(last + 1)), "given twice");
    refuses(folder.write("a.1", good + " 3.0 1 1 x 0\n"), "'x' is no finite number");
    refuses(folder.write("a.1", good + " 3.0 1 1 1e999 0\n"), "is no finite number");
    refuses(folder.write("a.1", good + " 3.0 1 1 1\n"), "5 belong here");
    refuses(folder.write("a.1", good + " 3.0 0 1 1 1\n"), "is none of 1, 2");
    folder.write("a.1", good);
    refuses(folder.write("b.1", good + std::string(1000, '1')), "line");
    std::string three = wamit_3();
    folder.write("a.3", three.substr(0, three.rfind('\n', three.size() - 2) + 1));
    refuses((folder / "a.1").string(), "missing");
    folder.write("a.3", three + " 3.3 0.0 1 1 1 1 1\n");
    refuses((folder / "a.1").string(), "is not in a.1");
    refuses((folder / "none.1").string(), "cannot open");
    refuses(folder.write("a.txt", good), "ends with none of");
}

TEST(HydroFiles, NegativeDampingAndSwappedLimits) {
    const Folder folder;
    std::string text;
    for (int n = 1; n <= 40; ++n) {
        const double omega = 0.1 * n;
        text += line(" %.9E 3 3 %.9E %.9E\n", 2 * kPi / omega, 1.0,
                     n == 7 ? -0.3 : omega * std::exp(-omega));
    }
    refuses(folder.write("a.1", text), "0.7 rad/s is not positive semi-definite");
}

std::string tec_radiation() {
    std::string out = "VARIABLES=\"w (rad/s)\"\n\"A   1   1\" \"B   1   1\"\n";
    for (int j = 0; j < 6; ++j) {
        out += line("Zone t=\"Motion of body  1 in DoF  %d\",I=   5,F=POINT\n", j + 1);
        for (const double w : kOmega) {
            out += line("  %.7E", w);
            for (int i = 0; i < 6; ++i)
                out += line("  %.7E  %.7E", added(i, j, w), damped(i, j, w));
            out += "\n";
        }
    }
    return out;
}

std::string tec_force(double share) {
    std::string out = "VARIABLES=\"w (rad/s)\"\n\"abs(F   1   1)\" \"angle(F   1   1)\"\n";
    for (int h = 0; h < 2; ++h) {
        out += line("Zone t=\"Diffraction force - beta = %7.3f deg\",I=   5,F=POINT\n",
                    kHead[std::size_t(h)]);
        for (const double w : kOmega) {
            out += line("  %.7E", w);
            for (int k = 0; k < 6; ++k) {
                const Complex x = share * pushed(k, h, w);
                out += line("  %.7E  %.7E", std::abs(x), std::arg(x));
            }
            out += "\n";
        }
    }
    return out;
}

TEST(HydroFiles, Nemoh) {
    const Folder folder;
    folder.write("ExcitationForce.tec", tec_force(1.0));
    folder.write("DiffractionForce.tec", tec_force(0.5));
    const std::string file = folder.write("RadiationCoefficients.tec", tec_radiation());
    expect_all(read_coefficients(file), true);
    const std::string good = tec_force(1.0);
    folder.write("ExcitationForce.tec", good.substr(0, good.size() / 2));
    refuses(file, "numbers");
    folder.write("ExcitationForce.tec", "1 2 3\n");
    refuses(file, "no zone");
    std::string other = good;
    other.replace(other.find("4.0000000E-01"), 13, "4.1000000E-01");
    folder.write("ExcitationForce.tec", other);
    refuses(file, "is not that of line 1");
}

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

TEST(HydroFiles, MeshesOfGdfAndNemoh) {
    const Folder folder;
    // A quarter of a box of 8 × 4 m, 3 m deep, without a deck.
    const std::string gdf =
        "a box\n 2.0 9.81\n 1 1\n 3\n"
        "0 0 -1.5  0 1 -1.5  2 1 -1.5  2 0 -1.5\n"
        "2 0 -1.5  2 1 -1.5  2 1 0  2 0 0\n"
        "2 1 -1.5  0 1 -1.5  0 1 0  2 1 0\n";
    HullMesh mesh = read_hull(folder.write("a.gdf", gdf));
    EXPECT_NE(hull_fault(mesh).find("open"), std::string::npos);
    close_hull(mesh, 2.0);
    EXPECT_EQ(hull_fault(mesh), "");
    EXPECT_NEAR(hull_statics(mesh, {}).volume, 8 * 4 * 3, 1e-9);
    // Half of it, mirrored in y.
    const std::string dat =
        "2 1\n1 -4 0 -3\n2 4 0 -3\n3 4 2 -3\n4 -4 2 -3\n5 -4 0 0\n6 4 0 0\n7 4 2 0\n8 -4 2 0\n"
        "0 0 0 0\n1 4 3 2\n2 3 7 6\n3 4 8 7\n4 1 5 8\n0 0 0 0\n";
    mesh = read_hull(folder.write("a.dat", dat));
    close_hull(mesh, 0.0);
    EXPECT_EQ(hull_fault(mesh), "");
    EXPECT_NEAR(hull_statics(mesh, {}, 0.5).volume, 8 * 4 * 3, 1e-9);
    for (const char* bad : {"", "2 1\n1 0 0\n", "2 1\n1 0 0 0\n0 0 0 0\n1 2 3 4\n", "3 1\n"})
        EXPECT_THROW((void)read_hull(folder.write("b.dat", bad)), DefError) << bad;
    for (const char* bad : {"", "t\n-1 9.81\n0 0\n1\n", "t\n1 9.81\n0 0\n99999999999\n",
                            "t\n1 9.81\n0 0\n1\n0 0 0 0 0 0 0 0 0 0 0\n"})
        EXPECT_THROW((void)read_hull(folder.write("b.gdf", bad)), DefError) << bad;
}

/// Files that were cut or changed at random are refused, or read as something finite.
TEST(HydroFiles, ChangedFilesDoNoHarm) {
    const Folder folder;
    std::uint64_t seed = 7;
    const auto random = [&](std::size_t below) {
        seed = seed * 6364136223846793005ull + 1442695040888963407ull;
        return static_cast<std::size_t>(seed >> 33) % below;
    };
    folder.write("a.gdf", "t\n 2.0 9.81\n");
    int taken = 0;
    for (int round = 0; round < 400; ++round) {
        std::string one = wamit_1(), three = wamit_3();
        std::string& which = round % 2 == 0 ? one : three;
        for (int n = 0; n < 3; ++n) which[random(which.size())] = "0123456789.-+E \nx"[random(17)];
        if (round % 5 == 0) which.resize(random(which.size()));
        folder.write("a.3", three);
        try {
            const WaveCoefficients c = read_coefficients(folder.write("a.1", one), kUnits);
            EXPECT_EQ(coefficients_fault(c), "");
            ++taken;
        } catch (const DefError&) {
        }
    }
    EXPECT_GT(taken, 0);
    EXPECT_LT(taken, 400);
}

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
}  // namespace hawser::test
