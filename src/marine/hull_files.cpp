// SPDX-License-Identifier: Apache-2.0
/// Readers of OBJ (Wavefront, 1990s: "v" and "f" lines), STL (3D Systems, 1988), GDF (WAMIT, low
/// order: four corners a panel, counterclockwise seen from the water) and NEMOH's meshes.
#include <hawser/def.h>
#include <hawser/hull.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdio>
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

/// Collect vertices; vertices at bitwise equal positions are merged.
class MeshMaker {
  public:
    explicit MeshMaker(const std::string& file) : file_(file) {}
    std::int32_t vertex(const Vec3& x) {
        // Adding 0.0 turns −0 into 0.
        const std::array<double, 3> key{x.x() + 0.0, x.y() + 0.0, x.z() + 0.0};
        const auto [there, first] =
            known_.try_emplace(key, static_cast<std::int32_t>(mesh.vertices.size()));
        if (first) mesh.vertices.push_back(x);
        return there->second;
    }
    /// Add a triangle unless two of its vertices are the same.
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
    constexpr std::size_t kStlHeadBytes = 84, kStlFacetBytes = 50;
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + 80, sizeof count);
    if (bytes.size() < kStlHeadBytes + kStlFacetBytes * std::size_t{count})
        refuse_hull(file, "it ends before its " + std::to_string(count) + " facets do");
    MeshMaker make(file);
    for (std::size_t i = 0; i < count; ++i) {
        float f[12];
        std::memcpy(f, bytes.data() + kStlHeadBytes + kStlFacetBytes * i, sizeof f);
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

/// Split a text into words and count their lines.
class Words {
  public:
    Words(const std::string& text, const std::string& file) : in_(text), file_(file) {}
    void skip_line() {
        std::string rest;
        std::getline(in_, rest);
        ++line_;
    }
    /// Return the next number of the text, on this line or a later one. @param what  Name of the
    /// number in the message.
    double number(const char* what) {
        std::string word;
        for (int c = in_.peek(); c != EOF && std::isspace(c) != 0; c = in_.peek()) {
            if (c == '\n') ++line_;
            in_.get();
        }
        if (!(in_ >> word))
            refuse_hull(file_,
                        "line " + std::to_string(line_) + ": it ends where " + what + " should be");
        return number_of(word, file_, line_);
    }
    [[nodiscard]] std::size_t line() const { return line_; }

  private:
    std::istringstream in_;
    const std::string& file_;
    std::size_t line_ = 1;
};

/// Add a panel of four corners, two of which may coincide, and its mirror images.
void add_panel(MeshMaker& make, const std::array<Vec3, 4>& corner, bool mirror_x, bool mirror_y) {
    for (const bool x : {false, true})
        for (const bool y : {false, true}) {
            if ((x && !mirror_x) || (y && !mirror_y)) continue;
            std::int32_t c[4];
            for (std::size_t k = 0; k < 4; ++k) {
                Vec3 at = corner[k];
                if (x) at.x() = -at.x();
                if (y) at.y() = -at.y();
                c[k] = make.vertex(at);
            }
            if (x != y) std::swap(c[1], c[3]);
            make.triangle(c[0], c[1], c[2]);
            make.triangle(c[0], c[2], c[3]);
        }
}

HullMesh read_gdf(const std::string& text, const std::string& file) {
    Words words(text, file);
    words.skip_line();
    const double length = words.number("ULEN");
    if (!(length > 0.0)) refuse_hull(file, "line 2: ULEN is not above 0");
    (void)words.number("gravity");
    const bool mirror_x = words.number("ISX") == 1.0, mirror_y = words.number("ISY") == 1.0;
    const double count = words.number("the number of panels");
    if (!(count >= 1.0 && count <= static_cast<double>(kMostTriangles)))
        refuse_hull(file, "line " + std::to_string(words.line()) +
                              ": the number of panels is not among 1 to 2000000 (higher-order "
                              "files are not read)");
    MeshMaker make(file);
    for (long i = 0; i < static_cast<long>(count); ++i) {
        std::array<Vec3, 4> corner;
        for (Vec3& x : corner)
            for (int k = 0; k < 3; ++k) x[k] = length * words.number("a corner");
        add_panel(make, corner, mirror_x, mirror_y);
    }
    return std::move(make.mesh);
}

/// Read a mesh of NEMOH: a line "2 symmetry", lines "number x y z" up to number 0, and panels of
/// four numbers up to zeros.
HullMesh read_nemoh(const std::string& text, const std::string& file) {
    Words words(text, file);
    if (words.number("2") != 2.0) refuse_hull(file, "line 1: a mesh of NEMOH begins with 2");
    const bool mirror_y = words.number("the symmetry") == 1.0;
    std::vector<Vec3> vertices;
    for (;;) {
        const double number = words.number("the number of a vertex");
        Vec3 x;
        for (int k = 0; k < 3; ++k) x[k] = words.number("a coordinate");
        if (number == 0.0) break;
        if (number != static_cast<double>(vertices.size() + 1) || vertices.size() >= kMostTriangles)
            refuse_hull(file, "line " + std::to_string(words.line()) +
                                  ": vertices have to be numbered 1, 2, 3 …");
        vertices.push_back(x);
    }
    MeshMaker make(file);
    for (;;) {
        std::array<Vec3, 4> corner;
        bool end = true;
        double at[4];
        for (double& i : at) {
            i = words.number("a corner of a panel");
            end = end && i == 0.0;
        }
        if (end) break;
        for (std::size_t k = 0; k < 4; ++k) {
            if (!(at[k] >= 1.0 && at[k] <= static_cast<double>(vertices.size()) &&
                  at[k] == std::floor(at[k])))
                refuse_hull(file, "line " + std::to_string(words.line()) +
                                      ": a panel has a vertex that is not there");
            corner[k] = vertices[static_cast<std::size_t>(at[k]) - 1];
        }
        add_panel(make, corner, false, mirror_y);
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
        // Binary files may begin with "solid", too. Their length distinguishes them.
        const bool exact = bytes.size() >= 84 && bytes.size() == 84 + 50 * std::size_t{count};
        if (!exact && bytes.size() < 84 && !bytes.starts_with("solid"))
            refuse_hull(file, "it is no STL file: too short");
        mesh = !exact && bytes.starts_with("solid") ? read_stl_text(bytes, file)
                                                    : read_stl_bytes(bytes, file);
    } else if (ends_with(file, ".gdf")) {
        mesh = read_gdf(bytes, file);
    } else if (ends_with(file, ".dat")) {
        mesh = read_nemoh(bytes, file);
    } else {
        refuse_hull(file, "its name ends with none of .obj, .stl, .gdf, .dat");
    }
    if (mesh.triangles.empty()) refuse_hull(file, "it has no triangles");
    return mesh;
}

}  // namespace hawser
