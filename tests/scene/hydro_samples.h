// SPDX-License-Identifier: Apache-2.0
#pragma once
// Expected contents of small files of coefficients, which tests write in each format.
#include <hawser/hydro_files.h>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include <unistd.h>

namespace hawser::test::hydro {

namespace fs = std::filesystem;
using Complex = std::complex<double>;
inline constexpr double kRho = 1025.0, kG = 9.81, kPi = std::numbers::pi;

/// A folder that the destructor deletes.
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

// Return the expected values of all formats: heave and sway-roll at four frequencies, 0 and 90
// degrees.
inline double added(int i, int j, double omega) {
    const double a[6] = {1e5, 2e5, 3e5, 4e6, 5e6, 6e6};
    if (i == j) return a[i] * (1.0 + 0.1 / omega);
    return (i == 1 && j == 3) || (i == 3 && j == 1) ? -2e5 : 0.0;
}
inline double damped(int i, int j, double omega) {
    const double b[6] = {1e4, 2e4, 3e4, 4e5, 5e5, 6e5};
    return i == j ? b[i] * omega * std::exp(-omega) : 0.0;
}
inline Complex pushed(int k, int head, double omega) {
    return Complex(1e4 * (k + 1), -2e3 * (head + 1)) * std::exp(-0.3 * omega);
}
inline const std::vector<double> kOmega{0.4, 0.7, 1.0, 1.5, 2.2};
inline const std::vector<double> kHead{0.0, 90.0};

inline void expect_all(const WaveCoefficients& c, bool scattering) {
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

inline std::string line(const char* format, auto... values) {
    char text[256];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

inline const HydroUnits kUnits{.density = kRho, .gravity = kG};

/// Expect an error that contains `why`. Reads in this process: sanitized builds of a test have no
/// reader program beside them.
inline void refuses(const std::string& file, const char* why) {
    try {
        (void)read_coefficients(file, kUnits, {.in_process = true});
        ADD_FAILURE() << "taken, but for " << why;
    } catch (const DefError& error) {
        EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
    }
}

}  // namespace hawser::test::hydro
