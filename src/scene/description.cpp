// SPDX-License-Identifier: Apache-2.0
#include "scene/description.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace hawser::scene {
namespace {

void throw_duplicate_name(const char* what, const std::string& name, const SourceLocation& location,
                          const SourceLocation& first) {
    throw_error(
        location,
        fmt::format("{} {} exists already, from {}", what, in_quotes(name),
                    first.file == location.file ? first.path : first.file + ": " + first.path));
}

void throw_too_many(std::size_t count, std::int64_t most, const char* what,
                    const SourceLocation& location) {
    if (static_cast<std::int64_t>(count) >= most) {
        throw_error(location, fmt::format("the scene has more than {} {}", most, what));
    }
}

}  // namespace

int Description::store_location(const SourceLocation& location) {
    locations_.push_back(location);
    return static_cast<int>(locations_.size()) - 1;
}

BodyId Description::add_body(BodyDef def, int location) {
    const auto index = static_cast<std::int32_t>(bodies.size());
    const SourceLocation& at = locations_[static_cast<std::size_t>(location)];
    throw_too_many(bodies.size(), settings.max_bodies, "bodies (settings.max_bodies)", at);
    if (!def.name.empty()) {
        const auto [entry, added] = body_names_.emplace(def.name, index);
        if (!added) {
            throw_duplicate_name("the body", def.name, at,
                                 body_location(static_cast<std::size_t>(entry->second)));
        }
    }
    bodies.push_back(std::move(def));
    body_at_.push_back(static_cast<std::size_t>(location));
    return BodyId{index};
}

void Description::add_shape(ShapeDef def, int location) {
    throw_too_many(shapes.size(), kMaxElements, "shapes",
                   locations_[static_cast<std::size_t>(location)]);
    shapes.push_back(std::move(def));
    shape_at_.push_back(static_cast<std::size_t>(location));
}

std::vector<std::string> Description::shape_places() const {
    std::vector<std::string> out;
    out.reserve(shapes.size());
    for (std::size_t i = 0; i < shapes.size(); ++i)
        out.push_back(shape_location(i).file + ": " + shape_location(i).path);
    return out;
}

std::optional<ShapeDef> Description::remove_segment(BodyId a, BodyId b) {
    std::optional<ShapeDef> out;
    for (std::size_t i = shapes.size(); i-- > 0;) {
        if (shapes[i].body != a || shapes[i].body_b != b) continue;
        out = std::move(shapes[i]);
        shapes.erase(shapes.begin() + static_cast<std::ptrdiff_t>(i));
        shape_at_.erase(shape_at_.begin() + static_cast<std::ptrdiff_t>(i));
    }
    return out;
}

InteractionId Description::add_interaction(InteractionDef def, int location) {
    const auto index = static_cast<std::int32_t>(interactions.size());
    const SourceLocation& at = locations_[static_cast<std::size_t>(location)];
    throw_too_many(interactions.size(), settings.max_interactions,
                   "interactions (settings.max_interactions)", at);
    if (!def.name.empty()) {
        const auto [entry, added] = interaction_names_.emplace(def.name, index);
        if (!added) {
            throw_duplicate_name("the interaction", def.name, at,
                                 interaction_location(static_cast<std::size_t>(entry->second)));
        }
    }
    interactions.push_back(std::move(def));
    interaction_at_.push_back(static_cast<std::size_t>(location));
    return InteractionId{index};
}

void Description::add_input(InputDef def, int location) {
    const auto index = static_cast<std::int32_t>(inputs.size());
    const auto [entry, added] = input_names_.emplace(def.name, index);
    if (!added) {
        throw_duplicate_name("the input", def.name, locations_[static_cast<std::size_t>(location)],
                             input_location(static_cast<std::size_t>(entry->second)));
    }
    inputs.push_back(std::move(def));
    input_at_.push_back(static_cast<std::size_t>(location));
}

void Description::add_signal_input(SignalInput input, int location) {
    const SourceLocation& at = locations_[static_cast<std::size_t>(location)];
    if (const auto other = input_names_.find(input.name); other != input_names_.end())
        throw_duplicate_name("the input", input.name, at,
                             input_location(static_cast<std::size_t>(other->second)));
    for (std::size_t i = 0; i < levers.size(); ++i)
        if (levers[i].input.name == input.name)
            throw_duplicate_name("the input", input.name, at, signal_input_location(i));
    levers.push_back({std::move(input), location});
}

