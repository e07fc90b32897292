// SPDX-License-Identifier: Apache-2.0
#include "export/gltf_document.h"

#include <hawser/hawser.h>

#include "draw/axes.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace hawser::exporting {
namespace {

// Constants of the format.
constexpr int kGltfFloat = 5126, kGltfUnsignedShort = 5123, kGltfUnsignedInt = 5125,
              kGltfUnsignedByte = 5121;
constexpr int kGltfArrayBuffer = 34962, kGltfIndexBuffer = 34963;

// Materials by their index.
enum Material : int { kHull, kStructure, kPlain, kWireMaterial, kMaterialCount };

nlohmann::json material(const char* name, double r, double g, double b, bool both_sides) {
    return {{"name", name},
            {"doubleSided", both_sides},
            {"pbrMetallicRoughness",
             {{"baseColorFactor", {r, g, b, 1.0}},
              {"metallicFactor", 0.0},
              {"roughnessFactor", 0.75}}}};
}

/// Select the material of a body. A body counts as a hull if it is long but not thin. Booms are
/// thin, and crates are not long.
int material_of(const record::RecordedBody& body) {
    const double reach = body.half_size.maxCoeff();
    if (reach > 8.0 && body.half_size.sum() - reach > 5.0) return kHull;
    return reach > 0.0 ? kStructure : kPlain;
}

/// Convert an sRGB value to a linear one with exponent 2.2 (approximation of IEC 61966-2-1). Vertex
/// colours are linear, those of pictures sRGB.
std::uint8_t linear_from_srgb(std::uint8_t value) {
    return static_cast<std::uint8_t>(std::lround(255.0 * std::pow(value / 255.0, 2.2)));
}

int size_of(const nlohmann::json& array) { return static_cast<int>(array.size()); }

}  // namespace

GltfDocument::GltfDocument(const record::Recording& recording, const Frames& frames, Layout& layout)
    : recording_(recording), frames_(frames), layout_(layout) {
    root_["asset"] = {{"version", "2.0"}, {"generator", std::string("hawser ") + version()}};
    for (const char* key : {"bufferViews", "accessors", "meshes", "nodes"})
        root_[key] = Json::array();
    root_["materials"] = {
        material("hull", 0.10, 0.22, 0.38, false), material("structure", 0.85, 0.45, 0.08, false),
        material("plain", 0.45, 0.47, 0.50, false), material("wire", 1.0, 1.0, 1.0, true)};
    // z up to y up: rotation by −90 degrees about x.
    root_["nodes"].push_back(
        {{"name", recording.scene_name.empty() ? "world" : recording.scene_name + " (z up)"},
         {"rotation", {-std::sqrt(0.5), 0.0, 0.0, std::sqrt(0.5)}}});
    scene_nodes_.push_back(0);
    add_times();
    add_bodies();
    add_rod_mesh();
    for (WireNodes& wire : layout_.wires) add_wire(wire);
    bytes_ = fixed_.size();
    add_channels();
    if (!children_.empty()) root_["nodes"][0]["children"] = std::move(children_);
    root_["scenes"] = {{{"nodes", std::move(scene_nodes_)}}};
    root_["scene"] = 0;
    if (root_["meshes"].empty()) root_.erase("meshes");
    root_["buffers"] = {{{"byteLength", bytes_}}};
}

int GltfDocument::add_buffer_view(const void* data, std::size_t size, int target) {
    fixed_.resize((fixed_.size() + 3) / 4 * 4);
    Json view{{"buffer", 0}, {"byteOffset", fixed_.size()}, {"byteLength", size}};
    if (target != 0) view["target"] = target;
    const auto* bytes = static_cast<const std::byte*>(data);
    fixed_.insert(fixed_.end(), bytes, bytes + size);
    fixed_.resize((fixed_.size() + 3) / 4 * 4);
    root_["bufferViews"].push_back(std::move(view));
    return size_of(root_["bufferViews"]) - 1;
}

int GltfDocument::add_accessor(int view, int type, std::size_t count, const char* shape) {
    root_["accessors"].push_back(
        {{"bufferView", view}, {"componentType", type}, {"count", count}, {"type", shape}});
    return size_of(root_["accessors"]) - 1;
}

int GltfDocument::add_points(const std::vector<Vec3>& points) {
    std::vector<float> values;
    float low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (const Vec3& p : points)
        for (int k = 0; k < 3; ++k) {
            values.push_back(static_cast<float>(p[k]));
            low[k] = std::min(low[k], values.back());
            high[k] = std::max(high[k], values.back());
        }
    const int view =
        add_buffer_view(values.data(), values.size() * sizeof(float), kGltfArrayBuffer);
    const int accessor = add_accessor(view, kGltfFloat, points.size(), "VEC3");
    Json& a = root_["accessors"].back();
    a["min"] = {low[0], low[1], low[2]};
    a["max"] = {high[0], high[1], high[2]};
    return accessor;
}

