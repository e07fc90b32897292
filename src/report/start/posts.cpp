// SPDX-License-Identifier: Apache-2.0
#include "report/start/parts.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace hawser::report::start {
namespace {

/// Return the names of posts in a scene's text; empty if the text is no scene.
std::vector<std::string> post_names(const std::string& text) {
    std::vector<std::string> out;
    const auto scene = nlohmann::json::parse(text, nullptr, false);
    if (!scene.is_object() || !scene.contains("posts")) return out;
    for (const auto& post : scene["posts"])
        if (post.is_object() && post.contains("name")) out.push_back(post["name"]);
    return out;
}

/// True if the nodes of the cable have contact shapes but its elements have no mass
/// (`consistent_mass`), so that it cannot engage bollards.
bool has_shapes_without_mass(const World& world, const record::CableInfo& cable) {
    for (const InteractionId id : cable.elements) {
        const InteractionDef& def = world.interaction_def(id);
        if (!kind_info(def.kind).is(kWireElement) || kind_info(def.kind).is(kWoundUp)) continue;
        if (def.get("mass") > 0.0) return false;
    }
    const auto of_it = [&](BodyId body) {
        return std::find(cable.nodes.begin(), cable.nodes.end(), body) != cable.nodes.end();
    };
    const auto shapes = world.shapes();
    return std::any_of(shapes.begin(), shapes.end(), [&](ShapeId id) {
        const ShapeDef& shape = world.shape_def(id);
        return shape.body_b.valid() && of_it(shape.body) && of_it(shape.body_b);
    });
}

/// Return the distance from the middle of a bollard to the nearest node of a cable [m].
double separation(const World& world, const ShapeDef& post, const record::CableInfo& cable) {
    const Vec3 at = world.world_point(post.body, post.position);
    double least = HUGE_VAL;
    for (const BodyId node : cable.nodes)
        if (node.valid()) least = std::min(least, (world.pose(node).position - at).norm());
    return least;
}

}  // namespace

void check_posts(const record::SceneInfo& scene, const World& world, Findings& out) {
    constexpr double kMaxDistanceFraction = 0.1;  // fraction of the cable's length
    const std::vector<std::string> names = post_names(scene.text);
    if (names.empty()) return;
    for (const record::CableInfo& cable : scene.cables) {
        if (cable.elements.empty() || !has_shapes_without_mass(world, cable)) continue;
        for (const ShapeId id : world.shapes()) {
            const ShapeDef& post = world.shape_def(id);
            if (std::find(names.begin(), names.end(), post.name) == names.end()) continue;
            const double near = separation(world, post, cable);
            if (!(near <= kMaxDistanceFraction * cable.length)) continue;
            out.add(
                false, FindingKind::post, {post.name, cable.name}, near,
                fmt::format("the bollard {} never engages the cable {}, which touches it node by "
                            "node; give the cable \"consistent_mass\": true",
                            record::name_in_quotes(post.name), record::name_in_quotes(cable.name)));
        }
    }
}

}  // namespace hawser::report::start
