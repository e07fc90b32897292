// SPDX-License-Identifier: Apache-2.0
/// Data sets of Capytaine (M. Ancellin and F. Dias, 2019) in netCDF-3 or -4: SI units, e^{−iωt}.
/// ```
///     added_mass, radiation_damping (omega, radiating_dof, influenced_dof)
///     excitation_force, diffraction_force (complex, omega, wave_direction, influenced_dof)
/// ```
/// with the axes in any order. ω = 0 and ω = ∞ among the frequencies are A(0) and A(∞).
#include "scene/hydro_read.h"

#include <algorithm>
#include <array>
#include <cmath>

#if HAWSER_HAVE_NETCDF
#include <netcdf.h>
#endif

namespace hawser::scene {

#if HAWSER_HAVE_NETCDF

namespace {

constexpr std::size_t kMaxNetcdf = 20'000'000;

class NetcdfFile {
  public:
    explicit NetcdfFile(const Path& path) : path_(path) {
        check_netcdf(nc_open(path.c_str(), NC_NOWRITE, &id_), "it is no netCDF file");
    }
    ~NetcdfFile() { nc_close(id_); }
    NetcdfFile(const NetcdfFile&) = delete;
    NetcdfFile& operator=(const NetcdfFile&) = delete;

    struct Array {
        std::vector<std::string> axis;
        std::vector<std::size_t> size;
        std::vector<double> value;

        /// Return the value at indices given by axis names; other axes have index 0.
        [[nodiscard]] double at(
            std::initializer_list<std::pair<const char*, std::size_t>> index) const {
            std::size_t flat = 0;
            for (std::size_t d = 0; d < axis.size(); ++d) {
                std::size_t i = 0;
                for (const auto& [name, k] : index)
                    if (axis[d] == name) i = k;
                flat = flat * size[d] + i;
            }
            return value[flat];
        }
    };
    [[nodiscard]] bool has(const char* name) const {
        int var = 0;
        return nc_inq_varid(id_, name, &var) == NC_NOERR;
    }
    [[nodiscard]] Array read(const char* name) const {
        const std::string what = std::string("variable '") + name + "'";
        int var = 0, axes = 0;
        check_netcdf(nc_inq_varid(id_, name, &var), what + " is missing");
        check_netcdf(nc_inq_varndims(id_, var, &axes), what);
        if (axes > 6) throw_hydro_error(path_, what + " has more than 6 dimensions");
        std::array<int, 6> of{};
        check_netcdf(nc_inq_vardimid(id_, var, of.data()), what);
        Array out;
        std::size_t count = 1;
        for (int d = 0; d < axes; ++d) {
            char text[NC_MAX_NAME + 1] = {};
            std::size_t size = 0;
            check_netcdf(nc_inq_dim(id_, of[static_cast<std::size_t>(d)], text, &size), what);
            if (size == 0 || size > kMaxNetcdf / count)
                throw_hydro_error(path_, what + " has more than " + std::to_string(kMaxNetcdf) +
                                             " values, or none");
            count *= size;
            out.axis.emplace_back(text);
            out.size.push_back(size);
        }
        nc_type type = NC_CHAR;
        check_netcdf(nc_inq_vartype(id_, var, &type), what);
        if (type == NC_CHAR || type >= NC_STRING)
            throw_hydro_error(path_, what + " has no numbers");
        out.value.resize(count);
        check_netcdf(nc_get_var_double(id_, var, out.value.data()), what + " cannot be read");
        return out;
    }

