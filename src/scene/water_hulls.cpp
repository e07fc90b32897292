// SPDX-License-Identifier: Apache-2.0
#include "scene/water_hulls.h"

#include "scene/description.h"

#include <cmath>
#include <memory>
#include <numbers>

namespace hawser::scene {
namespace {

constexpr double kOneDegree = std::numbers::pi / 180.0;

HullMesh read_mesh_of_hull(const Json& json, const Json& hull) {
    HullMesh mesh;
    if (json.contains("box")) {
        std::vector<int> n{1, 1, 1};
        if (json.contains("pieces")) n = json["pieces"].get<std::vector<int>>();
        mesh = box_hull(vector_of(json["box"]), n[0], n[1], n[2]);
    } else {
        for (const Json& vertex : json["vertices"]) mesh.vertices.push_back(vector_of(vertex));
        for (const Json& t : json["triangles"])
            mesh.triangles.push_back(
                {t[0].get<std::int32_t>(), t[1].get<std::int32_t>(), t[2].get<std::int32_t>()});
    }
    const double scale = number_or(hull, "scale", 1.0);
    const Vec3 offset = vector_or(hull, "offset", Vec3::Zero());
    for (Vec3& x : mesh.vertices) x = scale * x + offset;
    return mesh;
}

void read_six(const Json& object, const char* key, std::array<double, 6>& out) {
    if (const auto value = object.find(key); value != object.end())
        for (std::size_t i = 0; i < 6; ++i) out[i] = (*value)[i].get<double>();
}

const Json& list_in(const Json& json, const char* key) {
    static const Json none = Json::array();
    const auto found = json.find(key);
    return found == json.end() ? none : *found;
}

/// Read a list with one number for each frequency.
std::vector<double> read_frequency_values(const Json& entry, const char* key, std::size_t count,
                                          const SourceLocation& location) {
    std::vector<double> out(count, 0.0);
    const auto found = entry.find(key);
    if (found == entry.end()) return out;
    if (found->size() != count)
        throw_error(location / key, std::to_string(found->size()) +
                                        " values; give one for each of the " +
                                        std::to_string(count) + " frequencies");
    for (std::size_t i = 0; i < count; ++i) out[i] = (*found)[i].get<double>();
    return out;
}

/// Visits the given pairs, and the transpose of each pair whose transpose is not given.
class Pairs {
  public:
    template <class F>
    void each(const Json& list, const SourceLocation& location, F&& put) {
        bool pair_read[36] = {};
        for (std::size_t n = 0; n < list.size(); ++n) {
            const int i = motion(list[n]["of"][0]), j = motion(list[n]["of"][1]);
            if (pair_read[6 * i + j]) throw_error(location / n / "of", "this pair is there twice");
            pair_read[6 * i + j] = true;
        }
        for (std::size_t n = 0; n < list.size(); ++n) {
            const int i = motion(list[n]["of"][0]), j = motion(list[n]["of"][1]);
            put(list[n], location / n, i, j);
            if (i != j && !pair_read[6 * j + i]) put(list[n], location / n, j, i);
        }
    }

