// SPDX-License-Identifier: Apache-2.0
#include <hawser/body_fields.h>

#include "base/dense.h"
#include "scene/description.h"
#include "scene/field_reader.h"

#include <array>
#include <cmath>
#include <string>
#include <string_view>

namespace hawser::scene {
namespace {

constexpr std::array<const char*, 5> kKindWords = {"rigid", "lump", "scalar", "fixed", "kinematic"};

BodyKind kind_of(const std::string& word) {
    for (std::size_t i = 0; i < kKindWords.size(); ++i) {
        if (word == kKindWords[i]) {
            return static_cast<BodyKind>(i);
        }
    }
    return BodyKind::rigid;
}

bool is_moving(BodyKind kind) {
    return kind == BodyKind::rigid || kind == BodyKind::lump || kind == BodyKind::scalar;
}

/// Set the moments of a solid cylinder of mass m, and its half sizes for pictures. @param axis
/// Axis of the cylinder: x, y or z.
void set_cylinder(BodyDef& def, double radius, double length, char axis) {
    const int along = axis == 'x' ? 0 : axis == 'y' ? 1 : 2;
    const double across = def.mass * (3.0 * radius * radius + length * length) / 12.0;
    Vec3 moments = Vec3::Constant(across);
    moments[along] = def.mass * radius * radius / 2.0;
    def.inertia = moments.asDiagonal();
    def.half_size = Vec3::Constant(radius);
    def.half_size[along] = length / 2.0;
}

void set_inertia_matrix(BodyDef& def, const Json& value, const SourceLocation& location) {
    if (value[0].is_array()) {
        for (std::size_t i = 0; i < 3; ++i) {
            def.inertia.row(static_cast<Eigen::Index>(i)) = vector_of(value[i]);
        }
    } else {
        def.inertia = vector_of(value).asDiagonal();
    }
    const double size = def.inertia.cwiseAbs().maxCoeff();
    if ((def.inertia - def.inertia.transpose()).cwiseAbs().maxCoeff() > 1e-9 * size) {
        throw_error(location, "an inertia must be symmetric");
    }
    // Eigenvalues relative to the largest: a moment 1e-12 of another is round-off, not a body.
    if (!(base::symmetric_eigenvalues(def.inertia).minCoeff() > 1e-12 * size)) {
        throw_error(location,
                    "an inertia must be positive definite; all three principal moments must be "
                    "greater than zero");
    }
}

void set_extent(BodyDef& def, const Json& body, const SourceLocation& location) {
    if (const auto box = body.find("box"); box != body.end()) {
        const Vec3 s = vector_of(*box);
        const Vec3 q = s.cwiseProduct(s);
        const Vec3 moments(q.y() + q.z(), q.x() + q.z(), q.x() + q.y());
        def.inertia = (def.mass / 3.0 * moments).asDiagonal();
        def.half_size = s;
    } else if (const auto rod = body.find("cylinder"); rod != body.end()) {
        set_cylinder(def, (*rod)["radius"].get<double>(), (*rod)["length"].get<double>(),
                     text_or(*rod, "axis", "x").front());
    } else if (body.contains("sphere")) {
        const double r = body["sphere"].get<double>();
        def.inertia = Vec3::Constant(0.4 * def.mass * r * r).asDiagonal();
        def.half_size = Vec3::Constant(r);
    } else if (body.contains("inertia")) {
        set_inertia_matrix(def, body["inertia"], location / "inertia");
    } else if (def.kind == BodyKind::rigid) {
        throw_error(location,
                    "a rigid body needs \"inertia\", \"box\", \"cylinder\" or \"sphere\"");
    }
    def.half_size = vector_or(body, "half_size", def.half_size);
}

/// Reject keys that would have no effect on a body of this kind.
void check_useless_keys(const Json& body, BodyKind kind, const SourceLocation& location) {
    const auto refuse_key = [&](const char* key) {
        if (body.contains(key))
            throw_error(location / key, std::string("has no meaning for a body of kind ") +
                                            kKindWords[static_cast<std::size_t>(kind)]);
    };
    for (const FieldInfo<BodyDef>& row : kBodyFields) {
        if ((row.without & bit_of(kind)) == 0) continue;
        refuse_key(row.key);
        if (std::string_view(row.key) == "orientation") refuse_key("euler_deg");
    }
}

/// Read a scalar body. It has a coordinate instead of a position, so the frame does not apply.
void set_scalar(BodyDef& def, const Json& body, const SourceLocation& location) {
    for (const char* key : {"position", "velocity", "force"}) {
        const Vec3 value = vector_or(body, key, Vec3::Zero());
        if (value.y() != 0.0 || value.z() != 0.0) {
            throw_error(location / key, "a scalar body has one coordinate; y and z must be 0");
        }
    }
    def.position = vector_or(body, "position", Vec3::Zero());
    def.velocity = vector_or(body, "velocity", Vec3::Zero());
    def.force = vector_or(body, "force", Vec3::Zero());
    def.gravity = false;
    if (body.value("gravity", false)) {
        throw_error(location / "gravity", "a scalar body has no weight");
    }
}

void set_motion(BodyDef& def, const Json& body, const Frame& frame,
                const SourceLocation& location) {
    def.position = frame.point(vector_or(body, "position", Vec3::Zero()));
    def.orientation = (frame.orientation * orientation_of(body, location)).normalized();
    def.velocity = frame.velocity_at(def.position) +
                   frame.direction(vector_or(body, "velocity", Vec3::Zero()));
    def.angular_velocity =
        frame.angular_velocity + frame.direction(vector_or(body, "angular_velocity", Vec3::Zero()));
    if (def.kind == BodyKind::lump) {
        def.orientation = Quat::Identity();
        def.angular_velocity.setZero();
    } else if (def.kind == BodyKind::fixed) {
        def.velocity.setZero();
        def.angular_velocity.setZero();
    }
    def.force = frame.direction(vector_or(body, "force", Vec3::Zero()));
    def.torque = frame.direction(vector_or(body, "torque", Vec3::Zero()));
}

}  // namespace

std::string group_of(const Json& value) {
    return value.is_string() ? value.get<std::string>() : std::to_string(value.get<int>());
}

namespace {

BodyDef read_body(const Json& body, const Scope& scope, const SourceLocation& location) {
    BodyDef def;
    def.name = scope.prefix + body["name"].get<std::string>();
    def.kind = kind_of(text_or(body, "kind", "rigid"));
    read_fields(def, body, kBodyFields);
    if (body["name"] == "world" || scope.bound.contains(body["name"].get<std::string>())) {
        throw_error(location / "name", "the name " + describe(body["name"]) +
                                           " is taken: it stands for "
                                           "a body outside");
    }
    if (is_moving(def.kind) && !body.contains("mass")) {
        throw_error(location,
                    "a body of kind " + text_or(body, "kind", "rigid") + " needs the key \"mass\"");
    }
    check_useless_keys(body, def.kind, location);
    set_extent(def, body, location);
    if (def.kind == BodyKind::scalar) {
        set_scalar(def, body, location);
    } else {
        set_motion(def, body, scope.frame, location);
    }
    if (const auto group = body.find("group"); group != body.end()) {
        def.group = group_of(*group);
    }
    return def;
}

}  // namespace

void expand_bodies(Description& out, const Scope& scope) {
    const auto list = scope.content->find("bodies");
    if (list == scope.content->end()) {
        return;
    }
    for (std::size_t i = 0; i < list->size(); ++i) {
        const Json& json = (*list)[i];
        if (json.is_null()) {
            continue;  // Left out: mistakes.h.
        }
        const SourceLocation location = scope.location / "bodies" / i;
        BodyId id;
        const bool read = attempt(out.mistakes, [&] {
            id = out.add_body(read_body(json, scope, location), out.store_location(location));
        });
        if (!read) {
            out.mistakes->record_omitted(OmittedPart::body,
                                         scope.prefix + json["name"].get<std::string>());
        } else if (const auto shapes = json.find("shapes"); shapes != json.end()) {
            expand_shapes(out, id, *shapes, location / "shapes");
        }
    }
}

}  // namespace hawser::scene