  private:
    void check_netcdf(int status, const std::string& what) const {
        if (status != NC_NOERR)
            throw_hydro_error(path_, what + " (" + std::string(nc_strerror(status)) + ")");
    }
    const Path& path_;
    int id_ = 0;
};

void need_axis(const Path& file, const NetcdfFile::Array& of, const char* variable,
               const char* axis, std::size_t size) {
    for (std::size_t d = 0; d < of.axis.size(); ++d)
        if (of.axis[d] == axis) {
            if (of.size[d] == size) return;
            throw_hydro_error(file, std::string("variable '") + variable +
                                        "': " + std::to_string(of.size[d]) + " along '" + axis +
                                        "'; " + std::to_string(size) + " belong there");
        }
    throw_hydro_error(file,
                      std::string("variable '") + variable + "' has no dimension '" + axis + "'");
}

/// Return the indices of positive finite frequencies in ascending order of ω.
std::vector<std::size_t> positive_finite(const std::vector<double>& omega) {
    std::vector<std::size_t> out;
    for (std::size_t i = 0; i < omega.size(); ++i)
        if (omega[i] > 0.0 && std::isfinite(omega[i])) out.push_back(i);
    std::sort(out.begin(), out.end(),
              [&](std::size_t a, std::size_t b) { return omega[a] < omega[b]; });
    return out;
}

void read_capytaine_forces(const Path& path, const NetcdfFile& file, const char* name,
                           const std::vector<double>& omega, const std::vector<std::size_t>& order,
                           std::size_t first, WaveCoefficients& out,
                           std::vector<std::complex<double>>& table) {
    if (!file.has(name)) return;
    const auto force = file.read(name);
    need_axis(path, force, name, "complex", 2);
    need_axis(path, force, name, "omega", omega.size());
    need_axis(path, force, name, "wave_direction", out.heading.size());
    for (std::size_t h = 0; h < out.heading.size(); ++h)
        for (const std::size_t w : order)
            for (std::size_t k = 0; k < 6; ++k) {
                const auto part = [&](std::size_t c) {
                    return force.at({{"complex", c},
                                     {"omega", w},
                                     {"wave_direction", h},
                                     {"influenced_dof", first + k}});
                };
                table.emplace_back(part(0), part(1));
            }
}

}  // namespace

WaveCoefficients read_capytaine(const Path& path, const HydroUnits& units) {
    const NetcdfFile file(path);
    WaveCoefficients out;
    const std::vector<double> omega = file.read("omega").value;
    std::vector<std::size_t> order = positive_finite(omega);
    const auto first = static_cast<std::size_t>(6 * units.body);
    const auto a = file.read("added_mass"), b = file.read("radiation_damping");
    for (const auto* m : {&a, &b}) {
        const char* const name = m == &a ? "added_mass" : "radiation_damping";
        need_axis(path, *m, name, "omega", omega.size());
        for (std::size_t d = 0; d < m->axis.size(); ++d)
            if (m->axis[d].ends_with("_dof") && m->size[d] < first + 6)
                throw_hydro_error(path, std::string("variable '") + name +
                                            "': " + std::to_string(m->size[d]) + " motions; body " +
                                            std::to_string(units.body) + " needs six");
    }
    const auto matrix = [&](const NetcdfFile::Array& m, std::size_t w) {
        Matrix6 to;
        for (std::size_t i = 0; i < 6; ++i)
            for (std::size_t j = 0; j < 6; ++j)
                to(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = m.at(
                    {{"omega", w}, {"radiating_dof", first + j}, {"influenced_dof", first + i}});
        return to;
    };
    // Capytaine stores failed runs as matrices of NaN.
    std::erase_if(order, [&](std::size_t w) {
        return matrix(a, w).array().isNaN().all() && matrix(b, w).array().isNaN().all();
    });
    for (const std::size_t w : order) {
        out.frequency.push_back(omega[w]);
        out.added_mass.push_back(matrix(a, w));
        out.damping.push_back(matrix(b, w));
    }
    for (std::size_t w = 0; w < omega.size(); ++w) {
        if (omega[w] == 0.0) out.zero = matrix(a, w), out.has_zero = true;
        if (std::isinf(omega[w])) out.infinite = matrix(a, w), out.has_infinite = true;
    }
    if (file.has("wave_direction")) out.heading = file.read("wave_direction").value;
    read_capytaine_forces(path, file, "excitation_force", omega, order, first, out, out.excitation);
    read_capytaine_forces(path, file, "diffraction_force", omega, order, first, out,
                          out.scattering);
    if (file.has("hydrostatic_stiffness")) {
        const auto c = file.read("hydrostatic_stiffness");
        for (const std::size_t size : c.size)
            if (size < first + 6)
                throw_hydro_error(path, "variable 'hydrostatic_stiffness': not 6 x 6");
        for (std::size_t i = 0; i < 6; ++i)
            for (std::size_t j = 0; j < 6; ++j)
                out.stiffness(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
                    c.at({{"influenced_dof", first + i}, {"radiating_dof", first + j}});
        out.has_stiffness = true;
    }
    return out;
}

#else

WaveCoefficients read_capytaine(const Path& path, const HydroUnits&) {
    throw_hydro_error(path,
                      "this hawser was built without netCDF; install libnetcdf-dev and build with "
                      "HAWSER_NETCDF=ON");
}

#endif

}  // namespace hawser::scene