  private:
    static int motion(const Json& json) { return json.get<int>() - 1; }
};

void read_forces(const Json& json, const char* key, const WaveCoefficients& c,
                 const SourceLocation& location, std::vector<std::complex<double>>& table) {
    const Json& all = list_in(json, key);
    if (all.empty()) return;
    table.assign(c.heading.size() * c.frequency.size() * 6, 0.0);
    for (std::size_t n = 0; n < all.size(); ++n) {
        const SourceLocation at = location / key / n;
        const auto head = all[n]["heading"].get<std::size_t>();
        if (head >= c.heading.size())
            throw_error(at / "heading", "there are " + std::to_string(c.heading.size()) +
                                            " directions in headings_deg");
        const auto re = read_frequency_values(all[n], "re", c.frequency.size(), at);
        const auto im = read_frequency_values(all[n], "im", c.frequency.size(), at);
        for (std::size_t w = 0; w < re.size(); ++w)
            table[c.index(head, w, all[n]["of"].get<int>() - 1)] = {re[w], im[w]};
    }
}

WaveCoefficients read_hull_coefficients(const Json& json, const SourceLocation& location) {
    WaveCoefficients c;
    for (const Json& w : json["frequencies"]) c.frequency.push_back(w.get<double>());
    const std::size_t count = c.frequency.size();
    if (const Json& radiation = list_in(json, "radiation"); !radiation.empty()) {
        c.added_mass.assign(count, Matrix6::Zero());
        c.damping = c.added_mass;
        Pairs().each(radiation, location / "radiation",
                     [&](const Json& entry, const SourceLocation& at, int i, int j) {
                         const auto a = read_frequency_values(entry, "added_mass", count, at);
                         const auto b = read_frequency_values(entry, "damping", count, at);
                         for (std::size_t w = 0; w < count; ++w) {
                             c.added_mass[w](i, j) = a[w];
                             c.damping[w](i, j) = b[w];
                         }
                         c.has_infinite = c.has_infinite || entry.contains("infinite");
                         c.has_zero = c.has_zero || entry.contains("zero");
                         c.infinite(i, j) = number_or(entry, "infinite", 0.0);
                         c.zero(i, j) = number_or(entry, "zero", 0.0);
                     });
    }
    for (const Json& h : list_in(json, "headings_deg"))
        c.heading.push_back(h.get<double>() * kOneDegree);
    read_forces(json, "excitation", c, location, c.excitation);
    read_forces(json, "scattering", c, location, c.scattering);
    if (const Json& drift = list_in(json, "drift_forces"); !drift.empty()) {
        c.drift.assign(c.heading.size() * count * 6, 0.0);
        for (std::size_t n = 0; n < drift.size(); ++n) {
            const SourceLocation at = location / "drift_forces" / n;
            const auto head = drift[n]["heading"].get<std::size_t>();
            if (head >= c.heading.size())
                throw_error(at / "heading", "there are " + std::to_string(c.heading.size()) +
                                                " directions in headings_deg");
            const auto values = read_frequency_values(drift[n], "values", count, at);
            for (std::size_t w = 0; w < count; ++w)
                c.drift[c.index(head, w, drift[n]["of"].get<int>() - 1)] = values[w];
        }
    }
    const Json& stiffness = list_in(json, "stiffness");
    c.has_stiffness = !stiffness.empty();
    Pairs().each(stiffness, location / "stiffness",
                 [&](const Json& entry, const SourceLocation&, int i, int j) {
                     c.stiffness(i, j) = entry["value"].get<double>();
                 });
    return c;
}

void read_strips(const Json& json, const SourceLocation& location, WaterHull& hull) {
    const Json& all = list_in(json, "strips");
    for (std::size_t n = 0; n < all.size(); ++n) {
        if (all[n].is_null()) continue;
        const Vec3 from = vector_of(all[n]["from"]), to = vector_of(all[n]["to"]);
        Vec3 axis = vector_or(all[n], "axis", Vec3(0, 1, 0));
        if (!(axis.norm() > 0.0))
            throw_error(location / "strips" / n / "axis", "it has no direction");
        axis.normalize();
        const int count = all[n].value("count", 10);
        const double area = all[n]["drag_area"].get<double>() / count;
        for (int i = 0; i < count; ++i)
            hull.strips.push_back({from + (i + 0.5) / count * (to - from), axis, area});
    }
}

Json list_json(const std::vector<std::complex<double>>& table, const WaveCoefficients& c) {
    Json out = Json::array();
    for (std::size_t h = 0; h < c.heading.size(); ++h)
        for (int k = 0; k < 6; ++k) {
            Json re = Json::array(), im = Json::array();
            for (std::size_t w = 0; w < c.frequency.size(); ++w) {
                re.push_back(table[c.index(h, w, k)].real());
                im.push_back(table[c.index(h, w, k)].imag());
            }
            out.push_back({{"of", k + 1}, {"heading", h}, {"re", re}, {"im", im}});
        }
    return out;
}

Json drift_json(const WaveCoefficients& c) {
    Json out = Json::array();
    for (std::size_t h = 0; h < c.heading.size(); ++h)
        for (int k = 0; k < 6; ++k) {
            Json values = Json::array();
            for (std::size_t w = 0; w < c.frequency.size(); ++w)
                values.push_back(c.drift[c.index(h, w, k)]);
            out.push_back({{"of", k + 1}, {"heading", h}, {"values", values}});
        }
    return out;
}

}  // namespace

NegativeDamping negative_damping_from(const std::string& word) noexcept {
    return word == "truncate" ? NegativeDamping::truncate
           : word == "fit"    ? NegativeDamping::fit
                              : NegativeDamping::refuse;
}

bool hull_is_omitted(const Json& json) {
    for (const char* key : {"mesh", "coefficients"})
        if (const auto at = json.find(key);
            at != json.end() && (at->is_string() || at->is_null() || at->contains("file")))
            return true;
    return false;
}

WaterHull hull_of(const Json& json, const SourceLocation& location) {
    WaterHull hull;
    if (json.contains("mesh")) {
        hull.mesh = read_mesh_of_hull(json["mesh"], json);
        if (const std::string fault = hull_fault(hull.mesh); !fault.empty())
            throw_error(location / "mesh", fault);
    } else if (!json.contains("linear")) {
        throw_error(location, "a hull needs \"mesh\", or \"linear\" with coefficients");
    }
    hull.wave_pressure = json.value("wave_pressure", !json.contains("linear"));
    read_six(json, "added_mass", hull.added_mass);
    read_six(json, "damping", hull.damping);
    hull.design_draught = number_or(json, "design_draught", hull.design_draught);
    read_strips(json, location, hull);
    if (json.contains("coefficients")) {
        WaveCoefficients c =
            read_hull_coefficients(json["coefficients"], location / "coefficients");
        c.reference = vector_or(json, "reference", Vec3::Zero());
        try {
            c = repaired_damping(c,
                                 negative_damping_from(json.value("negative_damping", "refuse")));
        } catch (const DefError& error) {
            throw_error(location / "negative_damping", error.what());
        }
        if (const std::string fault = coefficients_fault(c); !fault.empty())
            throw_error(location / "coefficients", fault);
        hull.coefficients = std::make_shared<const WaveCoefficients>(std::move(c));
    }
    const std::string kind = json.value("radiation", "convolution");
    hull.radiation = kind == "convolution"   ? RadiationKind::convolution
                     : kind == "state_space" ? RadiationKind::state_space
                     : kind == "constant"    ? RadiationKind::constant
                                             : RadiationKind::none;
    hull.memory = number_or(json, "memory", hull.memory);
    hull.order = json.value("order", hull.order);
    hull.constant_period = number_or(json, "constant_period", 0.0);
    const std::string waves = json.value("excitation", "none");
    hull.excitation = waves == "full"         ? ExcitationKind::full
                      : waves == "scattering" ? ExcitationKind::scattering
                                              : ExcitationKind::none;
    hull.drift = json.value("drift", false);
    hull.coriolis = json.value("coriolis", false);
    hull.slow_time = number_or(json, "slow_time", hull.slow_time);
    if (const auto linear = json.find("linear"); linear != json.end()) {
        hull.linear.on = true;
        hull.linear.height = (*linear)["height"].get<double>();
        hull.linear.weight = number_or(*linear, "weight", hull.linear.weight);
    }
    return hull;
}

Json coefficients_json(const WaveCoefficients& c) {
    Json out = {{"frequencies", c.frequency}};
    Json radiation = Json::array(), stiffness = Json::array();
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) {
            if (!c.added_mass.empty()) {
                Json a = Json::array(), b = Json::array();
                double most = std::max(std::abs(c.infinite(i, j)), std::abs(c.zero(i, j)));
                for (std::size_t w = 0; w < c.frequency.size(); ++w) {
                    a.push_back(c.added_mass[w](i, j));
                    b.push_back(c.damping[w](i, j));
                    most = std::max(
                        {most, std::abs(c.added_mass[w](i, j)), std::abs(c.damping[w](i, j))});
                }
                const bool mirrored = c.infinite(j, i) != 0.0 || c.added_mass[0](j, i) != 0.0;
                if (most > 0.0 || mirrored) {
                    Json entry = {{"of", {i + 1, j + 1}}, {"added_mass", a}, {"damping", b}};
                    if (c.has_infinite) entry["infinite"] = c.infinite(i, j);
                    if (c.has_zero) entry["zero"] = c.zero(i, j);
                    radiation.push_back(std::move(entry));
                }
            }
            if (c.has_stiffness && (c.stiffness(i, j) != 0.0 || c.stiffness(j, i) != 0.0))
                stiffness.push_back({{"of", {i + 1, j + 1}}, {"value", c.stiffness(i, j)}});
        }
    if (!radiation.empty()) out["radiation"] = std::move(radiation);
    if (!stiffness.empty()) out["stiffness"] = std::move(stiffness);
    if (c.heading.empty()) return out;
    out["headings_deg"] = Json::array();
    for (const double h : c.heading) out["headings_deg"].push_back(h / kOneDegree);
    if (!c.excitation.empty()) out["excitation"] = list_json(c.excitation, c);
    if (!c.scattering.empty()) out["scattering"] = list_json(c.scattering, c);
    if (!c.drift.empty()) out["drift_forces"] = drift_json(c);
    return out;
}

}  // namespace hawser::scene
