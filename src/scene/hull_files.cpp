// SPDX-License-Identifier: Apache-2.0
/// Hulls in files become part of the document, which is then whole by itself.
#include <hawser/hull.h>

#include "scene/document.h"

namespace hawser::scene {
namespace {

void read_mesh(Document& document, Json& hull, const std::filesystem::path& file,
               const Place& place) {
    const auto mesh = hull.find("mesh");
    if (mesh == hull.end() || !mesh->is_string()) return;
    const auto stored = resolve_inside(file.parent_path(), file.parent_path(),
                                       mesh->get<std::string>(), place / "mesh");
    HullMesh read;
    try {
        read = read_hull(stored.string());
    } catch (const DefError& error) {
        refuse(place / "mesh", error.what());
    }
    document.files.push_back(stored);
    Json vertices = Json::array(), triangles = Json::array();
    for (const Vec3& x : read.vertices) vertices.push_back({x.x(), x.y(), x.z()});
    for (const auto& t : read.triangles) triangles.push_back({t[0], t[1], t[2]});
    *mesh = Json{{"vertices", std::move(vertices)}, {"triangles", std::move(triangles)}};
}

}  // namespace

void read_hull_files(Document& document, const std::filesystem::path& file) {
    const auto sea = document.root.find("sea");
    if (sea == document.root.end() || !sea->is_object() || !sea->contains("hulls")) return;
    Json& hulls = (*sea)["hulls"];
    for (std::size_t i = 0; i < hulls.size(); ++i)
        (void)attempt(document.mistakes, [&] {
            if (hulls[i].is_object())
                read_mesh(document, hulls[i], file, document.place / "sea" / "hulls" / i);
        });
}

}  // namespace hawser::scene
