// SPDX-License-Identifier: Apache-2.0
/// Readers of OBJ (Wavefront, 1990s: "v" and "f" lines) and STL files (3D Systems, 1988).
#include <hawser/def.h>
#include <hawser/hull.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <string_view>

namespace hawser {
namespace {

constexpr std::size_t kMostTriangles = 2'000'000;

[[noreturn]] void refuse_hull(const std::string& file, const std::string& what) {
    throw DefError("hull '" + file + "': " + what);
}

/// Gathers corners: those at the same place, to the bit, are one.
class MeshMaker {
  public:
    explicit MeshMaker(const std::string& file) : file_(file) {}
    std::int32_t vertex(const Vec3& x) {
        // + 0.0: −0 is 0.
        const std::array<double, 3> key{x.x() + 0.0, x.y() + 0.0, x.z() + 0.0};
        const auto [there, first] =
            known_.try_emplace(key, static_cast<std::int32_t>(mesh.vertices.size()));
        if (first) mesh.vertices.push_back(x);
        return there->second;
    }
    /// Triangles that have two corners at one place are left out.
    void triangle(std::int32_t a, std::int32_t b, std::int32_t c) {
        if (a == b || b == c || c == a) return;
        if (mesh.triangles.size() >= kMostTriangles)
            refuse_hull(file_, "more than " + std::to_string(kMostTriangles) + " triangles");
        mesh.triangles.push_back({a, b, c});
    }
    HullMesh mesh;

  private:
    const std::string& file_;
    std::map<std::array<double, 3>, std::int32_t> known_;
};

double number_of(const std::string& word, const std::string& file, std::size_t line) {
    double value = 0.0;
    const char* const end = word.data() + word.size();
    const char* const begin = word.data() + (word.starts_with('+') ? 1 : 0);
    const auto [at, fault] = std::from_chars(begin, end, value);
    if (fault != std::errc() || at != end || !(std::abs(value) <= 1e6))
        refuse_hull(
            file, "line " + std::to_string(line) + ": '" + word + "' is no length of up to 1e6 m");
    return value;
}

Vec3 point_of(std::istringstream& words, const std::string& file, std::size_t line) {
    Vec3 x;
    for (int k = 0; k < 3; ++k) {
        std::string word;
        if (!(words >> word))
            refuse_hull(file, "line " + std::to_string(line) + ": a vertex has three coordinates");
        x[k] = number_of(word, file, line);
    }
    return x;
}

HullMesh read_obj(const std::string& text, const std::string& file) {
    MeshMaker make(file);
    std::vector<std::int32_t> vertices;  // of the file, in the mesh
    std::istringstream lines(text);
    std::string row;
    for (std::size_t line = 1; std::getline(lines, row); ++line) {
        std::istringstream words(row);
        std::string what;
        if (!(words >> what)) continue;
        if (what == "v") vertices.push_back(make.vertex(point_of(words, file, line)));
        if (what != "f") continue;
        std::vector<std::int32_t> face;
        for (std::string word; words >> word;) {
            const std::string_view index(word.data(), std::min(word.find('/'), word.size()));
            long i = 0;
            const auto [at, fault] = std::from_chars(index.data(), index.data() + index.size(), i);
            const auto count = static_cast<long>(vertices.size());
            if (i < 0) i += count + 1;  // counted from the last one
            if (fault != std::errc() || at != index.data() + index.size() || i < 1 || i > count)
                refuse_hull(file, "line " + std::to_string(line) + ": there is no vertex '" + word +
                                      "' above it");
            face.push_back(vertices[static_cast<std::size_t>(i - 1)]);
        }
        if (face.size() < 3)
            refuse_hull(file,
                        "line " + std::to_string(line) + ": a face has three corners or more");
        for (std::size_t k = 2; k < face.size(); ++k) make.triangle(face[0], face[k - 1], face[k]);
    }
    return std::move(make.mesh);
}

HullMesh read_stl_text(const std::string& text, const std::string& file) {
    MeshMaker make(file);
    std::istringstream lines(text);
    std::string row;
    std::vector<std::int32_t> loop;
    for (std::size_t line = 1; std::getline(lines, row); ++line) {
        std::istringstream words(row);
        std::string what;
        if (!(words >> what)) continue;
        if (what == "vertex") loop.push_back(make.vertex(point_of(words, file, line)));
        if (what != "endloop") continue;
        if (loop.size() != 3)
            refuse_hull(file, "line " + std::to_string(line) + ": a facet has three vertices");
        make.triangle(loop[0], loop[1], loop[2]);
        loop.clear();
    }
    return std::move(make.mesh);
}

HullMesh read_stl_bytes(const std::string& bytes, const std::string& file) {
    constexpr std::size_t kHead = 84, kFacet = 50;
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + 80, sizeof count);
    if (bytes.size() < kHead + kFacet * std::size_t{count})
        refuse_hull(file, "it ends before its " + std::to_string(count) + " facets do");
    MeshMaker make(file);
    for (std::size_t i = 0; i < count; ++i) {
        float f[12];
        std::memcpy(f, bytes.data() + kHead + kFacet * i, sizeof f);
        std::int32_t corner[3];
        for (int k = 0; k < 3; ++k) {
            const float* x = f + 3 + 3 * k;
            if (!(std::abs(x[0]) <= 1e6F && std::abs(x[1]) <= 1e6F && std::abs(x[2]) <= 1e6F))
                refuse_hull(file, "facet " + std::to_string(i) + " has a vertex beyond 1e6 m");
            corner[k] = make.vertex({x[0], x[1], x[2]});
        }
        make.triangle(corner[0], corner[1], corner[2]);
    }
    return std::move(make.mesh);
}

bool ends_with(std::string name, std::string_view ending) {
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) {
        return static_cast<char>(c >= 'A' && c <= 'Z' ? c + 32 : c);
    });
    return name.ends_with(ending);
}

}  // namespace

HullMesh read_hull(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) refuse_hull(file, "cannot open it");
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    HullMesh mesh;
    if (ends_with(file, ".obj")) {
        mesh = read_obj(bytes, file);
    } else if (ends_with(file, ".stl")) {
        std::uint32_t count = 0;
        if (bytes.size() >= 84) std::memcpy(&count, bytes.data() + 80, sizeof count);
        // Binary files may begin with "solid", too: their length tells.
        const bool exact = bytes.size() >= 84 && bytes.size() == 84 + 50 * std::size_t{count};
        if (!exact && bytes.size() < 84 && !bytes.starts_with("solid"))
            refuse_hull(file, "it is no STL file: too short");
        mesh = !exact && bytes.starts_with("solid") ? read_stl_text(bytes, file)
                                                    : read_stl_bytes(bytes, file);
    } else {
        refuse_hull(file, "its name ends neither with .obj nor with .stl");
    }
    if (mesh.triangles.empty()) refuse_hull(file, "it has no triangles");
    return mesh;
}

}  // namespace hawser
