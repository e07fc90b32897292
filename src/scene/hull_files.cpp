// SPDX-License-Identifier: Apache-2.0
/// Copy hulls and coefficients from files into the document, which is then self-contained.
#include <hawser/hull.h>
#include <hawser/hydro_files.h>

#include "scene/description.h"
#include "scene/document.h"
#include "scene/water_hulls.h"

#include <algorithm>

namespace hawser::scene {
namespace {

void read_mesh(Document& document, Json& hull, const std::filesystem::path& file,
               const SourceLocation& location) {
    const auto mesh = hull.find("mesh");
    if (mesh == hull.end() || !mesh->is_string()) return;
    const auto stored = resolve_inside(file.parent_path(), file.parent_path(),
                                       mesh->get<std::string>(), location / "mesh");
    HullMesh read;
    try {
        read = read_hull(stored.string());
        const std::string ending = stored.extension().string();
        if (ending == ".gdf" || ending == ".dat" || hull.contains("deck")) {
            double top = read.vertices.front().z();
            for (const Vec3& x : read.vertices) top = std::max(top, x.z());
            close_hull(read, number_or(hull, "deck", top));
        }
    } catch (const DefError& error) {
        throw_error(location / "mesh", error.what());
    }
    document.files.push_back(stored);
    Json vertices = Json::array(), triangles = Json::array();
    for (const Vec3& x : read.vertices) vertices.push_back({x.x(), x.y(), x.z()});
    for (const auto& t : read.triangles) triangles.push_back({t[0], t[1], t[2]});
    *mesh = Json{{"vertices", std::move(vertices)}, {"triangles", std::move(triangles)}};
}

void read_coefficient_file(Document& document, Json& hull, const std::filesystem::path& file,
                           const SourceLocation& location) {
    const auto given = hull.find("coefficients");
    if (given == hull.end()) return;
    const bool named = given->is_object() && given->contains("file");
    if (!named && !given->is_string()) return;
    const Json& name = named ? (*given)["file"] : *given;
    HydroUnits units;
    if (const auto how = hull.find("negative_damping"); how != hull.end() && how->is_string())
        units.negative_damping = negative_damping_from(how->get<std::string>());
    if (named) {
        units.density = number_or(*given, "density", units.density);
        units.gravity = number_or(*given, "gravity", units.gravity);
        units.length = number_or(*given, "length", units.length);
        units.body = given->value("body_number", 0);
    }
    const auto stored = resolve_inside(file.parent_path(), file.parent_path(),
                                       name.get<std::string>(), location / "coefficients");
    try {
        const WaveCoefficients read = read_coefficients(stored.string(), units);
        document.files.push_back(stored);
        *given = coefficients_json(read);
    } catch (const DefError& error) {
        throw_error(location / "coefficients", error.what());
    }
}

}  // namespace

void read_hull_files(Document& document, const std::filesystem::path& file) {
    const auto sea = document.root.find("sea");
    if (sea == document.root.end() || !sea->is_object() || !sea->contains("hulls")) return;
    Json& hulls = (*sea)["hulls"];
    for (std::size_t i = 0; i < hulls.size(); ++i)
        (void)attempt(document.mistakes, [&] {
            if (!hulls[i].is_object()) return;
            const SourceLocation location = document.location / "sea" / "hulls" / i;
            read_mesh(document, hulls[i], file, location);
            read_coefficient_file(document, hulls[i], file, location);
        });
}

}  // namespace hawser::scene