int GltfDocument::add_triangles(const record::Triangles& surface, int material) {
    const int points = add_points(surface.points);
    const int view =
        add_buffer_view(surface.corners.data(), surface.corners.size() * sizeof surface.corners[0],
                        kGltfIndexBuffer);
    const int indices = add_accessor(view, kGltfUnsignedInt, 3 * surface.corners.size(), "SCALAR");
    root_["meshes"].push_back({{"primitives",
                                {{{"attributes", {{"POSITION", points}}},
                                  {"indices", indices},
                                  {"material", material}}}}});
    return size_of(root_["meshes"]) - 1;
}

void GltfDocument::add_times() {
    std::vector<float> times;
    const double start = frames_.empty() ? 0.0 : recording_.frame_head(frames_.front()).time;
    for (const std::size_t f : frames_)
        times.push_back(static_cast<float>(recording_.frame_head(f).time - start));
    times_ = add_accessor(add_buffer_view(times.data(), times.size() * sizeof(float), 0),
                          kGltfFloat, times.size(), "SCALAR");
    root_["accessors"].back()["min"] = {times.front()};
    root_["accessors"].back()["max"] = {times.back()};
}

void GltfDocument::add_bodies() {
    const record::Frame first = recording_.frame(frames_.front());
    for (BodyNode& b : layout_.bodies) {
        const auto index = static_cast<std::size_t>(b.body);
        const record::RecordedBody& body = recording_.bodies[index];
        Json node{{"name", body.name.empty() ? "body " + std::to_string(index) : body.name}};
        const Vec3& p = first.poses[index].position;
        const Quat& q = first.poses[index].orientation;
        node["translation"] = {p.x(), p.y(), p.z()};
        if (b.has_rotation || body.kind == BodyKind::fixed)
            node["rotation"] = {q.x(), q.y(), q.z(), q.w()};
        b.node = size_of(root_["nodes"]);
        Json parts = Json::array();
        if (b.surfaces.empty() && body.kind != BodyKind::fixed)
            b.surfaces.push_back(record::outline_surface(
                {.radius = 0.003 * layout_.size, .points = {Vec3::Zero()}}));
        for (const record::Triangles& surface : b.surfaces)
            parts.push_back(add_triangles(surface, material_of(body)));
        if (!parts.empty()) node["mesh"] = parts[0];
        root_["nodes"].push_back(std::move(node));
        for (std::size_t k = 1; k < parts.size(); ++k) {
            root_["nodes"][static_cast<std::size_t>(b.node)]["children"].push_back(
                root_["nodes"].size());
            root_["nodes"].push_back({{"mesh", parts[k]}});
        }
        children_.push_back(b.node);
    }
}

/// Add three ribbons for each segment between two joints, one along each axis. The corners of the
/// ribbons move with the joints. From any direction at least two ribbons appear wide.
/// @param fraction  Value of each segment on the colour scale, 0 to 1.
int GltfDocument::add_ribbons(const std::vector<std::pair<std::size_t, std::size_t>>& segments,
                              double radius, const std::vector<float>& fraction) {
    std::vector<Vec3> points;
    std::vector<std::uint16_t> owners;
    std::vector<float> weights;
    std::vector<std::uint8_t> colors;
    std::vector<std::uint32_t> indices;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const draw::Color color = draw::scale_color(fraction[i]);
        for (int axis = 0; axis < 3; ++axis) {
            const auto first = static_cast<std::uint32_t>(points.size());
            for (const std::size_t joint : {segments[i].first, segments[i].second})
                for (const double side : {-radius, radius}) {
                    points.push_back(side * Vec3::Unit(axis));
                    owners.insert(owners.end(), {static_cast<std::uint16_t>(joint), 0, 0, 0});
                    weights.insert(weights.end(), {1.0F, 0.0F, 0.0F, 0.0F});
                    colors.insert(colors.end(),
                                  {linear_from_srgb(color.r), linear_from_srgb(color.g),
                                   linear_from_srgb(color.b), 255});
                }
            for (const std::uint32_t k : {0U, 1U, 2U, 2U, 1U, 3U}) indices.push_back(first + k);
        }
    }
    Json attributes{{"POSITION", add_points(points)}};
    const auto put = [&](const char* key, const auto& data, int type) {
        const int view =
            add_buffer_view(data.data(), data.size() * sizeof data[0], kGltfArrayBuffer);
        attributes[key] = add_accessor(view, type, points.size(), "VEC4");
    };
    put("JOINTS_0", owners, kGltfUnsignedShort);
    put("WEIGHTS_0", weights, kGltfFloat);
    put("COLOR_0", colors, kGltfUnsignedByte);
    root_["accessors"].back()["normalized"] = true;
    const int view =
        add_buffer_view(indices.data(), indices.size() * sizeof indices[0], kGltfIndexBuffer);
    root_["meshes"].push_back(
        {{"primitives",
          {{{"attributes", std::move(attributes)},
            {"indices", add_accessor(view, kGltfUnsignedInt, indices.size(), "SCALAR")},
            {"material", static_cast<int>(kWireMaterial)}}}}});
    return size_of(root_["meshes"]) - 1;
}

