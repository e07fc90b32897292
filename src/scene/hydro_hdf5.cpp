// SPDX-License-Identifier: Apache-2.0
/// Read HDF5 files of BEMIO (WEC-Sim, M. Lawson and others). Dimensionless values:
/// ```
///     added_mass/all A/ρ, radiation_damping/all B/ρω      (6, all motions, frequencies)
///     excitation/re, im and excitation/scattering/re, im  X/ρg (6, directions, frequencies)
///     linear_restoring_stiffness C/ρg
/// ```
/// for each body, with phases of e^{+iωt}. If `scaled` is 1, A, B and X have dimensions.
#include "scene/hydro_read.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#if HAWSER_HAVE_HDF5
#include <hdf5.h>
#endif

namespace hawser::scene {

#if HAWSER_HAVE_HDF5

namespace {

constexpr hsize_t kMaxHdf5 = 20'000'000;

class Hdf5File {
  public:
    explicit Hdf5File(const Path& path) : path_(path) {
        H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // our messages replace those of the library
        id_ = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
        if (id_ < 0) throw_hydro_error(path, "it is no HDF5 file");
    }
    ~Hdf5File() { H5Fclose(id_); }
    Hdf5File(const Hdf5File&) = delete;
    Hdf5File& operator=(const Hdf5File&) = delete;

    struct Array {
        std::vector<hsize_t> size;
        std::vector<double> value;
        [[nodiscard]] double at(std::size_t i, std::size_t j, std::size_t k) const {
            return value[(i * size[1] + j) * size[2] + k];
        }
    };
    [[nodiscard]] bool has(const std::string& name) const {
        // H5Lexists() needs each part of the path separately.
        for (std::size_t end = name.find('/');; end = name.find('/', end + 1)) {
            if (H5Lexists(id_, name.substr(0, end).c_str(), H5P_DEFAULT) <= 0) return false;
            if (end == std::string::npos) return true;
        }
    }
    /// Return an array of `rank` dimensions; 0: any number of dimensions.
    [[nodiscard]] Array read(const std::string& name, int rank) const {
        if (!has(name)) throw_hydro_error(path_, "data set '" + name + "' is missing");
        const hid_t set = H5Dopen2(id_, name.c_str(), H5P_DEFAULT);
        if (set < 0) throw_hydro_error(path_, "'" + name + "' is no data set");
        const std::string fault = read_set(set, rank, out_);
        H5Dclose(set);
        if (!fault.empty()) throw_hydro_error(path_, "data set '" + name + "' " + fault);
        return std::move(out_);
    }

  private:
    [[nodiscard]] static std::string read_set(hid_t set, int rank, Array& out) {
        out = {};
        const hid_t space = H5Dget_space(set), type = H5Dget_type(set);
        const H5T_class_t kind = H5Tget_class(type);
        H5Tclose(type);
        hsize_t size[8] = {};
        const int has = H5Sget_simple_extent_ndims(space);
        if (has > 0 && has <= 8) H5Sget_simple_extent_dims(space, size, nullptr);
        H5Sclose(space);
        if (kind != H5T_FLOAT && kind != H5T_INTEGER) return "has no numbers";
        if (has < 0 || has > 8 || (rank > 0 && has != rank))
            return "has " + std::to_string(has) + " dimensions; " + std::to_string(rank) +
                   " belong there";
        hsize_t count = 1;
        for (int d = 0; d < has; ++d) {
            if (size[d] == 0 || size[d] > kMaxHdf5 / count)
                return "has more than " + std::to_string(kMaxHdf5) + " values, or none";
            count *= size[d];
            out.size.push_back(size[d]);
        }
        out.value.resize(count);
        if (H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, out.value.data()) < 0)
            return "cannot be read";
        return {};
    }
    const Path& path_;
    hid_t id_ = -1;
    mutable Array out_;
};

class Bemio {
  public:
    Bemio(const Path& path, const HydroUnits& units)
        : path_(path),
          file_(path),
          units_(units),
          at_("body" + std::to_string(units.body + 1) + "/hydro_coeffs/") {}