void Description::add_output(OutputDef def, int location) {
    const auto index = static_cast<std::int32_t>(outputs.size());
    const auto [entry, added] = output_names_.emplace(def.name, index);
    if (!added) {
        throw_duplicate_name("the output", def.name, locations_[static_cast<std::size_t>(location)],
                             output_location(static_cast<std::size_t>(entry->second)));
    }
    outputs.push_back(std::move(def));
    output_at_.push_back(static_cast<std::size_t>(location));
}

void Description::add_cable(Cable cable, const SourceLocation& location) {
    const auto index = static_cast<std::int32_t>(cables.size());
    if (!cable_names_.emplace(cable.name, index).second) {
        throw_error(location, "the cable " + in_quotes(cable.name) + " exists already");
    }
    cables.push_back(std::move(cable));
}

BodyId Description::find_body(const std::string& name) const {
    const auto entry = body_names_.find(name);
    return entry == body_names_.end() ? BodyId{} : BodyId{entry->second};
}

InteractionId Description::find_interaction(const std::string& name) const {
    const auto entry = interaction_names_.find(name);
    return entry == interaction_names_.end() ? InteractionId{} : InteractionId{entry->second};
}

bool Description::has_cable(const std::string& name) const { return cable_names_.contains(name); }

BodyId Description::world_body() {
    if (!world_.valid()) {
        BodyDef def;
        def.name = "world";
        def.kind = BodyKind::fixed;
        world_ = add_body(std::move(def), store_location({}));
    }
    return world_;
}

const Cable* Description::find_cable(const std::string& name) const {
    const auto entry = cable_names_.find(name);
    return entry == cable_names_.end() ? nullptr : &cables[static_cast<std::size_t>(entry->second)];
}

Vec3 Description::world_point(BodyId id, const Vec3& local) const {
    const BodyDef& b = body(id);
    return b.kind == BodyKind::lump ? b.position : Vec3(b.position + b.orientation * local);
}

Frame Description::frame_of(BodyId id) const {
    const BodyDef& b = body(id);
    return {b.position, b.orientation, b.velocity, b.angular_velocity};
}

BodyId resolve_body(Description& out, const Scope& scope, const std::string& name,
                    const SourceLocation& location) {
    if (const auto bound = scope.bound.find(name); bound != scope.bound.end()) {
        return bound->second == "world" ? out.world_body() : out.find_body(bound->second);
    }
    if (name == "world") {
        return out.world_body();
    }
    const BodyId id = out.find_body(scope.prefix + name);
    if (id.valid()) {
        return id;
    }
    std::vector<std::string> known{"world"};
    for (const auto& [local, full] : scope.bound) {
        known.push_back(local);
    }
    for (const BodyDef& body : out.bodies) {
        if (body.name.starts_with(scope.prefix)) {
            known.push_back(body.name.substr(scope.prefix.size()));
        }
    }
    report_missing(out.mistakes, OmittedPart::body, scope.prefix + name, location,
                   "there is no body " + in_quotes(name) + suggestion(name, known));
}

Vec3 vector_of(const Json& value) {
    return {value[0].get<double>(), value[1].get<double>(), value[2].get<double>()};
}

Vec3 vector_or(const Json& object, const char* key, const Vec3& fallback) {
    const auto entry = object.find(key);
    return entry == object.end() ? fallback : vector_of(*entry);
}

double number_or(const Json& object, const char* key, double fallback) {
    const auto entry = object.find(key);
    return entry == object.end() ? fallback : entry->get<double>();
}

std::string text_or(const Json& object, const char* key, const char* fallback) {
    const auto entry = object.find(key);
    return entry == object.end() ? fallback : entry->get<std::string>();
}

Quat quaternion_of(const Json& value, const SourceLocation& location) {
    const Quat q(value[0].get<double>(), value[1].get<double>(), value[2].get<double>(),
                 value[3].get<double>());
    // Hand-written quaternions have nearly unit length; other lengths are mistakes.
    if (std::abs(q.norm() - 1.0) > 1e-2) {
        throw_error(location,
                    fmt::format("expected a unit quaternion [w, x, y, z], found one of length "
                                "{}",
                                q.norm()));
    }
    return q.normalized();
}

Quat orientation_of(const Json& object, const SourceLocation& location) {
    if (const auto q = object.find("orientation"); q != object.end()) {
        return quaternion_of(*q, location / "orientation");
    }
    const auto euler = object.find("euler_deg");
    if (euler == object.end()) {
        return Quat::Identity();
    }
    const Vec3 angle = vector_of(*euler) * (std::numbers::pi / 180.0);
    return Quat(Eigen::AngleAxisd(angle.z(), Vec3::UnitZ()) *
                Eigen::AngleAxisd(angle.y(), Vec3::UnitY()) *
                Eigen::AngleAxisd(angle.x(), Vec3::UnitX()));
}

}  // namespace hawser::scene