void GltfDocument::add_rod_mesh() {
    if (layout_.rods.empty()) return;
    std::vector<std::pair<std::size_t, std::size_t>> segments;
    Json joints = Json::array();
    constexpr std::size_t kMaxJoints = 60'000;
    for (const Rod& rod : layout_.rods) {
        if (joints.size() >= kMaxJoints) break;
        segments.emplace_back(joints.size(), joints.size() + 1);
        for (int k = 0; k < 2; ++k) {
            joints.push_back(root_["nodes"].size());
            root_["nodes"][static_cast<std::size_t>(layout_.bodies[rod.body[k]].node)]["children"]
                .push_back(root_["nodes"].size());
            root_["nodes"].push_back(
                {{"translation", {rod.point[k].x(), rod.point[k].y(), rod.point[k].z()}}});
        }
    }
    const std::vector<float> dark(segments.size(), 0.0F);
    const int mesh = add_ribbons(segments, 0.0008 * layout_.size, dark);
    root_["skins"].push_back({{"name", "rods"}, {"joints", std::move(joints)}});
    scene_nodes_.push_back(root_["nodes"].size());
    root_["nodes"].push_back(
        {{"name", "rods"}, {"mesh", mesh}, {"skin", size_of(root_["skins"]) - 1}});
}

void GltfDocument::add_wire(WireNodes& wire) {
    // Joint indices of a skin have 16 bits.
    constexpr std::size_t kMaxJoints = 65'000;
    if (wire.segments == 0 || wire.joints() > kMaxJoints) {
        wire.segments = 0;
        return;
    }
    std::vector<std::pair<std::size_t, std::size_t>> segments;
    std::vector<float> fraction;
    for (std::size_t i = 0; i < wire.segments; ++i) {
        segments.emplace_back(wire.joint(i, 0), wire.joint(i, 1));
        fraction.push_back(wire.peak[i] / layout_.max_tension);
    }
    Json joints = Json::array();
    wire.node = size_of(root_["nodes"]);
    for (std::size_t j = 0; j < wire.joints(); ++j) {
        joints.push_back(root_["nodes"].size());
        children_.push_back(root_["nodes"].size());
        root_["nodes"].push_back({{"name", wire.name + "@" + std::to_string(j)}});
    }
    const int mesh = add_ribbons(segments, 0.0006 * layout_.size, fraction);
    root_["skins"].push_back({{"name", wire.name}, {"joints", std::move(joints)}});
    scene_nodes_.push_back(root_["nodes"].size());
    root_["nodes"].push_back(
        {{"name", wire.name}, {"mesh", mesh}, {"skin", size_of(root_["skins"]) - 1}});
}

/// Reserve buffer space for an animation channel. @return the index of its accessor.
int GltfDocument::write_channel_data(std::size_t& place, std::size_t width) {
    place = bytes_;
    const std::size_t size = width * sizeof(float) * frames_.size();
    root_["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", bytes_}, {"byteLength", size}});
    bytes_ += size;
    return add_accessor(size_of(root_["bufferViews"]) - 1, kGltfFloat, frames_.size(),
                        width == 4 ? "VEC4" : "VEC3");
}

void GltfDocument::add_channel(int node, const char* path, int output, const char* interpolation) {
    Json& animation = root_["animations"][0];
    animation["name"] = "run";
    animation["samplers"].push_back(
        {{"input", times_}, {"output", output}, {"interpolation", interpolation}});
    animation["channels"].push_back({{"sampler", size_of(animation["samplers"]) - 1},
                                     {"target", {{"node", node}, {"path", path}}}});
}

void GltfDocument::add_channels() {
    for (BodyNode& b : layout_.bodies) {
        if (b.moves) add_channel(b.node, "translation", write_channel_data(b.data, 3), "LINEAR");
        if (b.has_rotation)
            add_channel(b.node, "rotation", write_channel_data(b.rotation_offset, 4), "LINEAR");
        if (b.comes) add_channel(b.node, "scale", write_channel_data(b.size, 3), "STEP");
    }
    for (WireNodes& wire : layout_.wires)
        for (std::size_t j = 0; j < wire.joints(); ++j) {
            std::size_t place = 0;
            const int output = write_channel_data(place, 3);
            if (j == 0) wire.data = place;
            add_channel(wire.node + static_cast<int>(j), "translation", output, "LINEAR");
        }
}

}  // namespace hawser::exporting
