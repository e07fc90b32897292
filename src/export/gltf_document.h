// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file gltf_document.h
/// Build the JSON of a glTF and the part of its buffer that does not depend on time.

#include "export/gltf_layout.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace hawser::exporting {

class GltfDocument {
  public:
    /// Build the document. Writes nodes and offsets of channels to the layout.
    GltfDocument(const record::Recording& recording, const Frames& frames, Layout& layout);
    [[nodiscard]] std::string json() const { return root_.dump(); }
    /// Return the meshes and times, which form the beginning of the buffer; channels follow.
    [[nodiscard]] const std::vector<std::byte>& fixed_bytes() const noexcept { return fixed_; }
    [[nodiscard]] std::size_t buffer_bytes() const noexcept { return bytes_; }

  private:
    using Json = nlohmann::json;

    int add_buffer_view(const void* data, std::size_t size, int target);
    int add_accessor(int view, int type, std::size_t count, const char* shape);
    int add_points(const std::vector<Vec3>& points);
    int add_triangles(const record::Triangles& surface, int material);
    void add_bodies();
    void add_rod_mesh();
    void add_wire(WireNodes& wire);
    int add_ribbons(const std::vector<std::pair<std::size_t, std::size_t>>& segments, double radius,
                    const std::vector<float>& fraction);
    void add_times();
    void add_channels();
    int write_channel_data(std::size_t& place, std::size_t width);
    void add_channel(int node, const char* path, int output, const char* interpolation);

    const record::Recording& recording_;
    const Frames& frames_;
    Layout& layout_;
    Json root_;
    std::vector<std::byte> fixed_;
    std::size_t bytes_ = 0;
    int times_ = -1;
    Json children_ = Json::array();  ///< Children of the root node.
    Json scene_nodes_ = Json::array();
};

}  // namespace hawser::exporting