    WaveCoefficients read() {
        const double rho = units_.density, g = units_.gravity;
        const bool scaled = file_.has("simulation_parameters/scaled") &&
                            file_.read("simulation_parameters/scaled", 0).value[0] == 1.0;
        const std::vector<double> omega = file_.read("simulation_parameters/w", 0).value;
        order_.resize(omega.size());
        for (std::size_t i = 0; i < order_.size(); ++i) order_[i] = i;
        std::sort(order_.begin(), order_.end(),
                  [&](std::size_t a, std::size_t b) { return omega[a] < omega[b]; });
        for (const std::size_t w : order_) out_.frequency.push_back(omega[w]);
        const auto a = cube("added_mass/all", omega.size());
        const auto b = cube("radiation_damping/all", omega.size());
        for (const std::size_t w : order_) {
            out_.added_mass.push_back((scaled ? 1.0 : rho) * slice(a, w));
            out_.damping.push_back((scaled ? 1.0 : rho * omega[w]) * slice(b, w));
        }
        if (file_.has(at_ + "added_mass/inf_freq")) {
            out_.infinite = (scaled ? 1.0 : rho) * square("added_mass/inf_freq");
            out_.has_infinite = true;
        }
        if (file_.has(at_ + "linear_restoring_stiffness")) {
            out_.stiffness = (scaled ? 1.0 : rho * g) * square("linear_restoring_stiffness");
            out_.has_stiffness = true;
        }
        for (const double d : file_.read("simulation_parameters/wave_dir", 0).value)
            out_.heading.push_back(d * std::numbers::pi / 180.0);
        force("excitation/", scaled ? 1.0 : rho * g, omega.size(), out_.excitation);
        force("excitation/scattering/", scaled ? 1.0 : rho * g, omega.size(), out_.scattering);
        return std::move(out_);
    }

  private:
    [[nodiscard]] std::size_t column() const { return static_cast<std::size_t>(6 * units_.body); }
    Hdf5File::Array cube(const std::string& name, std::size_t frequencies) {
        auto m = file_.read(at_ + name, 3);
        if (m.size[0] < 6 || m.size[1] < column() + 6 || m.size[2] != frequencies)
            throw_hydro_error(
                path_, "data set '" + at_ + name + "': not 6 x 6 x " + std::to_string(frequencies));
        return m;
    }
    [[nodiscard]] Matrix6 slice(const Hdf5File::Array& m, std::size_t w) const {
        Matrix6 to;
        for (std::size_t i = 0; i < 6; ++i)
            for (std::size_t j = 0; j < 6; ++j)
                to(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
                    m.at(i, column() + j, w);
        return to;
    }
    Matrix6 square(const std::string& name) {
        const auto m = file_.read(at_ + name, 2);
        const std::size_t from = m.size[1] >= column() + 6 ? column() : 0;
        if (m.size[0] < 6 || m.size[1] < 6)
            throw_hydro_error(path_, "data set '" + at_ + name + "': not 6 x 6");
        Matrix6 to;
        for (std::size_t i = 0; i < 6; ++i)
            for (std::size_t j = 0; j < 6; ++j)
                to(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
                    m.value[i * m.size[1] + from + j];
        return to;
    }
    void force(const std::string& name, double scale, std::size_t frequencies,
               std::vector<std::complex<double>>& table) {
        if (!file_.has(at_ + name + "re")) return;
        const auto re = file_.read(at_ + name + "re", 3), im = file_.read(at_ + name + "im", 3);
        for (const auto* m : {&re, &im})
            if (m->size[0] < 6 || m->size[1] != out_.heading.size() || m->size[2] != frequencies)
                throw_hydro_error(path_, "data set '" + at_ + name + "': not 6 x " +
                                             std::to_string(out_.heading.size()) + " x " +
                                             std::to_string(frequencies));
        // BEMIO writes NaN for values that a program did not compute.
        if (std::all_of(re.value.begin(), re.value.end(), [](double x) { return std::isnan(x); }))
            return;
        for (std::size_t h = 0; h < out_.heading.size(); ++h)
            for (const std::size_t w : order_)
                for (std::size_t k = 0; k < 6; ++k)
                    table.push_back(scale * std::complex<double>(re.at(k, h, w), -im.at(k, h, w)));
    }

    const Path& path_;
    Hdf5File file_;
    const HydroUnits& units_;
    std::string at_;
    std::vector<std::size_t> order_;
    WaveCoefficients out_;
};

}  // namespace

WaveCoefficients read_bemio(const Path& path, const HydroUnits& units) {
    return Bemio(path, units).read();
}

#else

WaveCoefficients read_bemio(const Path& path, const HydroUnits&) {
    throw_hydro_error(path,
                      "this hawser was built without HDF5; install libhdf5-dev and build with "
                      "HAWSER_HDF5=ON");
}

#endif

}  // namespace hawser::scene
